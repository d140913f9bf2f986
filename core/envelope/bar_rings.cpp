#include "core/envelope/bar_rings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace hariko {

namespace {

/// Vertices nearer to the plane, of their longest way across it, are points of the ring.
constexpr double near_plane = 0.15;
constexpr double widest_ring = 12;  ///< radii of the bar: what lies farther out belongs to something else
constexpr int crossing_bisections = 40;
constexpr double usual_waist = 0.5;  ///< of the settings, where bars are as thick as the solids suggest
constexpr double slimmest = 0.25, thickest = 2;

/// The crossings of a cage with one plane. Nodes are vertices near it and edges through it, numbered after
/// the vertices.
class PlaneCrossing {
 public:
  PlaneCrossing(const FieldBar& bar, const Polyhedron& cage, const Surface& surface)
      : bar_(bar), cage_(cage), surface_(surface), mesh_(cage.topology()) {
    find_sides();
    find_arcs();
  }

  std::optional<BarRing> ring() const {
    std::optional<BarRing> best;
    double least = widest_ring * bar_.radius;
    std::vector<bool> seen(next_.size(), false);
    for (Index node = 0; node < next_.size(); ++node) {
      if (seen[node] || next_[node].empty()) continue;
      const auto loop = loop_from(node, seen);
      if (!loop) continue;
      BarRing ring{bar_.solids, Vector3::Zero(), {}};
      for (const Index n : *loop) ring.points.push_back(point(n));
      for (const RingPoint& p : ring.points) ring.centre += p.position / double(ring.points.size());
      const double size = largest_radius(ring);
      if (size <= least && winds_round(ring)) least = size, best = std::move(ring);
    }
    return best;
  }

 private:
  void find_sides() {
    height_.resize(mesh_.vertex_count());
    for (Index v = 0; v < height_.size(); ++v) height_[v] = (cage_.position(v) - bar_.middle).dot(bar_.axis);
    std::vector<double> extent(height_.size(), 0);
    for (Index h = 0; h < mesh_.half_edge_count(); ++h)
      extent[mesh_.origin(h)] =
          std::max(extent[mesh_.origin(h)], std::abs(height_[mesh_.target(h)] - height_[mesh_.origin(h)]));
    for (Index v = 0; v < height_.size(); ++v)
      if (std::abs(height_[v]) <= near_plane * extent[v]) height_[v] = 0;
  }

  void find_arcs() {
    next_.resize(mesh_.vertex_count() + mesh_.edge_count());
    twice_.assign(next_.size(), false);
    std::vector<Index> nodes;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      nodes.clear();
      for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h) {
        const double a = height_[mesh_.origin(h)], b = height_[mesh_.target(h)];
        if (a == 0) nodes.push_back(mesh_.origin(h));
        if (a * b < 0) nodes.push_back(mesh_.vertex_count() + mesh_.edge(h));
      }
      if (nodes.size() == 2) {
        next_[nodes[0]].insert(nodes[1]);
        next_[nodes[1]].insert(nodes[0]);
      } else if (nodes.size() > 2) {
        for (const Index n : nodes) twice_[n] = true;
      }
    }
  }

  /// Nothing where what hangs together is no simple loop.
  std::optional<std::vector<Index>> loop_from(Index start, std::vector<bool>& seen) const {
    std::vector<Index> part, open{start};
    bool simple = true;
    while (!open.empty()) {
      const Index node = open.back();
      open.pop_back();
      if (seen[node]) continue;
      seen[node] = true;
      part.push_back(node);
      simple = simple && next_[node].size() == 2 && !twice_[node];
      open.insert(open.end(), next_[node].begin(), next_[node].end());
    }
    if (!simple || part.size() < 3) return {};
    std::vector<Index> loop{start};
    for (Index before = no_index, at = start;;) {
      const auto& [one, other] = std::pair(*next_[at].begin(), *next_[at].rbegin());
      const Index to = one == before ? other : one;
      before = at, at = to;
      if (at == start) return loop;
      loop.push_back(at);
    }
  }

  RingPoint point(Index node) const {
    RingPoint out;
    Index half_edge = no_index;
    double along = 0;
    if (node < mesh_.vertex_count()) {
      out.vertex = node;
      half_edge = mesh_.outgoing(node);
    } else {
      out.edge = node - mesh_.vertex_count();
      half_edge = mesh_.half_edge_of_edge(out.edge);
      along = crossing(half_edge);
    }
    const Vector2 parameter(1 - along, along);
    out.position = out.vertex == no_index ? at(half_edge, along) : cage_.position(out.vertex);
    out.outward = surface_.normal(half_edge, parameter);
    return out;
  }

  /// Point of the surface over an edge of the cage.
  Vector3 at(Index half_edge, double along) const {
    return surface_.patches().evaluate(half_edge, {1 - along, along}, Order::first).position;
  }

  double crossing(Index half_edge) const {
    const bool rises = height_[mesh_.origin(half_edge)] < 0;
    double low = 0, high = 1;
    for (int i = 0; i < crossing_bisections; ++i) {
      const double middle = 0.5 * (low + high);
      const bool below = (at(half_edge, middle) - bar_.middle).dot(bar_.axis) < 0;
      (below == rises ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  Vector3 across(const Vector3& v) const { return v - v.dot(bar_.axis) * bar_.axis; }

  double largest_radius(const BarRing& ring) const {
    double out = 0;
    for (const RingPoint& p : ring.points) out = std::max(out, across(p.position - bar_.middle).norm());
    return out;
  }

  bool winds_round(const BarRing& ring) const {
    double angle = 0;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Vector3 a = across(ring.points[i].position - bar_.middle);
      const Vector3 b = across(ring.points[(i + 1) % ring.points.size()].position - bar_.middle);
      angle += std::atan2(a.cross(b).dot(bar_.axis), a.dot(b));
    }
    return std::abs(std::abs(angle) - 2 * std::numbers::pi) < 0.1;
  }

  const FieldBar& bar_;
  const Polyhedron& cage_;
  const Surface& surface_;
  const HalfEdgeMesh& mesh_;
  std::vector<double> height_;  ///< of vertices above the plane, 0 near it
  std::vector<std::set<Index>> next_;
  std::vector<bool> twice_;  ///< in a face that the plane crosses more than once
};

/// Faces that have a point of the ring.
std::set<Index> faces_of(const BarRing& ring, const HalfEdgeMesh& mesh) {
  std::set<Index> out;
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    for (const RingPoint& p : ring.points)
      if (p.vertex == no_index ? mesh.edge(h) == p.edge : mesh.origin(h) == p.vertex)
        out.insert(mesh.face(h));
  return out;
}

}  // namespace

std::vector<BarRing> bar_rings(std::span<const FieldBar> bars, const Polyhedron& cage,
                               const Surface& surface) {
  std::vector<BarRing> out;
  std::set<Index> taken;
  for (const FieldBar& bar : bars) {
    auto ring = PlaneCrossing(bar, cage, surface).ring();
    if (!ring) continue;
    const std::set<Index> faces = faces_of(*ring, cage.topology());
    if (std::ranges::any_of(faces, [&](Index f) { return taken.contains(f); })) continue;
    taken.insert(faces.begin(), faces.end());
    out.push_back(*std::move(ring));
  }
  return out;
}

RingedCage ringed_cage(const Polyhedron& cage, std::span<const double> cell, std::span<const BarRing> rings,
                       std::span<const double> factors) {
  const HalfEdgeMesh& mesh = cage.topology();
  RingedCage out;
  out.mesh.positions = cage.positions();
  out.cell.assign(cell.begin(), cell.end());
  std::vector<Index> on_edge(mesh.edge_count(), no_index);  // vertices
  std::vector<bool> on_ring(mesh.vertex_count(), false);
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const RingPoint& p : rings[r].points) {
      const Vector3 to = rings[r].centre + factors[r] * (p.position - rings[r].centre);
      if (p.vertex != no_index) {
        on_ring[p.vertex] = true;
        out.mesh.positions[p.vertex] = to;
        continue;
      }
      const Index h = mesh.half_edge_of_edge(p.edge);
      on_edge[p.edge] = Index(out.mesh.positions.size());
      out.mesh.positions.push_back(to);
      out.cell.push_back(std::min(cell[mesh.origin(h)], cell[mesh.target(h)]));
    }
  std::vector<Index> loop, marks;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    loop.clear();
    marks.clear();  // places in the loop that are on the ring
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      if (on_ring[mesh.origin(h)]) marks.push_back(Index(loop.size()));
      loop.push_back(mesh.origin(h));
      if (on_edge[mesh.edge(h)] == no_index) continue;
      marks.push_back(Index(loop.size()));
      loop.push_back(on_edge[mesh.edge(h)]);
    }
    const bool cut = marks.size() == 2 && marks[1] - marks[0] > 1 && marks[0] + loop.size() - marks[1] > 1;
    if (!cut) {
      out.mesh.add_face(loop);
      continue;
    }
    std::rotate(loop.begin(), loop.begin() + marks[0], loop.end());
    const Index other = marks[1] - marks[0];
    out.mesh.add_face(std::span(loop).first(other + 1));
    loop.push_back(loop.front());
    out.mesh.add_face(std::span(loop).subspan(other));
  }
  return out;
}

double wanted_thickness(const EnvelopeSettings& settings, const SolidPair& solids) {
  return std::clamp(thickness_growth(settings) * settings.waists.get_or(solids, 1.0), slimmest, thickest);
}

double thickness_growth(const EnvelopeSettings& settings) {
  return settings.waist / usual_waist;
}

std::vector<EnvelopeBridge> bridges_of(std::span<const BarRing> rings, const EnvelopeSettings& settings) {
  std::vector<EnvelopeBridge> out;
  for (const BarRing& ring : rings) {
    const double growth = thickness_growth(settings) / wanted_thickness(settings, ring.solids);
    for (const RingPoint& p : ring.points)
      out.push_back({ring.solids, p.position, p.outward, growth * (p.position - ring.centre)});
  }
  return out;
}

}  // namespace hariko
