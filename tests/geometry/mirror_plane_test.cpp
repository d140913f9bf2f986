#include "core/geometry/mirror_plane.hpp"

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

TEST(MirrorPlane, ImagesLieAsFarBeyondThePlaneAndPointsInItStay) {
  for_random(7200, 300, [](std::mt19937_64& rng) {
    const MirrorPlane plane{uniform_int(rng, 0, 2), uniform(rng, -3, 3)};
    const Vector3 p(uniform(rng, -5, 5), uniform(rng, -5, 5), uniform(rng, -5, 5));
    const Vector3 image = plane.image(p), foot = plane.foot(p);
    EXPECT_NEAR((image - plane.point()).dot(plane.normal()), -(p - plane.point()).dot(plane.normal()), 1e-14);
    EXPECT_LE(((image + p) / 2 - foot).norm(), 1e-14);
    EXPECT_LE((plane.image(image) - p).norm(), 1e-14);
    EXPECT_EQ(plane.image(foot), foot) << "to the last bit";
    for (int axis = 0; axis < 3; ++axis)
      if (axis != plane.axis) EXPECT_EQ(image[axis], p[axis]);
  });
}

TEST(MirrorPlane, AcrossZeroImagesOfImagesAreThePointsToTheLastBit) {
  for_random(7201, 300, [](std::mt19937_64& rng) {
    const MirrorPlane plane{uniform_int(rng, 0, 2), 0};
    const Vector3 p(uniform(rng, -5, 5), uniform(rng, -1e9, 1e9), uniform(rng, -1e-9, 1e-9));
    EXPECT_EQ(plane.image(plane.image(p)), p);
  });
}

}  // namespace
}  // namespace hariko::test
