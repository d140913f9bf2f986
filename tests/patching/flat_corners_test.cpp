// Corners of nearly a half turn: a vertex on a side of a face.

#include <cmath>
#include <numbers>

#include "core/network/fan_angles.hpp"
#include "core/network/vertex_frames.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// A prism of six sides and height 2 whose first side is cut in two from bottom to top, `share` of the way.
/// The vertices 12 (below) and 13 (above) lie on sides of faces 0 and 1.
PolygonMesh cut_prism(double share) {
  PolygonMesh mesh;
  for (const double z : {-1.0, 1.0})
    for (int k = 0; k < 6; ++k) {
      const double angle = k * std::numbers::pi / 3;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  for (const std::size_t low : {0, 6})
    mesh.positions.push_back((1 - share) * mesh.positions[low] + share * mesh.positions[low + 1]);
  mesh.add_face(std::vector<Index>{5, 4, 3, 2, 1, 12, 0});
  mesh.add_face(std::vector<Index>{6, 13, 7, 8, 9, 10, 11});
  mesh.add_face(std::vector<Index>{0, 12, 13, 6});
  mesh.add_face(std::vector<Index>{12, 1, 7, 13});
  for (Index k = 1; k < 6; ++k) mesh.add_face(std::vector<Index>{k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k});
  return mesh;
}

/// Angle from the edge of a corner to its split vector, as a share of the corner, in the fan.
double place_in_fan(const HalfEdgeMesh& mesh, const VertexFrames& frames, Index corner) {
  const auto [first, second] = frames.split_factors(mesh, corner);
  const double a = frames.length[2 * corner], b = frames.length[2 * mesh.previous(corner) + 1],
               step = frames.step[corner];
  return std::atan2(second * b * std::sin(step), first * a + second * b * std::cos(step)) / step;
}

TEST(FlatCorners, SplitVectorsGoWhereTheChartSays) {
  int flat = 0;
  for_random(31, 200, [&](std::mt19937_64& rng) {
    const double share = uniform(rng, 0.02, 0.98);
    PolygonMesh moved = cut_prism(share);
    // Along the side: the pieces' lengths change, not their directions.
    for (const std::size_t v : {12U, 13U})
      moved.positions[v] += uniform(rng, -0.1, 0.1) * std::min(share, 1 - share) *
                            (moved.positions[v - 11] - moved.positions[v - 12]);
    const Polyhedron polyhedron = Polyhedron::build(moved).value();
    const HalfEdgeMesh& mesh = polyhedron.topology();
    const VertexFrames frames = build_vertex_frames(polyhedron, {}, {Frames::metric}).value();
    for (const auto& [vertex, next] : {std::pair<Index, Index>(12, 0), std::pair<Index, Index>(13, 7)}) {
      const Index corner = mesh.find_half_edge(vertex, next);
      ASSERT_EQ(mesh.side_count(mesh.face(corner)), 7U);
      const double off =
          std::abs(place_in_fan(mesh, frames, corner) - place_in_corner(mesh, frames.charts, corner));
      const double share = flat_share(frames.step[corner], corner_angle(mesh, frames.charts, corner));
      EXPECT_LT(off, share == 1 ? 1e-9 : 0.5);
      flat += share == 1 ? 1 : 0;
    }
  });
  EXPECT_GT(flat, 0) << "corners are flat";
}

}  // namespace
}  // namespace hariko::test
