// Environments that surfaces reflect: which way they stand, turns, exposure, and what they leave alone.

#include <cmath>
#include <set>

#include "render/environment.hpp"
#include "tests/render_window/gl_context.hpp"
#include "tests/render_window/models.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

std::shared_ptr<const EnvironmentLevels> levels_of(EnvironmentKind kind) {
  return std::make_shared<const EnvironmentLevels>(environment_levels(environment_picture(kind)));
}
/// Light by direction, on the grid of the pictures.
template <class Light>
std::shared_ptr<const EnvironmentLevels> levels_by(const Light& light) {
  RadianceImage picture(environment_width, environment_height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.at(x, y) = light(environment_direction((x + 0.5) / picture.width, (y + 0.5) / picture.height));
  return std::make_shared<const EnvironmentLevels>(environment_levels(std::move(picture)));
}

Scene white_sphere() {
  SceneObject object = object_of(sphere(1), SurfaceMap::shaded, 24);
  object.color = {1, 1, 1, 1};
  return plain(std::move(object));
}

class EnvironmentLook : public GlTest {
 protected:
  Image front(const Scene& scene) { return draw(scene, looking(scene, StandardView::front), picture_size); }
  /// Red of a pixel beside the middle.
  int red(const Image& image, int right, int down) {
    return image.pixel(picture_size.width / 2 + right, picture_size.height / 2 + down)[0];
  }
};

TEST_F(EnvironmentLook, CompilesWithEveryLookAndEachKindHasItsOwn) {
  std::set<std::vector<std::uint8_t>> pictures;
  for (const EnvironmentKind kind :
       {EnvironmentKind::studio, EnvironmentKind::tubes, EnvironmentKind::horizon, EnvironmentKind::overcast})
    for (const PatchWire wire : {PatchWire::none, PatchWire::mesh})
      for (const bool highlight : {false, true}) {
        Scene scene = white_sphere();
        scene.environment.levels = levels_of(kind);
        scene.objects[0].wire = wire;
        if (highlight) scene.objects[0].selected_patches = {0, 3};
        EXPECT_TRUE(pictures.insert(front(scene).rgba).second) << int(kind) << int(wire) << highlight;
      }
}

TEST_F(EnvironmentLook, ChangesWithATurnAndComesBackAfterAWholeOne) {
  Scene scene = white_sphere();
  scene.environment.levels = levels_of(EnvironmentKind::studio);
  const Image before = front(scene);
  scene.environment.turn = 90;
  const Image turned = front(scene);
  EXPECT_NE(turned.rgba, before.rgba);
  scene.environment.turn = 360;
  EXPECT_EQ(front(scene).rgba, before.rgba);
  scene.environment.turn = 450;
  EXPECT_EQ(front(scene).rgba, turned.rgba);
}

/// A white sphere in even light cannot be told from the light.
TEST_F(EnvironmentLook, OfEvenLightIsEvenAndDoublesWithEachStop) {
  Scene scene = white_sphere();
  scene.environment.levels = levels_by([](const Vector3&) { return Radiance{0.125F, 0.125F, 0.125F}; });
  for (const int stops : {0, 1, 2}) {
    scene.environment.exposure = stops;
    const Image image = front(scene);
    const double wanted = 255 * std::pow(0.125 * (1 << stops), 1 / 2.2);
    for (const auto& [right, down] : {std::pair{0, 0}, {60, 0}, {-40, 50}, {0, -70}})
      EXPECT_NEAR(red(image, right, down), wanted, 2) << stops << " " << right << " " << down;
  }
}

TEST_F(EnvironmentLook, IsMirroredWhereItStands) {
  Scene scene = white_sphere();
  // From the front, +x is right and +z above.
  scene.environment.levels = levels_by([](const Vector3& d) {
    const float light = d.x() > 0 ? 0.8F : 0.0F;
    return Radiance{light, light, light};
  });
  const Image right = front(scene);
  EXPECT_GT(red(right, 40, 0), red(right, -40, 0) + 60);
  scene.environment.turn = 180;
  const Image left = front(scene);
  EXPECT_LT(red(left, 40, 0) + 60, red(left, -40, 0));
  scene.environment = {};
  scene.environment.levels = levels_by([](const Vector3& d) {
    const float light = d.z() > 0 ? 0.8F : 0.0F;
    return Radiance{light, light, light};
  });
  const Image above = front(scene);
  EXPECT_GT(red(above, 0, -40), red(above, 0, 40) + 60);
  // A quarter turn anticlockwise from above takes what stands at +x to +y, behind the sphere.
  scene.environment.levels = levels_by([](const Vector3& d) {
    const float light = d.x() > 0.5 ? 0.8F : 0.0F;
    return Radiance{light, light, light};
  });
  const Camera top = looking(scene, StandardView::top);
  scene.environment.turn = 90;
  const Image seen = draw(scene, top, picture_size);  // +y is above
  EXPECT_GT(red(seen, 0, -50), red(seen, 0, 50) + 40);
  EXPECT_GT(red(seen, 0, -50), red(seen, 50, 0) + 40);
}

TEST_F(EnvironmentLook, LeavesMapsAloneAndGoesOffAgain) {
  Scene scene = white_sphere();
  const Image material = front(scene);
  scene.objects[0].map = SurfaceMap::zebra;
  const Image zebra = front(scene);
  scene.environment.levels = levels_of(EnvironmentKind::tubes);
  EXPECT_EQ(front(scene).rgba, zebra.rgba);
  scene.objects[0].map = SurfaceMap::shaded;
  EXPECT_NE(front(scene).rgba, material.rgba);
  scene.environment.levels.reset();
  EXPECT_EQ(front(scene).rgba, material.rgba);
}

/// A unit square on the ground under a ceiling of tubes, from a side in parallel projection.
class CeilingOfTubes : public EnvironmentLook {
 protected:
  CeilingOfTubes() {
    scene = plain(object_of(height_field(1, 1, [](Index, Index) { return plane(); }), SurfaceMap::zebra, 4));
    scene.zebra = {16, {1, 0, 0.5}, StripeLock::tubes};
  }
  Camera from(StandardView side) const {
    Camera camera = Camera::standard(side);
    camera.orthographic = true;
    return framed(camera, scene, picture_size);
  }
  /// Whether each of 400 places along x or y is white.
  std::vector<bool> whites(const Camera& camera, int axis) {
    const Image image = draw(scene, camera, picture_size);
    const Projector projector(camera, picture_size);
    std::vector<bool> out;
    for (int i = 0; i < 400; ++i) {
      Vector3 place(0.5, 0.5, 0);
      place[axis] = (i + 0.5) / 400;
      const Vector3 at = *projector.project(place);
      out.push_back(image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()))[1] > 115);
    }
    return out;
  }
  static int changes(const std::vector<bool>& whites) {
    int count = 0;
    for (std::size_t i = 1; i < whites.size(); ++i) count += whites[i] != whites[i - 1] ? 1 : 0;
    return count;
  }
  Scene scene;
};

/// Sixteen dark stripes within two diagonals are 5.66 along the side, with a white one in its middle: twelve
/// edges.
TEST_F(CeilingOfTubes, IsSeenStraightAboveEachPlaceByAMirrorOnTheGround) {
  const Camera top = from(StandardView::top);
  const std::vector<bool> along_x = whites(top, 0);
  EXPECT_EQ(changes(along_x), 12);
  EXPECT_TRUE(along_x[200]);
  EXPECT_EQ(changes(whites(top, 1)), 0);
  scene.zebra.direction = {0, 1, 0};
  EXPECT_EQ(changes(whites(top, 0)), 0);
  EXPECT_EQ(changes(whites(top, 1)), 12);
}

TEST_F(CeilingOfTubes, StaysWhereItIsWhenTheCameraMoves) {
  const Camera top = from(StandardView::top);
  const std::vector<bool> before = whites(top, 0);
  Camera moved = top;
  moved.target += Vector3(0.11, -0.07, 0);
  const std::vector<bool> after = whites(moved, 0);
  int same = 0;
  for (std::size_t i = 0; i < before.size(); ++i) same += before[i] == after[i] ? 1 : 0;
  EXPECT_GT(same, 370) << "but for the pixels at edges";
}

TEST_F(CeilingOfTubes, IsNotSeenFromBelow) {
  EXPECT_EQ(changes(whites(from(StandardView::bottom), 0)), 0);
  EXPECT_FALSE(whites(from(StandardView::bottom), 0)[200]);
}

TEST_F(EnvironmentLook, IsUploadedOnce) {
  Scene scene = white_sphere();
  scene.environment.levels = levels_of(EnvironmentKind::horizon);
  front(scene);
  EXPECT_GE(renderer_->statistics().uploaded_bytes, scene.environment.levels->bytes());
  scene.environment.turn = 10;
  front(scene);
  EXPECT_LT(renderer_->statistics().uploaded_bytes, scene.environment.levels->bytes());
}

}  // namespace
}  // namespace hariko
