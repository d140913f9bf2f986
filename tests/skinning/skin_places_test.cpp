#include "core/skinning/sections/skin_places.hpp"

#include <cmath>

#include "tests/skinning/random_skins.hpp"
#include "tests/skinning/skin_inputs.hpp"

namespace hariko::test {
namespace {

double apart(double a, double b, bool closed) {
  const double gap = std::abs(a - b);
  return closed ? std::min(gap, std::abs(1 - gap)) : gap;
}

void expect_places(const Skin& skin) {
  const auto made = SkinSurfacer().surface(skin, Vector3::Zero());
  // Random correspondences may fold a mesh onto itself.
  if (!made.ok() && made.error().code == e_control_mesh) return;
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const SkinMesh& mesh = made->result.mesh;
  const SubdivisionTopology& topology = subdivision_patches(made->surface)->topology();
  const std::vector<double> places = vertex_places(skin, mesh);
  const bool closed = skin.path.closed;
  const auto at = [&](Index patch, const Vector2& p) {
    return place_on_path(topology, places, closed, patch, p);
  };
  for (Index patch = 0; patch < topology.patch_count(); ++patch)
    for (int corner = 0; corner < 4; ++corner) {
      const Index vertex = topology.node_vertex(topology.node(patch, corner));
      const auto place = at(patch, corner_parameter(Domain::square, corner));
      if (vertex == no_index || !place) continue;
      EXPECT_LT(apart(*place, places[vertex] - std::floor(places[vertex]), true), 1e-12);
    }
  // Both sides of a seam are at the same places.
  for (const Seam& seam : *topology.seams()) {
    for (const double x : {0.25, 0.5, 0.75}) {
      const auto a = at(seam.first.patch, side_parameter(Domain::square, seam.first.side, x)),
                 b = at(seam.second.patch, side_parameter(Domain::square, seam.second.side, 1 - x));
      if (!a || !b) continue;
      EXPECT_LT(apart(*a, *b, closed), 1e-12);
    }
  }
}

TEST(SkinPlaces, AreThoseOfRowsAndContinuous) {
  for (const char* name : {"car_edited", "tube", "merge_split", "ring", "fig9_interior"}) {
    SCOPED_TRACE(name);
    Skin skin = skin_input(name);
    expect_places(skin);
    skin.method = SkinMethod::smooth;
    skin.smooth.parameters = ColumnParameters::uniform;
    expect_places(skin);
  }
  for_random(941, 20, [](std::mt19937_64& rng) { expect_places(random_skin(rng)); });
}

TEST(SkinPlaces, CapsHaveNone) {
  Skin skin = skin_input("tube");
  skin.caps = Caps::dome;
  const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  const SubdivisionTopology& topology = subdivision_patches(made->surface)->topology();
  const std::vector<double> places = vertex_places(skin, made->result.mesh);
  int none = 0;
  for (Index patch = 0; patch < topology.patch_count(); ++patch)
    none += !place_on_path(topology, places, false, patch, {0.5, 0.5});
  EXPECT_GT(none, 0);
  EXPECT_LT(none, int(topology.patch_count()) / 2);
}

}  // namespace
}  // namespace hariko::test
