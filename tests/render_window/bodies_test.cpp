// Translucent bodies inside of a surface: seen through it, in their states, and no more than outlines over
// maps.

#include <array>
#include <cmath>
#include <numbers>

#include "render/body_buffers.hpp"
#include "tests/render_window/gl_context.hpp"
#include "tests/render_window/models.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

/// Two cubes beside each other in x, each of half a unit.
std::shared_ptr<const DisplayPolyhedron> cubes() {
  auto out = std::make_shared<DisplayPolyhedron>();
  for (const float x : {-0.35F, 0.35F}) {
    const auto base = Index(out->positions.size());
    const auto id = std::uint32_t(x > 0);
    for (int k = 0; k < 8; ++k) {
      const auto part = [&](int bit) { return (k >> bit & 1) != 0 ? 0.25F : -0.25F; };
      out->positions.push_back({x + part(0), part(1), part(2)});
      out->vertex_ids.push_back({id});
      out->box.extend(out->position(base + Index(k)));
    }
    for (const auto& face : {std::array<Index, 4>{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}}) {
      for (const Index corner : face) out->face_vertices.push_back(base + corner);
      out->face_offsets.push_back(Index(out->face_vertices.size()));
      out->face_ids.push_back({id});
    }
  }
  return out;
}

Scene with_bodies(SurfaceMap map) {
  SceneObject object = object_of(sphere(1), map, 16);
  object.polyhedron = cubes();
  object.show_polyhedron = false;
  object.show_network = false;
  object.show_bodies = true;
  Scene scene = scene_of(std::move(object));
  scene.grid.visible = false;
  return scene;
}

/// Largest difference of a channel at a pixel.
int difference(const Image& a, const Image& b, int x, int y) {
  int out = 0;
  for (int c = 0; c < 3; ++c) out = std::max(out, std::abs(int(a.pixel(x, y)[c]) - int(b.pixel(x, y)[c])));
  return out;
}

class BodiesTest : public GlTest {
 protected:
  struct At {
    int left_x, right_x, y;  ///< pixels in the middle of the cubes
  };
  static At middles(const Camera& camera) {
    const Projector projector(camera, picture_size);
    const auto left = projector.project({-0.35, -0.25, 0}), right = projector.project({0.35, -0.25, 0});
    return {int(left->x()), int(right->x()), int(left->y())};
  }
};

TEST_F(BodiesTest, ShowThroughTheSurfaceInTheirStates) {
  Scene scene = with_bodies(SurfaceMap::shaded);
  const Camera camera = framed(Camera::standard(StandardView::front), scene, picture_size);
  const At at = middles(camera);
  const Image shown = draw(scene, camera, picture_size);
  scene.objects[0].show_bodies = false;
  const Image hidden = draw(scene, camera, picture_size);
  EXPECT_GT(difference(shown, hidden, at.left_x, at.y), 8);
  EXPECT_GT(difference(shown, hidden, at.right_x, at.y), 8);
  EXPECT_EQ(difference(shown, hidden, (at.left_x + at.right_x) / 2, at.y), 0) << "nothing between them";
  scene.objects[0].show_bodies = true;
  scene.objects[0].selected.faces = {6, 7, 8, 9, 10, 11};
  const Image selected = draw(scene, camera, picture_size);
  EXPECT_EQ(difference(selected, shown, at.left_x, at.y), 0);
  EXPECT_GT(difference(selected, shown, at.right_x, at.y), 12);
  scene.objects[0].selected.faces.clear();
  scene.objects[0].hovered.faces = {0, 1, 2, 3, 4, 5};
  const Image hovered = draw(scene, camera, picture_size);
  EXPECT_GT(difference(hovered, shown, at.left_x, at.y), 8);
  EXPECT_EQ(difference(hovered, shown, at.right_x, at.y), 0);
  scene.objects[0].hovered.faces.clear();
  scene.objects[0].faint_bodies = true;
  const Image faint = draw(scene, camera, picture_size);
  EXPECT_GT(difference(shown, faint, at.left_x, at.y), 2);
  EXPECT_LT(difference(faint, hidden, at.left_x, at.y), difference(shown, hidden, at.left_x, at.y));
}

TEST_F(BodiesTest, LeaveTheColoursOfMapsWhereTheyLookAtTheEye) {
  for (const SurfaceMap map :
       {SurfaceMap::zebra, SurfaceMap::mean, SurfaceMap::isophotes, SurfaceMap::patches}) {
    Scene scene = with_bodies(map);
    const Camera camera = framed(Camera::standard(StandardView::front), scene, picture_size);
    const At at = middles(camera);
    const Image shown = draw(scene, camera, picture_size);
    scene.objects[0].show_bodies = false;
    const Image hidden = draw(scene, camera, picture_size);
    EXPECT_LE(difference(shown, hidden, at.left_x, at.y), 3) << int(map);
    // Seen from above at a slant the tops are darker, so that the form is there.
    const Camera slant = framed(Camera::standard(StandardView::iso), scene, picture_size);
    const Image plain = draw(scene, slant, picture_size);
    scene.objects[0].show_bodies = true;
    const Image with = draw(scene, slant, picture_size);
    int touched = 0;
    for (int y = 0; y < picture_size.height; ++y)
      for (int x = 0; x < picture_size.width; ++x) touched += difference(with, plain, x, y) > 2;
    EXPECT_GT(touched, 50) << int(map);
  }
}

TEST_F(BodiesTest, AreCutBySectionsAndShowWithoutASurface) {
  Scene scene = with_bodies(SurfaceMap::shaded);
  const Camera camera = framed(Camera::standard(StandardView::front), scene, picture_size);
  const At at = middles(camera);
  scene.objects[0].show_surface = false;
  scene.section = SectionPlane{Vector3::UnitX(), 0};
  const Image cut = draw(scene, camera, picture_size);
  scene.objects[0].show_bodies = false;
  const Image nothing = draw(scene, camera, picture_size);
  EXPECT_GT(difference(cut, nothing, at.left_x, at.y), 8);
  EXPECT_EQ(difference(cut, nothing, at.right_x, at.y), 0);
}

TEST(BodyNormals, RunSmoothlyRoundRoundBodiesOnly) {
  const auto bodies = cubes();
  const std::vector<Vector3> normals = gl::corner_normals(*bodies);
  ASSERT_EQ(normals.size(), bodies->face_vertices.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_NEAR(normals[i].cwiseAbs().maxCoeff(), 1, 1e-12) << "edges of cubes are sharp";
  }
  // A prism of 32 sides: normals at its side point away from the axis.
  DisplayPolyhedron prism;
  constexpr int sides = 32;
  for (int k = 0; k < 2 * sides; ++k) {
    const double a = 2 * std::numbers::pi * (k / 2) / sides;
    prism.positions.push_back({float(std::cos(a)), float(std::sin(a)), k % 2 == 0 ? -1.0F : 1.0F});
  }
  for (Index k = 0; k < sides; ++k) {
    const Index next = (k + 1) % sides;
    prism.face_vertices.insert(prism.face_vertices.end(), {2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
    prism.face_offsets.push_back(Index(prism.face_vertices.size()));
  }
  const std::vector<Vector3> round = gl::corner_normals(prism);
  for (std::size_t i = 0; i < round.size(); ++i) {
    Vector3 away = prism.position(prism.face_vertices[i]);
    away.z() = 0;
    EXPECT_LE((round[i] - away).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace hariko
