#include "core/patching/fair/boundary_curvature_load.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/base/solvers/small_solver.hpp"

namespace hariko {
namespace {

/// Regularisation relative to the mean square of the sides: keeps the form bounded in slivers, where three
/// chords do not determine it in the direction across them; elsewhere an error of a quarter of a percent.
constexpr double sliver = 0.05;

/// Second fundamental form over a triangle, fitted to the tangent planes at its corners: along a chord d its
/// value is d . (change of the normal).
class TriangleForm {
 public:
  TriangleForm(const std::array<Vector3, 3>& corner, const std::array<Vector3, 3>& normal)
      : x_((corner[1] - corner[0]).stableNormalized()),
        y_((normal[0] + normal[1] + normal[2]).cross(x_).stableNormalized()) {
    Matrix3 rows;
    Vector3 values;
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vector3 chord = corner[next] - corner[k];
      rows.row(Eigen::Index(k)) = products(chord, chord);
      values[Eigen::Index(k)] = chord.dot(normal[k] - normal[next]);
      square += chord.squaredNorm() / 3;
    }
    // Relative to the sides, so that nothing depends on the unit of length.
    if (!(square > 0)) return;
    rows /= square;
    const Matrix3 normal_equations = rows.transpose() * rows + sliver * sliver * Matrix3::Identity();
    form_ = solve_symmetric(normal_equations, rows.transpose() * values) / square;
  }
  double operator()(const Vector3& a, const Vector3& b) const { return products(a, b) * form_; }

 private:
  Eigen::RowVector3d products(const Vector3& a, const Vector3& b) const {
    const Vector2 p(a.dot(x_), a.dot(y_)), q(b.dot(x_), b.dot(y_));
    return {p.x() * q.x(), p.x() * q.y() + p.y() * q.x(), p.y() * q.y()};
  }
  Vector3 x_, y_, form_ = Vector3::Zero();
};

}  // namespace

std::vector<Index> clamped_boundary_edges(const Polyhedron& polyhedron, const Shaping& shaping) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto pinned = [&](Index v) {
    const Pin* pin = shaping.pin.find(polyhedron.vertex_id(v));
    return pin && pin->kind == Pin::Kind::tangents;
  };
  const auto formed = [&](Index v) {
    const VertexId id = polyhedron.vertex_id(v);
    return shaping.pin.contains(id) && shaping.form.contains(id);
  };
  const auto smooth = [&](Index v) {
    return shaping.tag.get_or(polyhedron.vertex_id(v), VertexTag::automatic) == VertexTag::smooth;
  };
  std::vector<Index> out;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twin(h) != no_index || mesh.side_count(mesh.face(h)) != 3) continue;
    const Index a = mesh.origin(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
    if (!smooth(a) || !smooth(b)) continue;
    const bool by_pins = pinned(a) && pinned(b) && pinned(c);
    const bool by_forms = formed(a) && formed(b) && shaping.pin.contains(polyhedron.vertex_id(c));
    if (by_pins || by_forms) out.push_back(h);
  }
  return out;
}

RimMeasure rim_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index half_edge) {
  if (charts.frames == Frames::equal)  // the inradius of the triangle with unit side
    return {0.5 / std::sqrt(3.0), 1};
  const double length = charts.edge_length[mesh.edge(half_edge)], x = charts.area[half_edge];
  return {2 * x / length, length * std::pow(x, 1.25)};
}

BoundaryCurvatureLoad rim_bend(const HalfEdgeMesh& mesh, std::span<const Vector3> positions,
                               const Network& network, std::span<const QuarticPatch> base, Index half_edge,
                               const RimMeasure& measure) {
  std::array<Vector3, 3> corner, normal;
  std::size_t k = 0;
  for (Index h = half_edge; k < 3; h = mesh.next(h), ++k) {
    corner[k] = positions[mesh.origin(h)];
    normal[k] = network.normal[mesh.origin(h)];
  }
  const TriangleForm form(corner, normal);
  // Derivatives across the rim, pointing inward in the chart, at its ends.
  using namespace quartic;
  const auto& d = base[half_edge].control;
  const double height = measure.height;
  const Vector3 a = 4 * (d[d130] - (d[d040] + d[d031]) / 2) / height;
  const Vector3 b = 4 * (d[d103] - (d[d004] + d[d013]) / 2) / height;
  // Integrated by parts, the bending II(v, v) n required across the rim acts there on the derivative 4 z_i
  // B_i(t) / height, with B_i the cubic Bernstein functions and v running from a to b.
  const double aa = form(a, a), ab = form(a, b), bb = form(b, b);
  const Vector3 outward = -4 * measure.factor / height * (normal[0] + normal[1]).stableNormalized();
  return {half_edge, (2 * aa + 2 * ab + bb) / 20 * outward, (aa + 2 * ab + 2 * bb) / 20 * outward};
}

}  // namespace hariko
