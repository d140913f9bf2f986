#include "core/network/vertex_fan.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "core/base/assert.hpp"
#include "core/network/network.hpp"

namespace hariko {

namespace {

/// Ranges between consecutive sharp edges: (first edge, number of corners).
std::vector<std::pair<std::size_t, std::size_t>> parts_between(const Fan& fan,
                                                               const std::vector<std::size_t>& sharp) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i + 1 < sharp.size(); ++i) out.emplace_back(sharp[i], sharp[i + 1] - sharp[i]);
  if (fan.closed) out.emplace_back(sharp.back(), fan.edges.size() - sharp.back() + sharp.front());
  return out;
}

}  // namespace

Fan fan_of(const HalfEdgeMesh& mesh, Index v) {
  Fan fan;
  fan.closed = !mesh.is_border_vertex(v);
  for (const Index h : mesh.fan_corners(v)) {
    fan.edges.push_back({h, true});
    fan.corners.push_back(h);
    if (mesh.rotate(h) == no_index) fan.edges.push_back({mesh.previous(h), false});
  }
  return fan;
}

Result<FanDivider::Division> FanDivider::divide(Index v, const Fan& fan, const FrameRequest* request) {
  const HalfEdgeMesh& mesh = polyhedron_.topology();
  const VertexTag tag = shaping_.tag.get_or(polyhedron_.vertex_id(v), VertexTag::automatic);
  std::vector<std::size_t> sharp;
  for (std::size_t k = 0; k < fan.edges.size(); ++k)
    if (sharp_[mesh.edge(fan.edges[k].half_edge)]) sharp.push_back(k);

  if (fan.closed && tag == VertexTag::corner && sharp.size() < 2)
    return make_error(e_corner_needs_crease,
                      "Vertex " + std::to_string(polyhedron_.vertex_id(v).value) +
                          " is tagged as a corner, but fewer than two creases meet there.",
                      "Crease two or more of its edges, or remove the tag.",
                      element_of(polyhedron_.vertex_id(v)));

  HARIKO_ASSERT(!request || (!fan.closed && sharp.size() == 2), "frames are asked for on plain borders");
  if (fan.closed && sharp.size() <= 1) return smooth(fan);
  if (request) return request->line ? line(fan, sharp) : corner(fan, sharp, request->opening);
  const bool border_tip = !fan.closed && fan.edges.size() == 2;
  if (sharp.size() >= 3 || tag == VertexTag::corner || (border_tip && tag != VertexTag::smooth))
    return corner(fan, sharp);
  return line(fan, sharp);
}

Index FanDivider::take_basis(Index count) {
  const Index first = next_basis_;
  next_basis_ += count;
  return first;
}

FanDivider::Division FanDivider::smooth(const Fan& fan) {
  const std::size_t n = fan.edges.size();
  const bool straight = n == 2;
  const Index first = take_basis(straight ? 1 : 2);
  Sector sector{straight ? Sector::Image::straight : Sector::Image::smooth, 0, n, 2 * std::numbers::pi};
  sector.basis = {first, straight ? no_index : first + 1};
  return {straight ? FrameKind::straight : FrameKind::smooth, {sector}};
}

FanDivider::Division FanDivider::line(const Fan& fan, const std::vector<std::size_t>& sharp) {
  Division out{FrameKind::sharp_line, {}};
  const Index tc = take_basis(1);
  double sign = 1;
  for (const auto& [first, m] : parts_between(fan, sharp)) {
    Sector sector{Sector::Image::line, first, m, std::numbers::pi};
    sector.basis = {m >= 2 ? take_basis(1) : no_index, tc};
    sector.sign = sign;
    out.sectors.push_back(sector);
    sign = -sign;
  }
  return out;
}

/// `given`: the opening of the only sector, where it is known.
FanDivider::Division FanDivider::corner(const Fan& fan, const std::vector<std::size_t>& sharp,
                                        std::optional<double> given) {
  constexpr double pi = std::numbers::pi;
  Division out{FrameKind::corner, {}};
  const Index first_basis = take_basis(static_cast<Index>(sharp.size()));
  const auto parts = parts_between(fan, sharp);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [first, m] = parts[i];
    const double full = fan.closed ? 2 * pi : pi;
    const double usual = parts.size() == 1 && !fan.closed
                             ? pi / 2
                             : std::min(full * double(m) / double(fan.corners.size()), 2 * pi / 3);
    Sector sector{Sector::Image::corner, first, m, given.value_or(usual)};
    sector.basis = {first_basis + static_cast<Index>(i),
                    first_basis + static_cast<Index>((i + 1) % sharp.size())};
    out.sectors.push_back(sector);
  }
  return out;
}

}  // namespace hariko
