#pragma once

// PictureOrder and DrawingOrder: pictures, or a line drawing, of the active view to be made and written as
// files, as values that need no window.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/drawing/line_drawing.hpp"
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
  bool grid = true;        ///< the view's grid, if it has one
  bool selection = false;  ///< marks of what is selected
  bool legend = true;      ///< the legend, if a map shows
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

/// Order of a picture of the active view. Lines are as wide as in the view in relation to the whole. Errors:
/// E_NOTHING_TO_SHOW, E_PICTURE_SIZE, E_SURFACE_PENDING while a surface is being computed.
Result<PictureOrder> order_picture(const Editor& editor, const SceneBuilder& scene,
                                   const PictureSettings& settings, const std::filesystem::path& file);
/// The model turned once round a vertical axis through its middle, to the left first; the first picture is
/// the view. Errors: those of `order_picture`, E_PICTURE_COUNT.
Result<PictureOrder> order_turntable(const Editor& editor, const SceneBuilder& scene,
                                     const PictureSettings& settings, const std::filesystem::path& file);

/// "name_0001.png" to "name_<count>.png" beside `file`, "name.png".
std::vector<std::filesystem::path> series_files(const std::filesystem::path& file, int count);

inline constexpr Code e_drawing_of_paper{"E_DRAWING_OF_PAPER"};

struct DrawingSettings {
  double width = 180;   ///< width of the page, mm; its height follows from the view's shape
  bool network = true;  ///< curves of the network; all other kinds of lines are always drawn
  bool hidden = false;  ///< hidden lines as well

  friend bool operator==(const DrawingSettings&, const DrawingSettings&) = default;
};

struct DrawingOrder {
  std::vector<DrawnSurface> surfaces;
  DrawingView view;  ///< in pixels of 1/96 inch
  LineDrawingSettings lines;
  std::filesystem::path file;  ///< SVG, in millimetres
};

/// Width and height, mm.
Vector2 page_of(const DrawingSettings& settings, PixelSize view);

/// The surfaces that the active view shows, seen as it shows them, without grid, polyhedra and marks. Errors:
/// E_NOTHING_TO_SHOW, E_SURFACE_PENDING while a surface is being computed, E_DRAWING_OF_PAPER while the view
/// shows paper.
Result<DrawingOrder> order_drawing(const Editor& editor, const SceneBuilder& scene,
                                   const DrawingSettings& settings, const std::filesystem::path& file);

}  // namespace hariko
