#include "core/cad/fit/inner_fit.hpp"

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// A fit of random values, with random ties beside all sides.
struct Problem {
  FitPlaces s{SplineSpace{5, {0, 0.1, 0.4, 1}}}, t{SplineSpace{5, {0, 0.5, 0.75, 1.5}}};
  SplineSurface boundary{s.space, t.space,
                         std::vector<Vector3>(s.space.size() * t.space.size(), Vector3::Zero())};
  std::vector<Vector3> targets, areas;
  std::vector<FaceTie> ties;
  double weight = 7, volume = 0.3;
  std::mt19937_64 rng{20};

  Vector3 vector() { return {uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)}; }
  Problem() {
    for (std::size_t j = 0; j < t.space.size(); ++j)
      for (std::size_t i = 0; i < s.space.size(); ++i)
        if (i == 0 || j == 0 || i + 1 == s.space.size() || j + 1 == t.space.size())
          boundary.points[boundary.index(i, j)] = vector();
    for (std::size_t k = 0; k < s.size() * t.size(); ++k) {
      targets.push_back(vector());
      areas.push_back(Vector3(0, 0, 1) + 0.3 * vector());
    }
    for (int side = 0; side < 4; ++side)
      for (const double f : {0.1, 0.35, 0.6, 0.9}) {
        const SplineSpace& along = side % 2 == 0 ? s.space : t.space;
        ties.push_back({turn_tie(boundary, side, f * along.end(), vector().normalized(), 2), 5, vector(), 0.1,
                        uniform(rng, -1, 1)});
      }
  }

  /// Cost that the solution minimises; `whole`: control points of a surface with the problem's boundary.
  double cost(const SplineSurface& whole) const {
    double out = 0;
    const auto points = evaluate_grid(whole, s.basis, t.basis),
               outer = evaluate_grid(boundary, s.basis, t.basis);
    for (std::size_t j = 0; j < t.size(); ++j)
      for (std::size_t i = 0; i < s.size(); ++i) {
        const std::size_t k = j * s.size() + i;
        out += weight * s.weight[i] * t.weight[j] *
               (points[k].position - outer[k].position - targets[k]).squaredNorm();
      }
    for (const FaceTie& tie : ties) {
      const Vector3 miss = tie.tie.sum(whole) - tie.rest - tie.wanted * tie.tie.normal;
      const double normal = miss.dot(tie.tie.normal);
      out += tie.weight * (tie.rest_share * miss.squaredNorm() + (1 - tie.rest_share) * normal * normal);
    }
    return out;
  }
  double volume_of(const SplineSurface& whole) const {
    double out = 0;
    const auto points = evaluate_grid(whole, s.basis, t.basis),
               outer = evaluate_grid(boundary, s.basis, t.basis);
    for (std::size_t j = 0; j < t.size(); ++j)
      for (std::size_t i = 0; i < s.size(); ++i) {
        const std::size_t k = j * s.size() + i;
        out += s.weight[i] * t.weight[j] * areas[k].dot(points[k].position - outer[k].position);
      }
    return out;
  }
};

TEST(InnerFit, IsTheLeastCostOfAllSurfacesWithTheVolume) {
  Problem problem;
  InnerFit fit(problem.s, problem.t, problem.weight, 1);
  fit.aim(problem.targets, problem.areas, problem.volume);
  fit.tie(problem.ties, problem.boundary);
  SplineSurface solved = problem.boundary;
  fit.solve(solved);
  EXPECT_NEAR(problem.volume_of(solved), problem.volume, 1e-10);
  // A quadratic cost is least where steps to both sides cost as much more.
  for (int round = 0; round < 40; ++round) {
    SplineSurface step = problem.boundary, up = solved, down = solved;
    for (std::size_t k = 0; k < step.points.size(); ++k) step.points[k].setZero();
    for (std::size_t j = 1; j + 1 < problem.t.space.size(); ++j)
      for (std::size_t i = 1; i + 1 < problem.s.space.size(); ++i)
        step.points[step.index(i, j)] = problem.vector();
    // Without change of the volume, by one control point.
    SplineSurface one = solved, moved = solved;
    const std::size_t middle = one.index(3, 3);
    one.points[middle].z() += 1;
    for (std::size_t k = 0; k < step.points.size(); ++k) moved.points[k] += step.points[k];
    const double slope = problem.volume_of(one) - problem.volume_of(solved);
    step.points[middle].z() -= (problem.volume_of(moved) - problem.volume_of(solved)) / slope;
    for (std::size_t k = 0; k < step.points.size(); ++k) {
      up.points[k] += step.points[k];
      down.points[k] -= step.points[k];
    }
    const double here = problem.cost(solved), more = problem.cost(up) - here,
                 less = problem.cost(down) - here;
    EXPECT_GT(more, 0);
    EXPECT_NEAR(more, less, 1e-9 * more);
  }
}

TEST(InnerFit, RowsAreThoseOfTheWholeSolution) {
  Problem problem;
  InnerFit fit(problem.s, problem.t, problem.weight, 1);
  fit.aim(problem.targets, problem.areas, problem.volume);
  fit.tie(problem.ties, problem.boundary);
  std::vector<double> wanted;
  for (std::size_t k = 0; k < problem.ties.size(); ++k) wanted.push_back(0.1 * double(k));
  fit.want(wanted);
  SplineSurface rows = problem.boundary, whole = problem.boundary;
  fit.solve_rows(rows);
  fit.solve(whole);
  const std::size_t m = problem.s.space.size(), n = problem.t.space.size();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < m; ++i) {
      const bool seen = i < 2 || j < 2 || i + 2 >= m || j + 2 >= n;
      const Vector3 want = seen ? whole.points[whole.index(i, j)] : Vector3(Vector3::Zero());
      EXPECT_LT((rows.points[rows.index(i, j)] - want).norm(), 1e-10);
    }
}

TEST(InnerFit, SplinesAreReproducedWithoutTies) {
  Problem problem;
  SplineSurface given = problem.boundary;
  for (std::size_t j = 1; j + 1 < problem.t.space.size(); ++j)
    for (std::size_t i = 1; i + 1 < problem.s.space.size(); ++i)
      given.points[given.index(i, j)] = problem.vector();
  const auto all = evaluate_grid(given, problem.s.basis, problem.t.basis),
             outer = evaluate_grid(problem.boundary, problem.s.basis, problem.t.basis);
  for (std::size_t k = 0; k < all.size(); ++k) problem.targets[k] = all[k].position - outer[k].position;
  InnerFit fit(problem.s, problem.t, problem.weight, 1);
  fit.aim(problem.targets, problem.areas, problem.volume_of(given));
  fit.tie({}, problem.boundary);
  SplineSurface solved = problem.boundary;
  fit.solve(solved);
  for (std::size_t k = 0; k < given.points.size(); ++k)
    EXPECT_LT((solved.points[k] - given.points[k]).norm(), 1e-9);
}

}  // namespace
}  // namespace hariko::test
