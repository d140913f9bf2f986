#include "core/gaussmap/fitted_tangents.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/solvers/conjugate_gradients.hpp"
#include "core/network/network_system.hpp"

namespace hariko {
namespace {

using Field = std::vector<Vector3>;

std::vector<Index> neighbours(const HalfEdgeMesh& mesh, Index v) {
  std::vector<Index> out;
  for (const FanEnd& each : fan_ends(mesh, v)) out.push_back(each.other);
  return out;
}

/// Second fundamental form at v as a symmetric matrix of the tangent plane, negative where the surface bends
/// away from its normal. Along each edge it is the second derivative of the cubic over the tangent plane with
/// the height and slope of both ends. The rotation of normals across the edges gets a small weight, which
/// matters only where there are too few edges.
Matrix3 second_form(const Polyhedron& polyhedron, std::span<const Vector3> normals, Index v) {
  const Vector3 &normal = normals[v], u = normal.unitOrthogonal(), w = normal.cross(u);
  Matrix3 system = Matrix3::Zero();
  Vector3 right = Vector3::Zero();
  const auto add = [&](const Vector3& row, double value, double weight) {
    system += weight * row * row.transpose();
    right += weight * value * row;
  };
  for (const Index k : neighbours(polyhedron.topology(), v)) {
    const Vector3 chord = polyhedron.position(k) - polyhedron.position(v);
    const double x = chord.dot(u), y = chord.dot(w), square = x * x + y * y, cosine = normal.dot(normals[k]);
    if (!(square > 0) || cosine < 0.1) continue;
    add(Vector3(x * x, 2 * x * y, y * y) / square,
        (4 * normal.dot(chord) + 2 * normals[k].dot(chord) / cosine) / square, 1);
    add(Vector3(-x * y, x * x - y * y, x * y) / square, normals[k].dot(y * u - x * w) / (cosine * square),
        1e-3);
  }
  system += 1e-9 * Matrix3::Identity();  // regularisation for directions without a neighbour
  const Vector3 found = system.inverse() * right;
  return found[0] * u * u.transpose() + found[1] * (u * w.transpose() + w * u.transpose()) +
         found[2] * w * w.transpose();
}

/// Gauss-Newton method for the sum of squares of the errors of the curves' normal curvature at the ends of
/// the edges, and of the deviations of tangents from those of the network.
class TangentFit {
 public:
  TangentFit(const Polyhedron& polyhedron, const NetworkSystem& network, std::span<const Vector3> normals)
      : polyhedron_(polyhedron),
        mesh_(polyhedron.topology()),
        frames_(network.frames()),
        normals_(normals),
        network_(network.solve(polyhedron.positions(), {}).basis),
        basis_(network_),
        vertex_(basis_.size()),
        fixed_(basis_.size(), 0),
        ends_(2 * std::size_t(mesh_.edge_count())),
        image_(ends_.size()) {
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      forms_.push_back(second_form(polyhedron, normals, v));
      const Index begin = frames_.basis_begin[v];
      for (Index b = begin; b < frames_.basis_begin[v + 1]; ++b) vertex_[b] = v;
      // The first basis vector of a smooth border is the tangent along it.
      if (mesh_.is_border_vertex(v)) fixed_[begin] = 1;
    }
  }

  const Field& basis() const { return basis_; }

  void run() {
    constexpr int most_steps = 4;
    // Relative decrease of the sum of squares below which improvements are invisible.
    constexpr double enough = 1e-2;
    linearise();
    distrust();
    double before = linearise();
    for (int step = 0; step < most_steps; ++step) {
      const Field old = basis_;
      move();
      const double after = linearise();
      if (!(after < before)) basis_ = old;
      if (!(after < (1 - enough) * before)) return;
      before = after;
    }
  }

  // Applies the matrix of the normal equations, for `conjugate_gradients`.
  void apply(const Field& x, Field& y) {
    for (std::size_t i = 0; i < ends_.size(); ++i) image_[i] = tangent(ends_[i].number, x);
    gather(
        [&](const End& end, const End& far, std::size_t i) {
          const Vector3 &own = image_[i], &other = image_[i ^ 1U];
          return Vector3((end.own.dot(own) + end.other.dot(other)) * end.own +
                         (far.own.dot(other) + far.other.dot(own)) * far.other + end.hold * own);
        },
        y);
  }
  void precondition(const Field& r, Field& z) const {
    for (std::size_t b = 0; b < r.size(); ++b) z[b] = r[b] / diagonal_[b];
  }
  static double dot(const Field& a, const Field& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
  }
  static void combine(Field& y, double scale, double factor, const Field& x) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = scale * y[i] + factor * x[i];
  }

 private:
  /// Full Gauss-Newton step.
  void move() {
    const Field zero(basis_.size(), Vector3::Zero());
    ConjugateGradientsWorkspace<Field, double> room{zero, zero, zero, zero};
    gather(
        [](const End& end, const End& far, std::size_t) {
          return Vector3(-end.off * end.own - far.off * far.other - end.hold * end.away);
        },
        room.residual);
    Field by = zero;
    ConjugateGradientsOptions options;
    options.tolerance = 1e-4;
    options.max_steps = 200;
    conjugate_gradients(*this, by, room, options, {});
    for (std::size_t b = 0; b < basis_.size(); ++b) {
      if (fixed_[b]) continue;
      const Vector3& normal = normals_[vertex_[b]];
      basis_[b] += by[b];
      basis_[b] -= normal * normal.dot(basis_[b]);  // removes the normal component left by rounding
    }
  }

  /// End of an edge; its other end is its neighbour in the list.
  struct End {
    Index number = 0;  ///< number in `VertexFrames`
    double trust = 1;  ///< weight of the normal curvature here
    double off = 0;    ///< error of the normal curvature, with its derivatives by both ends' tangents
    Vector3 own = Vector3::Zero(), other = Vector3::Zero();
    Vector3 away = Vector3::Zero();  ///< deviation of the tangent from the network's
    double hold = 0;                 ///< weight of the squared deviation
  };

  Vector3 tangent(Index end, const Field& basis) const { return tangent_image(frames_.ends[end], basis); }

  /// Computes y: for each free basis vector, within its plane, the sum of gradient(end, other end, number)
  /// over all ends, by the end's tangent.
  template <class Gradient>
  void gather(const Gradient& gradient, Field& y) const {
    std::fill(y.begin(), y.end(), Vector3::Zero());
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Vector3 of_tangent = gradient(ends_[i], ends_[i ^ 1U], i);
      const TangentCoefficients& of = frames_.ends[ends_[i].number];
      for (std::size_t k = 0; k < 2; ++k)
        if (of.basis[k] != no_index) y[of.basis[k]] += of.c[k] * of_tangent;
    }
    for (std::size_t b = 0; b < y.size(); ++b) {
      const Vector3& normal = normals_[vertex_[b]];
      y[b] = fixed_[b] ? Vector3(Vector3::Zero()) : Vector3(y[b] - normal * normal.dot(y[b]));
    }
  }

  /// Lowers the weight where the error of the curvature is much larger than tangents could correct: positions
  /// and normals are inconsistent there, and the form is less reliable.
  void distrust() {
    constexpr double usual = 0.1;  // relative error of the second derivative: 60 % of the curvature
    for (End& end : ends_) end.trust = 1 / (1 + std::pow(end.off / usual, 2));
  }

  /// Half the sum of squares for the present basis, with derivatives.
  double linearise() {
    constexpr double hold = 0.03;  // with less weight tangents deviate wildly at the rims
    double sum = 0;
    diagonal_.assign(basis_.size(), 1e-300);
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      for (const Index side : {0U, 1U}) {
        const Index h = mesh_.half_edge_of_edge(e);
        const Index v = side ? mesh_.target(h) : mesh_.origin(h),
                    w = side ? mesh_.origin(h) : mesh_.target(h);
        End& end = ends_[2 * e + side];
        end.number = 2 * h + side;
        const Vector3 chord = polyhedron_.position(w) - polyhedron_.position(v);
        if (!(chord.norm() > 0)) continue;
        const Vector3 &normal = normals_[v], here = tangent(end.number, basis_),
                      there = tangent(end.number ^ 1U, basis_);
        // Perpendicular to the plane the second derivative of the cubic is 6 (chord + other tangent), along
        // it the first one is 3 tangents: curvature requires 6 n.(chord + other) = 9 form(tangent, tangent).
        const double scale =
            chord.squaredNorm() * std::max(forms_[v].norm(), 0.01 / chord.norm()) / end.trust;
        end.off = (normal.dot(chord + there) - 1.5 * here.dot(forms_[v] * here)) / scale;
        end.own = -3 / scale * (forms_[v] * here);
        end.other = normal / scale;
        end.away = here - tangent(end.number, network_);
        end.hold = hold / chord.squaredNorm();
        sum += (end.off * end.off + end.hold * end.away.squaredNorm()) / 2;
      }
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const TangentCoefficients& of = frames_.ends[ends_[i].number];
      const double own = ends_[i].own.squaredNorm() / 2 + ends_[i].hold;
      for (std::size_t k = 0; k < 2; ++k)
        if (of.basis[k] != no_index) {
          // The other end contributes an equation across its own plane.
          const Vector3& normal = normals_[vertex_[of.basis[k]]];
          const Vector3& other = ends_[i ^ 1U].other;
          const double asked = (other.squaredNorm() - std::pow(other.dot(normal), 2)) / 2;
          diagonal_[of.basis[k]] += of.c[k] * of.c[k] * (own + asked);
        }
    }
    return sum;
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const VertexFrames& frames_;
  std::span<const Vector3> normals_;
  const Field network_;
  Field basis_;
  std::vector<Index> vertex_;  ///< vertex of each basis vector
  std::vector<char> fixed_;    ///< one per basis vector
  std::vector<Matrix3> forms_;
  std::vector<End> ends_;  ///< two per edge
  Field image_;
  std::vector<double> diagonal_;  ///< approximate diagonal of the normal equations, one per basis vector
};

}  // namespace

Result<FlatMap<VertexId, Pin>> fitted_tangents(const Polyhedron& polyhedron, const Shaping& shaping,
                                               std::span<const Vector3> normals) {
  const auto network = NetworkSystem::assemble(polyhedron, shaping);
  if (!network) return network.error();
  TangentFit fit(polyhedron, *network, normals);
  fit.run();
  FlatMap<VertexId, Pin> out;
  const std::vector<Index>& begin = network->frames().basis_begin;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    out.set(polyhedron.vertex_id(v),
            Pin{Pin::Kind::tangents, {fit.basis().begin() + begin[v], fit.basis().begin() + begin[v + 1]}});
  return out;
}

}  // namespace hariko
