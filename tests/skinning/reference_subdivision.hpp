#pragma once

// Catmull and Clark's rules written out plainly, with creases, corners and the limit masks: what the surfaces
// of core/skinning are checked against. Keeps where every corner of every face lies in a patch.

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/subdivision/control_mesh.hpp"

namespace hariko::test {

struct ReferenceMesh {
  struct Face {
    std::vector<Index> vertices;
    Index patch = no_index;              ///< once known
    std::array<Vector2, 4> parameter{};  ///< parameters of its corners in the patch
  };
  using Edge = std::pair<Index, Index>;
  static Edge edge(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  std::vector<Vector3> points;
  std::vector<Face> faces;
  std::map<Edge, double> sharpness;
  std::map<Index, double> corner;

  explicit ReferenceMesh(const ControlMesh& control) : points(control.mesh.positions) {
    const bool cut = !control.all_quads();
    for (std::size_t f = 0; f < control.mesh.face_count(); ++f) {
      const auto face = control.mesh.face(f);
      Face made{{face.begin(), face.end()}, no_index, {}};
      if (!cut) {
        made.patch = Index(f);
        made.parameter = {Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 1)};
      }
      faces.push_back(made);
    }
    for (const auto& c : control.creases) sharpness[edge(c.a, c.b)] = c.sharpness;
    for (const auto& c : control.corners) corner[c.vertex] = c.sharpness;
  }

  struct Around {
    std::vector<Index> faces;
    std::vector<Index> neighbours;                ///< along edges
    std::vector<Index> boundary;                  ///< neighbours along edges with one face
    std::vector<std::pair<Index, double>> sharp;  ///< neighbours along sharp or boundary edges
  };
  std::vector<Around> rings() const {
    std::vector<Around> out(points.size());
    std::map<Edge, int> uses;
    for (const Face& f : faces)
      for (std::size_t i = 0; i < f.vertices.size(); ++i)
        ++uses[edge(f.vertices[i], f.vertices[(i + 1) % f.vertices.size()])];
    for (Index f = 0; f < faces.size(); ++f)
      for (const Index v : faces[f].vertices) out[v].faces.push_back(f);
    for (const auto& [e, count] : uses) {
      const auto found = sharpness.find(e);
      const double s = count == 1 ? infinitely_sharp : found == sharpness.end() ? 0 : found->second;
      for (const auto& [v, w] : {e, Edge(e.second, e.first)}) {
        out[v].neighbours.push_back(w);
        if (count == 1) out[v].boundary.push_back(w);
        if (s > 0) out[v].sharp.emplace_back(w, s);
      }
    }
    return out;
  }
  bool fixed(Index v, const Around& around) const {
    const auto found = corner.find(v);
    return (found != corner.end() && found->second > 0) || around.sharp.size() > 2 ||
           around.faces.size() == 1;
  }

  /// Semi-sharp rules for integer sharpness: a sharp rule until the sharpness is used up.
  ReferenceMesh subdivided() const {
    ReferenceMesh out = *this;
    out.faces.clear(), out.sharpness.clear(), out.corner.clear();
    const std::vector<Around> ring = rings();
    std::vector<Vector3> centre;
    for (const Face& f : faces) {
      Vector3 sum = Vector3::Zero();
      for (const Index v : f.vertices) sum += points[v];
      centre.push_back(sum / double(f.vertices.size()));
    }
    std::map<Edge, std::vector<Index>> edge_faces;
    for (Index f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < faces[f].vertices.size(); ++i)
        edge_faces[edge(faces[f].vertices[i], faces[f].vertices[(i + 1) % faces[f].vertices.size()])]
            .push_back(f);
    for (Index v = 0; v < points.size(); ++v) {
      const Around& a = ring[v];
      const double n = double(a.faces.size());
      if (fixed(v, a)) continue;
      if (a.sharp.size() == 2) {
        out.points[v] = (points[a.sharp[0].first] + 6 * points[v] + points[a.sharp[1].first]) / 8;
        continue;
      }
      Vector3 faces_sum = Vector3::Zero(), edges_sum = Vector3::Zero();
      for (const Index f : a.faces) faces_sum += centre[f];
      for (const Index w : a.neighbours) edges_sum += points[w];
      out.points[v] = (faces_sum / n + edges_sum / n + (n - 2) * points[v]) / n;
    }
    for (const auto& [v, s] : corner) out.corner[v] = s >= infinitely_sharp ? s : std::max(0.0, s - 1);
    std::map<Edge, Index> middle;
    for (const auto& [e, list] : edge_faces) {
      const auto found = sharpness.find(e);
      const double s = found == sharpness.end() ? 0 : found->second;
      Vector3 point = (points[e.first] + points[e.second]) / 2;
      if (list.size() == 2 && s < 1) {
        const Vector3 smooth = (points[e.first] + points[e.second] + centre[list[0]] + centre[list[1]]) / 4;
        point = smooth + s * (point - smooth);
      }
      middle[e] = Index(out.points.size());
      out.points.push_back(point);
      const double next = s >= infinitely_sharp ? s : std::max(0.0, s - 1);
      if (next > 0) {
        out.sharpness[edge(e.first, middle[e])] = next;
        out.sharpness[edge(e.second, middle[e])] = next;
      }
    }
    Index patch = 0;
    for (Index f = 0; f < faces.size(); ++f) {
      const Face& face = faces[f];
      const Index c = Index(out.points.size());
      out.points.push_back(centre[f]);
      const std::size_t n = face.vertices.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Index v = face.vertices[i];
        Face made;
        made.vertices = {v, middle[edge(v, face.vertices[(i + 1) % n])], c,
                         middle[edge(face.vertices[(i + n - 1) % n], v)]};
        if (face.patch == no_index) {
          made.patch = patch++;
          made.parameter = {Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 1)};
        } else {
          const auto& p = face.parameter;
          made.patch = face.patch;
          made.parameter = {p[i], (p[i] + p[(i + 1) % 4]) / 2, (p[0] + p[2]) / 2,
                            (p[i] + p[(i + 3) % 4]) / 2};
        }
        out.faces.push_back(made);
      }
    }
    return out;
  }

  /// Limit positions by the masks of all-quad meshes whose creases are infinitely sharp.
  std::vector<Vector3> limits() const {
    std::vector<Vector3> out = points;
    const std::vector<Around> ring = rings();
    for (Index v = 0; v < points.size(); ++v) {
      const Around& a = ring[v];
      if (a.faces.empty() || fixed(v, a)) continue;
      if (a.sharp.size() == 2) {
        out[v] = (points[a.sharp[0].first] + 4 * points[v] + points[a.sharp[1].first]) / 6;
        continue;
      }
      const double n = double(a.faces.size());
      Vector3 sum = n * n * points[v];
      for (const Index w : a.neighbours) sum += 4 * points[w];
      for (const Index f : a.faces) {
        const auto& q = faces[f].vertices;
        for (std::size_t i = 0; i < 4; ++i)
          if (q[i] == v) sum += points[q[(i + 2) % 4]];
      }
      out[v] = sum / (n * (n + 5));
    }
    return out;
  }
};

}  // namespace hariko::test
