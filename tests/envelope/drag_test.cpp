// One solid is dragged in a thousand steps through the others: what the screen shows between two frames. The
// short version does the steps in the middle, where the solids meet; HARIKO_REPEAT_SCALE=200 does all.

#include <iostream>
#include <numeric>

#include "core/analysis/continuity.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

constexpr int all_steps = 1000;

struct Frame {
  std::vector<Vector3> points;  ///< grid points on every patch
  std::vector<std::pair<Index, Index>> connection;
};

Frame frame_of(const EnvelopeSurface& made) {
  const GridPattern pattern{made.surface.domain(), 3};
  std::vector<Index> all(made.surface.patch_count());
  std::iota(all.begin(), all.end(), Index{0});
  Frame out;
  out.points.resize(all.size() * std::size_t(pattern.point_count()));
  std::vector<Vector3> normals(out.points.size());
  made.surface.patches().evaluate_grid(all, pattern, out.points, normals);
  for (Vector3& p : out.points) p += made.origin;
  for (const Seam& seam : made.surface.seams())
    out.connection.emplace_back(4 * seam.first.patch + seam.first.side,
                                4 * seam.second.patch + seam.second.side);
  return out;
}

/// Largest move of a point where the patches are the same ones; else largest distance of a point from the
/// nearest one before, less the spacing of these.
double jump(const Frame& before, const Frame& now, bool same) {
  double largest = 0;
  if (same) {
    for (std::size_t i = 0; i < now.points.size(); ++i)
      largest = std::max(largest, (now.points[i] - before.points[i]).norm());
    return largest;
  }
  for (const Vector3& p : now.points) {
    double least = 1e300;
    for (const Vector3& q : before.points) least = std::min(least, (p - q).squaredNorm());
    largest = std::max(largest, least);
  }
  return std::sqrt(largest);
}

struct Statistics {
  int changes = 0;
  double steady = 0, change = 0;  ///< largest jump, over the diagonal
};

Statistics drag(EnvelopeInput input, int steps) {
  const int first = (all_steps - steps) / 2;
  const Solid solid = input.solids.front();
  Eigen::AlignedBox3d box;
  for (const Solid& other : input.solids) box.extend(box_of(other));
  const Vector3 from(box.min().x() - 0.5 * box.sizes().x(), box.center().y(), box.center().z());
  const Vector3 way(2 * box.sizes().x(), 0, 0);
  const auto place = [&](int step) { input.solids.front().position = from + step / double(all_steps) * way; };
  EnvelopeSurfacer surfacer;
  place(first);
  const auto start = must(surfacer.rebuild(input));
  Statistics out;
  Frame before = frame_of(*start);
  for (int step = first + 1; step <= first + steps; ++step) {
    place(step);
    const auto made = surfacer.rebuild(input, Quality::drag);
    EXPECT_TRUE(made.ok()) << step;
    if (!made) return out;
    const Frame now = frame_of(*made);
    const bool finite =
        std::all_of(now.points.begin(), now.points.end(), [](const Vector3& p) { return p.allFinite(); });
    EXPECT_TRUE(finite) << step;
    EXPECT_TRUE(made->surface.boundary_sides().empty()) << step;
    if (step % 20 == 0) {
      EXPECT_LE(continuity(made->surface).largest_gap, 1e-12 * made->diagonal) << step;
    }
    const bool same = now.connection == before.connection && now.points.size() == before.points.size();
    const double moved = jump(before, now, same) / made->diagonal;
    double& largest = same ? out.steady : out.change;
    largest = std::max(largest, moved);
    out.changes += !same;
    before = now;
  }
  // Released, the surface is the one that the solids have from the start.
  const auto released = must(surfacer.rebuild(input)), cold = must(EnvelopeSurfacer().rebuild(input));
  EXPECT_EQ(frame_of(*released).points, frame_of(*cold).points);
  return out;
}

}  // namespace

TEST(EnvelopeDrag, ASolidGoesThroughTheOthersWithoutGaps) {
  const int steps = std::min(all_steps, repetitions(5));
  for (const char* name : {"four"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    choose_ball(input);
    const Statistics found = drag(input, steps);
    std::cout << name << ": " << steps << " steps, " << found.changes
              << " changes of the patches; largest move " << found.steady << ", at a change " << found.change
              << " of the diagonal\n";
    // A step of the solid is a five hundredth of the scene's width; points of another grid are farther off.
    EXPECT_LE(found.change, 0.03);
    EXPECT_LE(found.steady, 0.03);
  }
}

}  // namespace hariko::test
