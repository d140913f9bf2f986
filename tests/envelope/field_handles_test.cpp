// Vertices of a field's cage that are pulled by hand.

#include "core/envelope/field_handles.hpp"

#include <map>
#include <set>

#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

void pull(EnvelopeInput& input, const EnvelopeVertex& vertex, const Vector3& way) {
  input.settings.offsets.set(vertex.vertex, vertex.axes.transpose() * way);
}

/// The nearest one of that name: a vertex and its image share theirs.
const EnvelopeVertex* vertex_named(const EnvelopeSurface& made, const NetworkVertexKey& name,
                                   const Vector3& near) {
  const EnvelopeVertex* best = nullptr;
  for (const EnvelopeVertex& vertex : made.handles.vertices)
    if (vertex.vertex == name && (!best || (vertex.position - near).norm() < (best->position - near).norm()))
      best = &vertex;
  return best;
}

/// Of a surfacer that knows the scene already: what is pulled changes the base neither here nor in the
/// window.
EnvelopeSurface envelope_by(EnvelopeSurfacer& surfacer, const EnvelopeInput& input) {
  auto made = surfacer.rebuild(input);
  if (!made) ADD_FAILURE() << to_string(made.error());
  return made ? std::move(made).value() : EnvelopeSurface{};
}

void expect_there(const EnvelopeSurface& made, const EnvelopeVertex& vertex, const Vector3& place) {
  const EnvelopeVertex* found = vertex_named(made, vertex.vertex, place);
  ASSERT_TRUE(found);
  EXPECT_LE((found->position - place).norm(), 0.01 * made.diagonal);
  EXPECT_NEAR(found->outward.norm(), 1, 1e-12);
  EXPECT_LE((found->axes * found->axes.transpose() - Matrix3::Identity()).norm(), 1e-12);
}

}  // namespace

TEST(FieldHandles, EveryVertexHasANameOfItsOwn) {
  for (const char* name : {"camera", "ring6", "dryer", "torus", "capsule", "ten"}) {
    SCOPED_TRACE(name);
    const EnvelopeInput input = golden_field_scene(name);
    const EnvelopeSurface made = envelope_of(input);
    ASSERT_EQ(made.route, EnvelopeRoute::field);
    EXPECT_EQ(made.handles.vertices.size(), made.cage->vertex_count());
    EXPECT_EQ(made.handles.curves.size(), made.cage->topology().edge_count());
    std::set<NetworkVertexKey> names;
    for (const EnvelopeVertex& vertex : made.handles.vertices) {
      EXPECT_TRUE(is_field_name(vertex.vertex));
      EXPECT_LT(vertex.vertex.solid, input.solids.size());
      EXPECT_TRUE(names.insert(vertex.vertex).second) << "two vertices have one name";
    }
  }
}

TEST(FieldHandles, VerticesGoWhereTheyArePulledAndOthersStay) {
  for (const char* name : {"camera", "ring6", "dryer"}) {
    SCOPED_TRACE(name);
    const EnvelopeInput input = golden_field_scene(name);
    EnvelopeSurfacer surfacer;
    const EnvelopeSurface before = envelope_by(surfacer, input);
    const std::size_t step = before.handles.vertices.size() / 5;
    for (std::size_t i = 0; i < before.handles.vertices.size(); i += step) {
      const EnvelopeVertex& vertex = before.handles.vertices[i];
      const Vector3 way = 0.04 * before.diagonal * vertex.outward;
      EnvelopeInput pulled = input;
      pull(pulled, vertex, way);
      const EnvelopeSurface after = envelope_by(surfacer, pulled);
      EXPECT_TRUE(after.enclosed);
      EXPECT_EQ(after.level, before.level);
      EXPECT_EQ(after.folds == 0, !warned(after, w_envelope_fold));
      expect_there(after, vertex, vertex.position + way);
      ASSERT_EQ(after.handles.vertices.size(), before.handles.vertices.size());
      for (std::size_t k = 0; k < before.handles.vertices.size(); ++k) {
        if (k == i) continue;
        EXPECT_EQ(after.handles.vertices[k].vertex, before.handles.vertices[k].vertex);
        EXPECT_LE((after.handles.vertices[k].position - before.handles.vertices[k].position).norm(),
                  0.01 * before.diagonal);
      }
    }
  }
}

TEST(FieldHandles, WhatIsPulledIntoASolidIsPushedOutAgain) {
  const EnvelopeInput input = golden_field_scene("camera");
  EnvelopeSurfacer surfacer;
  const EnvelopeSurface before = envelope_by(surfacer, input);
  const std::size_t step = before.handles.vertices.size() / 4;
  for (std::size_t i = 0; i < before.handles.vertices.size(); i += step) {
    const EnvelopeVertex& vertex = before.handles.vertices[i];
    EnvelopeInput pulled = input;
    pull(pulled, vertex, -0.06 * before.diagonal * vertex.outward);
    const EnvelopeSurface after = envelope_by(surfacer, pulled);
    EXPECT_TRUE(after.enclosed || warned(after, w_not_enclosed));
    ASSERT_TRUE(after.check);
    EXPECT_LE(after.check->worst, 2e-3 * after.diagonal);
  }
}

TEST(FieldHandles, PullsStayWhileSolidsMove) {
  // Whatever moves, what was pulled stays with its solid, on the vertex that is nearest to the place.
  for (const char* name : {"camera", "dryer"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_field_scene(name);
    const EnvelopeSurface plain = envelope_of(input);
    const EnvelopeVertex* vertex = nullptr;
    for (const EnvelopeVertex& one : plain.handles.vertices)
      if (one.vertex.solid == 0 && (!vertex || one.position.x() < vertex->position.x())) vertex = &one;
    ASSERT_TRUE(vertex);
    const Vector3 way = 0.05 * plain.diagonal * vertex->outward;
    pull(input, *vertex, way);
    for (const double step : {0.02, 0.05, 0.1}) {
      SCOPED_TRACE(step);
      EnvelopeInput moved = input;
      moved.solids.back().position += Vector3(step, 0, step / 2);
      EnvelopeInput unpulled = moved;
      unpulled.settings.offsets = {};
      const EnvelopeSurface with = envelope_of(moved), without = envelope_of(unpulled);
      const EnvelopeVertex* found = vertex_named(with, vertex->vertex, vertex->position);
      ASSERT_TRUE(found);
      double nearest = 1e300;
      for (const EnvelopeVertex& one : without.handles.vertices)
        nearest = std::min(nearest, (one.position + way - found->position).norm());
      EXPECT_LE(nearest, 0.01 * plain.diagonal);
    }
    // Of a whole that moves it goes along.
    EnvelopeInput away = input;
    for (Solid& solid : away.solids) solid.position += Vector3(40, -7, 3);
    const EnvelopeSurface there = envelope_of(away);
    const EnvelopeSurface here = envelope_of(input);
    const EnvelopeVertex *a = vertex_named(here, vertex->vertex, vertex->position),
                         *b = vertex_named(there, vertex->vertex, vertex->position);
    ASSERT_TRUE(a && b);
    EXPECT_LE((a->position + here.origin + Vector3(40, -7, 3) - b->position - there.origin).norm(),
              0.01 * plain.diagonal);
  }
}

TEST(FieldHandles, CurvesGetFullerAndTauterTheWayThatIsTold) {
  for (const char* name : {"camera", "ring6", "dryer"}) {
    SCOPED_TRACE(name);
    const EnvelopeInput input = golden_field_scene(name);
    EnvelopeSurfacer surfacer;
    const EnvelopeSurface before = envelope_by(surfacer, input);
    const std::size_t step = before.handles.curves.size() / 4;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < before.handles.curves.size(); i += step) {
      const EnvelopeCurve& curve = before.handles.curves[i];
      for (const double factor : {0.6, 1.6}) {
        SCOPED_TRACE(factor);
        EnvelopeInput changed = input;
        changed.settings.fullness.set(curve.curve, factor);
        const EnvelopeSurface after = envelope_by(surfacer, changed);
        ASSERT_EQ(after.handles.curves.size(), before.handles.curves.size());
        EXPECT_EQ(after.handles.curves[i].curve, curve.curve);
        EXPECT_TRUE(after.enclosed);
        const Vector3 gone = after.handles.curves[i].middle - curve.middle;
        const double share = gone.dot(curve.way) / curve.way.squaredNorm() / (factor - 1);
        // A taut curve that comes into a solid is pushed out again.
        EXPECT_GT(share, -0.3);
        EXPECT_LT(share, 2);
        sum += share, count += 1;
      }
    }
    EXPECT_GT(sum / count, 0.4);
    EXPECT_LT(sum / count, 1.3);
  }
}

TEST(FieldHandles, SettingsOfAnotherConstructionRest) {
  // On a network what was pulled on a field does nothing, and the other way round.
  const EnvelopeInput tight = golden_scene("ell_tight");
  const EnvelopeSurface field = envelope_of(golden_field_scene("ell_tight"));
  EnvelopeInput pulled = tight;
  for (const EnvelopeVertex& vertex : field.handles.vertices)
    pull(pulled, vertex, 0.1 * field.diagonal * vertex.outward);
  for (const EnvelopeCurve& curve : field.handles.curves) pulled.settings.fullness.set(curve.curve, 0.5);
  const auto before = EnvelopeSurfacer().rebuild(tight), after = EnvelopeSurfacer().rebuild(pulled);
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_EQ(after->route, EnvelopeRoute::valleys);
  ASSERT_EQ(after->handles.vertices.size(), before->handles.vertices.size());
  for (std::size_t i = 0; i < before->handles.vertices.size(); ++i)
    EXPECT_EQ(after->handles.vertices[i].position, before->handles.vertices[i].position);

  EnvelopeInput networked = golden_field_scene("ell_tight");
  for (const EnvelopeVertex& vertex : before->handles.vertices)
    pull(networked, vertex, 0.1 * before->diagonal * vertex.outward);
  for (const EnvelopeCurve& curve : before->handles.curves) networked.settings.fullness.set(curve.curve, 0.5);
  const EnvelopeSurface same = envelope_of(networked);
  ASSERT_EQ(same.handles.vertices.size(), field.handles.vertices.size());
  for (std::size_t i = 0; i < field.handles.vertices.size(); ++i)
    EXPECT_EQ(same.handles.vertices[i].position, field.handles.vertices[i].position);
}

TEST(FieldHandles, OfSymmetricSolidsBothSidesFollow) {
  EnvelopeInput input = golden_field_scene("car");
  for (Solid& solid : input.solids) solid.position.y() = 0;
  input.settings.symmetry = SymmetryPlane::y;
  EnvelopeInput pair = golden_field_scene("two_apart");
  for (Solid& solid : pair.solids) solid.position.z() += 3;
  pair.settings.symmetry = SymmetryPlane::z;
  for (const EnvelopeInput& scene : {input, pair}) {
    EnvelopeSurfacer surfacer;
    const EnvelopeSurface before = envelope_by(surfacer, scene);
    ASSERT_TRUE(before.symmetric);
    const Eigen::Index axis = &scene == &input || scene.settings.symmetry == SymmetryPlane::y ? 1 : 2;
    std::map<NetworkVertexKey, int> shared;
    for (const EnvelopeVertex& vertex : before.handles.vertices) ++shared[vertex.vertex];
    for (const auto& [name, count] : shared) EXPECT_LE(count, 2);
    const std::size_t step = before.handles.vertices.size() / 6;
    for (std::size_t i = 0; i < before.handles.vertices.size(); i += step) {
      const EnvelopeVertex& vertex = before.handles.vertices[i];
      const Vector3 way = 0.03 * before.diagonal * vertex.outward;
      EnvelopeInput pulled = scene;
      pull(pulled, vertex, way);
      const EnvelopeSurface after = envelope_by(surfacer, pulled);
      EXPECT_TRUE(after.symmetric);
      expect_there(after, vertex, vertex.position + way);
      EnvelopeVertex image = vertex;
      image.position[axis] *= -1;
      Vector3 back = way;
      back[axis] *= -1;
      expect_there(after, image, image.position + back);
    }
  }
}

TEST(FieldHandles, FarPullsEndInASurfaceOrAWarning) {
  const EnvelopeInput input = golden_field_scene("dryer");
  EnvelopeSurfacer surfacer;
  const EnvelopeSurface before = envelope_by(surfacer, input);
  std::mt19937_64 rng(random_seed(20261123));
  for (int round = 0; round < repetitions(2); ++round) {
    EnvelopeInput pulled = input;
    const int count = uniform_int(rng, 1, 5);
    for (int k = 0; k < count; ++k) {
      const auto i = std::size_t(uniform_int(rng, 0, int(before.handles.vertices.size()) - 1));
      pull(pulled, before.handles.vertices[i], random_vector(rng, 1e3 * before.diagonal));
    }
    const auto after = surfacer.rebuild(pulled);
    ASSERT_TRUE(after.ok());
    EXPECT_TRUE(after->folds == 0 || warned(*after, w_envelope_fold));
    EXPECT_TRUE(after->enclosed || warned(*after, w_not_enclosed));
  }
}

TEST(FieldHandles, TheDragOfAVertexEndsWhereItIsLetGo) {
  // The cage is that of the last final result, so nothing jumps when the vertex is let go.
  EnvelopeInput input = golden_field_scene("camera");
  EnvelopeSurfacer surfacer;
  const auto before = surfacer.rebuild(input);
  ASSERT_TRUE(before.ok());
  const EnvelopeVertex vertex = before->handles.vertices[before->handles.vertices.size() / 2];
  const Vector3 way = 0.05 * before->diagonal * vertex.outward;
  pull(input, vertex, way);
  const auto dragged = surfacer.rebuild(input, Quality::drag);
  const auto last = surfacer.rebuild(input);
  ASSERT_TRUE(dragged.ok() && last.ok());
  const EnvelopeSurface cold = envelope_of(input);
  ASSERT_EQ(dragged->handles.vertices.size(), last->handles.vertices.size());
  for (std::size_t i = 0; i < last->handles.vertices.size(); ++i) {
    EXPECT_EQ(last->handles.vertices[i].position, cold.handles.vertices[i].position);
    EXPECT_LE((dragged->handles.vertices[i].position - last->handles.vertices[i].position).norm(),
              2e-3 * before->diagonal);
  }
}

}  // namespace hariko::test
