#include "core/polyhedron/join_corners.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/near_vertices.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

bool is_sound(const PolygonMesh& mesh) {
  return connectivity_errors(mesh, 1).empty();
}

/// Vertices whose edges do not all have exactly two consistently oriented faces: 1 for those, 0 where faces
/// close round a vertex. `loose` becomes true when every edge has one face only.
std::vector<char> open_vertices(const PolygonMesh& mesh, bool& loose) {
  std::vector<char> out(mesh.positions.size(), 0);
  loose = true;
  const std::vector<char> sound = sound_faces(mesh);
  EdgeTable(mesh, sound).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    loose = loose && uses.size() == 1;
    if (uses.size() != 2 || !is_manifold_edge(mesh, uses)) out[low] = out[high] = 1;
  });
  for (std::size_t f = 0; f < sound.size(); ++f)
    for (const Index v : mesh.face(f))
      if (!sound[f] && v < out.size()) out[v] = 1;
  return out;
}

/// Target of each vertex: itself, or for an open vertex the first open vertex near it.
std::vector<Index> targets_of(const PolygonMesh& mesh, double distance, bool& loose) {
  std::vector<Index> out = ascending_indices(mesh.positions.size());
  const std::vector<Index> all = representatives(mesh.positions, distance);
  if (all == out) return out;  // the usual case
  const std::vector<char> open = open_vertices(mesh, loose);
  std::vector<Index> numbers;
  std::vector<Vector3> points;
  for (Index v = 0; v < open.size(); ++v)
    if (open[v] && mesh.positions[v].allFinite()) {
      numbers.push_back(v);
      points.push_back(mesh.positions[v]);
    }
  const std::vector<Index> near = representatives(points, distance);
  for (std::size_t k = 0; k < near.size(); ++k) out[numbers[k]] = numbers[near[k]];
  return out;
}

/// Corners without consecutive repetitions, which joined neighbours leave. Empty where fewer than three
/// remain.
std::vector<Index> without_repeats(std::vector<Index> corners) {
  remove_repeats(corners);
  if (corners.size() < 3) corners.clear();
  return corners;
}

/// Mesh with all corners moved to their targets, without the vertices that are no longer used.
TidyMesh moved_to(const PolygonMesh& mesh, const std::vector<Index>& target) {
  TidyMesh out;
  out.vertex_of.assign(target.size(), no_index);
  for (Index v = 0; v < target.size(); ++v) {
    if (target[v] == v) {
      out.vertex_of[v] = static_cast<Index>(out.mesh.positions.size());
      out.mesh.positions.push_back(mesh.positions[v]);
      continue;
    }
    ++out.joined;
    out.vertex_of[v] = out.vertex_of[target[v]];  // targets come first
    out.farthest = std::max(out.farthest, (mesh.positions[v] - mesh.positions[target[v]]).norm());
  }
  std::vector<Index> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const bool in_range =
        std::all_of(face.begin(), face.end(), [&](Index v) { return v < out.vertex_of.size(); });
    corners.assign(face.begin(), face.end());
    if (in_range && face.size() >= 3) {
      for (Index& v : corners) v = out.vertex_of[v];
      corners = without_repeats(std::move(corners));
      if (corners.empty()) {
        ++out.collapsed;
        continue;
      }
    } else {  // kept for `validate`, which reports it
      for (Index& v : corners) v = v < out.vertex_of.size() ? out.vertex_of[v] : no_index;
    }
    out.mesh.add_face(corners);
  }
  return out;
}

}  // namespace

double used_size(const PolygonMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Index v : mesh.face_vertices)
    if (v < mesh.positions.size() && mesh.positions[v].allFinite()) box.extend(mesh.positions[v]);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

double median_side(const PolygonMesh& mesh) {
  constexpr std::size_t sample = 65'536;
  const std::size_t step = mesh.face_vertices.size() / sample + 1;
  std::vector<double> lengths;
  std::size_t f = 0;
  for (std::size_t h = 0; h < mesh.face_vertices.size(); h += step) {
    while (h >= mesh.face_offsets[f + 1]) ++f;
    const std::size_t next = h + 1 == mesh.face_offsets[f + 1] ? mesh.face_offsets[f] : h + 1;
    const Index a = mesh.face_vertices[h], b = mesh.face_vertices[next];
    if (std::max(a, b) >= mesh.positions.size()) continue;
    const double length = (mesh.positions[b] - mesh.positions[a]).norm();
    if (length > 0 && std::isfinite(length)) lengths.push_back(length);
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double joining_distance(const PolygonMesh& mesh) {
  constexpr double share = 0.1;  // share of the median side
  const double usual = usual_joining_distance * used_size(mesh), side = median_side(mesh);
  return side > 0 ? std::min(usual, share * side) : usual;
}

TidyMesh join_corners(const PolygonMesh& mesh, double distance) {
  bool loose = false;
  const std::vector<Index> itself = ascending_indices(mesh.positions.size()),
                           target = targets_of(mesh, distance, loose);
  TidyMesh joined = moved_to(mesh, target);
  if (joined.joined == 0) return joined;
  CutKeyholes whole =
      cut_keyholes(std::move(joined.mesh));  // the two sides of a bridge had vertices of their own
  joined.keyholes = whole.cut;
  joined.mesh = std::move(whole.mesh);
  if (is_sound(joined.mesh)) return joined;
  TidyMesh apart = moved_to(mesh, itself);
  if (!is_sound(apart.mesh)) return joined;
  // Bodies that touch, and fans that touch in a point only, get separate vertices again; the positions are
  // equal, so the choice does not matter.
  if (auto bodies = separate_bodies(joined.mesh)) {
    joined.joined -= std::min(joined.joined, bodies->original.size() - joined.mesh.positions.size());
    joined.mesh = std::move(bodies->mesh);
    return joined;
  }
  return loose ? joined : apart;
}

NearCorners near_corners(const PolygonMesh& mesh, double distance) {
  const TidyMesh joined = join_corners(mesh, distance);
  return {joined.joined, joined.farthest};
}

}  // namespace hariko
