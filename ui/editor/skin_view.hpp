#pragma once

// Handles and lines of a skin, which are shown and can be taken hold of: curves and points as they are now,
// correspondence lines as the surface has them that the worker made last. Positions are in the object's
// space.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/skinning/evaluate_skin.hpp"
#include "render/camera.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Points of the path have no ids of their own; selected, they are named by these numbers.
inline constexpr std::uint32_t path_point_ids = 0x80000000U, rail_point_ids = 0xc0000000U;
inline bool is_path_point(std::uint32_t id) {
  return id >= path_point_ids && id != 0xffffffffU;
}
/// Place of a point of a section, of the path or of the second rail, in the object's space; nothing where
/// there is none with this id.
std::optional<Vector3> skin_point(const Skin& skin, std::uint32_t id);

/// Samples of each span of the curves that are shown.
inline constexpr int curve_samples = 12;

struct SkinView {
  struct Section {
    std::uint32_t id = 0;
    bool closed = false;
    std::vector<Vector3> curve, polygon;
  };
  struct Handle {
    /// place: where a section that can slide lies on the path.
    enum class Kind { control, limit, path, place };
    Kind kind = Kind::control;
    std::uint32_t id = 0;  ///< id of the section point, of the point of the path, or of the section
    int section = -1;
    Vector3 position = Vector3::Zero();
    bool sharp = false;
  };
  /// A line from a section to the next one, which its strip begins and ends with.
  struct Line {
    std::uint32_t first = 0, second = 0;  ///< the sections
    std::uint32_t a = 0, b = 0;           ///< points of its ends
    LineOrigin origin = LineOrigin::matched;
    std::optional<std::uint32_t> entry;  ///< link or merge that it belongs to
    bool locked = false;
    std::vector<Vector3> points;
    std::vector<double> along;  ///< places of the points, 0 at the strip's first section .. 1
    double begin = 0, end = 1;  ///< range of the strip on the path; beyond 1 across the seam of a closed one
  };
  struct Diamond {
    std::uint32_t merge = 0;
    std::uint32_t first = 0;  ///< the section that its strip begins with
    Vector3 position = Vector3::Zero();
  };
  /// A column of a smooth skin.
  struct Column {
    std::vector<Vector3> points;
    std::vector<double> places;  ///< places of the points on the path, ascending
  };
  std::vector<Section> sections;
  std::vector<std::vector<Vector3>> paths;  ///< the path, and the second rail, evenly by their parameters
  std::vector<Handle> handles;
  std::vector<Line> lines;
  std::vector<Diamond> diamonds;
  std::vector<Column> columns;
  std::vector<Vector3> extraordinary;             ///< vertices of the mesh that are not regular
  std::vector<std::array<Vector3, 3>> triangles;  ///< triangles of the mesh
  bool path_closed = false;
};

/// `surface`: of this object, whichever skin it was made from; null where there is none yet.
SkinView view_of(const Skin& skin, const Surface* surface);

/// The view of the skin that was asked for last.
class SkinViewCache {
 public:
  const SkinView& of(const Editor& editor, const Object& object);

 private:
  std::optional<Shared<Skin>> skin_;
  Surface surface_;
  SkinView view_;
};

/// The active object where it is a visible skin and the view shows objects; else null.
const Object* shown_skin(const Editor& editor);
/// The surface of an object that was made last; null where there is none.
const Surface* shown_surface(const Editor& editor, const Object& object);

/// Thing that a press would take hold of.
struct SkinHit {
  enum class Kind { none, handle, diamond };
  Kind kind = Kind::none;
  std::size_t index = 0;  ///< into handles or diamonds
};
/// Within a radius of 14 design pixels (diamonds 10, places of sections 11); points of curves before control
/// points, and both before places where they are nearer than half of that.
SkinHit skin_hit(const SkinView& view, const Object& object, const Projector& projector, const Vector2& pixel,
                 double pixel_scale);

/// The line nearest to a pixel, and where on it.
struct LineHit {
  std::size_t line = 0;
  double along = 0, distance = 0;  ///< fraction of the strip; pixels
};
/// Nearest line of the strips that begin with these sections, or of all.
std::optional<LineHit> nearest_line(const SkinView& view, const Object& object, const Projector& projector,
                                    const Vector2& pixel, const std::vector<std::uint32_t>& strips = {});

/// A line with those that go on from its ends over the other sections; itself first.
std::vector<std::size_t> connected_lines(const SkinView& view, std::size_t line);

/// Parameter of the path where it is nearest to a pixel; nothing where it cannot be seen.
std::optional<double> path_place(const SkinView& view, const Object& object, const Projector& projector,
                                 const Vector2& pixel);

/// About the curve that a section taken from the surface would have, one point a line or column there.
std::vector<Vector3> section_sketch(const SkinView& view, double place);

/// A point of the object's space on the picture.
std::optional<Vector2> pixel_of(const Object& object, const Projector& projector, const Vector3& point);

}  // namespace hariko
