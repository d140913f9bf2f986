#include "core/g2/prescribed_ribbons.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Unknowns of a corner's sector at an end of a border side: the form along the side, and the second
/// derivative along and across it.
struct SideEnd {
  Index corner = no_index;
  Index along = no_index, across = no_index;
};

/// Unknowns at an end of a side: its half-edge opens the first sector of its origin's fan and closes the last
/// one of its target's.
SideEnd end_of(const HalfEdgeMesh& mesh, const G2Unknowns& unknowns, Index half_edge, bool at_origin) {
  SideEnd out;
  out.corner = at_origin ? half_edge : mesh.next(half_edge);
  const CornerUnknowns& corner = unknowns.corner[out.corner];
  // At a smooth line the unknowns are (along, H12, H22); at a corner vertex (c_a, m, c_b), where a side that
  // closes the sector has c_b.
  out.along = corner.unknown[at_origin || !corner.between_sharp_edges ? 0 : 2];
  out.across = corner.unknown[1];
  return out;
}

class Resolver {
 public:
  Resolver(const HalfEdgeMesh& mesh, const VertexFrames& frames, const G2Unknowns& unknowns)
      : mesh_(mesh), frames_(frames), unknowns_(unknowns) {}

  GivenSides resolve(std::vector<GivenSide> sides) {
    std::sort(sides.begin(), sides.end(),
              [](const GivenSide& a, const GivenSide& b) { return a.half_edge < b.half_edge; });
    for (const GivenSide& side : sides)
      for (const bool at_origin : {true, false}) claim(side, at_origin);
    GivenSides out;
    for (const auto& [unknown, wanted] : wanted_) out.unknowns.emplace_back(unknown, wanted.mean());
    for (GivenSide& side : sides) {
      GivenSides::Side entry{side, {}};
      for (Vector3& departure : entry.departure) departure.setZero();
      for (const bool at_origin : {true, false}) depart(entry, at_origin);
      out.sides.push_back(std::move(entry));
    }
    return out;
  }

 private:
  struct Wanted {
    Vector3 sum = Vector3::Zero();
    int count = 0;
    Vector3 mean() const { return sum / double(count); }
  };
  void want(Index unknown, const Vector3& value) {
    Wanted& wanted = wanted_[unknown];
    wanted.sum += value;
    ++wanted.count;
  }
  bool at_corner_vertex(const SideEnd& end) const { return unknowns_.corner[end.corner].between_sharp_edges; }
  /// Angle between the two sharp edges of the sector.
  double opening(const SideEnd& end) const { return unknowns_.corner[end.corner].opening; }
  /// Factor of the mixed derivative: r1' = sigma g12.
  double sigma(const SideEnd& end) const {
    const double step = frames_.step[end.corner];
    return is_straight(step) ? 1.0 : std::sin(step);
  }
  static const Vector3& second(const GivenSide& side, bool at_origin) {
    return at_origin ? side.second_origin : side.second_target;
  }
  static const Vector3& cross(const GivenSide& side, bool at_origin) {
    return at_origin ? side.cross_origin : side.cross_target;
  }

  void claim(const GivenSide& side, bool at_origin) {
    const SideEnd end = end_of(mesh_, unknowns_, side.half_edge, at_origin);
    const Vector3& along = second(side, at_origin);
    want(end.along, along);
    if (!side.has_cross) return;
    const Vector3 mixed = cross(side, at_origin) / sigma(end);
    if (at_corner_vertex(end)) {
      // H(a, b), from the frame of the side: a' = (b - cos a) / sin at its origin, b' = (cos b - a) / sin.
      const double phi = opening(end), c = std::cos(phi), s = std::sin(phi);
      want(end.across, c * along + (at_origin ? s : -s) * mixed);
    } else {
      want(end.across, mixed);
    }
    const std::optional<Vector3>& tangent = at_origin ? side.tangent_origin : side.tangent_target;
    const CornerUnknowns& corner = unknowns_.corner[end.corner];
    HARIKO_ASSERT(tangent.has_value() == is_straight(frames_.step[end.corner]),
                  "straight corners need a second tangent");
    if (tangent) want(corner.tangent[1], *tangent / corner.tangent_turn(1, 1));
  }

  void depart(GivenSides::Side& side, bool at_origin) {
    const SideEnd end = end_of(mesh_, unknowns_, side.given.half_edge, at_origin);
    const Wanted& along = wanted_.at(end.along);
    const Vector3 asked = second(side.given, at_origin);
    if (along.count > 1) side.departure[at_origin ? departs_curve_a : departs_curve_b] = asked - along.mean();
    if (!side.given.has_cross) return;
    const Wanted& across = wanted_.at(end.across);
    if (across.count < 2) return;
    Vector3 mixed = across.mean();
    if (at_corner_vertex(end)) {
      const double phi = opening(end);
      mixed = (at_origin ? 1 : -1) * (mixed - std::cos(phi) * asked) / std::sin(phi);
    }
    side.departure[at_origin ? departs_cross_a : departs_cross_b] =
        cross(side.given, at_origin) - sigma(end) * mixed;
  }

  const HalfEdgeMesh& mesh_;
  const VertexFrames& frames_;
  const G2Unknowns& unknowns_;
  std::map<Index, Wanted> wanted_;
};

}  // namespace

const GivenSides::Side* GivenSides::find(Index half_edge) const {
  const auto found = std::lower_bound(sides.begin(), sides.end(), half_edge,
                                      [](const Side& side, Index h) { return side.given.half_edge < h; });
  return found != sides.end() && found->given.half_edge == half_edge ? &*found : nullptr;
}

std::vector<bool> given_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                 const G2Unknowns& unknowns, const std::vector<PrescribedRibbon>& ribbons) {
  std::vector<bool> out(unknowns.count, false);
  for (Index h = 0; h < ribbons.size(); ++h) {
    if (ribbons[h] == PrescribedRibbon::none) continue;
    HARIKO_ASSERT(mesh.twin(h) == no_index, "only border sides are given");
    const auto& side = unknowns.side[h].unknown;
    out[side[side_e0]] = true;
    if (ribbons[h] != PrescribedRibbon::curve) out[side[side_e1]] = out[side[side_e1_odd]] = true;
    for (const bool at_origin : {true, false}) {
      const SideEnd end = end_of(mesh, unknowns, h, at_origin);
      out[end.along] = true;
      if (ribbons[h] != PrescribedRibbon::cross) continue;
      out[end.across] = true;
      if (is_straight(frames.step[end.corner])) out[unknowns.corner[end.corner].tangent[1]] = true;
    }
  }
  return out;
}

GivenSides resolve_given_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                               const G2Unknowns& unknowns, std::vector<GivenSide> sides) {
  return Resolver(mesh, frames, unknowns).resolve(std::move(sides));
}

}  // namespace hariko
