#pragma once

// Skin: the designer's sections in work planes along a path, the correspondence of their points, and the
// method of the surface between them. A value with stable ids; everything else is derived
// (evaluate_skin.hpp).

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/mirror_plane.hpp"
#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

struct SectionPoint {
  std::uint32_t id = 0;  ///< unique in the skin
  Vector3 position = Vector3::Zero();
  bool sharp = false;
  friend bool operator==(const SectionPoint&, const SectionPoint&) = default;
};

/// Section: a curve at a place of the path. Points are in the skin's space, not in the section's plane.
struct SkinSection {
  std::uint32_t id = 0;  ///< unique among sections
  double v = 0;          ///< place on the path, 0 .. 1
  bool closed = false;
  std::vector<SectionPoint> points;  ///< one point: a tip, only at an end
  /// Point of the section that stays on the path when the section moves with it; without one, the path's
  /// point.
  std::optional<Vector3> reference;
  /// The designer chose the direction: it is never reversed automatically.
  bool direction_chosen = false;
  /// The designer chose the start of the closed section: its first point corresponds to the first of the
  /// section before. Otherwise the start is found (section_starts.hpp).
  bool start_chosen = false;

  int size() const { return int(points.size()); }
  SubdivisionCurve curve() const;
  friend bool operator==(const SkinSection&, const SkinSection&) = default;
};

/// Link: points of a section that correspond to points of the next one. A single point on a side is joined
/// with all points of the other; two groups are joined at their ends, and the points between are matched
/// automatically.
struct SkinLink {
  std::uint32_t id = 0;                 ///< unique among links and merges
  std::uint32_t first = 0, second = 0;  ///< ids of the sections
  std::vector<std::uint32_t> a, b;      ///< ids of points of `first` and of `second`
  bool lasso = false;                   ///< drawn as a closed curve
  bool locked = false;                  ///< is not replaced by new links and merges
  friend bool operator==(const SkinLink&, const SkinLink&) = default;
};

/// Side of a strip: its first section (a) or its second one (b).
enum class StripSide : std::uint8_t { a, b };

/// Merge: neighbouring points of one section of a strip become one line inside the strip, which runs on to a
/// point of the other section.
struct SkinMerge {
  std::uint32_t id = 0;
  std::uint32_t first = 0, second = 0;
  StripSide side = StripSide::a;       ///< side of the members
  std::vector<std::uint32_t> members;  ///< ids of points, at least two
  std::uint32_t target = 0;            ///< id of the point on the other side
  double v = 0.5;                      ///< place where the lines meet, 0 at `first` .. 1 at `second`
  bool locked = false;
  friend bool operator==(const SkinMerge&, const SkinMerge&) = default;
};

/// Frames that carry sections along the path: not rotated (`translate`), rotation-minimising, spanned by two
/// rails, or `automatic` (see `SkinFrames::mode`).
enum class FrameMode : std::uint8_t { automatic, translate, rotation_minimising, two_rail };
/// Method of the surface: blended sections (`smooth`), the same with links as anchors (`anchored`), or a
/// control mesh along the lines of the correspondence (`pleat`).
enum class SkinMethod : std::uint8_t { smooth, anchored, pleat };
/// Interpolation of sections along the path: see `BlendWeights`.
enum class Blend : std::uint8_t { automatic, linear, natural, hermite };
/// Parameters of columns: evenly spaced, optimised for all sections together, or for each section.
enum class ColumnParameters : std::uint8_t { uniform, shared, per_section };
/// Places of rows: even, or at the path's control points.
enum class RowPlacement : std::uint8_t { even, path };
/// Interpolation of interior sections: none, `fit_sections_locally`, or `fit_sections_fairly`.
enum class SectionFit : std::uint8_t { none, local, fair };
/// Cost of lines between sections: by parameters, or by the distance of points relative to their centre.
enum class MatchCost : std::uint8_t { parameter, shape };
/// Caps at the ends of a tube, see `add_caps`.
enum class Caps : std::uint8_t { none, flat, dome };

struct SmoothOptions {
  int columns = 0, rows = 0;  ///< 0: chosen from the curves
  ColumnParameters parameters = ColumnParameters::per_section;
  Blend blend = Blend::automatic;
  /// Anchors of method `anchored` in addition to the links: rows of one parameter per section, increasing.
  std::vector<std::vector<double>> anchors = {};
  friend bool operator==(const SmoothOptions&, const SmoothOptions&) = default;
};

struct PleatOptions {
  RowPlacement rows = RowPlacement::even;
  bool quad_fans = true;
  bool collars = true;
  SectionFit fit = SectionFit::fair;
  double tension = 200;  ///< 5 flows like a spline, 1e4 is nearly straight from section to section
  double density = 1;    ///< rows per span of the path
  MatchCost cost = MatchCost::parameter;
  friend bool operator==(const PleatOptions&, const PleatOptions&) = default;
};

struct Skin {
  SubdivisionCurve path;
  std::optional<SubdivisionCurve> second_rail;
  FrameMode frame = FrameMode::automatic;
  std::vector<SkinSection> sections;
  SkinMethod method = SkinMethod::pleat;
  SmoothOptions smooth;
  PleatOptions pleat;
  std::vector<SkinLink> links;
  std::vector<SkinMerge> merges;
  bool creases = true;
  Caps caps = Caps::none;
  bool flip_normals = false;
  /// Plane of symmetric editing: edits of sections change both halves.
  std::optional<MirrorPlane> mirror = {};

  int section_count() const { return int(sections.size()); }
  /// Number of strips between neighbouring sections; one more on a closed path.
  int strip_count() const { return path.closed ? section_count() : section_count() - 1; }
  /// Index of a section by its id; -1 when there is none.
  int find_section(std::uint32_t id) const;
  std::uint32_t free_point_id() const;
  std::uint32_t free_section_id() const;
  std::uint32_t free_link_id() const;
  friend bool operator==(const Skin&, const Skin&) = default;
};

/// Calls change(Vector3&) for every position: path, rails, points and references of sections.
template <class Change>
void change_positions(Skin& skin, Change&& change) {
  for (Vector3& point : skin.path.points) change(point);
  if (skin.second_rail)
    for (Vector3& point : skin.second_rail->points) change(point);
  for (SkinSection& section : skin.sections) {
    for (SectionPoint& point : section.points) change(point.position);
    if (section.reference) change(*section.reference);
  }
}

/// Index of a point by its id; -1 when there is none.
int find_point(const SkinSection& section, std::uint32_t id);

}  // namespace hariko
