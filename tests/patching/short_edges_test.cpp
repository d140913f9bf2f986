// Networks by measure beside edges far shorter than those next to them (kuriyama.md section 12.8): boxes
// tightened by loops near their edges, and flat triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/network/short_edges.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A box cut by loops at these coordinates, the first and last of which are its ends.
PolygonMesh box_with_loops(const std::array<std::vector<double>, 3>& cuts) {
  PolygonMesh mesh;
  std::map<std::array<std::size_t, 3>, Index> known;
  const auto corner = [&](std::size_t axis, std::size_t level, std::size_t i, std::size_t j) {
    std::array<std::size_t, 3> at{};
    at[axis] = level;
    at[(axis + 1) % 3] = i;
    at[(axis + 2) % 3] = j;
    const auto [found, fresh] = known.try_emplace(at, Index(mesh.positions.size()));
    if (fresh) mesh.positions.emplace_back(cuts[0][at[0]], cuts[1][at[1]], cuts[2][at[2]]);
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i + 1 < cuts[(axis + 1) % 3].size(); ++i)
      for (std::size_t j = 0; j + 1 < cuts[(axis + 2) % 3].size(); ++j)
        for (const bool last : {false, true}) {
          const std::size_t level = last ? cuts[axis].size() - 1 : 0;
          std::vector<Index> face{corner(axis, level, i, j), corner(axis, level, i + 1, j),
                                  corner(axis, level, i + 1, j + 1), corner(axis, level, i, j + 1)};
          if (!last) std::reverse(face.begin(), face.end());
          mesh.add_face(face);
        }
  return mesh;
}

PolygonMesh box_with_a_loop(double size, double distance) {
  return box_with_loops({std::vector<double>{0, size}, {0, size}, {0, size - distance, size}});
}

struct Made {
  Polyhedron polyhedron;
  PolyhedronSurface surface;
  const Vector3& tangent(Index from, Index to) const {
    return surface.network->start[polyhedron.topology().find_half_edge(from, to)];
  }
};
Made make(const PolygonMesh& mesh) {
  Polyhedron polyhedron = Polyhedron::build(mesh).value();
  PolyhedronSurfaceInput input{polyhedron, {}, Mode::fair, Vector3::Zero()};
  input.frames = Frames::metric;
  auto made = must(PolyhedronSurfacer().rebuild(input));
  return {std::move(polyhedron), std::move(made).value()};
}

Index vertex_at(const PolygonMesh& mesh, const Vector3& place) {
  const auto nearest = std::min_element(
      mesh.positions.begin(), mesh.positions.end(),
      [&](const Vector3& a, const Vector3& b) { return (a - place).norm() < (b - place).norm(); });
  return Index(nearest - mesh.positions.begin());
}

TEST(ShortEdges, ALengthIsKeptFromZeroButHardlyLonger) {
  EXPECT_DOUBLE_EQ(fan_length(2, 2), std::hypot(2, 0.02));
  EXPECT_DOUBLE_EQ(fan_length(0.2, 2), std::hypot(0.2, 0.02));
  EXPECT_GT(fan_length(0, 2), 0);
  double last = 0;
  for (double length = 1e-5; length < 2; length *= 1.01) {
    const double kept = fan_length(length, 2);
    EXPECT_GT(kept, last);
    if (length > 0.01) {
      EXPECT_LT(kept, 1.05 * length);
    }
    last = kept;
  }
}

TEST(ShortEdges, BoxesWithRandomLoopsDoNotFold) {
  for_random(34, 24, [](std::mt19937_64& rng) {
    std::array<std::vector<double>, 3> cuts;
    for (std::vector<double>& cut : cuts) {
      const double size = std::exp(uniform(rng, -1, 1));
      cut = {0, size};
      for (int loops = uniform_int(rng, 0, 2); loops > 0; --loops)
        cut.push_back(size * uniform(rng, 0.02, 0.98));
      std::sort(cut.begin(), cut.end());
      // Loops at one place are one.
      cut.erase(std::unique(cut.begin(), cut.end(), [&](double a, double b) { return b - a < 0.005 * size; }),
                cut.end());
      cut.back() = size;
    }
    const PolyhedronSurface made = make(box_with_loops(cuts)).surface;
    const ContinuityReport report = continuity(made.surface);
    EXPECT_EQ(report.folded_samples, 0U);
    EXPECT_LE(report.largest_normal_jump.value_or(0), 1e-10);
  });
}

TEST(ShortEdges, ALoopNearTheEndOfABoxTightensItsRim) {
  for (const double size : {1e-3, 1.0, 1e6})
    for (const double share : {0.1, 0.03, 0.01}) {
      const PolygonMesh mesh = box_with_a_loop(size, share * size);
      const Made made = make(mesh);
      const ContinuityReport report = continuity(made.surface.surface);
      EXPECT_EQ(report.folded_samples, 0U) << size << " " << share;
      EXPECT_LE(report.largest_normal_jump.value_or(0), 1e-10);
      // Its bending is that of a rim, which goes with length over radius.
      EXPECT_LT(measure(made.surface.surface).bending, 60 / share) << size << " " << share;
    }
}

TEST(ShortEdges, ARimAndTheLoopBesideItGoAlike) {
  const PolygonMesh mesh = box_with_a_loop(2, 0.01);
  const Made made = make(mesh);
  const auto turn = [&](double z) {
    const Index corner = vertex_at(mesh, {0, 0, z});
    const Vector3 a = made.tangent(corner, vertex_at(mesh, {2, 0, z})).normalized();
    const Vector3 b = made.tangent(corner, vertex_at(mesh, {0, 2, z})).normalized();
    return std::numbers::pi - std::acos(std::clamp(a.dot(b), -1.0, 1.0));
  };
  EXPECT_LT(turn(1.99), 5 * degree);  // a flow line
  EXPECT_LT(turn(2), 30 * degree);    // a right angle in the box
}

TEST(ShortEdges, ASideDoesNotBulgePastACornerCloseToIt) {
  // An octahedron with a vertex in the plane of a face, close to the middle of its side.
  for (const double size : {1e-3, 1.0, 1e6})
    for (const double distance : {0.1, 0.05}) {
      PolygonMesh mesh;
      mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      const Vector3 middle(0.5, 0.5, 0);
      mesh.positions.push_back(middle + distance * (Vector3(0, 0, 1) - middle).normalized());
      for (Vector3& p : mesh.positions) p *= size;
      for (const auto& face : {std::vector<Index>{0, 2, 6},
                               {2, 4, 6},
                               {4, 0, 6},
                               {2, 1, 4},
                               {1, 3, 4},
                               {3, 0, 4},
                               {2, 0, 5},
                               {1, 2, 5},
                               {3, 1, 5},
                               {0, 3, 5}})
        mesh.add_face(face);
      const Made made = make(mesh);
      const Vector3 bulge = 0.375 * (made.tangent(0, 2) + made.tangent(2, 0));
      EXPECT_LT(bulge.norm(), 0.75 * distance * size) << size << " " << distance;
      EXPECT_EQ(continuity(made.surface.surface).folded_samples, 0U);
    }
}

}  // namespace
}  // namespace hariko::test
