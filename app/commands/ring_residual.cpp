#include "app/commands/ring_residual.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

namespace {

/// Side factor of the construction: f_n = 1 / (4 sin^2(pi / n)).
double side_factor(Index sides) {
  const double sine = std::sin(std::numbers::pi / sides);
  return 1 / (4 * sine * sine);
}

/// Sums of y . R and |y|^2 over the edges of one ring; the edges alternate in sign.
class RingSum {
 public:
  /// Adds an edge. `left` and `right`: inner points beside the edge; a_left + a_right = 1; `x_left` and
  /// `x_right`: side factors of the patches' faces.
  void add(const Vector3& centre, const Vector3& left, double a_left, const Vector3& right, double x_left,
           double x_right) {
    const double y = sign_ * (1 / x_left + 1 / x_right);
    sum_ += y * (a_left * (left - centre) + (1 - a_left) * (right - centre));
    square_ += y * y;
    sign_ = -sign_;
  }
  double residual() const { return square_ > 0 ? sum_.norm() / std::sqrt(square_) : 0; }

 private:
  Vector3 sum_ = Vector3::Zero();
  double square_ = 0, sign_ = 1;
};

double centre_residual(const HalfEdgeMesh& mesh, const QuarticPatchSet& patches, Index f) {
  if (mesh.side_count(f) % 2 != 0) return 0;
  RingSum sum;
  for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
    const auto& left = patches.patch(h).control;
    const auto& right = patches.patch(mesh.previous(h)).control;
    sum.add(left[quartic::d400], left[quartic::d211w], 0.5, right[quartic::d211v], 1, 1);
  }
  return sum.residual();
}

double vertex_residual(const HalfEdgeMesh& mesh, const QuarticPatchSet& patches, Index v) {
  RingSum sum;
  Index h = mesh.outgoing(v);
  do {
    const auto& after = patches.patch(h).control;
    const auto& before = patches.patch(mesh.twin(h)).control;
    const auto& next = patches.patch(mesh.previous(h)).control;
    const Vector3 centre = after[quartic::d040];
    const double left = side_factor(mesh.side_count(mesh.face(h)));
    const double right = side_factor(mesh.side_count(mesh.face(mesh.twin(h))));
    sum.add(centre, after[quartic::d121u], right / (left + right), before[quartic::d112u], left, right);
    sum.add(centre, next[quartic::d112v], 0.5, after[quartic::d121w], left, left);
    h = mesh.rotate(h);
  } while (h != mesh.outgoing(v));
  return sum.residual();
}

}  // namespace

double largest_ring_residual(const PolyhedronSource& source, const QuarticPatchSet& patches) {
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::vector<char> open(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.outgoing(v) == no_index || mesh.is_border_vertex(v)) open[v] = 1;
  for (const auto& [id, sharp] : source.shaping->crease)
    for (const VertexId end : {id.low, id.high})
      if (const Index v = source.polyhedron.find(end); v != no_index) open[v] = 1;

  double largest = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    largest = std::max(largest, centre_residual(mesh, patches, f));
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!open[v]) largest = std::max(largest, vertex_residual(mesh, patches, v));
  return largest;
}

}  // namespace hariko
