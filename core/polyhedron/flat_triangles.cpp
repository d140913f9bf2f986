#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index_list.hpp"
#include "core/polyhedron/join_corners.hpp"

namespace hariko {

namespace {

constexpr double flat_height = 1e-6;  ///< height of a flat triangle, relative to its longest side

using Edge = std::pair<Index, Index>;  ///< low vertex first
Edge edge_of(Index a, Index b) {
  return std::minmax(a, b);
}

/// Removal of flat triangles from faces kept as editable lists.
class FlatRemover {
 public:
  explicit FlatRemover(const PolygonMesh& mesh) : mesh_(mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      if (is_flat(mesh.face(f))) flat_.insert(f);
  }
  bool nothing_to_do() const { return flat_.empty(); }

  TidyMesh run() {
    TidyMesh out;
    index_faces();
    for (bool changed = true; changed;) {
      changed = false;
      for (auto f = flat_.begin(); f != flat_.end();) {
        if (!drop(*f) && !turn(*f)) {
          ++f;
          continue;
        }
        f = flat_.erase(f);
        ++out.flat;
        changed = true;
      }
    }
    out.mesh.positions = mesh_.positions;
    for (const auto& face : faces_)
      if (!face.empty()) out.mesh.add_face(face);
    return out;
  }

 private:
  /// Middle corner of a flat triangle: the corner that nearly lies on the longest side; nothing for other
  /// faces.
  std::optional<std::size_t> middle_of(std::span<const Index> face) const {
    if (face.size() != 3) return {};
    std::array<Vector3, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      if (face[k] >= mesh_.positions.size() || face[k] == face[(k + 1) % 3]) return {};
      at[k] = mesh_.positions[face[k]];
    }
    std::size_t middle = 0;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (const double length = (at[(k + 2) % 3] - at[(k + 1) % 3]).norm(); length > longest)
        longest = length, middle = k;
    const Vector3 side = at[(middle + 2) % 3] - at[(middle + 1) % 3];
    const double height = (at[middle] - at[(middle + 1) % 3]).cross(side).norm() / longest;
    return longest > 0 && height <= flat_height * longest ? std::optional(middle) : std::nullopt;
  }
  bool is_flat(std::span<const Index> face) const { return middle_of(face).has_value(); }

  void index_faces() {
    faces_.resize(mesh_.face_count());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      faces_[f].assign(mesh_.face(f).begin(), mesh_.face(f).end());
      enter(f, true);
    }
  }
  void enter(std::size_t f, bool present) {
    const auto& face = faces_[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      auto& users = users_[edge_of(face[k], face[(k + 1) % face.size()])];
      if (present)
        users.push_back(f);
      else
        users.erase(std::find(users.begin(), users.end(), f));
    }
  }
  bool runs(std::size_t f, Index from, Index to) const {
    const auto& face = faces_[f];
    for (std::size_t k = 0; k < face.size(); ++k)
      if (face[k] == from && face[(k + 1) % face.size()] == to) return true;
    return false;
  }
  /// Other faces at an edge of a face, at most three of them: an edge with so many is not repaired.
  std::vector<std::size_t> others(std::size_t f, Index a, Index b) const {
    std::vector<std::size_t> out;
    for (const std::size_t user : users_.at(edge_of(a, b))) {
      if (user != f) out.push_back(user);
      if (out.size() == 3) break;
    }
    return out;
  }

  /// Drops a triangle where its edges remain manifold without it; false where they would not.
  bool drop(std::size_t f) {
    const auto face = faces_[f];
    std::size_t fitting = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k], b = face[(k + 1) % 3];
      const auto rest = others(f, a, b);
      if (rest.empty()) continue;
      if (rest.size() != 2 || runs(rest[0], a, b) == runs(rest[1], a, b)) return false;
      ++fitting;
    }
    if (fitting == 0) return false;  // an isolated triangle is kept
    enter(f, false);
    faces_[f].clear();
    return true;
  }

  /// Turns a triangle that fills a T-joint: the face across its longest side gets its middle corner.
  bool turn(std::size_t f) {
    const auto face = faces_[f];
    const std::size_t k = *middle_of(face);
    const Index m = face[k], b = face[(k + 1) % 3], a = face[(k + 2) % 3];  // a, m, b along the line
    const auto rest = others(f, a, b);
    if (rest.size() != 1 || flat_.contains(rest[0]) || !runs(rest[0], a, b)) return false;
    const std::size_t other = rest[0];
    auto& neighbour = faces_[other];
    if (std::find(neighbour.begin(), neighbour.end(), m) != neighbour.end()) return false;
    enter(f, false);
    enter(other, false);
    const auto at =
        static_cast<std::size_t>(std::find(neighbour.begin(), neighbour.end(), a) - neighbour.begin());
    if (neighbour.size() == 3) {
      const Index c = neighbour[(at + 2) % 3];
      neighbour = {a, m, c};
      faces_[f] = {m, b, c};
      enter(f, true);
    } else {
      neighbour.insert(neighbour.begin() + static_cast<std::ptrdiff_t>(at) + 1, m);
      faces_[f].clear();
    }
    enter(other, true);
    return true;
  }

  const PolygonMesh& mesh_;
  std::set<std::size_t> flat_;
  std::vector<std::vector<Index>> faces_;
  std::map<Edge, std::vector<std::size_t>> users_;
};

}  // namespace

TidyMesh drop_flat_triangles(const PolygonMesh& mesh) {
  FlatRemover remover(mesh);
  TidyMesh out;
  if (remover.nothing_to_do())
    out.mesh = mesh;
  else
    out = remover.run();
  out.vertex_of = ascending_indices(mesh.positions.size());
  return out;
}

}  // namespace hariko
