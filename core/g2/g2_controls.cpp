#include "core/g2/g2_controls.hpp"

#include <array>
#include <cmath>

namespace hariko {

namespace {

/// Tangents (g1, g2) of the corner at a half-edge's origin.
std::array<Vector3, 2> corner_frame(const G2Layout& layout, Index h, const std::vector<Vector3>& unknowns) {
  const CornerUnknowns& corner = layout.unknowns().corner[h];
  const Vector3 &a = unknowns[corner.tangent[0]], &b = unknowns[corner.tangent[1]];
  const Eigen::Matrix2d& turn = corner.tangent_turn;
  return {turn(0, 0) * a + turn(0, 1) * b, turn(1, 0) * a + turn(1, 1) * b};
}

/// Bezier points, of degree six, of the curve along the edge's first half-edge.
std::array<Vector3, 7> edge_curve(const G2Layout& layout, Index edge, const G2Given& given,
                                  const std::vector<Vector3>& unknowns) {
  const HalfEdgeMesh& mesh = layout.mesh();
  const Index h = mesh.half_edge_of_edge(edge), following = mesh.next(h);
  const auto form = [&](Index corner) {
    const CornerUnknowns& at = layout.unknowns().corner[corner];
    std::array<Vector3, 3> out;
    for (int i = 0; i < 3; ++i)
      out[std::size_t(i)] = at.turn(i, 0) * unknowns[at.unknown[0]] +
                            at.turn(i, 1) * unknowns[at.unknown[1]] + at.turn(i, 2) * unknowns[at.unknown[2]];
    return out;
  };
  const Vector3 a = given.positions[mesh.origin(h)], b = given.positions[mesh.target(h)];
  const double angle = layout.frames().step[following];
  const double c = is_straight(angle) ? -1 : std::cos(angle), s = is_straight(angle) ? 0 : std::sin(angle);
  const double length_a = layout.corner(h).out, length_b = layout.corner(following).in;
  const auto [g1, g2] = corner_frame(layout, following, unknowns);
  const Vector3 ga = length_a * corner_frame(layout, h, unknowns)[0], gb = length_b * (c * g1 + s * g2);
  Vector3 second_a = length_a * length_a * form(h)[0];
  const auto at_b = form(following);
  Vector3 second_b = length_b * length_b * (c * c * at_b[0] + 2 * c * s * at_b[1] + s * s * at_b[2]);
  if (const GivenSides::Side* side = given.sides ? given.sides->find(h) : nullptr) {
    second_a = side->given.second_origin;
    second_b = side->given.second_target;
  }
  const Vector3 five[6] = {
      a, a + ga / 5, a + 2 * ga / 5 + second_a / 20, b + 2 * gb / 5 + second_b / 20, b + gb / 5, b};
  std::array<Vector3, 7> out;
  out[0] = a;
  out[6] = b;
  for (int i = 1; i < 6; ++i) out[std::size_t(i)] = (double(i) * five[i - 1] + double(6 - i) * five[i]) / 6;
  out[3] += unknowns[layout.unknowns().side[h].unknown[side_e0]] / 20;
  return out;
}

}  // namespace

Network surface_network(const G2Layout& layout, const G2Given& given, const std::vector<Vector3>& unknowns) {
  const HalfEdgeMesh& mesh = layout.mesh();
  Network out = *given.network;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const CornerShape &a = layout.corner(h), &b = layout.corner(mesh.next(h));
    out.start[h] = a.out / 3 * corner_frame(layout, h, unknowns)[0];
    const auto [g1, g2] = corner_frame(layout, mesh.next(h), unknowns);
    const bool straight = is_straight(b.angle);
    out.end[h] =
        b.in / 3 * (straight ? Vector3(-g1) : Vector3(std::cos(b.angle) * g1 + std::sin(b.angle) * g2));
  }
  return out;
}

G2Face face_controls(const G2Layout& layout, const CondensedFace& element, Index face, const G2Given& given,
                     const std::vector<Vector3>& unknowns) {
  const HalfEdgeMesh& mesh = layout.mesh();
  const FaceChart& of = layout.chart(face);
  const ControlPlaces& places = layout.places(face);
  const Vector3 mean = face_mean(mesh, face, given);
  const int slots = layout.slot_count(face);
  std::vector<Vector3> local(std::size_t(slots) + places.given.size());
  for (int i = 0; i < slots; ++i) local[std::size_t(i)] = unknowns[layout.slot_unknown(face, i)];
  layout.turn<G2Layout::Turn::plain>(face, local.data());
  given_controls(layout, face, given, mean, local.data() + slots);
  std::vector<Vector3> centre(places.centre.size());
  multiply(element.centre, local.data(), centre.data());
  if (given.target)
    for (std::size_t i = 0; i < centre.size(); ++i) centre[i] += (*given.target)[face].centre[i];
  centre[0] += mean;

  G2Face out(std::size_t(of.control_count()) + 7 * std::size_t(of.sides()));
  for (int i = 0; i < slots; ++i) out[std::size_t(places.unknown[std::size_t(i)])] = local[std::size_t(i)];
  for (std::size_t i = 0; i < places.given.size(); ++i)
    out[std::size_t(places.given[i])] = local[std::size_t(slots) + i];
  for (std::size_t i = 0; i < centre.size(); ++i) out[std::size_t(places.centre[i])] = centre[i];
  for (int j = 0; j < of.sides(); ++j) {
    const Index h = layout.half_edge(face, j), e = mesh.edge(h);
    out[std::size_t(of.corner_control(j, corner_p))] = given.positions[mesh.origin(h)];
    const auto curve = edge_curve(layout, e, given, unknowns);
    Vector3* side = out.data() + of.control_count() + 7 * j;
    const bool forward = mesh.half_edge_of_edge(e) == h;
    for (std::size_t i = 0; i < 7; ++i) side[i] = curve[forward ? i : 6 - i];
  }
  return out;
}

}  // namespace hariko
