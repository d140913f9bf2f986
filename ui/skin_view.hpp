#pragma once

// What is shown of a skin and can be taken hold of: curves, points, correspondence lines. Positions are in
// the object's space.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/skinning/evaluate_skin.hpp"
#include "render/camera.hpp"
#include "ui/editor.hpp"

namespace hariko {

/// Points of the path have no ids of their own; selected, they are named by these numbers.
inline constexpr std::uint32_t path_point_ids = 0x80000000U, rail_point_ids = 0xc0000000U;
inline bool is_path_point(std::uint32_t id) {
  return id >= path_point_ids && id != 0xffffffffU;
}

struct SkinView {
  struct Section {
    std::uint32_t id = 0;
    bool closed = false;
    std::vector<Vector3> curve, polygon;
  };
  struct Handle {
    enum class Kind { control, limit, path };
    Kind kind = Kind::control;
    std::uint32_t id = 0;  ///< of the section point, or of the point of the path
    int section = -1;
    Vector3 position = Vector3::Zero();
    bool sharp = false;
  };
  struct Line {
    int strip = 0;
    std::uint32_t a = 0, b = 0;  ///< points of its ends
    LineOrigin origin = LineOrigin::matched;
    std::optional<std::uint32_t> entry;  ///< link or merge that it belongs to
    bool locked = false;
    std::vector<Vector3> points;
    std::vector<double> along;  ///< of the points, 0 at the strip's first section .. 1
  };
  struct Diamond {
    std::uint32_t merge = 0;
    int strip = 0;
    Vector3 position = Vector3::Zero();
  };
  std::vector<Section> sections;
  std::vector<std::vector<Vector3>> paths;  ///< the path, and the second rail
  std::vector<Handle> handles;
  std::vector<Line> lines;
  std::vector<Diamond> diamonds;
  /// What `info` reports, for the panel: rows of the control mesh over all strips; nothing on an error.
  int rows = 0, columns = 0, vertices = 0;
};

/// Lines lie on the surface where it can be made. `surfacer` keeps what helps next time.
SkinView view_of(const Skin& skin, SkinSurfacer& surfacer);

/// The view of the skin that was asked for last.
class SkinViewCache {
 public:
  const SkinView& of(const Shared<Skin>& skin);

 private:
  SkinSurfacer surfacer_;
  std::optional<Shared<Skin>> skin_;
  SkinView view_;
};

/// The active object where it is a visible skin and the view shows objects; else null.
const Object* shown_skin(const Editor& editor);

/// What a press would take hold of.
struct SkinHit {
  enum class Kind { none, handle, diamond };
  Kind kind = Kind::none;
  std::size_t index = 0;  ///< into handles or diamonds
};
/// Within a radius of 14 design pixels (diamonds 10); points of curves before control points.
SkinHit skin_hit(const SkinView& view, const Object& object, const Projector& projector, const Vector2& pixel,
                 double pixel_scale);

/// The line nearest to a pixel, and where on it.
struct LineHit {
  std::size_t line = 0;
  double along = 0, distance = 0;  ///< fraction of the strip; pixels
};
std::optional<LineHit> nearest_line(const SkinView& view, const Object& object, const Projector& projector,
                                    const Vector2& pixel, const std::vector<int>& strips = {});

}  // namespace hariko
