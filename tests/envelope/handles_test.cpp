// Handles: what the designer drags when a waist, a curve or a vertex changes.

#include "core/envelope/network_handles.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

TEST(EnvelopeBridges, MiddlesGoTheWayThatIsTold) {
  for (const char* name : {"two_apart", "four", "four_boxes"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    input.settings.tightness = 0;
    EnvelopeSurfacer surfacer;
    const auto before = surfacer.rebuild(input);
    ASSERT_TRUE(before.ok());
    ASSERT_FALSE(before->handles.bridges.empty());
    constexpr double step = 1e-3;
    for (std::size_t i = 0; i < before->handles.bridges.size(); i += 5) {
      const EnvelopeBridge& bridge = before->handles.bridges[i];
      EXPECT_LT(bridge.solids.low, bridge.solids.high);
      EXPECT_NEAR(bridge.outward.norm(), 1, 1e-12);
      // The same network with another factor: the search for enclosure is left out.
      std::vector<PlacedSolid> solids = place_solids(input);
      for (PlacedSolid& solid : solids) solid.centre -= before->origin;
      std::map<std::pair<Index, Index>, double> cuts;
      for (Index a = 0; a < solids.size(); ++a)
        for (Index b = a + 1; b < solids.size(); ++b)
          if (SolidPair::of(solids[a].id, solids[b].id) == bridge.solids) cuts[{a, b}] = 1;
      CurveSettings settings;
      settings.solids = solids;
      settings.waist = input.settings.waist;
      settings.cuts = &cuts;
      const auto middles = [&](double factor) {
        for (auto& [pair, cut] : cuts) cut = factor;
        EnvelopeSettings factors;
        factors.waists.set(bridge.solids, factor);
        return handles_of(curve_network(before->network->cage, settings), solids, factors).bridges;
      };
      const auto from = middles(1), to = middles(1 + step);
      ASSERT_EQ(from.size(), before->handles.bridges.size());
      const Vector3 told = step * from[i].way, gone = to[i].middle - from[i].middle;
      EXPECT_LE((told - gone).norm(), 1e-9 * before->diagonal);
      EXPECT_LE((from[i].way - to[i].way).norm(), 1e-9 * before->diagonal);
    }
  }
}

TEST(EnvelopeBridges, ImagesShareTheWaistOfTheirSolids) {
  EnvelopeInput input = golden_scene("two_apart");
  input.settings.symmetry = SymmetryPlane::z;
  for (Solid& solid : input.solids) solid.position.z() += 3;
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  bool to_image = false;
  for (const EnvelopeBridge& bridge : before->handles.bridges)
    to_image = to_image || bridge.solids.low == bridge.solids.high;
  EXPECT_TRUE(to_image) << "a solid and its image have a bridge, too";
  input.settings.waists.set(SolidPair::of(input.solids[0].id, input.solids[1].id), 0.5);
  const auto after = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(after.ok());
  EXPECT_TRUE(after->symmetric);
}

namespace {

/// Of the same vertex in a later surface; null where it was thinned out.
const EnvelopeVertex* vertex_of(const EnvelopeSurface& made, const NetworkVertexKey& key,
                                const Vector3& near) {
  const EnvelopeVertex* best = nullptr;
  for (const EnvelopeVertex& vertex : made.handles.vertices)
    if (vertex.vertex == key && (!best || (vertex.position - near).norm() < (best->position - near).norm()))
      best = &vertex;
  return best;
}

const EnvelopeCurve* curve_of(const EnvelopeSurface& made, const NetworkEdgeKey& key) {
  for (const EnvelopeCurve& curve : made.handles.curves)
    if (curve.curve == key) return &curve;
  return nullptr;
}

}  // namespace

TEST(EnvelopeHandles, VerticesGoWhereTheyArePulled) {
  for (const char* name : {"two_apart", "four", "dryer"}) {
    for (const double tightness : {0.0, 0.6}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(tightness));
      EnvelopeInput input = golden_scene(name);
      input.settings.method = EnvelopeMethod::network;
      input.settings.tightness = tightness;
      const auto before = EnvelopeSurfacer().rebuild(input);
      ASSERT_TRUE(before.ok());
      ASSERT_GE(before->handles.vertices.size(), 4U);
      for (std::size_t i = 0; i < before->handles.vertices.size(); i += 17) {
        const EnvelopeVertex& vertex = before->handles.vertices[i];
        EXPECT_LE((vertex.axes * vertex.axes.transpose() - Matrix3::Identity()).norm(), 1e-12);
        // Outwards, so that nothing has to be pushed back.
        const Vector3 pull = 0.04 * before->diagonal * vertex.outward;
        EnvelopeInput pulled = input;
        pulled.settings.offsets.set(vertex.vertex, vertex.axes.transpose() * pull);
        const auto after = EnvelopeSurfacer().rebuild(pulled);
        ASSERT_TRUE(after.ok());
        EXPECT_TRUE(after->enclosed);
        if (after->level != before->level) continue;
        const Vector3 shift = after->origin - before->origin;
        const EnvelopeVertex* found = vertex_of(*after, vertex.vertex, vertex.position - shift);
        ASSERT_TRUE(found);
        const Vector3 gone = found->position + shift - vertex.position;
        EXPECT_GT(gone.dot(pull), 0.5 * pull.squaredNorm());
      }
    }
  }
}

TEST(EnvelopeHandles, CurvesGetFullerTheWayThatIsTold) {
  for (const char* name : {"two_apart", "four"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    input.settings.tightness = 0;
    const auto before = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(before.ok());
    std::vector<PlacedSolid> solids = place_solids(input);
    for (PlacedSolid& solid : solids) solid.centre -= before->origin;
    ASSERT_FALSE(before->handles.curves.empty());
    for (std::size_t i = 0; i < before->handles.curves.size(); i += 3) {
      const NetworkEdgeKey key = before->handles.curves[i].curve;
      if (key.low.solid == key.high.solid) continue;  // their weights follow the curvature of the vertices
      // The same network with another factor: the search for enclosure is left out.
      const auto with = [&](double factor) {
        EnvelopeSettings factors = input.settings;
        factors.fullness.set(key, factor);
        CurveSettings settings;
        settings.solids = solids;
        settings.waist = input.settings.waist;
        settings.fullness = &factors.fullness;
        EnvelopeSurface made;
        made.handles = handles_of(curve_network(before->network->cage, settings), solids, factors);
        return made;
      };
      constexpr double step = 1e-3;
      const EnvelopeSurface from = with(1.2), to = with(1.2 + step);
      const EnvelopeCurve *a = curve_of(from, key), *b = curve_of(to, key);
      ASSERT_TRUE(a && b);
      EXPECT_LE((step * a->way - (b->middle - a->middle)).norm(), 1e-9 * before->diagonal);
    }
  }
}

TEST(EnvelopeHandles, OfSymmetricSolidsBothSidesFollow) {
  EnvelopeInput input = golden_scene("two_apart");
  input.settings.symmetry = SymmetryPlane::z;
  for (Solid& solid : input.solids) solid.position.z() += 3;
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  ASSERT_TRUE(before->symmetric);
  // One above the plane and one below have a handle each; every pull makes the surface symmetric again.
  for (const double side : {1.0, -1.0}) {
    SCOPED_TRACE(side);
    const EnvelopeVertex* outermost = nullptr;
    for (const EnvelopeVertex& vertex : before->handles.vertices)
      if (!outermost || side * vertex.position.z() > side * outermost->position.z()) outermost = &vertex;
    ASSERT_TRUE(outermost);
    const Vector3 pull = 0.05 * before->diagonal * outermost->outward;
    EnvelopeInput pulled = input;
    pulled.settings.offsets.set(outermost->vertex, outermost->axes.transpose() * pull);
    const auto after = EnvelopeSurfacer().rebuild(pulled);
    ASSERT_TRUE(after.ok());
    EXPECT_TRUE(after->symmetric);
    const Vector3 shift = after->origin - before->origin;
    const EnvelopeVertex* found = vertex_of(*after, outermost->vertex, outermost->position - shift);
    ASSERT_TRUE(found);
    EXPECT_GT((found->position + shift - outermost->position).dot(pull), 0.5 * pull.squaredNorm());
  }
}

}  // namespace hariko::test
