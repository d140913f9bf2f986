#include "core/skinning/columns/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/assert.hpp"
#include "core/base/index_list.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

PairCost parameter_cost(int n, int m, bool closed, double start) {
  return [n, m, closed, start](int a, int b) {
    const auto parameter = [closed](int i, int count) {
      const int spans = closed ? count : count - 1;
      return spans > 0 ? double(i) / spans : 0.5;
    };
    const double ua = parameter(a, n), ub = parameter(b, m);
    double d = std::abs(ua - ub);
    if (closed) {
      d = ua + start - ub;
      d -= std::round(d);
      return d * d;
    }
    return d * d - 1e-9 * (ua - 0.5) * (ub - 0.5);
  };
}

namespace {

struct Score {
  int triangles = std::numeric_limits<int>::max();
  double cost = 0;
  /// Costs that differ by rounding only are equal: then the earlier candidate is kept.
  friend bool operator<(const Score& x, const Score& y) {
    return x.triangles != y.triangles ? x.triangles < y.triangles : x.cost < y.cost - 1e-13;
  }
};

/// Best lines from `from` to `to`, unwrapped indices, in a grid of cells; `to` is part of the result.
class Segment {
 public:
  Segment(PointPair from, PointPair to, const PairCost& cost)
      : from_(from), width_(to.a - from.a + 1), height_(to.b - from.b + 1), cost_(cost) {}

  Score run() {
    best_.assign(std::size_t(width_) * std::size_t(height_), Score{});
    step_.assign(best_.size(), 0);
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) {
        Score& here = best_[at(i, j)];
        const double cost = cost_(from_.a + i, from_.b + j);
        if (i == 0 && j == 0) {
          here = {0, cost};
          continue;
        }
        const auto offer = [&](int di, int dj, int triangle, char step) {
          if (i < di || j < dj) return;
          const Score& before = best_[at(i - di, j - dj)];
          const Score candidate{before.triangles + triangle, before.cost + cost};
          if (candidate < here) here = candidate, step_[at(i, j)] = step;
        };
        offer(1, 1, 0, 0);
        offer(1, 0, 1, 1);
        offer(0, 1, 1, 2);
      }
    return best_.back();
  }
  /// Lines after `from`, in order.
  std::vector<PointPair> lines() const {
    std::vector<PointPair> out;
    int i = width_ - 1, j = height_ - 1;
    while (i > 0 || j > 0) {
      out.push_back({from_.a + i, from_.b + j});
      const char step = step_[at(i, j)];
      if (step != 2) --i;
      if (step != 1) --j;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  std::size_t at(int i, int j) const { return std::size_t(j) * std::size_t(width_) + std::size_t(i); }
  PointPair from_;
  int width_, height_;
  const PairCost& cost_;
  std::vector<Score> best_;
  std::vector<char> step_;
};

Message crossing(PointPair x, PointPair y) {
  const auto text = [](PointPair p) { return "(" + std::to_string(p.a) + "-" + std::to_string(p.b) + ")"; };
  return make_error(e_link_cross, "These correspondences cross: " + text(x) + " and " + text(y) + ".",
                    "Delete one of them.");
}

/// First two consecutive pairs in sorted order that cross; nothing when all are monotone.
std::optional<std::pair<PointPair, PointPair>> first_crossing(std::span<const PointPair> sorted) {
  for (std::size_t k = 0; k + 1 < sorted.size(); ++k)
    if (sorted[k + 1].b < sorted[k].b) return std::pair{sorted[k], sorted[k + 1]};
  return {};
}

std::vector<PointPair> through(std::span<const PointPair> stations, const PairCost& cost) {
  std::vector<PointPair> out{stations.front()};
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    if (stations[k] == stations[k + 1]) continue;
    Segment segment(stations[k], stations[k + 1], cost);
    segment.run();
    const auto lines = segment.lines();
    out.insert(out.end(), lines.begin(), lines.end());
  }
  return out;
}

Result<std::vector<PointPair>> open_lines(int n, int m, const PairCost& cost,
                                          std::vector<PointPair> stations) {
  stations.push_back({0, 0});
  stations.push_back({n - 1, m - 1});
  std::sort(stations.begin(), stations.end());
  if (const auto crossed = first_crossing(stations)) return crossing(crossed->first, crossed->second);
  return through(stations, cost);
}

Result<std::vector<PointPair>> closed_lines(int n, int m, const PairCost& cost,
                                            std::span<const PointPair> forced) {
  const auto wrapped = [&](PointPair p) { return PointPair{p.a % n, p.b % m}; };
  const PairCost cyclic = [&](int a, int b) { return cost(a % n, b % m); };
  const auto finish = [&](std::vector<PointPair> lines) {
    lines.pop_back();  // repeats the first line
    for (PointPair& p : lines) p = wrapped(p);
    return lines;
  };
  if (forced.empty()) {
    Score best;
    std::vector<PointPair> lines;
    for (int start = 0; start < m; ++start) {
      Segment segment({0, start}, {n, start + m}, cyclic);
      Score score = segment.run();
      score.cost -= cyclic(0, start);  // the cut is counted once
      if (!(score < best)) continue;
      best = score;
      lines = segment.lines();
      lines.insert(lines.begin(), {0, start});
    }
    return finish(std::move(lines));
  }
  // A pair may be the first or the last of a fan across the cut, so every pair is tried as the cut.
  std::optional<std::pair<PointPair, PointPair>> crossed;
  Score best;
  std::vector<PointPair> lines;
  for (const PointPair cut : forced) {
    std::vector<PointPair> stations;
    for (const PointPair p : forced)
      stations.push_back({cut.a + ((p.a - cut.a) % n + n) % n, cut.b + ((p.b - cut.b) % m + m) % m});
    stations.push_back({cut.a + n, cut.b + m});
    std::sort(stations.begin(), stations.end());
    if (const auto found = first_crossing(stations)) {
      if (!crossed) crossed = {wrapped(found->first), wrapped(found->second)};
      continue;
    }
    auto candidate = finish(through(stations, cyclic));
    Score score{0, 0};
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const PointPair here = candidate[p], next = candidate[(p + 1) % candidate.size()];
      score.triangles += here.a == next.a || here.b == next.b;
      score.cost += cost(here.a, here.b);
    }
    if (score < best) best = score, lines = std::move(candidate);
  }
  if (!lines.empty()) return lines;
  return crossing(crossed->first, crossed->second);
}

}  // namespace

Result<std::vector<PointPair>> correspondence(int n, int m, bool closed, const PairCost& cost,
                                              std::span<const PointPair> forced) {
  HARIKO_ASSERT(n >= 1 && m >= 1, "sections have points");
  std::vector<PointPair> pairs(forced.begin(), forced.end());
  sort_unique(pairs);
  for (const PointPair& p : pairs)
    HARIKO_ASSERT(p.a >= 0 && p.a < n && p.b >= 0 && p.b < m, "forced pairs are of points");
  if (closed && n > 1 && m > 1) return closed_lines(n, m, cost, pairs);
  return open_lines(n, m, cost, std::move(pairs));
}

}  // namespace hariko
