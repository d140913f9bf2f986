// Handles: what the designer drags when a waist, a curve or a vertex changes.

#include <set>

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

const EnvelopeCurve* curve_of(const EnvelopeHandles& handles, const NetworkEdgeKey& key) {
  for (const EnvelopeCurve& curve : handles.curves)
    if (curve.curve == key) return &curve;
  return nullptr;
}

/// Of the same network with another factor on a curve: the search for enclosure is left out.
EnvelopeHandles with_fullness(const EnvelopeSurface& made, const EnvelopeInput& input,
                              const NetworkEdgeKey& curve, double factor) {
  std::vector<PlacedSolid> solids = place_solids(input);
  for (PlacedSolid& solid : solids) solid.centre -= made.origin;
  EnvelopeSettings factors = input.settings;
  factors.fullness.set(curve, factor);
  CurveSettings settings;
  settings.solids = solids;
  settings.waist = input.settings.waist;
  settings.fullness = &factors.fullness;
  return handles_of(curve_network(made.network->cage, settings), solids, factors);
}

EnvelopeInput with_pulled(EnvelopeInput input, const EnvelopeVertex& vertex, const Vector3& way) {
  input.settings.offsets.set(vertex.vertex, vertex.axes.transpose() * way);
  return input;
}

void expect_followed(const EnvelopeSurface& before, const EnvelopeVertex& vertex,
                     const EnvelopeSurface& after, const Vector3& way) {
  const Vector3 shift = after.origin - before.origin;
  const EnvelopeVertex* found = vertex_of(after, vertex.vertex, vertex.position - shift);
  ASSERT_TRUE(found) << vertex.vertex.solid << " " << vertex.vertex.vertex;
  EXPECT_GT((found->position + shift - vertex.position).dot(way), 0.5 * way.squaredNorm());
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
        const auto after = EnvelopeSurfacer().rebuild(with_pulled(input, vertex, pull));
        ASSERT_TRUE(after.ok());
        EXPECT_TRUE(after->enclosed);
        if (after->level != before->level) continue;
        expect_followed(*before, vertex, *after, pull);
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
    ASSERT_FALSE(before->handles.curves.empty());
    for (std::size_t i = 0; i < before->handles.curves.size(); i += 3) {
      const NetworkEdgeKey key = before->handles.curves[i].curve;
      if (key.low.solid == key.high.solid) continue;  // their weights follow the curvature of the vertices
      constexpr double step = 1e-3;
      const EnvelopeHandles from = with_fullness(*before, input, key, 1.2),
                            to = with_fullness(*before, input, key, 1.2 + step);
      const EnvelopeCurve *a = curve_of(from, key), *b = curve_of(to, key);
      ASSERT_TRUE(a && b);
      EXPECT_LE((step * a->way - (b->middle - a->middle)).norm(), 1e-9 * before->diagonal);
    }
  }
}

TEST(EnvelopeHandles, InValleysVerticesGoWhereTheyArePulled) {
  // Corners that were put back between valleys, and points on a third solid below, follow as well.
  for (const char* name : {"ell_tight", "you", "car"}) {
    SCOPED_TRACE(name);
    const EnvelopeInput input = golden_scene(name);
    const auto before = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(before.ok());
    ASSERT_EQ(before->route, EnvelopeRoute::valleys);
    ASSERT_EQ(before->handles.vertices.size(), before->network->cage.vertices.size());
    ASSERT_EQ(before->handles.curves.size(), before->network->curves.size());
    std::set<NetworkVertexKey> names;
    std::size_t in_valley = 0;
    for (const EnvelopeVertex& vertex : before->handles.vertices) {
      EXPECT_TRUE(names.insert(vertex.vertex).second) << "two vertices have one name";
      in_valley += vertex.vertex.in_valley();
    }
    EXPECT_GE(in_valley, 2U);
    for (const EnvelopeVertex& vertex : before->handles.vertices) {
      const Vector3 pull = 0.03 * before->diagonal * vertex.outward;
      const auto after = EnvelopeSurfacer().rebuild(with_pulled(input, vertex, pull));
      ASSERT_TRUE(after.ok());
      EXPECT_EQ(after->route, EnvelopeRoute::valleys);
      if (after->level != before->level) continue;
      expect_followed(*before, vertex, *after, pull);
    }
  }
}

TEST(EnvelopeHandles, InValleysNamesStayWhileSolidsMove) {
  // As long as the edges of the hull do: what was flush, or of one height, stays so.
  for (const auto& [name, step] : {std::pair("ell_tight", Vector3(0, 0.05, 0)),
                                   {"you", Vector3(0, 0, 0.07)},
                                   {"car", Vector3(0.06, 0, 0.02)}}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    const auto before = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(before.ok());
    for (std::size_t i = 1; i < input.solids.size(); ++i) input.solids[i].position += step;
    const auto after = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(after.ok());
    ASSERT_EQ(after->route, EnvelopeRoute::valleys);
    for (const EnvelopeVertex& vertex : before->handles.vertices) {
      if (!vertex.vertex.in_valley()) continue;
      const EnvelopeVertex* found = vertex_of(*after, vertex.vertex, vertex.position);
      ASSERT_TRUE(found);
      EXPECT_LE((found->position - vertex.position).norm(), 2 * step.norm());
    }
  }
}

TEST(EnvelopeHandles, InValleysCurvesGetTauter) {
  const EnvelopeInput input = golden_scene("ell_tight");
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  int count = 0;
  for (const EnvelopeCurve& curve : before->handles.curves) {
    if (!curve.curve.low.in_valley() && !curve.curve.high.in_valley()) continue;
    const EnvelopeHandles made = with_fullness(*before, input, curve.curve, 0.2);
    const EnvelopeCurve* taut = curve_of(made, curve.curve);
    ASSERT_TRUE(taut);
    EXPECT_LE((taut->way - curve.way).norm(), 1e-9 * before->diagonal);
    // A tangent that would have dived into a solid was shorter before.
    EXPECT_LE((taut->middle - curve.middle).dot(curve.way), 1e-12 * before->diagonal);
    count += (taut->middle - curve.middle).norm() > 1e-3 * before->diagonal ? 1 : 0;
  }
  EXPECT_GE(count, 4);
}

TEST(EnvelopeHandles, WhatIsPulledDoesNotChangeTheConstruction) {
  const EnvelopeInput input = golden_scene("ell_tight");
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  for (const EnvelopeVertex& vertex : before->handles.vertices) {
    if (!vertex.vertex.in_valley()) continue;
    const Vector3 aside = 0.8 * before->diagonal * vertex.outward.unitOrthogonal();
    const auto after = EnvelopeSurfacer().rebuild(with_pulled(input, vertex, aside));
    ASSERT_TRUE(after.ok());
    EXPECT_EQ(after->route, EnvelopeRoute::valleys);
    EXPECT_TRUE(after->folds == 0 || warned(*after, w_envelope_fold));
    EXPECT_TRUE(after->enclosed || warned(*after, w_not_enclosed));
  }
}

TEST(EnvelopeHandles, InValleysOfSymmetricSolidsBothSidesFollow) {
  EnvelopeInput input = golden_scene("car");
  for (Solid& solid : input.solids) solid.position.y() = 0;
  input.settings.symmetry = SymmetryPlane::y;
  input.settings.method = EnvelopeMethod::network;
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  ASSERT_TRUE(before->symmetric);
  int count = 0;
  for (const EnvelopeVertex& vertex : before->handles.vertices) {
    if (!vertex.vertex.in_valley()) continue;
    ++count;
    const Vector3 pull = 0.02 * before->diagonal * vertex.outward;
    const auto after = EnvelopeSurfacer().rebuild(with_pulled(input, vertex, pull));
    ASSERT_TRUE(after.ok());
    EXPECT_TRUE(after->symmetric);
    if (after->level != before->level) continue;
    expect_followed(*before, vertex, *after, pull);
  }
  EXPECT_GE(count, 2);
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
    const auto after = EnvelopeSurfacer().rebuild(with_pulled(input, *outermost, pull));
    ASSERT_TRUE(after.ok());
    EXPECT_TRUE(after->symmetric);
    expect_followed(*before, *outermost, *after, pull);
  }
}

}  // namespace hariko::test
