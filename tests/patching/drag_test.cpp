// A dragged vertex: few patches change, and what is shown differs from the full solution by less than 1e-9 of
// the object's size.

#include <Eigen/Geometry>
#include <set>

#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

const QuarticPatchSet& set_of(const PolyhedronSurface& surface) {
  return dynamic_cast<const QuarticPatchSet&>(surface.surface.patches());
}

double largest_difference(const QuarticPatchSet& a, const QuarticPatchSet& b) {
  double largest = 0;
  for (Index h = 0; h < a.patch_count(); ++h)
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      largest = std::max(largest, (a.patch(h).control[i] - b.patch(h).control[i]).norm());
  return largest;
}

void drag_and_compare(const Polyhedron& start, const Shaping& shaping, Mode mode, std::vector<Index> vertices,
                      std::mt19937_64& rng, std::size_t* changed_count = nullptr, bool soft = false) {
  PolyhedronSurfaceInput input{start, shaping, mode, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  const auto before = must(surfacer.rebuild(input));
  PolyhedronSurface dragged;
  Vector3 move;
  std::vector<double> shares(vertices.size(), 1);
  for (std::size_t i = 1; soft && i < shares.size(); ++i) shares[i] = uniform(rng, 0.01, 1);
  for (int frame = 0; frame < 3 || !dragged.settled; ++frame) {
    ASSERT_LT(frame, 40);
    move = random_vector(rng, 0.3);
    std::vector<Vector3> positions;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      positions.push_back(start.position(vertices[i]) + shares[i] * move);
    input.polyhedron = start.with_positions(vertices, positions).value();
    dragged = surfacer.rebuild(input, Quality::drag).value();
    ASSERT_TRUE(dragged.changed);
    EXPECT_EQ(dragged.base_revision, before->revision);
  }
  PolyhedronSurfacer fresh;
  const auto full = fresh.rebuild(input);
  EXPECT_LT(largest_difference(set_of(dragged), set_of(*full)), 1e-9 * size_of(start));
  std::set<Index> changed(dragged.changed->begin(), dragged.changed->end());
  for (Index h = 0; h < set_of(dragged).patch_count(); ++h)
    if (!changed.contains(h)) {
      for (std::size_t i = 0; i < quartic_control_count; ++i)
        ASSERT_EQ(set_of(dragged).patch(h).control[i], set_of(*before).patch(h).control[i]);
    }
  if (changed_count) *changed_count = changed.size();

  const auto released = surfacer.rebuild(input, Quality::final);
  for (Index h = 0; h < set_of(*released).patch_count(); ++h)
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      ASSERT_EQ(set_of(*released).patch(h).control[i], set_of(*full).patch(h).control[i])
          << "final depends on history";
}

TEST(Drag, OneVertexOfTwentyThousandFaces) {
  std::mt19937_64 rng(31);
  PolygonMesh mesh = torus(200, 100);
  perturb(mesh, rng, 0.1);
  const Polyhedron polyhedron = Polyhedron::build(mesh).value();
  for (const Mode mode : {Mode::paper, Mode::target, Mode::fair}) {
    std::size_t changed = 0;
    drag_and_compare(polyhedron, {}, mode, {12345}, rng, &changed);
    EXPECT_LT(changed, 3000U);
    EXPECT_GT(changed, 100U);
  }
}

TEST(Drag, VerticesThatFollowInPart) {
  for_random(35, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const Shaping shaping = random_shaping(polyhedron, rng, 100, 0.01, 100);
    std::set<Index> vertices;
    for (int i = uniform_int(rng, 2, 12); i > 0; --i)
      vertices.insert(
          static_cast<Index>(uniform_int(rng, 0, static_cast<int>(polyhedron.vertex_count()) - 1)));
    drag_and_compare(polyhedron, shaping, chance(rng, 0.5) ? Mode::fair : Mode::target,
                     {vertices.begin(), vertices.end()}, rng, nullptr, true);
  });
}

TEST(Drag, SeveralVerticesOfRandomPolyhedraWithTensions) {
  for_random(32, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const Shaping shaping = random_shaping(polyhedron, rng, 100, 0.01, 100);
    std::set<Index> vertices;
    for (int i = uniform_int(rng, 1, 4); i > 0; --i)
      vertices.insert(static_cast<Index>(rng() % polyhedron.vertex_count()));
    for (const Mode mode : {Mode::paper, Mode::target, Mode::fair})
      drag_and_compare(polyhedron, shaping, mode, {vertices.begin(), vertices.end()}, rng);
  });
}

TEST(Drag, TensionSlidersAndNormalPinsFallBackToASolve) {
  std::mt19937_64 rng(33);
  PolyhedronSurfaceInput input{Polyhedron::build(cube()).value(), {}, Mode::fair, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  ASSERT_TRUE(surfacer.rebuild(input).ok());
  input.shaping.alpha.set({0}, 3.0);
  const auto tensioned = surfacer.rebuild(input, Quality::drag).value();
  EXPECT_FALSE(tensioned.changed);
  PolyhedronSurfacer fresh;
  EXPECT_LT(largest_difference(set_of(tensioned), set_of(*fresh.rebuild(input))), 1e-4);

  input.shaping.pin.set({6}, {Pin::Kind::normal, {Vector3(1, 2, 3)}});
  ASSERT_TRUE(surfacer.rebuild(input).ok());
  const Index v = 6;
  const Vector3 moved = input.polyhedron.position(v) + Vector3(0.1, 0, 0);
  input.polyhedron = input.polyhedron.with_positions(std::span(&v, 1), std::span(&moved, 1)).value();
  const auto pinned = surfacer.rebuild(input, Quality::drag).value();
  EXPECT_FALSE(pinned.changed);
  EXPECT_LT(largest_difference(set_of(pinned), set_of(*fresh.rebuild(input))), 1e-4);
}

TEST(Drag, CancelGivesAnErrorAndKeepsTheSurfacerUsable) {
  PolyhedronSurfaceInput input{Polyhedron::build(torus(30, 20)).value(), {}, Mode::fair, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  const auto stopped = surfacer.rebuild(input, Quality::final, cancel);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code.name, e_cancelled.name);
  EXPECT_TRUE(surfacer.rebuild(input).ok());
}

}  // namespace
}  // namespace hariko::test
