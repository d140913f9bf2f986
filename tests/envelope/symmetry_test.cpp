// Planes of symmetry: solids get images, and the surface is its own image.

#include <Eigen/Geometry>
#include <numeric>

#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "core/envelope/solid_shape.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

constexpr SymmetryPlane planes[] = {SymmetryPlane::x, SymmetryPlane::y, SymmetryPlane::z};

Vector3 reflected(Vector3 p, SymmetryPlane plane) {
  p[static_cast<Eigen::Index>(plane) - 1] *= -1;
  return p;
}

/// The largest distance of the image of a point of the surface from the nearest of the points, over the
/// diagonal. Grids of patches are symmetric, so images of points are among them.
double asymmetry(const EnvelopeSurface& made, SymmetryPlane plane) {
  const GridPattern pattern{made.surface.domain(), 6};
  std::vector<Index> all(made.surface.patch_count());
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<Vector3> points(all.size() * std::size_t(pattern.point_count())), normals(points.size());
  made.surface.patches().evaluate_grid(all, pattern, points, normals);
  std::vector<std::pair<double, Index>> order;
  const auto key = [&](const Vector3& p) { return p.x() + 1.7 * p.y() + 2.3 * p.z(); };
  for (Index i = 0; i < points.size(); ++i) {
    points[i] += made.origin;
    order.emplace_back(key(points[i]), i);
  }
  std::sort(order.begin(), order.end());
  double largest = 0;
  for (const Vector3& p : points) {
    const Vector3 image = reflected(p, plane);
    double least = 1e300;
    const double at = key(image), reach = 3.5e-6 * made.diagonal;
    for (auto o = std::lower_bound(order.begin(), order.end(), std::pair(at - reach, Index{0}));
         o != order.end() && o->first <= at + reach; ++o)
      least = std::min(least, (points[o->second] - image).norm());
    largest = std::max(largest, std::min(least, made.diagonal));
  }
  return largest / made.diagonal;
}

Solid at(SolidKind kind, const Vector3& position, const Vector3& rotation = Vector3::Zero()) {
  Solid out;
  out.kind = kind;
  out.position = position;
  out.rotation = rotation;
  out.height = 1.3;
  if (kind == SolidKind::polyhedron) out.points = {{0, 0, 0}, {1, 0, 0}, {0, 1.2, 0}, {0.1, 0.2, 0.9}};
  return out;
}

}  // namespace

TEST(EnvelopeSymmetry, ImagesOfSolidsAreTheirReflections) {
  for_random(11, 40, [&](std::mt19937_64& rng) {
    Solid solid =
        at(static_cast<SolidKind>(uniform_int(rng, 0, 8)), random_vector(rng, 2), random_vector(rng, 180));
    solid.scale = {uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), uniform(rng, 0.5, 2)};
    solid.sides = std::uint32_t(uniform_int(rng, 3, 8));
    for (const SymmetryPlane plane : planes) {
      const Eigen::Index axis = static_cast<Eigen::Index>(plane) - 1;
      const SolidShape own(solid, Vector3::Zero()), image(reflected(solid, axis), Vector3::Zero());
      for (int k = 0; k < 20; ++k) {
        const Vector3 p = solid.position + random_vector(rng, 2);
        EXPECT_NEAR(own.distance(p), image.distance(reflected(p, plane)), 1e-9);
      }
      const Solid back = reflected(reflected(solid, axis), axis);
      EXPECT_LE((solid_rotation(back.rotation) - solid_rotation(solid.rotation)).norm(), 1e-12);
    }
  });
}

TEST(EnvelopeSymmetry, SymmetricSolidsAndPairsGetNoImages) {
  const auto images = [](std::vector<Solid> solids, SymmetryPlane plane) {
    EnvelopeInput input;
    for (std::size_t i = 0; i < solids.size(); ++i) solids[i].id = std::uint32_t(i);
    input.solids = std::move(solids);
    input.settings.symmetry = plane;
    return images_of(input).size();
  };
  for (const SymmetryPlane plane : planes) {
    for (int kind = 0; kind < 8; ++kind)
      for (const double turn : {0.0, 90.0}) {
        // The axis of cones stands in the plane.
        const Vector3 rotation = plane == SymmetryPlane::z ? Vector3(90, turn, 0) : Vector3(0, 0, turn);
        Solid solid = at(static_cast<SolidKind>(kind), Vector3::Zero(), rotation);
        solid.sides = 4;
        EXPECT_EQ(images({solid}, plane), 0U) << kind << " " << turn;
      }
    EXPECT_EQ(images({at(SolidKind::box, {0.1, 0.1, 0.1})}, plane), 1U);
    EXPECT_EQ(images({at(SolidKind::polyhedron, {0.1, 0.1, 0.1})}, plane), 1U);
    const Vector3 away = {1, 1.1, 1.2};
    EXPECT_EQ(
        images({at(SolidKind::capsule, away, {10, 20, 30}),
                reflected(at(SolidKind::capsule, away, {10, 20, 30}), static_cast<Eigen::Index>(plane) - 1)},
               plane),
        0U);
  }
  // However round bodies are turned about their axis.
  EXPECT_EQ(images({at(SolidKind::cylinder, Vector3::Zero(), {0, 0, 10})}, SymmetryPlane::x), 0U);
  EXPECT_EQ(images({at(SolidKind::prism, Vector3::Zero(), {0, 0, 10})}, SymmetryPlane::x), 1U);
}

TEST(EnvelopeSymmetry, NetworksAreTheirOwnImagesOrSaySo) {
  int symmetric = 0;
  for (const char* name : {"box", "sphere", "cylinder", "hexprism", "two_apart", "ell", "four"})
    for (const SymmetryPlane plane : planes) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(int(plane)));
      EnvelopeInput input = golden_scene(name);
      input.settings.symmetry = plane;
      const EnvelopeSurface made = envelope_of(input);
      EXPECT_EQ(made.symmetric, !warned(made, w_not_symmetric));
      symmetric += made.symmetric;
      if (made.symmetric) {
        EXPECT_LE(asymmetry(made, plane), 1e-5);
      }
    }
  EXPECT_GE(symmetric, 3) << "that of a box at least";
}

TEST(EnvelopeSymmetry, HalfASceneBecomesTheWhole) {
  // One ear of a head: the other one is its image.
  EnvelopeInput input;
  input.solids = {at(SolidKind::sphere, Vector3::Zero()), at(SolidKind::box, {0.6, 0, 0.6}, {0, 20, 0})};
  input.solids[0].radius = 0.8;
  input.solids[1].size = {0.3, 0.2, 0.5};
  input.solids[1].id = 1;
  choose_ball(input);
  input.settings.symmetry = SymmetryPlane::x;
  EXPECT_EQ(images_of(input).size(), 1U);
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_TRUE(made.symmetric);
  EXPECT_TRUE(made.enclosed);
  EXPECT_LE(asymmetry(made, SymmetryPlane::x), 1e-9);
  Eigen::AlignedBox3d box;
  for (const Vector3& p : made.cage->positions) box.extend(Vector3(p + made.origin));
  EXPECT_LT(box.min().x(), -input.solids[1].position.x());
  EXPECT_NEAR(box.min().x(), -box.max().x(), 1e-9);
}

TEST(EnvelopeSymmetry, DragsStaySymmetric) {
  EnvelopeInput input = golden_scene("four");
  choose_ball(input);
  input.settings.symmetry = SymmetryPlane::x;
  EnvelopeSurfacer surfacer;
  for (int step = 0; step < 4; ++step) {
    input.solids[0].position.x() += 0.05;
    const auto made = must(surfacer.rebuild(input, Quality::drag));
    EXPECT_TRUE(made->symmetric) << step;
    EXPECT_LE(asymmetry(*made, SymmetryPlane::x), 1e-9);
  }
}

}  // namespace hariko::test
