#include "core/skinning/columns/correspondence.hpp"

#include <algorithm>
#include <limits>

#include "core/skinning/skin_messages.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

struct Best {
  int triangles = std::numeric_limits<int>::max();
  double cost = 0;
};

/// Every way to go from one pair to another, one step at a time.
void walk(PointPair at, PointPair end, std::vector<PointPair>& path, int triangles, double sum,
          const PairCost& cost, const std::vector<PointPair>& forced, int n, int m, Best& best) {
  if (at == end) {
    for (const PointPair& f : forced) {
      const bool met = std::any_of(path.begin(), path.end(), [&](const PointPair& p) {
        return PointPair{p.a % n, p.b % m} == f;
      });
      if (!met) return;
    }
    if (triangles < best.triangles || (triangles == best.triangles && sum < best.cost))
      best = {triangles, sum};
    return;
  }
  for (const auto& [da, db] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 1}}) {
    const PointPair next{at.a + da, at.b + db};
    if (next.a > end.a || next.b > end.b) continue;
    path.push_back(next);
    walk(next, end, path, triangles + (da + db == 1), sum + cost(next.a % n, next.b % m), cost, forced, n, m,
         best);
    path.pop_back();
  }
}

Best brute_open(int n, int m, const PairCost& cost, const std::vector<PointPair>& forced) {
  Best best;
  std::vector<PointPair> path{{0, 0}};
  walk({0, 0}, {n - 1, m - 1}, path, 0, cost(0, 0), cost, forced, n, m, best);
  return best;
}

Best brute_closed(int n, int m, const PairCost& cost, const std::vector<PointPair>& forced) {
  Best best;
  for (int start = 0; start < m; ++start) {
    std::vector<PointPair> path{{0, start}};
    // The pair at the cut counts once, at the end.
    walk({0, start}, {n, start + m}, path, 0, 0, cost, forced, n, m, best);
  }
  return best;
}

Best score(const std::vector<PointPair>& lines, int n, int m, bool closed, const PairCost& cost) {
  Best out{0, 0};
  for (std::size_t p = 0; p < lines.size(); ++p) {
    out.cost += cost(lines[p].a, lines[p].b);
    if (!closed && p + 1 == lines.size()) break;
    const PointPair next = lines[(p + 1) % lines.size()];
    const int da = (next.a - lines[p].a + n) % n, db = (next.b - lines[p].b + m) % m;
    EXPECT_LE(da, 1);
    EXPECT_LE(db, 1);
    EXPECT_GE(da + db, 1);
    out.triangles += da + db == 1;
  }
  return out;
}

/// The best of all that can be tried with some forced pairs, or a refusal where these cross.
void expect_best(std::mt19937_64& rng, int n, int m, bool closed) {
  std::vector<double> values(std::size_t(n * m));
  for (double& v : values) v = uniform(rng);
  const PairCost random_cost = [&](int a, int b) { return values[std::size_t(a * m + b)]; };
  const PairCost cost = chance(rng, 0.5) ? random_cost : parameter_cost(n, m, closed);
  std::vector<PointPair> forced;
  for (int k = uniform_int(rng, 0, closed ? 3 : 2); k > 0; --k)
    forced.push_back({uniform_int(rng, 0, n - 1), uniform_int(rng, 0, m - 1)});
  const Best wanted = closed ? brute_closed(n, m, cost, forced) : brute_open(n, m, cost, forced);
  const auto lines = correspondence(n, m, closed, cost, forced);
  if (wanted.triangles == std::numeric_limits<int>::max()) return must_fail(lines, e_link_cross);
  ASSERT_TRUE(lines.ok()) << to_string(lines.error());
  if (!closed) {
    EXPECT_EQ(lines->front(), (PointPair{0, 0}));
    EXPECT_EQ(lines->back(), (PointPair{n - 1, m - 1}));
  }
  const Best got = score(*lines, n, m, closed, cost);
  EXPECT_EQ(got.triangles, wanted.triangles);
  EXPECT_NEAR(got.cost, wanted.cost, 1e-11);
}

TEST(Correspondence, IsTheBestOfAllOpenOnes) {
  for_random(701, 250, [](std::mt19937_64& rng) {
    const int n = uniform_int(rng, 1, 6);
    expect_best(rng, n, uniform_int(rng, n == 1 ? 2 : 1, 6), false);
  });
}

TEST(Correspondence, IsTheBestOfAllClosedOnes) {
  for_random(702, 90, [](std::mt19937_64& rng) {
    const int n = uniform_int(rng, 3, 5);
    expect_best(rng, n, uniform_int(rng, 3, 5), true);
  });
}

TEST(Correspondence, MirrorImagesAreMatchedAlike) {
  for (int n = 2; n <= 12; ++n)
    for (int m = 2; m <= 12; ++m) {
      const auto lines = must(correspondence(n, m, false, parameter_cost(n, m, false), {}));
      std::vector<PointPair> mirrored;
      for (const PointPair& line : *lines) mirrored.push_back({n - 1 - line.a, m - 1 - line.b});
      std::reverse(mirrored.begin(), mirrored.end());
      // An odd number of triangles cannot be symmetric.
      if ((n - m) % 2 == 0) {
        EXPECT_EQ(*lines, mirrored) << n << ' ' << m;
      }
    }
}

}  // namespace
}  // namespace hariko::test
