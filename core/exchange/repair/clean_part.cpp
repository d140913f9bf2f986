#include "core/exchange/repair/clean_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/t_joints.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

/// Text of a non-negative length, three digits, rounded up: used as a tolerance, it still reaches as far.
std::string length_text(double length) {
  std::string text = rounded_text(length, 3);
  double told = 0;
  if (parse_real(text, told) == NumberStatus::ok && told < length)
    text = rounded_text(length + 0.5 * std::pow(10.0, std::floor(std::log10(length)) - 2), 3);
  return text;
}

/// Replaces the part's mesh and renumbers its creases and corners.
void take(TidyMesh tidy, ImportedPart& part) {
  part.mesh = std::move(tidy.mesh);
  const auto number = [&](Index v) { return v < tidy.vertex_of.size() ? tidy.vertex_of[v] : no_index; };
  for (auto& [a, b] : part.creases) {
    a = number(a);
    b = number(b);
  }
  std::erase_if(part.creases, [](const auto& crease) { return crease[0] == crease[1]; });
  for (Index& v : part.corners) v = number(v);
}

/// Removes vertices that only dropped faces used; vertices that no face used before stay.
void remove_left_over(const std::vector<char>& used_before, ImportedPart& part) {
  std::vector<char> used(part.mesh.positions.size(), 0);
  for (const Index v : part.mesh.face_vertices)
    if (v < used.size()) used[v] = 1;
  TidyMesh out;
  for (Index v = 0; v < used.size(); ++v) {
    const bool keep = used[v] || v >= used_before.size() || !used_before[v];
    out.vertex_of.push_back(keep ? static_cast<Index>(out.mesh.positions.size()) : no_index);
    if (keep) out.mesh.positions.push_back(part.mesh.positions[v]);
  }
  if (out.mesh.positions.size() == used.size()) return;
  out.mesh.face_offsets = part.mesh.face_offsets;
  for (const Index v : part.mesh.face_vertices)
    out.mesh.face_vertices.push_back(v < used.size() ? out.vertex_of[v] : v);
  take(std::move(out), part);
}

/// Whether every corner has a vertex of its own: no two faces hang together.
bool is_loose(const PolygonMesh& mesh) {
  if (mesh.face_count() < 2) return false;
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Index v : mesh.face_vertices)
    if (v >= used.size() || std::exchange(used[v], 1)) return false;
  return true;
}

/// Counts the corners that are near others and are not joined. Where all faces are loose the mesh is no
/// surface as it is, and corners farther apart count too, but by no more than a tenth of the edges.
void count_near(const PolygonMesh& mesh, double tolerance, CleanReport& report) {
  NearCorners near = near_corners(mesh, tolerance);
  if (is_loose(mesh)) {
    const double distance = std::min(loose_joining_distance * used_size(mesh), 0.1 * median_side(mesh));
    const NearCorners farther = near_corners(mesh, std::max(distance, tolerance));
    if (farther.count > near.count) {
      near = farther;
      report.tolerance = std::max(report.tolerance, (1 + 1e-6) * near.farthest);  // reaches as far
      report.loose = true;
    }
  }
  report.near += near.count;
  report.near_farthest = std::max(report.near_farthest, near.farthest);
}

/// Lets creases run along the parts of edges that are split.
void split_creases(const std::vector<TJoint>& joints, ImportedPart& part) {
  if (part.creases.empty()) return;
  const PolygonMesh& mesh = part.mesh;
  std::map<std::array<Index, 2>, std::vector<Index>> chains;  // by the ends of the edges
  for (const TJoint& joint : joints) {
    const auto end = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), joint.corner);
    const Index next = joint.corner + 1 == *end ? *(end - 1) : joint.corner + 1;
    std::vector<Index> chain{mesh.face_vertices[joint.corner]};
    chain.insert(chain.end(), joint.between.begin(), joint.between.end());
    chain.push_back(mesh.face_vertices[next]);
    const std::array<Index, 2> ends{std::min(chain.front(), chain.back()),
                                    std::max(chain.front(), chain.back())};
    chains[ends] = std::move(chain);
  }
  std::vector<std::array<Index, 2>> creases;
  for (const auto& crease : part.creases) {
    const auto found = chains.find({std::min(crease[0], crease[1]), std::max(crease[0], crease[1])});
    if (found == chains.end()) {
      creases.push_back(crease);
      continue;
    }
    const std::vector<Index>& chain = found->second;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) creases.push_back({chain[k], chain[k + 1]});
  }
  part.creases = std::move(creases);
}

/// Counts the corners on edges of other faces; with `split` the edges are split there.
void mend_t_joints(double tolerance, bool split, ImportedPart& part, CleanReport& report) {
  const std::vector<TJoint> joints = find_t_joints(part.mesh, tolerance);
  std::size_t corners = 0;
  for (const TJoint& joint : joints) corners += joint.between.size();
  (split ? report.split_edges : report.on_edges) += corners;
  if (!split || corners == 0) return;
  split_creases(joints, part);
  part.mesh = with_split_edges(part.mesh, joints);
}

/// Separates bodies that share corners where they touch. Marks go along to the copies.
void separate(ImportedPart& part, CleanReport& report) {
  if (part.mesh.face_count() == 0) return;
  auto bodies = separate_bodies(part.mesh);
  if (!bodies) return;
  report.apart += bodies->original.size() - part.mesh.positions.size();
  std::vector<std::array<Index, 2>> creases;
  for (auto& [a, b] : part.creases)
    if (a > b) std::swap(a, b);
  std::sort(part.creases.begin(), part.creases.end());
  for (std::size_t f = 0; !part.creases.empty() && f < bodies->mesh.face_count(); ++f) {
    const auto face = bodies->mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Index v = face[k], w = face[(k + 1) % face.size()];
      const auto [low, high] = std::minmax(bodies->original[v], bodies->original[w]);
      if (std::binary_search(part.creases.begin(), part.creases.end(), std::array<Index, 2>{low, high}))
        creases.push_back({std::min(v, w), std::max(v, w)});
    }
  }
  sort_unique(creases);
  part.creases = std::move(creases);
  std::sort(part.corners.begin(), part.corners.end());
  const auto before = static_cast<Index>(part.mesh.positions.size());
  std::vector<Index> copies;
  for (Index v = before; v < bodies->original.size(); ++v)
    if (std::binary_search(part.corners.begin(), part.corners.end(), bodies->original[v]))
      copies.push_back(v);
  part.corners.insert(part.corners.end(), copies.begin(), copies.end());
  part.mesh = std::move(bodies->mesh);
}

}  // namespace

void clean(ImportedPart& part, const JoinChoice& choice, CleanReport& report) {
  const double usual = joining_distance(part.mesh);
  const double tolerance = choice.near ? choice.distance.value_or(usual) : usual;
  report.tolerance = std::max(report.tolerance, tolerance);
  ++report.meshes;
  std::vector<char> used(part.mesh.positions.size(), 0);
  for (const Index v : part.mesh.face_vertices)
    if (v < used.size()) used[v] = 1;
  CutKeyholes whole = cut_keyholes(std::move(part.mesh));
  part.mesh = std::move(whole.mesh);
  report.keyholes += whole.cut;
  const auto join = [&](double distance) {
    TidyMesh joined = join_corners(part.mesh, distance);
    report.joined += joined.joined;
    report.keyholes += joined.keyholes;
    report.collapsed += joined.collapsed;
    report.farthest = std::max(report.farthest, joined.farthest);
    std::vector<char> now(joined.mesh.positions.size(), 0);
    for (Index v = 0; v < used.size(); ++v)
      if (used[v] && joined.vertex_of[v] != no_index) now[joined.vertex_of[v]] = 1;
    used = std::move(now);
    const std::size_t count = joined.joined;
    take(std::move(joined), part);
    return count;
  };
  join(0);
  if (choice.near)
    report.near_joined += join(tolerance);
  else
    count_near(part.mesh, tolerance, report);
  TidyMesh flat = drop_flat_triangles(part.mesh);
  report.flat += flat.flat;
  take(std::move(flat), part);
  if (report.flat + report.collapsed > 0) remove_left_over(used, part);
  mend_t_joints(tolerance, choice.near || choice.split_edges, part, report);
  separate(part, report);
}

std::vector<Message> CleanReport::messages() const {
  std::vector<Message> out;
  // The tolerance of a large mesh would ruin small ones beside it.
  const bool each_own = meshes > 1 && !loose;
  if (joined > 0 && near_joined == 0)
    out.push_back(make_warning(w_corners_joined,
                               counted(joined, " corner at the same place as another one was joined with it.",
                                       " corners at the same places as others were joined with them.")));
  if (near_joined > 0)
    out.push_back(make_warning(
        w_corners_joined,
        counted(joined, " corner was joined with another one", " corners were joined with others") + ", " +
            std::to_string(near_joined) + " of them up to " + length_text(farthest) + " apart (tolerance " +
            length_text(tolerance) + ")."));
  if (near > 0)
    out.push_back(make_warning(w_near_corners,
                               counted(near, " corner lies nearly at the same place as another one",
                                       " corners lie nearly at the same places as others") +
                                   ", up to " + length_text(near_farthest) +
                                   " apart: the surface is open between them.",
                               "Join them while opening the file (--weld" +
                                   (each_own ? std::string() : " " + length_text(tolerance)) + ")."));
  if (collapsed > 0)
    out.push_back(make_warning(w_degenerate_triangles,
                               counted(collapsed, " face with corners at the same place was left out.",
                                       " faces with corners at the same place were left out.")));
  if (flat > 0)
    out.push_back(make_warning(w_flat_triangles, counted(flat, " flat triangle along an edge was left out.",
                                                         " flat triangles along edges were left out.")));
  if (keyholes > 0)
    out.push_back(make_warning(w_keyholes, counted(keyholes, " face with a hole was cut into faces without.",
                                                   " faces with holes were cut into faces without.")));
  if (apart > 0)
    out.push_back(make_warning(w_bodies_apart,
                               counted(apart, " corner was doubled where bodies touch, which stay apart.",
                                       " corners were doubled where bodies touch, which stay apart.")));
  if (on_edges > 0)
    out.push_back(
        make_warning(w_t_joints,
                     counted(on_edges, " corner lies on an edge of another face: the surface is open there.",
                             " corners lie on edges of other faces: the surface is open there."),
                     "Split those edges while opening the file (--repair)."));
  if (split_edges > 0)
    out.push_back(make_warning(
        w_t_joints, counted(split_edges, " edge was split where a corner of another face lies on it.",
                            " edges were split where corners of other faces lie on them.")));
  return out;
}

}  // namespace hariko
