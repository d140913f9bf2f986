#include "core/offset/wall_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

/// Cosine of the angle between normals from which on a sharp edge counts as back to back.
constexpr double back_to_back = -0.9999;
/// Angle, radians, by which normals may differ at a side that is shrunk to a point.
constexpr double same_at_tip = 1e-3;

}  // namespace

WallBuilder::WallBuilder(std::shared_ptr<const BaseNormals> normals, std::vector<double> layers)
    : normals_(std::move(normals)),
      base_(normals_->base()),
      layers_(std::move(layers)),
      triangles_(base_.domain() == Domain::triangle),
      corners_(corner_count(base_.domain())) {}

WallBuilder::Cell WallBuilder::add(const WallPatch& patch, const Provenance& source, bool flipped,
                                   bool own_domain) {
  const Cell out{Index(patches_.size()), flipped, own_domain};
  patches_.push_back(patch);
  patches_.back().flipped = flipped;
  provenance_.push_back(source);
  if (own_domain || !triangles_) return out;
  patches_.push_back(patches_.back());
  patches_.back().second_half = true;
  provenance_.push_back(source);
  Seam diagonal;
  diagonal.first = {out.patch, 1};
  diagonal.second = {out.patch + 1, 1};
  seams_.push_back(diagonal);
  return out;
}

WallBuilder::Cell WallBuilder::face(std::size_t layer, Index patch) const {
  return {Index(layer) * base_.patch_count() + patch, layer == 1, true};
}

PatchSide WallBuilder::placed(const CellPart& part, double& begin, double& end) const {
  PatchSide out{part.cell.patch, std::uint8_t(part.side)};
  if (triangles_ && !part.cell.own_domain) {
    if (part.side == 1 || part.side == 2) ++out.patch;
    out.side = part.side == 0 || part.side == 2 ? 0 : 2;
  }
  begin = part.begin;
  end = part.end;
  if (!part.cell.flipped) return out;
  // The exchange of s and t turns the order of the sides round.
  out.side = std::uint8_t(corners_ - 1 - out.side);
  begin = 1 - begin;
  end = 1 - end;
  return out;
}

void WallBuilder::join(const CellPart& a, const CellPart& b, Continuity continuity, const Element& source) {
  Seam seam;
  seam.first = placed(a, seam.first_begin, seam.first_end);
  seam.second = placed(b, seam.second_begin, seam.second_end);
  if (seam.first_begin > seam.first_end) {
    std::swap(seam.first_begin, seam.first_end);
    std::swap(seam.second_begin, seam.second_end);
  }
  seam.intended = continuity;
  seam.source = source;
  seams_.push_back(seam);
}

void WallBuilder::add_faces() {
  for (std::size_t layer = 0; layer < layers_.size(); ++layer)
    for (Index patch = 0; patch < base_.patch_count(); ++patch) {
      WallPatch made;
      made.base = patch;
      made.from = made.to = layers_[layer];
      add(made, base_.provenance()[patch], layer == 1, true);
    }
}

std::optional<Index> WallBuilder::group_at(const PatchSide& side, double x) const {
  if (x != 0 && x != 1) return {};
  return normals_->group(side.patch, (side.side + int(x)) % corners_);
}

bool WallBuilder::add_base_seam(Index index) {
  if (normals_->sharp(index)) return add_join(index);
  const Seam& seam = base_.seams()[index];
  for (std::size_t layer = 0; layer < layers_.size(); ++layer)
    join({face(layer, seam.first.patch), seam.first.side, seam.first_begin, seam.first_end},
         {face(layer, seam.second.patch), seam.second.side, seam.second_begin, seam.second_end},
         seam.intended, seam.source);
  return true;
}

bool WallBuilder::add_join(Index index) {
  const Seam& seam = base_.seams()[index];
  ++sharp_edges_;
  const BaseSide first{seam.first, seam.first_begin, seam.first_end};
  const BaseSide second{seam.second, seam.second_begin, seam.second_end};
  const auto on = [&](const BaseSide& side, double x) {
    return normals_->on_side(side.side, side.begin + x * (side.end - side.begin));
  };
  for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0})
    if (on(first, x).normal.dot(on(second, x).normal) < back_to_back) return false;
  const SidePoint middle = on(first, 0.5);
  const double turn =
      middle.normal.cross(on(second, 0.5).normal).dot(middle.position_x) * (first.end - first.begin);
  for (const double distance : layers_)
    if (distance * turn < 0) {
      ++crossings_;
      break;
    }
  std::array<Turn, 2> turns;  // at x = 0, where it is side 1, and at x = 1
  turns[0].side = 1;
  turns[1].side = 3;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    const CellPart a{face(layer, first.side.patch), first.side.side, first.begin, first.end};
    const CellPart b{face(layer, second.side.patch), second.side.side, second.begin, second.end};
    if (layers_[layer] == 0) {
      join(a, b, Continuity::g0, seam.source);
      for (Turn& at : turns) at.cells.emplace_back();
      continue;
    }
    WallPatch made;
    made.kind = WallPatch::Kind::join;
    made.from = made.to = layers_[layer];
    made.first = first;
    made.second = second;
    const Cell cell = add(made, base_.provenance()[seam.first.patch], layer == 1, false);
    join(a, {cell, 0, 1, 0}, Continuity::g1);
    join({cell, 2, 0, 1}, b, Continuity::g1);
    for (Turn& at : turns) at.cells.emplace_back(cell);
  }
  for (std::size_t end : {0U, 1U}) {
    const auto low = group_at(first.side, end == 0 ? first.begin : first.end);
    const auto high = group_at(second.side, end == 0 ? second.begin : second.end);
    if (!low || !high) {
      ++gaps_;
      continue;
    }
    if (*low == *high) continue;
    Turn& at = turns[end];
    at.from = end == 0 ? *low : *high;
    at.to = end == 0 ? *high : *low;
    at.position = on(first, double(end)).position;
    at.source = base_.provenance()[seam.first.patch];
    turns_.push_back(at);
  }
  return true;
}

void WallBuilder::close_turns() {
  // The border of the hole at a corner runs along each turn backwards: from its `to` to its `from`.
  std::map<Index, Index> by_to;
  for (Index i = 0; i < turns_.size(); ++i) by_to.emplace(turns_[i].to, i);
  std::vector<std::uint8_t> seen(turns_.size(), 0);
  for (Index begin = 0; begin < turns_.size(); ++begin) {
    if (seen[begin]) continue;
    std::vector<Index> chain;
    bool closed = false;
    for (Index at = begin; !seen[at];) {
      seen[at] = 1;
      chain.push_back(at);
      const auto next = by_to.find(turns_[at].from);
      if (next == by_to.end()) break;
      closed = next->second == begin;
      at = next->second;
    }
    if (!closed) {
      // The rest of an open chain may come from another beginning.
      continue;
    }
    for (const Index turn : chain) turns_[turn].closed = true;
    if (chain.size() > 2) {
      add_fans(chain);
      continue;
    }
    const Turn &a = turns_[chain[0]], &b = turns_[chain[1]];
    for (std::size_t layer = 0; layer < layers_.size(); ++layer)
      if (a.cells[layer]) join({*a.cells[layer], a.side}, {*b.cells[layer], b.side, 1, 0}, Continuity::g1);
  }
}

void WallBuilder::add_fans(std::span<const Index> turns) {
  Vector3 sum = Vector3::Zero();
  for (const Index turn : turns) sum += normals_->group_normal(turns_[turn].from);
  const Vector3 top =
      sum.norm() > 1e-6 ? Vector3(sum.normalized()) : normals_->group_normal(turns_[turns[0]].from);
  const int before = triangles_ ? 2 : 3;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    if (layers_[layer] == 0) continue;
    std::vector<Cell> cells;
    for (const Index index : turns) {
      const Turn& turn = turns_[index];
      WallPatch made;
      made.kind = WallPatch::Kind::fan;
      made.from = made.to = layers_[layer];
      made.position = turns_[turns[0]].position;
      made.normals = {normals_->group_normal(turn.to), normals_->group_normal(turn.from), top};
      cells.push_back(add(made, turn.source, layer == 1, true));
      join({*turn.cells[layer], turn.side}, {cells.back(), 0, 1, 0}, Continuity::g1);
    }
    for (std::size_t k = 0; k < cells.size(); ++k)
      join({cells[k], 1}, {cells[(k + 1) % cells.size()], before, 1, 0}, Continuity::g1);
  }
}

void WallBuilder::take_port(std::optional<Index> group, const Cell& cell, int side) {
  if (!group) {
    ++gaps_;
    return;
  }
  Port& port = ports_[*group];
  std::optional<Cell>& place = side == 1 ? port.side_1 : port.side_3;
  if (place) ++gaps_;
  place = cell;
}

void WallBuilder::add_rim(const PatchSide& side, double begin, double end) {
  WallPatch made;
  made.kind = WallPatch::Kind::rim;
  made.from = layers_[0];
  made.to = layers_[1];
  made.first = {side, begin, end};
  const Cell cell = add(made, base_.provenance()[side.patch], false, false);
  join({face(0, side.patch), side.side, begin, end}, {cell, 0, 1, 0}, Continuity::g0);
  join({cell, 2, 0, 1}, {face(1, side.patch), side.side, begin, end}, Continuity::g0);
  take_port(group_at(side, begin), cell, 1);
  take_port(group_at(side, end), cell, 3);
}

void WallBuilder::add_rims() {
  constexpr double least = 1e-9;
  const Adjacency adjacency(base_);
  for (const PatchSide& side : adjacency.boundary()) {
    if (normals_->shrunk(side)) continue;
    std::vector<std::pair<double, double>> covered;
    for (const Index index : adjacency.seams(side)) {
      const Seam& seam = base_.seams()[index];
      if (seam.first == side) covered.push_back(std::minmax(seam.first_begin, seam.first_end));
      if (seam.second == side) covered.push_back(std::minmax(seam.second_begin, seam.second_end));
    }
    std::sort(covered.begin(), covered.end());
    double begin = 0;
    for (const auto& [from, to] : covered) {
      if (from > begin + least) add_rim(side, begin, from);
      begin = std::max(begin, to);
    }
    if (begin < 1 - least) add_rim(side, begin, 1);
  }
}

void WallBuilder::add_ends() {
  for (const Turn& turn : turns_) {
    if (turn.closed) continue;
    WallPatch made;
    made.kind = WallPatch::Kind::end;
    made.from = layers_[0];
    made.to = layers_[1];
    made.position = turn.position;
    made.normals = {normals_->group_normal(turn.to), normals_->group_normal(turn.from), Vector3::Zero()};
    const Cell cell = add(made, turn.source, false, false);
    if (turn.cells[0]) join({*turn.cells[0], turn.side}, {cell, 0, 1, 0}, Continuity::g0);
    if (turn.cells[1]) join({cell, 2}, {*turn.cells[1], turn.side}, Continuity::g0);
    take_port(turn.from, cell, 1);
    take_port(turn.to, cell, 3);
  }
}

void WallBuilder::join_ports() {
  for (const auto& [group, port] : ports_) {
    if (port.side_1 && port.side_3)
      join({*port.side_3, 3}, {*port.side_1, 1, 1, 0}, Continuity::g0);
    else
      ++gaps_;
  }
}

void WallBuilder::count_tips() {
  const PatchSet& patches = base_.patches();
  for (Index patch = 0; patch < base_.patch_count(); ++patch)
    for (int side = 0; side < corners_; ++side) {
      if (!normals_->shrunk({patch, std::uint8_t(side)})) continue;
      const Vector3& tip = normals_->group_normal(normals_->group(patch, side));
      for (const double x : {0.0, 0.5, 1.0}) {
        const Vector2 at = side_parameter(base_.domain(), side, x);
        if ((patches.inner_normal(patch, at) - tip).norm() <= same_at_tip) continue;
        ++tips_;
        break;
      }
    }
}

std::optional<Surface> WallBuilder::build() {
  add_faces();
  for (Index seam = 0; seam < base_.seams().size(); ++seam)
    if (!add_base_seam(seam)) return {};
  close_turns();
  if (layers_.size() == 2) {
    add_rims();
    add_ends();
    join_ports();
  }
  count_tips();
  return surface();
}

Surface WallBuilder::surface() const {
  const auto patches = std::make_shared<const WallPatchSet>(normals_, patches_);
  const auto corner_slot = [&](const PatchSide& side, double x) {
    return Index(side.patch * Index(corners_) + Index(side.side + int(x)) % Index(corners_));
  };
  DisjointSets sets(patches_.size() * std::size_t(corners_));
  for (const Seam& seam : seams_)
    for (const auto& [a, b] :
         {std::pair(seam.first_begin, seam.second_begin), std::pair(seam.first_end, seam.second_end)})
      if ((a == 0 || a == 1) && (b == 0 || b == 1))
        sets.join(corner_slot(seam.first, a), corner_slot(seam.second, b));
  const auto shrunk = [&](Index patch, int side) {
    const auto at = [&](double x) {
      return patches->evaluate(patch, side_parameter(base_.domain(), side, x), Order::first);
    };
    const PatchPoint begin = at(0);
    const double limit = 1e-9 * (begin.ds.norm() + begin.dt.norm());
    for (const double x : {1.0, 0.5, 0.25, 0.75})
      if (!((at(x).position - begin.position).norm() <= limit)) return false;
    return true;
  };
  for (Index patch = 0; patch < patches_.size(); ++patch)
    for (int side = 0; side < corners_; ++side)
      if (shrunk(patch, side))
        sets.join(corner_slot({patch, std::uint8_t(side)}, 0), corner_slot({patch, std::uint8_t(side)}, 1));
  std::vector<Index> nodes(sets.size()), number(sets.size(), no_index);
  std::vector<Vector3> node_normals;
  for (Index k = 0; k < sets.size(); ++k) {
    Index& node = number[sets.find(k)];
    const Vector3 normal = patches->corner_normal(k / Index(corners_), int(k % Index(corners_)));
    if (node == no_index) {
      node = Index(node_normals.size());
      node_normals.push_back(normal);
    } else if ((node_normals[node] - normal).norm() > 1e-9) {
      node_normals[node].setZero();
    }
    nodes[k] = node;
  }
  Surface::Parts parts;
  parts.origin = base_.origin();
  parts.patches = patches;
  parts.seams = std::make_shared<const std::vector<Seam>>(seams_);
  parts.provenance = std::make_shared<const std::vector<Provenance>>(provenance_);
  parts.corner_nodes = std::make_shared<const std::vector<Index>>(std::move(nodes));
  parts.node_count = Index(node_normals.size());
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(std::move(node_normals));
  const bool open = layers_.size() == 1;
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>(open ? base_.boundary_sides()
                                                                             : std::vector<PatchSide>());
  parts.boundary_sources =
      std::make_shared<const std::vector<Element>>(open ? base_.boundary_sources() : std::vector<Element>());
  return Surface(std::move(parts));
}

}  // namespace hariko
