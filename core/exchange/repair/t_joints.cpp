#include "core/exchange/repair/t_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/box_tree.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"

namespace hariko {

namespace {

/// Border edge in the direction of its face.
struct BorderEdge {
  Index from, to, corner, face;
};

std::vector<BorderEdge> border_edges(const PolygonMesh& mesh) {
  std::vector<BorderEdge> out;
  EdgeTable(mesh, sound_faces(mesh)).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const Index corner = uses[0].corner;
    const bool forward = mesh.face_vertices[corner] == low;
    const auto behind = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), corner);
    out.push_back({forward ? low : high, forward ? high : low, corner,
                   static_cast<Index>(behind - mesh.face_offsets.begin() - 1)});
  });
  std::sort(out.begin(), out.end(), [](const BorderEdge& a, const BorderEdge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  return out;
}

/// Distance of a point from the segment a b, and the parameter of the nearest point of the line.
std::pair<double, double> from_segment(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? (point - a).dot(along) / square : 0;
  return {(point - a - std::clamp(t, 0.0, 1.0) * along).norm(), t};
}

/// Search for T-joints along the borders of a mesh.
class TJointSearch {
 public:
  TJointSearch(const PolygonMesh& mesh, double distance)
      : mesh_(mesh), distance_(distance), edges_(border_edges(mesh)) {
    for (const BorderEdge& edge : edges_) vertices_.push_back(edge.from);
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    std::vector<Eigen::AlignedBox3d> boxes;
    std::vector<Vector3> middles;
    for (const Index v : vertices_) {
      middles.push_back(mesh.positions[v]);
      boxes.emplace_back(mesh.positions[v]);
    }
    tree_ = BoxTree(boxes, middles, 4);
  }

  std::vector<TJoint> run() const {
    std::vector<TJoint> out;
    for (const BorderEdge& edge : edges_) {
      const std::map<Index, double> on_it = vertices_on(edge);
      if (on_it.empty()) continue;
      std::vector<Index> between = way_back(edge, on_it);
      if (!between.empty()) out.push_back({edge.corner, std::move(between)});
    }
    return out;
  }

 private:
  /// Border vertices inside an edge, with their parameters.
  std::map<Index, double> vertices_on(const BorderEdge& edge) const {
    const Vector3 &a = mesh_.positions[edge.from], &b = mesh_.positions[edge.to];
    const double length = (b - a).norm();
    std::map<Index, double> out;
    const auto away = [&](const Eigen::AlignedBox3d& box) {
      return from_segment(box.center(), a, b).first - 0.5 * box.diagonal().norm();
    };
    // Rounding of the bound itself must not hide a vertex.
    const double reach = distance_ + 1e-12 * (length + a.norm());
    if (!(length > 2 * reach)) return out;  // no vertex is inside so short an edge, but many may be near
    tree_.visit_near(
        away, [&](double least) { return least <= reach; },
        [&](Index k) {
          const Index v = vertices_[k];
          if (v == edge.from || v == edge.to) return;
          const auto [off, t] = from_segment(mesh_.positions[v], a, b);
          if (off <= reach && t * length > reach && (1 - t) * length > reach) out.emplace(v, t);
        });
    return out;
  }

  /// Vertices on an edge, in its direction, along which border edges run from its end back to its start; none
  /// where they do not reach it.
  std::vector<Index> way_back(const BorderEdge& edge, const std::map<Index, double>& on_it) const {
    std::vector<Index> out;
    Index at = edge.to;
    double parameter = 1;
    while (at != edge.from) {
      auto next = std::lower_bound(edges_.begin(), edges_.end(), at,
                                   [](const BorderEdge& other, Index v) { return other.from < v; });
      for (; next != edges_.end() && next->from == at; ++next) {
        if (next->face == edge.face) continue;  // a flat face lies on itself
        if (next->to == edge.from && at != edge.to) break;
        const auto found = on_it.find(next->to);
        if (found != on_it.end() && found->second < parameter) break;
      }
      if (next == edges_.end() || next->from != at) return {};
      at = next->to;
      if (at == edge.from) break;
      parameter = on_it.at(at);
      out.push_back(at);
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  const PolygonMesh& mesh_;
  double distance_;
  std::vector<BorderEdge> edges_;  ///< ascending by their vertices
  std::vector<Index> vertices_;    ///< on borders, ascending
  BoxTree tree_;
};

}  // namespace

std::vector<TJoint> find_t_joints(const PolygonMesh& mesh, double distance) {
  return TJointSearch(mesh, distance).run();
}

PolygonMesh with_split_edges(const PolygonMesh& mesh, const std::vector<TJoint>& joints) {
  if (joints.empty()) return mesh;
  std::map<Index, const std::vector<Index>*> between;  // by corner
  for (const TJoint& joint : joints) between[joint.corner] = &joint.between;
  std::set<std::pair<Index, Index>> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < mesh.face(f).size(); ++k)
      edges.insert(std::minmax(mesh.face(f)[k], mesh.face(f)[(k + 1) % mesh.face(f).size()]));
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    std::vector<Index> corners;
    std::size_t split = 0, at = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      corners.push_back(face[k]);
      const auto found = between.find(mesh.face_offsets[f] + static_cast<Index>(k));
      if (found == between.end()) continue;
      corners.insert(corners.end(), found->second->begin(), found->second->end());
      ++split;
      at = k;
    }
    if (split != 1 || face.size() != 3) {
      out.add_face(corners);
      continue;
    }
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(at), corners.end());
    const Index tip = corners.back();
    const bool free = std::none_of(corners.begin() + 1, corners.end() - 2,
                                   [&](Index v) { return !edges.insert(std::minmax(v, tip)).second; });
    if (!free)
      out.add_face(corners);
    else
      for (std::size_t k = 0; k + 2 < corners.size(); ++k) out.add_face({corners[k], corners[k + 1], tip});
  }
  return out;
}

}  // namespace hariko
