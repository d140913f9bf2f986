#pragma once

// PictureOrder: pictures of the active view to be drawn and written as files, as a value that needs no
// window.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
#include "render/legend.hpp"
#include "render/scene.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

inline constexpr Code e_picture_count{"E_PICTURE_COUNT"};
inline constexpr int most_turntable_pictures = 3600;

struct PictureSettings {
  enum class Size { view, full_hd, ultra_hd, custom };
  Size size = Size::view;
  PixelSize custom{1920, 1080};
  bool transparent = false;
  bool grid = true;        ///< where the view has one
  bool selection = false;  ///< marks of what is selected
  bool legend = true;      ///< where a map shows
  int turntable_pictures = 72;
  bool fit = true;  ///< the turntable's camera moves so that every picture shows the whole model

  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

template <>
inline constexpr auto enum_words<PictureSettings::Size> =
    all_words<PictureSettings::Size>({{PictureSettings::Size::view, "view"},
                                      {PictureSettings::Size::full_hd, "full_hd"},
                                      {PictureSettings::Size::ultra_hd, "ultra_hd"},
                                      {PictureSettings::Size::custom, "custom"}});

/// In pixels. `view`: the size of the active view.
PixelSize size_of(const PictureSettings& settings, PixelSize view);

struct PictureOrder {
  Scene scene;
  PixelSize size;
  std::vector<Camera> cameras;               ///< one for each picture
  std::vector<std::filesystem::path> files;  ///< likewise; PNG
  std::optional<Legend> legend;
};

/// What the active view shows. Lines are as wide as in the view in relation to the whole. Errors:
/// E_NOTHING_TO_SHOW, E_PICTURE_SIZE, E_SURFACE_PENDING while a surface is being computed.
Result<PictureOrder> order_picture(const Editor& editor, const SceneBuilder& scene,
                                   const PictureSettings& settings, const std::filesystem::path& file);
/// The model turned once round a vertical axis through its middle, to the left first; the first picture is
/// the view. Errors: those of `order_picture`, E_PICTURE_COUNT.
Result<PictureOrder> order_turntable(const Editor& editor, const SceneBuilder& scene,
                                     const PictureSettings& settings, const std::filesystem::path& file);

/// "name_0001.png" to "name_<count>.png" beside `file`, "name.png".
std::vector<std::filesystem::path> series_files(const std::filesystem::path& file, int count);

}  // namespace hariko
