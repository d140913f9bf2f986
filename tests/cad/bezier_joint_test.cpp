// Bezier patches that were cut out of one spline are one again.

#include "core/cad/fit/bezier_joint.hpp"

#include <algorithm>

#include "core/cad/cad_measure.hpp"
#include "core/cad/cad_model.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// The Bezier patch of a spline between breaks i, i + 1 by s and j, j + 1 by t: the polynomial through values
/// at places between.
BezierPatch piece(const SplineSurface& spline, std::size_t i, std::size_t j) {
  const int p = spline.s.degree;
  const SplineSpace s{p, {spline.s.breaks[i], spline.s.breaks[i + 1]}},
      t{p, {spline.t.breaks[j], spline.t.breaks[j + 1]}};
  const SplineInterpolation along(s), up(t);
  const SplineEvaluator evaluator(spline);
  BezierPatch out;
  out.degree_s = out.degree_t = p;
  for (const double y : up.places())
    for (const double x : along.places()) out.points.push_back(evaluator.at(x, y).position);
  const std::size_t n = s.size();
  along.solve(out.points, 1, n, n);
  up.solve(out.points, n, n, 1);
  return out;
}

/// A spline over uneven breaks whose points wave.
SplineSurface random_spline(int degree, std::mt19937_64& rng) {
  const SplineSpace s{degree, {0, 0.125, 0.25, 0.5, 1}}, t{degree, {0, 1, 3}};
  SplineSurface out{s, t, {}};
  for (std::size_t j = 0; j < t.size(); ++j)
    for (std::size_t i = 0; i < s.size(); ++i)
      out.points.emplace_back(double(i), double(j), uniform(rng, -1, 1));
  return out;
}

std::vector<BezierPatch> pieces_of(const SplineSurface& spline) {
  std::vector<BezierPatch> out;
  for (std::size_t j = 0; j < spline.t.span_count(); ++j)
    for (std::size_t i = 0; i < spline.s.span_count(); ++i) out.push_back(piece(spline, i, j));
  return out;
}

TEST(BezierJoint, WidthsAreFoundExactly) {
  for_random(7100, 12, [](std::mt19937_64& rng) {
    const SplineSurface spline = random_spline(uniform_int(rng, 2, 6), rng);
    const BezierPatch narrow = piece(spline, 1, 0), wide = piece(spline, 2, 0), above = piece(spline, 1, 1);
    EXPECT_EQ(spline_joint(narrow, 1, wide, 3, 1e-11), 2.0);
    EXPECT_EQ(spline_joint(wide, 3, narrow, 1, 1e-11), 0.5);
    EXPECT_EQ(spline_joint(narrow, 2, above, 0, 1e-11), 2.0);
    // Another spline's piece.
    EXPECT_FALSE(spline_joint(narrow, 1, piece(random_spline(spline.s.degree, rng), 2, 0), 3, 1e-11));
    EXPECT_FALSE(one_polynomial(narrow, 0, wide, 0, 2, 1e-11));
  });
}

TEST(BezierJoint, APolynomialThatIsCutHasNoKnotThere) {
  for_random(7300, 8, [](std::mt19937_64& rng) {
    const int p = uniform_int(rng, 2, 6);
    SplineSurface one{{p, {0, 1}}, {p, {0, 1}}, {}};
    for (int k = 0; k < (p + 1) * (p + 1); ++k)
      one.points.emplace_back(k % (p + 1), k / (p + 1), uniform(rng, -1, 1));
    // The same polynomial over more breaks.
    SplineSurface cut = one;
    cut.s.breaks = {0, 0.25, 1};
    const SplineInterpolation along(cut.s), up(cut.t);
    const SplineEvaluator evaluator(one);
    cut.points.clear();
    for (const double y : up.places())
      for (const double x : along.places()) cut.points.push_back(evaluator.at(x, y).position);
    along.solve(cut.points, 1, cut.t.size(), cut.s.size());
    up.solve(cut.points, cut.s.size(), cut.s.size(), 1);
    EXPECT_TRUE(one_polynomial(piece(cut, 0, 0), 0, piece(cut, 1, 0), 0, 3, 1e-11));
    EXPECT_TRUE(one_polynomial(piece(cut, 1, 0), 2, piece(cut, 0, 0), 2, 1.0 / 3, 1e-11));
  });
}

TEST(BezierJoint, PiecesOfASplineBecomeThatSpline) {
  for_random(7200, 8, [](std::mt19937_64& rng) {
    const SplineSurface spline = random_spline(uniform_int(rng, 2, 6), rng);
    std::vector<BezierPatch> patches = pieces_of(spline);
    std::shuffle(patches.begin(), patches.end(), rng);
    const Surface surface = weld_patches(Vector3::Zero(), patches).value();
    const auto model = must(make_cad_model(surface));
    ASSERT_EQ(model->faces.size(), 1U);
    EXPECT_TRUE(model->faces[0].exact);
    const SplineSurface& back = model->faces[0].surface;
    EXPECT_EQ(back.s.degree, spline.s.degree);
    EXPECT_EQ(back.points.size(), spline.points.size());
    EXPECT_LE(measure_cad(surface, *model).largest, 1e-11);
  });
}

}  // namespace
}  // namespace hariko::test
