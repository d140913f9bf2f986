#pragma once

// Skin: what the designer draws. Sections in work planes along a path, how their points correspond, and how
// the surface between them is made. A value with stable ids; everything else is derived (evaluate_skin.hpp).

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/mirror_plane.hpp"
#include "core/skinning/subdivision_curve.hpp"

namespace hariko {

struct SectionPoint {
  std::uint32_t id = 0;  ///< unique in the skin
  Vector3 position = Vector3::Zero();
  bool sharp = false;
  friend bool operator==(const SectionPoint&, const SectionPoint&) = default;
};

/// Points are where the designer sees them.
struct SkinSection {
  std::uint32_t id = 0;  ///< unique among sections
  double v = 0;          ///< place on the path, 0 .. 1
  bool closed = false;
  std::vector<SectionPoint> points;  ///< one point: a tip, only at an end
  /// The point of the section that stays on the path when it is carried; the path's own where none.
  std::optional<Vector3> reference;
  /// The designer chose the direction: it is never turned round for him.
  bool direction_chosen = false;
  /// The designer chose where the closed section begins: its first point belongs to the first of the section
  /// before. Otherwise what belongs together is found (section_starts.hpp).
  bool start_chosen = false;

  int size() const { return int(points.size()); }
  SubdivisionCurve curve() const;
  friend bool operator==(const SkinSection&, const SkinSection&) = default;
};

/// Points of a section that belong to points of the next one. One point on a side takes all of the other;
/// two groups are joined at their ends, and what is between is matched as by default.
struct SkinLink {
  std::uint32_t id = 0;                 ///< unique among links and merges
  std::uint32_t first = 0, second = 0;  ///< the sections
  std::vector<std::uint32_t> a, b;      ///< ids of points of `first` and of `second`
  bool lasso = false;                   ///< drawn as a closed curve
  bool locked = false;                  ///< does not give way to new ones
  friend bool operator==(const SkinLink&, const SkinLink&) = default;
};

enum class StripSide : std::uint8_t { a, b };

/// Neighbouring points of one section of a strip become one line inside of it, which runs on to a point of
/// the other section.
struct SkinMerge {
  std::uint32_t id = 0;
  std::uint32_t first = 0, second = 0;
  StripSide side = StripSide::a;       ///< where the members are
  std::vector<std::uint32_t> members;  ///< at least two
  std::uint32_t target = 0;            ///< on the other side
  double v = 0.5;                      ///< where the lines meet, 0 at `first` .. 1 at `second`
  bool locked = false;
  friend bool operator==(const SkinMerge&, const SkinMerge&) = default;
};

enum class FrameMode : std::uint8_t { automatic, translate, rotation_minimising, two_rail };
enum class SkinMethod : std::uint8_t { smooth, anchored, pleat };
enum class Blend : std::uint8_t { automatic, linear, natural, hermite };
enum class ColumnParameters : std::uint8_t { uniform, shared, per_section };
enum class RowPlacement : std::uint8_t { even, path };
enum class SectionFit : std::uint8_t { none, local, fair };
enum class MatchCost : std::uint8_t { parameter, shape };
enum class Caps : std::uint8_t { none, flat, dome };

struct SmoothOptions {
  int columns = 0, rows = 0;  ///< 0: as many as the curves suggest
  ColumnParameters parameters = ColumnParameters::per_section;
  Blend blend = Blend::automatic;
  /// Method `anchored`, beside the links: one parameter a section, increasing.
  std::vector<std::vector<double>> anchors = {};
  friend bool operator==(const SmoothOptions&, const SmoothOptions&) = default;
};

struct PleatOptions {
  RowPlacement rows = RowPlacement::even;
  bool quad_fans = true;
  bool collars = true;
  SectionFit fit = SectionFit::fair;
  double tension = 200;  ///< 5 flows like a spline, 1e4 runs straight from section to section
  double density = 1;    ///< rows a span of the path
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
  /// Edits of sections change both halves.
  std::optional<MirrorPlane> mirror = {};

  int section_count() const { return int(sections.size()); }
  /// Strips between neighbouring sections; one more on a closed path.
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
