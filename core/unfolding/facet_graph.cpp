#include "core/unfolding/facet_graph.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/ids.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/message_group.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

constexpr const char* refusal = "The mesh cannot be unfolded: ";

Vector3 area_vector(const std::vector<Vector3>& positions, std::span<const Index> face) {
  return (positions[face[1]] - positions[face[0]]).cross(positions[face[2]] - positions[face[0]]);
}

/// Its height is nothing against its longest edge.
bool degenerate(const std::vector<Vector3>& positions, std::span<const Index> face) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (positions[face[(k + 1) % 3]] - positions[face[k]]).norm());
  return !(area_vector(positions, face).norm() > 1e-12 * longest * longest);
}

std::string edge_text(Index low, Index high, std::span<const EdgeUse> uses) {
  const std::string name = "(" + std::to_string(low) + "," + std::to_string(high) + ")";
  if (uses.size() == 2)
    return std::string(refusal) + "the two facets at edge " + name + " face opposite ways.";
  return std::string(refusal) + "non-manifold edge: " + std::to_string(uses.size()) + " facets share edge " +
         name + ".";
}

/// Errors of facets by themselves; 1 for every face whose edges can be judged.
std::vector<char> report_facets(const PolygonMesh& mesh, std::size_t limit, std::vector<Message>& out) {
  const std::vector<char> sound = sound_faces(mesh);
  const auto name = [](std::size_t f) { return element_of(FaceId{static_cast<Index>(f)}); };
  MessageGroup sides(out, Severity::error, e_facet_not_triangular,
                     "Triangulate the mesh before it is unfolded.", limit);
  for (std::size_t f = 0; f < sound.size(); ++f)
    if (sound[f] && mesh.face(f).size() != 3)
      sides.add(name(f), [&] { return refusal + ("facet " + std::to_string(f)) + " is not triangular."; });
  return sound;
}

void report_degenerate(const PolygonMesh& mesh, const std::vector<char>& sound, std::size_t limit,
                       std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_facet_degenerate,
                     "Remove the facet, or merge the vertices that lie on one line.", limit);
  for (std::size_t f = 0; f < sound.size(); ++f)
    if (sound[f] && mesh.face(f).size() == 3 && degenerate(mesh.positions, mesh.face(f)))
      group.add(element_of(FaceId{static_cast<Index>(f)}),
                [&] { return refusal + ("degenerate facet " + std::to_string(f)) + " has zero area."; });
}

void report_edges(const PolygonMesh& mesh, const std::vector<char>& sound, std::size_t limit,
                  std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_edge_nonmanifold_or_flipped,
                     "Repair the orientation, or split the non-manifold edges.", limit);
  EdgeTable(mesh, sound).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (!is_manifold_edge(mesh, uses))
      group.add(element_of(EdgeId{{low}, {high}}), [&] { return edge_text(low, high, uses); });
  });
}

/// Faults that other parts of the program name too; faults at vertices do not matter here.
void report_polygons(const PolygonMesh& mesh, std::size_t limit, std::vector<Message>& out) {
  for (Message& message : connectivity_errors(mesh, limit))
    if (message.code == e_no_faces || message.code == e_index_range || message.code == e_face_too_small ||
        message.code == e_face_repeated_vertex)
      out.push_back(std::move(message));
}

double signed_fold_angle(const Vector3& first, const Vector3& second, const Vector3& direction) {
  return std::atan2(direction.dot(first.cross(second)), first.dot(second));
}

}  // namespace

std::vector<Message> unfolding_errors(const PolygonMesh& mesh, std::size_t limit) {
  std::vector<Message> out = position_errors(mesh, limit);
  if (!out.empty()) return out;
  report_polygons(mesh, limit, out);
  const std::vector<char> sound = report_facets(mesh, limit, out);
  report_degenerate(mesh, sound, limit, out);
  report_edges(mesh, sound, limit, out);
  return out;
}

Result<FacetGraph> FacetGraph::build(const PolygonMesh& mesh) {
  if (auto errors = unfolding_errors(mesh, 1); !errors.empty()) return std::move(errors.front());
  FacetGraph out;
  out.positions_ = mesh.positions;
  out.triangles_.resize(mesh.face_count());
  out.edges_of_.resize(mesh.face_count());
  out.areas_.resize(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::copy_n(mesh.face(f).begin(), 3, out.triangles_[f].begin());
    out.areas_[f] = 0.5 * area_vector(out.positions_, out.triangles_[f]).norm();
  }
  EdgeTable(mesh).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    FacetEdge edge{low, high};
    edge.length = (out.positions_[high] - out.positions_[low]).norm();
    for (std::size_t k = 0; k < uses.size(); ++k) {
      edge.facets[k] = uses[k].corner / 3;
      edge.sides[k] = uses[k].corner % 3;
      out.edges_of_[edge.facets[k]][edge.sides[k]] = static_cast<Index>(out.edges_.size());
    }
    if (!edge.border()) {
      const auto& corners = out.triangles_[edge.facets[0]];
      const Vector3 along =
          out.positions_[corners[(edge.sides[0] + 1) % 3]] - out.positions_[corners[edge.sides[0]]];
      edge.fold_angle =
          signed_fold_angle(out.normal(edge.facets[0]), out.normal(edge.facets[1]), along / edge.length);
    }
    out.longest_edge_ = std::max(out.longest_edge_, edge.length);
    out.edges_.push_back(edge);
  });
  out.find_components();
  return out;
}

void FacetGraph::find_components() {
  component_of_.assign(facet_count(), no_index);
  std::vector<Index> stack;
  for (Index seed = 0; seed < facet_count(); ++seed) {
    if (component_of_[seed] != no_index) continue;
    component_of_[seed] = static_cast<Index>(component_count_);
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index facet = stack.back();
      stack.pop_back();
      for (Index side = 0; side < 3; ++side) {
        const Index next = neighbour(facet, side);
        if (next == no_index || component_of_[next] != no_index) continue;
        component_of_[next] = static_cast<Index>(component_count_);
        stack.push_back(next);
      }
    }
    ++component_count_;
  }
}

Index FacetGraph::mate_side(Index facet, Index side) const {
  const FacetEdge& edge = edges_[edges_of_[facet][side]];
  return edge.facets[0] == facet ? edge.sides[1] : edge.sides[0];
}

Index FacetGraph::find_edge(Index a, Index b) const {
  const std::pair<Index, Index> wanted = std::minmax(a, b);
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), wanted,
                       [](const auto& edge, const auto& w) { return std::pair(edge.low, edge.high) < w; });
  return found != edges_.end() && std::pair(found->low, found->high) == wanted
             ? static_cast<Index>(found - edges_.begin())
             : no_index;
}

double FacetGraph::total_area() const {
  double sum = 0;
  for (const double area : areas_) sum += area;
  return sum;
}

Vector3 FacetGraph::normal(Index facet) const {
  return area_vector(positions_, triangles_[facet]).normalized();
}

PolygonMesh polygons_of(const TriangleMesh& mesh) {
  PolygonMesh out;
  out.positions.reserve(mesh.positions.size());
  for (const Vector3& position : mesh.positions) out.positions.push_back(mesh.origin + position);
  for (const auto& triangle : mesh.triangles) out.add_face(triangle);
  return out;
}

}  // namespace hariko
