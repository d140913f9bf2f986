// Pictures for people: set HARIKO_PICTURES to a folder to look at them. The test itself checks that every
// model draws in every map without an error and that the picture shows it.

#include <cstdlib>
#include <filesystem>

#include "render/picking.hpp"
#include "tests/render_window/models.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

constexpr int picture_width = 640, picture_height = 480;

void keep(const std::string& name, const Image& image) {
  const char* folder = std::getenv("HARIKO_PICTURES");
  if (!folder) return;
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(write_png(std::filesystem::path(folder) / (name + ".png"), image).ok());
}

class Maps : public ::testing::TestWithParam<const char*> {};

TEST_P(Maps, ModelDrawsInAMap) {
  const SurfaceMap map = *surface_map_from(GetParam());
  for (const std::string model : {"fig2", "genus3", "car"}) {
    Scene scene = scene_of(golden_object(model + ".obj", map));
    scene.objects[0].show_network = true;
    const Camera camera = framed(Camera::standard(StandardView::iso), scene, {picture_width, picture_height},
                                 has_values(map) ? legend_width : 0);
    Result<Image> picture = must(render_picture(scene, camera, picture_width, picture_height));
    Image image = std::move(picture).value();
    if (has_values(map)) {
      const auto values = values_of(*scene.objects[0].mesh, map);
      Legend legend{map, scene.objects[0].range, unit_of(map, "mm"), {}, true, 1};
      legend.histogram = histogram(values, legend.range, 40);
      paint_legend(image, legend);
    }
    keep(model + "-" + GetParam(), image);
  }
}

TEST(Gallery, OverlaysInBothThemes) {
  for (const Background background : {Background::dark, Background::light}) {
    Scene scene = scene_of(golden_object("cube.obj", SurfaceMap::shaded, "cube_crease.tension.json"));
    SceneObject& object = scene.objects[0];
    object.show_network = object.show_polyhedron = object.x_ray = true;
    object.wire = PatchWire::borders;
    object.selected.vertices = {6};
    object.hovered.vertices = {7};
    object.selected.edges = {2, 5};
    object.selected.faces = {1};
    object.hovered.edges = {8};
    object.selected_patches = {4, 5, 6, 7};
    scene.background = background;
    const Camera camera =
        framed(Camera::standard(StandardView::iso).orbit(0.25, -0.1), scene, {picture_width, picture_height});
    const Result<Image> picture = must(render_picture(scene, camera, picture_width, picture_height));
    keep(background == Background::dark ? "overlays-dark" : "overlays-light", *picture);
  }
  Scene scene = scene_of(golden_object("fig2_open.obj", SurfaceMap::shaded));
  scene.objects[0].show_network = scene.objects[0].show_polyhedron = scene.objects[0].x_ray = true;
  const Result<Image> picture = render_picture(
      scene, framed(Camera::standard(StandardView::iso), scene, {picture_width, picture_height}),
      picture_width, picture_height);
  ASSERT_TRUE(picture.ok());
  keep("open", *picture);
}

TEST(Gallery, ZebraSixteenTimesCloser) {
  Scene scene = scene_of(golden_object("genus3.obj", SurfaceMap::zebra));
  scene.objects[0].show_network = true;
  scene.zebra.stripes = 24;
  Camera camera = framed(Camera::standard(StandardView::iso), scene, {picture_width, picture_height});
  const Vector3 aim =
      pick_surface(scene, Projector(camera, {picture_width, picture_height}).ray({330, 200}))->point;
  camera.target = aim;
  camera.distance /= 16;
  const Result<Image> picture = must(render_picture(scene, camera, picture_width, picture_height));
  keep("zebra-close", *picture);
}

INSTANTIATE_TEST_SUITE_P(Every, Maps,
                         ::testing::Values("shaded", "patches", "zebra", "gauss", "mean", "k1", "k2",
                                           "continuity"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace hariko::test
