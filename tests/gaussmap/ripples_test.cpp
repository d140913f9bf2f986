// Ripples: how far the curvature of the surface between control points is from the true one, near vertices
// with other than six neighbours, among those with six, and along the rims.

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/analysis/curvature.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/gaussmap/rim_tangents.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

struct Case {
  GroundTruth truth;
  Vector3 axes;  ///< half axes of the ellipsoid
};

double mean_curvature(const Vector3& axes, const Vector3& point) {
  const Vector3 squares = axes.cwiseAbs2();
  return (squares.sum() - point.squaredNorm()) /
         (2 * squares.prod() * std::pow(point.cwiseQuotient(squares).norm(), 3));
}

struct Deviation {
  double rms = 0, usual = 0;  ///< errors of the mean curvature, relative; the second: of 95 % of the places
};
Deviation deviation(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  double sum = 0;
  for (const double one : all) sum += one * one;
  return {std::sqrt(sum / double(all.size())), all[all.size() * 95 / 100]};
}

struct Ripples {
  Deviation odd, even, rim;
};

Ripples ripples(const Case& of, const OutlinePolyhedron& polyhedron, Mode mode) {
  const auto made =
      PolyhedronSurfacer().rebuild({polyhedron.polyhedron, polyhedron.shaping, mode, polyhedron.origin});
  EXPECT_TRUE(made.ok());
  const HalfEdgeMesh& mesh = polyhedron.polyhedron.topology();
  std::vector<double> odd, even, rim;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    bool border = false, irregular = false;
    for (const Index v : {mesh.origin(h), mesh.target(h), mesh.target(mesh.next(h))}) {
      border = border || mesh.is_border_vertex(v);
      irregular = irregular || mesh.valence(v) != 6;
    }
    for (const Vector2& at : {Vector2(0.85, 0.1), Vector2(0.45, 0.45), Vector2(0.2, 0.2)}) {
      const PatchPoint point = made->surface.patches().evaluate(h, at, Order::second);
      const auto found = curvature(point);
      if (!found) continue;
      const double is =
          mean_curvature(of.axes, of.truth.truth.foot(point.position + made->surface.origin()).point);
      (border ? rim : irregular ? odd : even).push_back(std::abs(found->mean / is - 1));
    }
  }
  return {deviation(odd), deviation(even), deviation(rim)};
}

/// The pins as they were without the fit: normals inside, tangents along the rims.
Shaping without_fit(const OutlinePolyhedron& made, const ControlPoints& points) {
  Shaping out = made.shaping;
  for (Index v = 0; v < points.points.size(); ++v)
    out.pin.set(VertexId{v}, {Pin::Kind::normal, {points.normals[v]}});
  const auto rims = *rim_tangents(made.polyhedron, out);
  for (const auto& [vertex, pin] : rims) out.pin.set(vertex, pin);
  return out;
}

void show(const char* what, const std::string& name, Mode mode, const Ripples& r) {
  if (!std::getenv("HARIKO_SHOW_NUMBERS")) return;
  std::ostringstream line;
  line << std::fixed << std::setprecision(3) << "ripples | " << name << " | "
       << (mode == Mode::g2 ? "g2" : "fair") << " | " << what << " | odd " << r.odd.rms << " " << r.odd.usual
       << " | even " << r.even.rms << " " << r.even.usual << " | rim " << r.rim.rms << " " << r.rim.usual;
  std::cout << line.str() << std::endl;
}

TEST(Ripples, FittedTangentsTakeThemAway) {
  for (const auto& [of, mode] :
       {std::pair{Case{sphere_cap(28), Vector3::Constant(2)}, Mode::fair},
        {Case{ellipsoid_cap(32), {2, 1.5, 1}}, Mode::g2},
        {Case{three_holes(Vector3::Ones(), 12, "three holes"), Vector3::Ones()}, Mode::fair}}) {
    SCOPED_TRACE(of.truth.name);
    ControlPoints points = *control_points(of.truth.outline, {});
    // On the true surface, so that what is left is between the points.
    for (std::size_t i = points.boundary_count; i < points.points.size(); ++i)
      points.points[i] = of.truth.truth.point_of_normal(points.normals[i]);
    const OutlinePolyhedron fitted = *outline_polyhedron(points);
    OutlinePolyhedron plain = fitted;
    plain.shaping = without_fit(plain, points);
    const Ripples before = ripples(of, plain, mode), after = ripples(of, fitted, mode);
    show("network", of.truth.name, mode, before);
    show("fitted", of.truth.name, mode, after);
    EXPECT_LE(after.rim.usual, 1.05 * before.rim.usual);
    if (mode == Mode::g2) {
      // It finds good tangents by itself: half of what the other modes leave.
      for (const Ripples& each : {before, after}) EXPECT_LE(std::max(each.odd.rms, each.even.rms), 0.065);
      continue;
    }
    EXPECT_LE(after.odd.rms, 0.85 * before.odd.rms);
    EXPECT_LE(after.even.rms, 0.85 * before.even.rms);
  }
}

TEST(FittedTangents, StayInTheirPlanesAndAlongTheRim) {
  const GroundTruth truth = ellipsoid_cap(32);
  const ControlPoints points = *control_points(truth.outline, {});
  const OutlinePolyhedron made = *outline_polyhedron(points);
  const Shaping before = without_fit(made, points);
  for (Index v = 0; v < points.points.size(); ++v) {
    const Pin* pin = made.shaping.pin.find(VertexId{v});
    ASSERT_TRUE(pin && pin->kind == Pin::Kind::tangents);
    for (const Vector3& tangent : pin->vectors)
      EXPECT_LE(std::abs(tangent.dot(points.normals[v])), 1e-14 * tangent.norm());
    if (v < points.boundary_count) {
      EXPECT_EQ(pin->vectors[0], before.pin.find(VertexId{v})->vectors[0]);
    }
  }
  EXPECT_EQ(outline_polyhedron(points)->shaping, made.shaping);
}

TEST(FittedTangents, BearNormalsThatAreNotThoseOfThePoints) {
  for_random(9605, 4, [](std::mt19937_64& rng) {
    const GroundTruth truth = three_holes(Vector3::Ones(), 12, "");
    ControlPoints points = *control_points(truth.outline, {});
    const double noise = uniform(rng, 0, 1);
    for (std::size_t i = points.boundary_count; i < points.points.size(); ++i) {
      points.normals[i] = (points.normals[i] + random_vector(rng, noise)).normalized();
      points.points[i] += random_vector(rng, 0.1 * noise);
    }
    const OutlinePolyhedron made = *outline_polyhedron(points);
    const HalfEdgeMesh& mesh = made.polyhedron.topology();
    const auto network = must(NetworkSystem::assemble(made.polyhedron, made.shaping));
    const auto basis = network->solve(made.polyhedron.positions(), {}).basis;
    double longest = 0;
    for (Index h = 0; h < mesh.half_edge_count(); ++h)
      longest = std::max(
          longest,
          (made.polyhedron.position(mesh.target(h)) - made.polyhedron.position(mesh.origin(h))).norm());
    for (Index h = 0; h < mesh.half_edge_count(); ++h)
      EXPECT_LE(network->tangents(h, basis).first.norm(), longest);
  });
}

}  // namespace
}  // namespace hariko
