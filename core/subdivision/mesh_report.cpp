#include "core/subdivision/mesh_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "core/base/solvers/dense_solver.hpp"
#include "core/base/solvers/sparse_solver.hpp"
#include "core/geometry/edge_key.hpp"

namespace hariko {

ControlMeshFigures figures(const PolygonMesh& mesh) {
  ControlMeshFigures out;
  out.vertices = int(mesh.positions.size());
  out.faces = int(mesh.face_count());
  std::map<std::pair<Index, Index>, int> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    ++(face.size() == 4 ? out.quads : face.size() == 3 ? out.triangles : out.polygons);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  out.edges = int(edges.size());
  out.euler = out.vertices - out.edges + out.faces;
  std::vector<int> valence(mesh.positions.size()), boundary(mesh.positions.size()),
      faces(mesh.positions.size());
  for (const Index v : mesh.face_vertices) ++faces[v];
  for (const auto& [edge, count] : edges) {
    out.nonmanifold_edges += count > 2;
    for (const Index v : {edge.first, edge.second}) ++valence[v], boundary[v] += count == 1;
  }
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0) continue;
    out.boundary_vertices += boundary[v] > 0;
    const bool regular = boundary[v] > 0 ? valence[v] == 3 || faces[v] == 1 : valence[v] == 4;
    if (!regular) ++out.extraordinary[(boundary[v] > 0 ? "b" : "i") + std::to_string(valence[v])];
  }
  return out;
}

std::size_t regular_face_count(const ControlMesh& control) {
  const PolygonMesh& mesh = control.mesh;
  std::unordered_set<std::uint64_t> half_edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i)
      half_edges.insert(half_edge_key(face[i], face[(i + 1) % face.size()]));
  }
  struct Ring {
    int faces = 0, borders = 0;
    bool quads = true, sharp = false, corner = false;
  };
  std::vector<Ring> rings(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      Ring& ring = rings[face[i]];
      ++ring.faces;
      ring.quads = ring.quads && face.size() == 4;
      const Index next = face[(i + 1) % face.size()];
      if (!half_edges.contains(half_edge_key(next, face[i]))) ++ring.borders, ++rings[next].borders;
    }
  }
  for (const auto& crease : control.creases) rings[crease.a].sharp = rings[crease.b].sharp = true;
  for (const auto& corner : control.corners) rings[corner.vertex].corner = true;
  const auto is_regular = [&](Index v) {
    const Ring& ring = rings[v];
    const bool inside = ring.borders == 0 && ring.faces == 4 && !ring.corner;
    const bool border = ring.borders == 2 && (ring.faces == 1 || (ring.faces == 2 && !ring.corner));
    return ring.quads && !ring.sharp && (inside || border);
  };
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    count += mesh.face(f).size() == 4 && std::all_of(mesh.face(f).begin(), mesh.face(f).end(), is_regular);
  return count;
}

namespace {

SparseMatrix limit_matrix(const SubdivisionTopology& topology) {
  const auto n = Eigen::Index(topology.mesh().mesh.positions.size());
  SparseEntries entries;
  for (Index v = 0; v < Index(n); ++v) {
    const Index node = topology.vertex_node(v);
    if (node == no_index) {
      entries.emplace_back(v, v, 1.0);
      continue;
    }
    const auto& owner = topology.node_owner(node);
    const auto weights =
        topology.weights(owner.patch, corner_parameter(Domain::square, owner.corner), Order::first).value;
    const auto controls = topology.controls(owner.patch);
    for (std::size_t k = 0; k < controls.size(); ++k)
      if (weights[k] != 0) entries.emplace_back(v, controls[k], weights[k]);
  }
  return sparse_matrix(n, n, entries);
}

/// Largest eigenvalue of a symmetric positive operator, by iteration.
template <class Apply>
double largest_eigenvalue(Eigen::Index n, const Apply& apply) {
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = std::sin(1.0 + double(i) * 0.7);
  double value = 0;
  for (int round = 0; round < 2000; ++round) {
    x.normalize();
    Eigen::VectorXd next = apply(x);
    const double got = x.dot(next);
    x = std::move(next);
    if (std::abs(got - value) <= 1e-9 * got) return got;
    value = got;
  }
  return value;
}

}  // namespace

double limit_condition(const SubdivisionTopology& topology) {
  const SparseMatrix matrix = limit_matrix(topology);
  if (matrix.rows() <= 600) {
    // Squares of the singular values are accurate to 1e-8 of the largest; conditions are far below 1e7.
    const Eigen::MatrixXd dense(matrix);
    const Eigen::VectorXd squares = symmetric_eigenvalues(transposed_product(dense, dense));
    const double low = squares[0], high = squares[squares.size() - 1];
    return low > 1e-15 * high ? std::sqrt(high / low) : INFINITY;
  }
  const SparseMatrix transposed = matrix.transpose();
  const SparseLu factor(matrix), other(transposed);
  if (!factor.succeeded() || !other.succeeded()) return INFINITY;
  const double high = largest_eigenvalue(
      matrix.rows(), [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return transposed * (matrix * x); });
  const double low = largest_eigenvalue(matrix.rows(), [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    const Eigen::VectorXd y = other.solve(x);
    return factor.solve(y);
  });
  return std::sqrt(high * low);
}

}  // namespace hariko
