#pragma once

// Surfaces of known shape, given by a formula for each patch, to check computations on a Surface.

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko::test {

using PatchFormula = std::function<PatchPoint(double s, double t)>;  ///< gives first and second derivatives

/// Patches given by formulas.
class AnalyticPatchSet final : public PatchSet {
 public:
  AnalyticPatchSet(Domain domain, std::vector<PatchFormula> formulas)
      : domain_(domain), formulas_(std::move(formulas)) {}

  Domain domain() const override { return domain_; }
  Index patch_count() const override { return static_cast<Index>(formulas_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override {
    PatchPoint point = formulas_[patch](parameter.x(), parameter.y());
    if (order == Order::first) point.dss = point.dst = point.dtt = Vector3::Zero();
    return point;
  }
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override {
    for_grid(patches, pattern, [&](std::size_t at, const PatchPoint& point) {
      positions[at] = point.position;
      normals[at] = unit_normal(point);
    });
  }
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override {
    for_grid(patches, pattern, [&](std::size_t at, const PatchPoint& point) { points[at] = point; });
  }
  CornerSecondOrder second_order_at_corner(Index, int) const override { return corners; }

  CornerSecondOrder corners = CornerSecondOrder::exact;

 private:
  template <class Body>
  void for_grid(std::span<const Index> patches, const GridPattern& pattern, const Body& body) const {
    std::size_t at = 0;
    const auto parameters = pattern.parameters();
    for (const Index patch : patches)
      for (const Vector2& q : parameters) body(at++, evaluate(patch, q, Order::second));
  }
  Domain domain_;
  std::vector<PatchFormula> formulas_;
};

/// Adjacency and normals of an analytic surface.
struct AnalyticOptions {
  Continuity continuity = Continuity::g1;
  std::vector<Vector3> node_normals;  ///< zero vectors when empty
  Vector3 origin = Vector3::Zero();
  CornerSecondOrder corners = CornerSecondOrder::exact;
  bool source_edges = false;  ///< seams lie on source edges named by their nodes, instead of inside elements
};

/// Surface of patches whose corners are given as nodes, patch by patch. Sides of different patches between
/// the same two nodes, run in opposite directions, become seams.
inline Surface make_surface(Domain domain, std::vector<PatchFormula> formulas,
                            std::vector<Index> corner_nodes, const AnalyticOptions& options = {}) {
  const auto corners = static_cast<Index>(corner_count(domain));
  const auto patch_count = static_cast<Index>(formulas.size());
  Index node_count = 0;
  for (const Index node : corner_nodes) node_count = std::max(node_count, node + 1);

  std::map<std::pair<Index, Index>, PatchSide> sides;
  for (Index p = 0; p < patch_count; ++p)
    for (Index c = 0; c < corners; ++c)
      sides[{corner_nodes[p * corners + c], corner_nodes[p * corners + (c + 1) % corners]}] =
          PatchSide{p, static_cast<std::uint8_t>(c)};
  std::vector<Seam> seams;
  for (const auto& [ends, side] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    if (other == sides.end() || ends.first > ends.second) continue;
    Seam seam;
    seam.first = side;
    seam.second = other->second;
    seam.intended = options.continuity;
    if (options.source_edges)
      seam.source = element_of(EdgeId::of(VertexId{ends.first}, VertexId{ends.second}));
    seams.push_back(seam);
  }
  auto patches = std::make_shared<AnalyticPatchSet>(domain, std::move(formulas));
  patches->corners = options.corners;
  Surface::Parts parts;
  parts.origin = options.origin;
  parts.patches = std::move(patches);
  parts.seams = std::make_shared<const std::vector<Seam>>(std::move(seams));
  parts.provenance = std::make_shared<const std::vector<Provenance>>(patch_count);
  parts.corner_nodes = std::make_shared<const std::vector<Index>>(std::move(corner_nodes));
  parts.node_count = node_count;
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(
      options.node_normals.empty() ? std::vector<Vector3>(node_count, Vector3::Zero())
                                   : options.node_normals);
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>();
  parts.boundary_sources = std::make_shared<const std::vector<Element>>();
  return Surface(std::move(parts));
}

/// Part of a sphere about the origin over a flat triangle a, b, c, projected from the centre.
inline PatchFormula sphere_patch(const Vector3& a, const Vector3& b, const Vector3& c, double radius) {
  return [=](double s, double t) {
    const Vector3 ps = b - a, pt = c - a, p = a + s * ps + t * pt;
    const double r = p.norm();
    const Vector3 q = p / r;
    const auto first = [&](const Vector3& d) -> Vector3 { return (d - q * q.dot(d)) / r; };
    const auto second = [&](const Vector3& d, const Vector3& e) -> Vector3 {
      const Vector3 qe = first(e);
      return -(qe * q.dot(d) + q * qe.dot(d)) / r - first(d) * q.dot(e) / r;
    };
    return PatchPoint{radius * q,
                      radius * first(ps),
                      radius * first(pt),
                      radius * second(ps, ps),
                      radius * second(ps, pt),
                      radius * second(pt, pt)};
  };
}

/// Sphere of eight octants; nodes 0 .. 5 are +x, -x, +y, -y, +z, -z.
inline Surface sphere(double radius, const AnalyticOptions& options = {}) {
  const Vector3 at[6] = {Vector3::UnitX(),  -Vector3::UnitX(), Vector3::UnitY(),
                         -Vector3::UnitY(), Vector3::UnitZ(),  -Vector3::UnitZ()};
  const std::vector<Index> nodes = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  std::vector<PatchFormula> formulas;
  for (std::size_t k = 0; k < nodes.size(); k += 3)
    formulas.push_back(sphere_patch(at[nodes[k]], at[nodes[k + 1]], at[nodes[k + 2]], radius));
  AnalyticOptions own = options;
  if (own.node_normals.empty()) own.node_normals.assign(at, at + 6);
  return make_surface(Domain::triangle, std::move(formulas), nodes, own);
}

/// Torus of rows x columns squares (both >= 3) round the z axis; outward normals.
inline Surface torus(double large, double small, Index columns, Index rows,
                     const AnalyticOptions& options = {}) {
  std::vector<PatchFormula> formulas;
  std::vector<Index> nodes;
  for (Index i = 0; i < columns; ++i)
    for (Index j = 0; j < rows; ++j) {
      const Index i1 = (i + 1) % columns, j1 = (j + 1) % rows;
      for (const Index node : {i * rows + j, i1 * rows + j, i1 * rows + j1, i * rows + j1})
        nodes.push_back(node);
      const double du = 2 * std::numbers::pi / columns, dv = 2 * std::numbers::pi / rows;
      formulas.push_back([=](double s, double t) {
        const double u = du * (i + s), v = dv * (j + t);
        const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v);
        const double ring = large + small * cv;
        PatchPoint p;
        p.position = {ring * cu, ring * su, small * sv};
        p.ds = du * Vector3(-ring * su, ring * cu, 0);
        p.dt = dv * small * Vector3(-sv * cu, -sv * su, cv);
        p.dss = du * du * Vector3(-ring * cu, -ring * su, 0);
        p.dst = du * dv * small * Vector3(sv * su, -sv * cu, 0);
        p.dtt = dv * dv * small * Vector3(-cv * cu, -cv * su, -sv);
        return p;
      });
    }
  return make_surface(Domain::square, std::move(formulas), nodes, options);
}

using Height = std::function<std::array<double, 6>(double x, double y)>;  ///< gives z, zx, zy, zxx, zxy, zyy

/// Patch of a height field over the rectangle from (x0, y0) with sides dx, dy.
inline PatchFormula height_patch(const Height& height, double x0, double y0, double dx, double dy) {
  return [=](double s, double t) {
    const double x = x0 + s * dx, y = y0 + t * dy;
    const auto z = height(x, y);
    PatchPoint p;
    p.position = {x, y, z[0]};
    p.ds = dx * Vector3(1, 0, z[1]);
    p.dt = dy * Vector3(0, 1, z[2]);
    p.dss = dx * dx * Vector3(0, 0, z[3]);
    p.dst = dx * dy * Vector3(0, 0, z[4]);
    p.dtt = dy * dy * Vector3(0, 0, z[5]);
    return p;
  };
}

/// Height field of columns x rows unit squares from (0, 0), patch i of row j at j * columns + i, each with
/// its own height function.
inline Surface height_field(Index columns, Index rows, const std::function<Height(Index i, Index j)>& height,
                            const AnalyticOptions& options = {}) {
  std::vector<PatchFormula> formulas;
  std::vector<Index> nodes;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index n = j * (columns + 1) + i;
      for (const Index node : {n, n + 1, n + columns + 2, n + columns + 1}) nodes.push_back(node);
      formulas.push_back(height_patch(height(i, j), i, j, 1, 1));
    }
  return make_surface(Domain::square, std::move(formulas), nodes, options);
}

/// Hyperbolic paraboloid z = x y.
inline Height saddle() {
  return [](double x, double y) { return std::array<double, 6>{x * y, y, x, 0, 1, 0}; };
}
/// Plane z = offset + slope_x x + slope_y y.
inline Height plane(double slope_x = 0, double slope_y = 0, double offset = 0) {
  return [=](double x, double y) {
    return std::array<double, 6>{offset + slope_x * x + slope_y * y, slope_x, slope_y, 0, 0, 0};
  };
}
/// Cylinder of this radius along y, with its lowest line at x = 0.
inline Height trough(double radius) {
  return [=](double x, double) {
    const double h = std::sqrt(radius * radius - x * x);
    return std::array<double, 6>{radius - h, x / h, 0, radius * radius / (h * h * h), 0, 0};
  };
}

}  // namespace hariko::test
