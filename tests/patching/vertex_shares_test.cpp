// Shares of vertices: the surface after moves is the surface before and the moves times the shares.

#include "core/patching/vertex_shares.hpp"

#include <algorithm>
#include <array>

#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

using namespace test;

const std::vector<Vector2>& places() {
  static const std::vector<Vector2> out{{0.1, 0.2}, {0.6, 0.3}, {1. / 3, 1. / 3}, {1, 0}, {0, 0}};
  return out;
}

PolyhedronSurfaceInput input_of(const PolygonMesh& mesh, Mode mode) {
  return {Polyhedron::build(mesh).value(), {}, mode};
}

/// Points at the places on all patches.
std::vector<Vector3> points_of(const PolyhedronSurfaceInput& input) {
  const Surface surface = PolyhedronSurfacer().rebuild(input).value().surface;
  std::vector<Vector3> out;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (const Vector2& at : places())
      out.push_back(surface.patches().evaluate(p, at, Order::first).position);
  return out;
}

/// Largest difference between how points move with one vertex and its shares; beyond the faces that have its
/// shares, how far points move.
double worst_error(const PolyhedronSurfaceInput& input, const std::vector<FaceShares>& shares, Index vertex) {
  const HalfEdgeMesh& mesh = input.polyhedron.topology();
  const Vector3 move(0.25, -0.5, 1);
  PolyhedronSurfaceInput after = input;
  after.polyhedron = input.polyhedron
                         .with_positions(std::array{vertex},
                                         std::array<Vector3, 1>{input.polyhedron.position(vertex) + move})
                         .value();
  const std::vector<Vector3> from = points_of(input), to = points_of(after);
  double worst = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& vertices = shares[f].vertices;
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), vertex);
    const bool has = found != vertices.end() && *found == vertex;
    const std::size_t first = mesh.face_begin(f) * places().size();
    for (std::size_t p = 0; p < mesh.side_count(f) * places().size(); ++p) {
      const double share =
          has ? shares[f].of_point(p)[static_cast<std::size_t>(found - vertices.begin())] : 0;
      worst = std::max(worst, (to[first + p] - from[first + p] - share * move).norm() / move.norm());
    }
  }
  return worst;
}

TEST(VertexShares, AreHowTheSurfaceFollowsWhereFramesStay) {
  for (const Mode mode : {Mode::paper, Mode::target, Mode::fair})
    for (const PolygonMesh& mesh : {cube(), prism(5), torus(9, 8), grid(9, 9)}) {
      const PolyhedronSurfaceInput input = input_of(mesh, mode);
      const auto shares = must(vertex_shares(input, places()));
      for (Index v = 0; v < input.polyhedron.vertex_count(); v += 7)
        EXPECT_LT(worst_error(input, *shares, v), 0.08) << mesh.positions.size() << " vertex " << v;
    }
}

TEST(VertexShares, OfSmallCagesAreExact) {
  // Every vertex is within one diagonal of every face, so none is left out.
  const PolyhedronSurfaceInput input = input_of(cube(), Mode::fair);
  const auto shares = must(vertex_shares(input, places()));
  for (Index v = 0; v < 8; ++v) EXPECT_LT(worst_error(input, *shares, v), 1e-6) << v;
}

TEST(VertexShares, AddUpToOneAndAreOneAtTheVertexItself) {
  for (const Frames frames : {Frames::equal, Frames::metric})
    for (const Mode mode : {Mode::fair, Mode::g2}) {
      PolyhedronSurfaceInput input = input_of(torus(9, 8), mode);
      input.frames = frames;
      const auto shares = must(vertex_shares(input, places()));
      const HalfEdgeMesh& mesh = input.polyhedron.topology();
      for (Index f = 0; f < mesh.face_count(); ++f) {
        const FaceShares& face = (*shares)[f];
        for (std::size_t p = 0; p < mesh.side_count(f) * places().size(); ++p) {
          double sum = 0;
          for (const double share : face.of_point(p)) sum += share;
          EXPECT_NEAR(sum, 1, 1e-12);
        }
        const Index v = mesh.origin(mesh.face_begin(f));
        const auto own =
            std::lower_bound(face.vertices.begin(), face.vertices.end(), v) - face.vertices.begin();
        EXPECT_NEAR(face.of_point(3)[static_cast<std::size_t>(own)], 1, 1e-3) << "corner 1 is the vertex";
      }
    }
}

TEST(VertexShares, CanBeCancelled) {
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  const auto shares = vertex_shares(input_of(torus(5, 5), Mode::fair), places(), cancel);
  ASSERT_FALSE(shares.ok());
  EXPECT_EQ(shares.error().code.name, e_cancelled.name);
}

}  // namespace
}  // namespace hariko
