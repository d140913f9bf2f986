#pragma once

// Random solids, sections and outlines with every field set.

#include "core/document/source.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

inline Solid any_solid(std::mt19937_64& rng, std::uint32_t id) {
  Solid solid;
  solid.kind = static_cast<SolidKind>(uniform_int(rng, 0, 8));
  solid.size = Vector3(log_uniform(rng, 0.01, 100), 1, log_uniform(rng, 0.01, 100));
  solid.radius = log_uniform(rng, 0.01, 100);
  solid.height = log_uniform(rng, 0.01, 100);
  solid.length = log_uniform(rng, 0.01, 100);
  solid.tube = solid.radius * uniform(rng, 0.1, 0.9);
  solid.sides = static_cast<std::uint32_t>(uniform_int(rng, 3, 64));
  if (solid.kind == SolidKind::polyhedron) {
    solid.points = {Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    solid.points.push_back(random_vector(rng));
  }
  solid.position = 100 * random_vector(rng);
  solid.rotation = 360 * random_vector(rng);
  solid.scale = Vector3(uniform(rng, 0.5, 2), 1, uniform(rng, 0.5, 2));
  if (chance(rng, 0.5)) solid.roundness = uniform(rng, 0.1, 1);
  solid.id = id;
  if (chance(rng, 0.3)) {
    solid.bridge = Bridge{{id + 1, std::uint32_t(uniform_int(rng, 0, 9))}, {}};
    if (chance(rng, 0.5)) solid.bridge->ball_radius = uniform(rng, 0.1, 10);
  }
  return solid;
}

inline EnvelopeInput any_solids(std::mt19937_64& rng) {
  EnvelopeInput input;
  for (int i = uniform_int(rng, 1, 5); i > 0; --i)
    input.solids.push_back(any_solid(rng, std::uint32_t(3 * i)));
  EnvelopeSettings& settings = input.settings;
  settings.roundness = uniform(rng, 0.1, 1);
  settings.clearance = uniform(rng, 0, 1);
  settings.method = chance(rng, 0.5) ? EnvelopeMethod::network : EnvelopeMethod::ball;
  settings.rounding = uniform(rng, 0.01, 1);
  if (chance(rng, 0.5)) settings.ball_radius = uniform(rng, 0.1, 10);
  settings.on_faces = chance(rng, 0.5);
  settings.finer_patches = chance(rng, 0.5);
  settings.symmetry = static_cast<SymmetryPlane>(uniform_int(rng, 0, 3));
  return input;
}

inline PictureSource any_picture(std::mt19937_64& rng) {
  PictureSource picture;
  picture.path = chance(rng, 0.5) ? "/drawings/\u5074\u9762 \"side\".png" : "side.jpg";
  picture.columns = static_cast<std::uint32_t>(uniform_int(rng, 1, 10000));
  picture.rows = static_cast<std::uint32_t>(uniform_int(rng, 1, 10000));
  picture.width = log_uniform(rng, 1e-3, 1e6);
  picture.look.opacity = uniform(rng, 0, 1);
  picture.look.layer = static_cast<PictureLayer>(uniform_int(rng, 0, 2));
  if (chance(rng, 0.5)) picture.look.only_from = static_cast<PictureSide>(uniform_int(rng, 0, 5));
  if (chance(rng, 0.5)) {
    std::string bytes(std::size_t(uniform_int(rng, 1, 40)), '\0');
    for (char& byte : bytes) byte = static_cast<char>(rng());
    picture.bytes = std::move(bytes);
  }
  return picture;
}

inline BezierPatch any_bezier_patch(std::mt19937_64& rng) {
  BezierPatch patch;
  patch.degree_s = uniform_int(rng, 1, 6);
  patch.degree_t = uniform_int(rng, 1, 6);
  const bool rational = chance(rng, 0.5);
  for (int i = (patch.degree_s + 1) * (patch.degree_t + 1); i > 0; --i) {
    patch.points.push_back(std::exp(uniform(rng, -20, 20)) * random_vector(rng));
    if (rational) patch.weights.push_back(log_uniform(rng, 1e-3, 1e3));
  }
  return patch;
}

inline BezierSource any_bezier(std::mt19937_64& rng) {
  std::vector<BezierPatch> patches;
  for (int i = uniform_int(rng, 1, 4); i > 0; --i) patches.push_back(any_bezier_patch(rng));
  return BezierSource::from_patches(100 * random_vector(rng), std::move(patches)).value();
}

inline std::vector<Vector3> any_points(std::mt19937_64& rng, int most) {
  std::vector<Vector3> out;
  for (int i = uniform_int(rng, 1, most); i > 0; --i) out.push_back(100 * random_vector(rng));
  return out;
}

inline SkinSection any_section(std::mt19937_64& rng, std::uint32_t id) {
  SkinSection section;
  section.id = id;
  section.v = uniform(rng, 0, 1);
  section.closed = chance(rng, 0.5);
  section.direction_chosen = chance(rng, 0.3);
  section.start_chosen = chance(rng, 0.3);
  if (chance(rng, 0.3)) section.reference = random_vector(rng);
  std::uint32_t point = 100 * id;
  for (const Vector3& position : any_points(rng, 8))
    section.points.push_back({++point, position, chance(rng, 0.3)});
  return section;
}

inline SubdivisionCurve any_curve(std::mt19937_64& rng) {
  SubdivisionCurve curve;
  curve.points = any_points(rng, 6);
  curve.closed = chance(rng, 0.5);
  if (chance(rng, 0.3)) curve.sharp.assign(curve.points.size(), 1);
  return curve;
}

inline void any_correspondences(std::mt19937_64& rng, Skin& skin) {
  for (std::size_t k = 1; k < skin.sections.size(); ++k) {
    const SkinSection &a = skin.sections[k - 1], &b = skin.sections[k];
    const auto id = std::uint32_t(10 * k);
    if (chance(rng, 0.7))
      skin.links.push_back(
          {id, a.id, b.id, {a.points[0].id}, {b.points[0].id, b.points.back().id}, chance(rng, 0.5), true});
    if (chance(rng, 0.5))
      skin.merges.push_back({id + 1,
                             a.id,
                             b.id,
                             StripSide::b,
                             {b.points[0].id, b.points.back().id},
                             a.points[0].id,
                             uniform(rng, 0, 1),
                             chance(rng, 0.5)});
  }
}

/// Correspondences may be nonsense: only their form is kept in files.
inline Skin any_skin(std::mt19937_64& rng) {
  Skin skin;
  skin.path = any_curve(rng);
  if (chance(rng, 0.5)) skin.second_rail = any_curve(rng);
  skin.frame = static_cast<FrameMode>(uniform_int(rng, 0, 3));
  for (int k = uniform_int(rng, 1, 5); k > 0; --k)
    skin.sections.push_back(any_section(rng, std::uint32_t(k)));
  skin.method = static_cast<SkinMethod>(uniform_int(rng, 0, 2));
  skin.smooth.columns = uniform_int(rng, 0, 20);
  skin.smooth.rows = uniform_int(rng, 0, 20);
  skin.smooth.parameters = static_cast<ColumnParameters>(uniform_int(rng, 0, 2));
  skin.smooth.blend = static_cast<Blend>(uniform_int(rng, 0, 3));
  if (chance(rng, 0.3)) skin.smooth.anchors = {{0, 0.5, 1}, {0, uniform(rng, 0, 1), 1}};
  skin.pleat = {
      static_cast<RowPlacement>(uniform_int(rng, 0, 1)), chance(rng, 0.5),         chance(rng, 0.5),
      static_cast<SectionFit>(uniform_int(rng, 0, 2)),   log_uniform(rng, 5, 1e4), uniform(rng, 0.5, 4),
      static_cast<MatchCost>(uniform_int(rng, 0, 1))};
  any_correspondences(rng, skin);
  skin.creases = chance(rng, 0.5);
  skin.caps = static_cast<Caps>(uniform_int(rng, 0, 2));
  skin.flip_normals = chance(rng, 0.5);
  if (chance(rng, 0.5)) skin.mirror = {uniform_int(rng, 0, 2), uniform(rng, -100, 100)};
  return skin;
}

inline Outline any_outline(std::mt19937_64& rng) {
  Outline outline;
  for (int k = uniform_int(rng, 0, 3); k > 0; --k) {
    OutlineLoop loop;
    loop.points = any_points(rng, 9);
    const bool curved = chance(rng, 0.5);
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      loop.normals.push_back(random_vector(rng));
      if (curved) loop.curvature.push_back(uniform(rng, -1, 1));
    }
    outline.loops.push_back(std::move(loop));
  }
  return outline;
}

inline OutlineSettings any_outline_settings(std::mt19937_64& rng) {
  OutlineSettings settings;
  settings.mode = static_cast<GaussMode>(uniform_int(rng, 0, 3));
  settings.sign = static_cast<CurvatureSign>(uniform_int(rng, 0, 1));
  settings.radius = log_uniform(rng, 0.02, 50);
  settings.most_points = static_cast<Index>(uniform_int(rng, 0, 20000));
  if (chance(rng, 0.5)) settings.gap = log_uniform(rng, 1e-6, 1e6);
  settings.curvature_continuous = chance(rng, 0.5);
  settings.frames = chance(rng, 0.5) ? Frames::metric : Frames::equal;
  return settings;
}

}  // namespace hariko::test
