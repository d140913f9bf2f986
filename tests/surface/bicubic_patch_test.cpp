// Grids of bicubic patches: evaluation, seams, sides.

#include "core/surface/bicubic_patch.hpp"

#include <cstring>
#include <variant>

#include "core/surface/adjacency.hpp"
#include "core/surface/tensor_bezier.hpp"
#include "core/surface/tessellation.hpp"
#include "core/surface/triangle_net.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

BicubicNet random_net(std::mt19937_64& rng, Index columns, Index rows) {
  BicubicNet net{columns, rows, {}};
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i) net.points.push_back(Vector3(i, j, 0) + random_vector(rng, 0.3));
  return net;
}

/// Makes neighbours share their derivatives across columns and rows.
BicubicNet smooth_net(std::mt19937_64& rng, Index columns, Index rows) {
  BicubicNet net = random_net(rng, columns, rows);
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 3; i + 1 < net.width(); i += 3)
      net.points[net.index(i, j)] = (net.at(i - 1, j) + net.at(i + 1, j)) / 2;
  for (Index j = 3; j + 1 < net.height(); j += 3)
    for (Index i = 0; i < net.width(); ++i)
      net.points[net.index(i, j)] = (net.at(i, j - 1) + net.at(i, j + 1)) / 2;
  return net;
}

/// By de Casteljau's construction, which shares nothing with the code under test.
Vector3 constructed(const BicubicNet& net, Index patch, double s, double t) {
  Vector3 p[4][4];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) p[i][j] = net.points[net.index(patch, i, j)];
  for (int round = 3; round > 0; --round)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < round; ++j) p[i][j] = (1 - t) * p[i][j] + t * p[i][j + 1];
  for (int round = 3; round > 0; --round)
    for (int i = 0; i < round; ++i) p[i][0] = (1 - s) * p[i][0] + s * p[i + 1][0];
  return p[0][0];
}

TEST(BicubicPatch, PointsAndDerivatives) {
  for_random(601, 50, [](std::mt19937_64& rng) {
    const BicubicPatchSet set(random_net(rng, 2, 3));
    const Index patch = Index(uniform_int(rng, 0, 5));
    const Vector2 at(uniform(rng, 0.01, 0.99), uniform(rng, 0.01, 0.99));
    const PatchPoint point = set.evaluate(patch, at, Order::second);
    EXPECT_LT((point.position - constructed(set.net(), patch, at.x(), at.y())).norm(), 1e-13);
    const double h = 1e-5;
    const auto first = [&](double s, double t) { return set.evaluate(patch, {s, t}, Order::first); };
    const PatchPoint s0 = first(at.x() - h, at.y()), s1 = first(at.x() + h, at.y());
    const PatchPoint t0 = first(at.x(), at.y() - h), t1 = first(at.x(), at.y() + h);
    EXPECT_LT(((s1.position - s0.position) / (2 * h) - point.ds).norm(), 1e-8);
    EXPECT_LT(((t1.position - t0.position) / (2 * h) - point.dt).norm(), 1e-8);
    EXPECT_LT(((s1.ds - s0.ds) / (2 * h) - point.dss).norm(), 1e-8);
    EXPECT_LT(((s1.dt - s0.dt) / (2 * h) - point.dst).norm(), 1e-8);
    EXPECT_LT(((t1.dt - t0.dt) / (2 * h) - point.dtt).norm(), 1e-8);
  });
}

TEST(BicubicPatch, GridsAreTheSinglePoints) {
  std::mt19937_64 rng(7);
  const BicubicPatchSet set(random_net(rng, 2, 2));
  const GridPattern pattern{Domain::square, 7};
  const std::vector<Index> patches{3, 0};
  const auto count = std::size_t(pattern.point_count());
  std::vector<PatchPoint> points(2 * count);
  std::vector<Vector3> positions(2 * count), normals(2 * count);
  set.evaluate_grid(patches, pattern, points);
  set.evaluate_grid(patches, pattern, positions, normals);
  const auto parameters = pattern.parameters();
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < count; ++i) {
      const PatchPoint single = set.evaluate(patches[k], parameters[i], Order::second);
      EXPECT_LT((points[k * count + i].dst - single.dst).norm(), 1e-13);
      EXPECT_LT((positions[k * count + i] - single.position).norm(), 1e-14);
      EXPECT_LT((normals[k * count + i] - unit_normal(single)).norm(), 1e-13);
    }
}

TEST(BicubicPatch, TheExactFormIsThePatch) {
  for_random(607, 20, [](std::mt19937_64& rng) {
    const BicubicPatchSet set(random_net(rng, 3, 2));
    const GridPattern pattern{Domain::square, 5};
    const auto count = std::size_t(pattern.point_count());
    std::vector<PatchPoint> points(count), others(count);
    std::vector<Vector3> positions(count), normals(count), other_positions(count), other_normals(count);
    for (Index p = 0; p < set.patch_count(); ++p) {
      const auto form = std::get<BicubicPatch>(set.exact_form(p));
      const BezierPatchSet same({{3, 3, {form.controls.begin(), form.controls.end()}, {}}});
      const std::vector<Index> one{p}, first{0};
      set.evaluate_grid(one, pattern, points);
      same.evaluate_grid(first, pattern, others);
      set.evaluate_grid(one, pattern, positions, normals);
      same.evaluate_grid(first, pattern, other_positions, other_normals);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_LT((points[i].position - others[i].position).norm(), 1e-13);
        EXPECT_LT((points[i].dst - others[i].dst).norm(), 1e-12);
        EXPECT_LT((positions[i] - other_positions[i]).norm(), 1e-13);
        EXPECT_LT((normals[i] - other_normals[i]).norm(), 1e-12);
      }
      EXPECT_EQ(std::get<BezierPatch>(same.exact_form(0)), same.patch(0));
      EXPECT_EQ(polynomial_degree(set, p), polynomial_degree(same, 0));
    }
  });
}

TEST(BicubicPatch, SeamsHaveTheSameBitsOnBothSides) {
  for_random(611, 20, [](std::mt19937_64& rng) {
    const Surface surface =
        bicubic_surface(Vector3::Zero(), random_net(rng, Index(uniform_int(rng, 1, 3)), 2));
    for (const Seam& seam : surface.seams())
      for (const int density : {1, 3, 8, 13})
        for (int i = 0; i <= density; ++i) {
          const auto at = [&](PatchSide side, int place) {
            const double x = grid_fraction(place, density);
            return surface.patches()
                .evaluate(side.patch, side_parameter(Domain::square, side.side, x), Order::first)
                .position;
          };
          const Vector3 a = at(seam.first, i), b = at(seam.second, density - i);
          EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof(double) * 3), 0);
        }
  });
}

TEST(BicubicPatch, SeamsAreAsSmoothAsTheNet) {
  for_random(621, 20, [](std::mt19937_64& rng) {
    const Surface smooth = bicubic_surface(Vector3::Zero(), smooth_net(rng, 3, 2));
    for (const Seam& seam : smooth.seams()) EXPECT_EQ(seam.intended, Continuity::g1);
    const Surface rough = bicubic_surface(Vector3::Zero(), random_net(rng, 3, 2));
    for (const Seam& seam : rough.seams()) EXPECT_EQ(seam.intended, Continuity::g0);
  });
}

TEST(BicubicPatch, AClosedNetHasNoBorderThere) {
  BicubicNet net{4, 1, {}};
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i) {
      const double angle = 2 * 3.14159265358979 * double(i % (net.width() - 1)) / double(net.width() - 1);
      net.points.emplace_back(std::cos(angle), std::sin(angle), double(j));
    }
  const Surface surface = bicubic_surface(Vector3::Zero(), net);
  EXPECT_EQ(surface.boundary_sides().size(), 8U);
  EXPECT_EQ(surface.node_count(), 8U);
  const TriangleMesh mesh = tessellate(surface, 4);
  EXPECT_EQ(mesh.positions.size(), 16U * 5U);
}

TEST(BicubicPatch, SidesRunRoundTheGrid) {
  std::mt19937_64 rng(9);
  const BicubicNet net = random_net(rng, 3, 2);
  const Surface surface = bicubic_surface(Vector3::Zero(), net);
  Index previous = no_index;
  std::size_t sides = 0;
  for (std::uint8_t side = 0; side < 4; ++side)
    for (Index place = 0; place < places_of(net, side); ++place, ++sides) {
      const SideRows rows = side_rows(net, {side, place});
      if (previous != no_index) {
        EXPECT_EQ(rows.curve[0], previous);
      }
      previous = rows.curve[3];
      const Index patch = patch_of(net, {side, place});
      for (const double x : {0.0, 0.25, 1.0}) {
        const PatchPoint point =
            surface.patches().evaluate(patch, side_parameter(Domain::square, side, x), Order::first);
        Vector3 on_curve = Vector3::Zero(), inward = Vector3::Zero();
        const double weight[4] = {(1 - x) * (1 - x) * (1 - x), 3 * x * (1 - x) * (1 - x), 3 * x * x * (1 - x),
                                  x * x * x};
        for (std::size_t i = 0; i < 4; ++i) {
          on_curve += weight[i] * net.points[rows.curve[i]];
          inward += 3 * weight[i] * (net.points[rows.row[i]] - net.points[rows.curve[i]]);
        }
        const Vector3 across = side == 0   ? point.dt
                               : side == 1 ? Vector3(-point.ds)
                               : side == 2 ? Vector3(-point.dt)
                                           : point.ds;
        EXPECT_LT((on_curve - point.position).norm(), 1e-14);
        EXPECT_LT((inward - across).norm(), 1e-13);
      }
    }
  EXPECT_EQ(sides, surface.boundary_sides().size());
  EXPECT_EQ(previous, net.index(0, 0));
}

TEST(BicubicPatch, NormalsAtSidesShrunkToAPoint) {
  BicubicNet net{1, 1, {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) net.points.emplace_back(j * (i - 1.5), j, 0);  // side 0 is the point zero
  const BicubicPatchSet set(net);
  std::vector<Vector3> positions(25), normals(25);
  const Index patch = 0;
  set.evaluate_grid(std::span(&patch, 1), {Domain::square, 4}, positions, normals);
  for (const Vector3& normal : normals) EXPECT_LT((normal - Vector3::UnitZ()).norm(), 1e-9);
  EXPECT_EQ(set.second_order_at_corner(0, 0), CornerSecondOrder::undefined);
  EXPECT_EQ(set.second_order_at_corner(0, 2), CornerSecondOrder::exact);
}

}  // namespace
}  // namespace hariko::test
