// Pictures of known scenes, checked by their properties.

#include "render/renderer.hpp"

#include <cmath>
#include <limits>

#include "tests/render_window/gl_context.hpp"
#include "tests/render_window/models.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

struct Rgb {
  int r, g, b;
};
Rgb at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}
Rgb centre(const Image& image) {
  return at(image, image.width / 2, image.height / 2);
}
int spread(Rgb c) {
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
}

class RendererTest : public GlTest {};

TEST_F(RendererTest, BackgroundIsAGradientFromTopToBottom) {
  for (const auto& [background, top, bottom] : {std::tuple{Background::dark, "#3a3d42", "#24262a"},
                                                std::tuple{Background::light, "#f4f5f7", "#d9dce1"}}) {
    Scene scene;
    scene.background = background;
    scene.grid.visible = false;
    const Image image = draw(scene, Camera{}, picture_size);
    const auto expect = [&](int y, const char* hex) {
      const Color wanted = color_from_hex(hex);
      EXPECT_NEAR(at(image, 10, y).r, wanted.r * 255, 1.6);
      EXPECT_NEAR(at(image, 10, y).b, wanted.b * 255, 1.6);
    };
    expect(0, top);
    expect(picture_size.height - 1, bottom);
    int last = 255;
    for (int y = 0; y < picture_size.height; y += 24) {
      EXPECT_LE(at(image, 100, y).g, last + 1);
      last = at(image, 100, y).g;
    }
  }
}

TEST_F(RendererTest, TransparentBackgroundHasNoAlpha) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 16));
  scene.background = Background::transparent;
  const Image image = draw(scene, looking(scene, StandardView::front), picture_size);
  EXPECT_EQ(image.pixel(1, 1)[3], 0);
  EXPECT_EQ(image.pixel(160, 120)[3], 255);
}

TEST_F(RendererTest, ASphereIsWarmOutsideCoolInsideAndRound) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 24));
  const Camera camera = looking(scene, StandardView::front);
  const Image outside = draw(scene, camera, picture_size);
  const Rgb warm = centre(outside);
  EXPECT_GT(warm.r, warm.b);
  EXPECT_GT(warm.r, 100);
  // The silhouette is a circle: 1 / 1.08 of the height.
  const double radius = picture_size.height / 2.0 / 1.08;
  for (double angle = 0.1; angle < 6.2; angle += 0.37) {
    const auto near_rim = [&](double r) {
      return at(outside, static_cast<int>(160 + r * std::cos(angle)),
                static_cast<int>(120 - r * std::sin(angle)));
    };
    EXPECT_LT(near_rim(radius + 3).r, 70) << angle;
    EXPECT_GT(spread(near_rim(radius + 3)) + near_rim(radius - 4).r, 75) << angle;
  }
  Camera within = camera;
  within.distance = 0.01;
  within.target = Vector3::Zero();
  const Rgb cool = centre(draw(scene, within, picture_size));
  EXPECT_GT(cool.b, cool.r);
}

TEST_F(RendererTest, MirroredObjectsKeepTheirOutside) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 16));
  scene.objects[0].transform(0, 0) = -1;
  const Rgb warm = centre(draw(scene, looking(scene, StandardView::front), picture_size));
  EXPECT_GT(warm.r, warm.b);
}

TEST_F(RendererTest, ZebraIsBlackAndWhiteAndHasBoth) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::zebra, 32));
  scene.zebra.stripes = 6;
  const Image image = draw(scene, looking(scene, StandardView::front), picture_size, 1);
  int black = 0, white = 0, between = 0;
  for (int y = 0; y < picture_size.height; ++y)
    for (int x = 0; x < picture_size.width; ++x) {
      if (std::hypot(x - 160, y - 120) > 0.8 * picture_size.height / 2 / 1.08) continue;
      const Rgb c = at(image, x, y);
      ASSERT_LE(spread(c), 1);
      if (c.r < 20)
        ++black;
      else if (c.r > 235)
        ++white;
      else
        ++between;
    }
  EXPECT_GT(black, 3000);
  EXPECT_GT(white, 3000);
  EXPECT_GT(between, 100);                  // edges are anti-aliased ...
  EXPECT_LT(between, (black + white) / 4);  // ... and narrow
}

TEST_F(RendererTest, MoreStripesMakeMoreEdges) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::zebra, 32));
  scene.zebra.direction = {1, 0, 0};
  const auto edges = [&](int stripes) {
    scene.zebra.stripes = stripes;
    const Image image = draw(scene, looking(scene, StandardView::front), picture_size, 1);
    int count = 0;
    for (int x = 100; x < 220; ++x) count += (at(image, x, 120).r < 128) != (at(image, x + 1, 120).r < 128);
    return count;
  };
  const int few = edges(4), many = edges(16);
  EXPECT_GE(few, 2);
  EXPECT_GT(many, 2 * few);
}

/// One flat unit square per entry, seen from above, with a constant value each.
Scene value_row(const std::vector<float>& values, SurfaceMap map, ValueRange range) {
  DisplayOptions options;
  options.density = 4;
  options.map = [values](const Surface&, std::span<const Index> patches, const GridPattern& pattern,
                         std::span<float> out) {
    const auto n = static_cast<std::size_t>(pattern.point_count());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[patches[i / n]];
  };
  SceneObject object;
  object.mesh = DisplayMesh::build(
      height_field(static_cast<Index>(values.size()), 1, [](Index, Index) { return plane(); }), options);
  object.map = map;
  object.range = range;
  return plain(object);
}

TEST_F(RendererTest, MapColoursAreThoseOfTheTable) {
  const std::vector<float> values{-2, -1, -0.5F, 0, 0.5F, 1, 2};
  for (const SurfaceMap map : {SurfaceMap::gaussian, SurfaceMap::principal_max}) {
    Scene scene = value_row(values, map, {-1, 1});
    Camera camera = Camera::standard(StandardView::top);
    camera.orthographic = true;
    camera = framed(camera, scene, picture_size);
    const Image image = draw(scene, camera, picture_size);
    const Projector projector(camera, picture_size);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Vector3 pixel = *projector.project({double(i) + 0.5, 0.5, 0});
      const Rgb seen = at(image, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
      const Color wanted = color_at(scale_of(map), (double(values[i]) + 1) / 2);
      EXPECT_NEAR(seen.r, wanted.r * 255, 3) << i;
      EXPECT_NEAR(seen.g, wanted.g * 255, 3) << i;
      EXPECT_NEAR(seen.b, wanted.b * 255, 3) << i;
    }
  }
}

TEST_F(RendererTest, UndefinedIsGrey) {
  Scene scene = value_row({std::numeric_limits<float>::quiet_NaN(), 1}, SurfaceMap::mean, {-1, 1});
  Camera camera = framed(Camera::standard(StandardView::top), scene, picture_size);
  const Image image = draw(scene, camera, picture_size);
  const Vector3 grey = *Projector(camera, picture_size).project({0.5, 0.5, 0}),
                red = *Projector(camera, picture_size).project({1.5, 0.5, 0});
  EXPECT_LE(spread(at(image, int(grey.x()), int(grey.y()))), 2);
  EXPECT_NEAR(at(image, int(grey.x()), int(grey.y())).r, 127, 8);
  EXPECT_GT(spread(at(image, int(red.x()), int(red.y()))), 80);
}

TEST_F(RendererTest, DimmedIsDarker) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 12));
  const Camera camera = looking(scene, StandardView::front);
  const int bright = centre(draw(scene, camera, picture_size)).r;
  scene.objects[0].dimmed = true;
  EXPECT_NEAR(centre(draw(scene, camera, picture_size)).r, 0.8 * bright, 3);
}

TEST_F(RendererTest, LinesHaveTheirWidth) {
  Scene scene;
  scene.grid.visible = false;
  Camera camera = Camera::standard(StandardView::front);
  for (const float width : {1.0F, 2.0F, 5.0F}) {
    scene.lines = {{{-10, 0, 0.001}, {10, 0, 0.001}, {1, 1, 1, 1}, width, true}};
    const Image image = draw(scene, camera, picture_size);
    double covered = 0;
    for (int y = 100; y < 140; ++y) {
      const double ground = at(image, 5, y).r;  // also on the line: it spans the picture
      covered += std::max(0.0, (ground - 48) / (255 - 48));
    }
    EXPECT_NEAR(covered, width, 0.35) << width;
  }
}

TEST_F(RendererTest, LinesThatPassBehindTheEyeStayFinite) {
  Scene scene;
  scene.grid.visible = false;
  const Camera camera = Camera::standard(StandardView::front);
  scene.lines = {{camera.eye() - 5 * camera.forward() + camera.up(), {0, 50, -8}, {1, 1, 1, 1}, 3, true}};
  const Image image = draw(scene, camera, picture_size);
  int lit = 0;
  for (int y = 0; y < picture_size.height; ++y)
    for (int x = 0; x < picture_size.width; ++x) lit += at(image, x, y).r > 150;
  EXPECT_GT(lit, 300);
  EXPECT_LT(lit, 3000);
}

TEST_F(RendererTest, CurvesOnTheSurfaceAreUnbroken) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 16));
  // Octants are joined by seams without a source: split edges.
  scene.objects[0].wire = PatchWire::borders;
  scene.objects[0].show_network = true;
  Camera camera = looking(scene, StandardView::iso);
  scene.pixel_scale = 2;
  const Image with = draw(scene, camera, picture_size);
  scene.objects[0].wire = PatchWire::none;
  scene.objects[0].show_network = false;
  const Image without = draw(scene, camera, picture_size);
  const Projector projector(camera, picture_size);
  for (double angle = 0.03; angle < 1.55; angle += 0.02) {
    const Vector3 on_seam(std::cos(angle), -std::sin(angle), 0);
    const Vector3 pixel = *projector.project(on_seam);
    const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
    EXPECT_LT(at(with, x, y).r, at(without, x, y).r - 12) << angle;
  }
}

TEST_F(RendererTest, EdgesOfFacetsLieOverTheSurfaceThatTheyStandFor) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 32));
  const Camera camera = looking(scene, StandardView::front);
  const Image without = draw(scene, camera, picture_size);
  const double half = 0.35, behind = 1 - std::cos(half);  // middle of the chord, so far behind the sphere
  const auto darker = [&](double side, double depth) {
    const std::vector<Vector3> corners{Vector3(-std::sin(half), side * std::cos(half), 0),
                                       Vector3(std::sin(half), side * std::cos(half), 0),
                                       Vector3(0, side * std::cos(0.7), std::sin(0.7))};
    const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}};
    scene.objects[0].facet_edges = facet_lines(Vector3::Zero(), corners, triangles, depth);
    const Vector3 pixel = *Projector(camera, picture_size).project((corners[0] + corners[1]) / 2);
    const Image with = draw(scene, camera, picture_size);
    int least = 255;  // the line is one pixel wide
    for (int y = -1; y <= 1; ++y) least = std::min(least, at(with, int(pixel.x()), int(pixel.y()) + y).r);
    return at(without, int(pixel.x()), int(pixel.y())).r - least;
  };
  EXPECT_GT(darker(-1, 1.2 * behind), 20);
  EXPECT_LT(darker(-1, 0.2 * behind), 8) << "it lies behind the sphere";
  EXPECT_LT(darker(1, 1.2 * behind), 8) << "the far side is not seen";
}

TEST_F(RendererTest, PolyhedronPointsAndSelectionShow) {
  Scene scene = plain(golden_object("cube.obj", SurfaceMap::shaded));
  SceneObject& object = scene.objects[0];
  object.show_surface = false;
  object.show_polyhedron = true;
  // Turned a little, so that no two corners lie behind each other.
  const Camera camera = framed(Camera::standard(StandardView::iso).orbit(0.3, -0.2), scene, picture_size);
  const Projector projector(camera, picture_size);
  const auto pixel_of = [&](Index v) {
    const Vector3 p = *projector.project(object.polyhedron->origin + object.polyhedron->position(v));
    return std::pair{static_cast<int>(p.x()), static_cast<int>(p.y())};
  };
  Image image = draw(scene, camera, picture_size);
  for (Index v = 0; v < 8; ++v) {
    const auto [x, y] = pixel_of(v);
    EXPECT_GT(at(image, x, y).r, 150) << v;  // pale in the middle; no line is as bright
  }
  object.selected.vertices = {3};
  object.selected.edges = {0};
  object.selected.faces = {1};
  image = draw(scene, camera, picture_size);
  const auto [x, y] = pixel_of(3);
  EXPECT_GT(at(image, x, y).r - at(image, x, y).b, 100);  // the accent is orange
}

TEST_F(RendererTest, SelectedPatchesAreTinted) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 12));
  const Camera camera = looking(scene, StandardView::iso);
  const Rgb before = centre(draw(scene, camera, picture_size));
  for (Index p = 0; p < 8; ++p) scene.objects[0].selected_patches.push_back(p);
  const Rgb after = centre(draw(scene, camera, picture_size));
  EXPECT_GT(after.r - after.b, before.r - before.b + 30);
}

/// Lines stood round the place of an outlined object where one of an earlier picture had been.
TEST_F(RendererTest, OutlinesForgetEarlierPictures) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 16));
  scene.objects[0].outlined = true;
  const Camera close = looking(scene, StandardView::iso);
  Camera distant = close;
  distant.distance *= 3;
  const Image alone = draw(scene, distant, picture_size);
  draw(scene, close, picture_size);
  EXPECT_EQ(draw(scene, distant, picture_size).rgba, alone.rgba);
}

TEST_F(RendererTest, HiddenLinesShowFaintlyWithXRay) {
  Scene scene = plain(golden_object("cube.obj", SurfaceMap::shaded));
  SceneObject& object = scene.objects[0];
  object.show_polyhedron = true;
  const Camera camera = looking(scene, StandardView::iso);
  const Image opaque = draw(scene, camera, picture_size);
  object.x_ray = true;
  const Image through = draw(scene, camera, picture_size);
  int changed = 0, largest = 0;
  for (std::size_t i = 0; i < opaque.rgba.size(); ++i) {
    const int d = std::abs(int(opaque.rgba[i]) - int(through.rgba[i]));
    changed += d > 3;
    largest = std::max(largest, d);
  }
  EXPECT_GT(changed, 200);
  EXPECT_LT(largest, 70);
}

TEST_F(RendererTest, ASubRangeUpdateEqualsAFullUpload) {
  const auto field = [](double lift) {
    return height_field(20, 10, [=](Index i, Index j) { return plane(0, 0, i == 7 && j == 4 ? lift : 0.0); });
  };
  const DisplayOptions options = map_options(SurfaceMap::mean, 3);
  Scene scene = plain(object_of(field(0), SurfaceMap::mean, 3));
  const Camera camera = looking(scene, StandardView::iso);
  const Image before = draw(scene, camera, picture_size);
  const std::size_t first_upload = renderer_->statistics().uploaded_bytes;
  draw(scene, camera, picture_size);
  EXPECT_EQ(renderer_->statistics().uploaded_bytes, 0U);  // nothing changed

  const std::vector<Index> changed{4 * 20 + 7};
  const Surface after = field(0.8);
  scene.objects[0].mesh = scene.objects[0].mesh->refreshed(after, changed);
  const Image updated = draw(scene, camera, picture_size);
  const std::size_t update = renderer_->statistics().uploaded_bytes;
  EXPECT_GT(update, 0U);
  EXPECT_LT(update, first_upload / 4);
  scene.objects[0].mesh = DisplayMesh::build(after, options);
  const Image fresh = draw(scene, camera, picture_size);
  EXPECT_EQ(updated.rgba, fresh.rgba);
  EXPECT_NE(updated.rgba, before.rgba);
}

TEST_F(RendererTest, ADragUploadsWhatItMovesAndNoCurves) {
  const auto field = [](double lift) {
    return height_field(20, 10, [=](Index i, Index j) { return plane(0, 0, i == 7 && j == 4 ? lift : 0.0); });
  };
  Scene scene = plain(object_of(field(0), SurfaceMap::shaded, 8));
  scene.objects[0].show_network = true;
  const Camera camera = looking(scene, StandardView::iso);
  draw(scene, camera, picture_size);
  for (const double lift : {0.4, 0.8}) {
    const DisplayMesh& mesh = *scene.objects[0].mesh;
    const std::size_t chunk =
        DisplayMesh::patches_per_chunk * mesh.vertices_per_patch() * sizeof(DisplayVertex);
    scene.objects[0].mesh = mesh.refreshed(field(lift), std::vector<Index>{4 * 20 + 7});
    draw(scene, camera, picture_size);
    EXPECT_EQ(renderer_->statistics().uploaded_bytes, chunk);
  }
}

TEST_F(RendererTest, TheTimeOfAPictureComesOnceAndLater) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 16));
  const Camera camera = looking(scene, StandardView::iso);
  DrawOptions options{picture_size, 2};
  const auto time_of = [&](bool timed) {
    options.timed = timed;
    EXPECT_TRUE(renderer_->draw(scene, camera, options).ok());
    renderer_->finish();
    return renderer_->statistics().time;
  };
  EXPECT_FALSE(time_of(false));
  EXPECT_FALSE(time_of(true)) << "nothing was timed before";
  options.samples = 1;
  const auto first = time_of(true), second = time_of(false);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->samples, 2);
  EXPECT_EQ(second->samples, 1);
  EXPECT_GT(first->milliseconds, 0);
  EXPECT_LT(first->milliseconds, 60'000);
  EXPECT_FALSE(time_of(false));
}

TEST_F(RendererTest, FarFromZeroLooksLikeNear) {
  Scene near_scene = plain(golden_object("fig2.obj", SurfaceMap::zebra)), far_scene = near_scene;
  const Camera camera = looking(near_scene, StandardView::iso);
  Camera far_camera = camera;
  const Vector3 far_away(1e6, -1e6, 1e6);
  far_scene.objects[0].transform.topRightCorner<3, 1>() = far_away;
  far_camera.target += far_away;
  const Image a = draw(near_scene, camera, picture_size), b = draw(far_scene, far_camera, picture_size);
  int differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) differing += std::abs(int(a.rgba[i]) - int(b.rgba[i])) > 8;
  EXPECT_LT(differing, 40);
}

TEST_F(RendererTest, GridFadesAndHasColouredAxes) {
  Scene scene;
  Camera camera = Camera::standard(StandardView::top);
  const Image image = draw(scene, camera, picture_size);
  const Rgb on_x = at(image, 200, 120), on_y = at(image, 160, 80);
  EXPECT_GT(on_x.r, on_x.g + 40);
  EXPECT_GT(on_y.g, on_y.r + 30);
}

TEST_F(RendererTest, ResizingAndEverySampleCountWork) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 8));
  const Camera camera = looking(scene, StandardView::front);
  for (const int samples : {1, 2, 4, 64})
    for (const PixelSize s : {PixelSize{1, 1}, PixelSize{33, 200}, picture_size}) {
      const Image image = draw(scene, camera, s, samples);
      EXPECT_EQ(image.width, s.width);
      EXPECT_GT(centre(image).r, 80);
    }
}

TEST_F(RendererTest, ImpossibleSizesAreErrors) {
  must_fail(renderer_->draw({}, {}, {{1'000'000, 10}, 4}), e_gl_framebuffer);
  draw({}, {}, picture_size);  // and the renderer still works
}

TEST_F(RendererTest, EmptyObjectsDrawNothing) {
  Scene scene;
  scene.objects.emplace_back();
  SceneObject empty;
  empty.mesh = DisplayMesh::build(Surface(), {});
  empty.show_polyhedron = true;
  scene.objects.push_back(empty);
  draw(scene, framed(Camera{}, scene, picture_size), picture_size);
}

TEST(Picture, SizesOutsideTheLimitsAreErrors) {
  for (const auto& [w, h] : {std::pair{0, 10}, std::pair{10, -1}, std::pair{max_picture_side + 1, 10}}) {
    must_fail(render_picture({}, {}, w, h), e_picture_size);
  }
}

TEST(Picture, IsTheSameEveryTime) {
  const Scene scene = scene_of(object_of(sphere(1), SurfaceMap::shaded, 8));
  const Result<Image> a = render_picture(scene, Camera{}, 200, 150),
                      b = render_picture(scene, Camera{}, 200, 150);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->rgba, b->rgba);
  EXPECT_EQ(a->width, 200);
}

}  // namespace
}  // namespace hariko
