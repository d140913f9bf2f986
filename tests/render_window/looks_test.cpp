// Ways of looking at a surface: materials, isophotes, sections, wires, marks, combs, tensions.

#include <gtest/gtest.h>

#include <set>

#include "core/analysis/combs.hpp"
#include "render/element_colors.hpp"
#include "tests/render_window/gl_context.hpp"
#include "tests/render_window/models.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

Color pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {float(p[0]) / 255, float(p[1]) / 255, float(p[2]) / 255, float(p[3]) / 255};
}
/// Number of pixels of about this hue: each channel within `tolerance`.
int count_near(const Image& image, const Color& wanted, float tolerance = 0.12F) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Color c = pixel(image, x, y);
      if (std::abs(c.r - wanted.r) < tolerance && std::abs(c.g - wanted.g) < tolerance &&
          std::abs(c.b - wanted.b) < tolerance)
        ++count;
    }
  return count;
}

class LooksTest : public GlTest {};

TEST_F(LooksTest, EveryMaterialCompilesWithEveryLookAndHasItsOwn) {
  std::set<std::vector<std::uint8_t>> pictures;
  for (int m = 0; m < material_count; ++m)
    for (const PatchWire wire : {PatchWire::none, PatchWire::mesh})
      for (const bool highlight : {false, true}) {
        SceneObject object = object_of(sphere(1), SurfaceMap::shaded, 8);
        object.material = static_cast<Material>(m);
        object.wire = wire;
        if (highlight) object.selected_patches = {0, 3};
        const Scene scene = plain(std::move(object));
        EXPECT_TRUE(pictures.insert(draw(scene, looking(scene, StandardView::iso), picture_size).rgba).second)
            << m << " " << int(wire) << " " << highlight;
      }
}

TEST_F(LooksTest, TheInsideIsCoolerInEveryMaterial) {
  for (int m = 0; m < material_count; ++m) {
    SceneObject object = object_of(sphere(1), SurfaceMap::shaded, 16);
    object.material = static_cast<Material>(m);
    object.color = color_of(natural_colour(object.material));
    Scene scene = plain(std::move(object));
    const Camera camera = looking(scene, StandardView::front);
    const Color outside =
        pixel(draw(scene, camera, picture_size), picture_size.width / 2, picture_size.height / 2);
    scene.section = SectionPlane{-Vector3::UnitY(), 0.0};  // the front half goes: y < 0
    const Color inside =
        pixel(draw(scene, camera, picture_size), picture_size.width / 2, picture_size.height / 2);
    EXPECT_GT(inside.b - inside.r, outside.b - outside.r + 0.08F) << m;
  }
}

TEST_F(LooksTest, ASectionCutsAwayOneHalfAndDrawsItsCurve) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 24));
  const Camera camera = looking(scene, StandardView::iso);
  scene.background = Background::transparent;
  const auto covered = [&](const Image& image) {
    int count = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 200 ? 1 : 0;
    return count;
  };
  const Color accent = color_from_hex("#ffa51f");
  const Image whole = draw(scene, camera, picture_size);
  EXPECT_EQ(count_near(whole, accent, 0.08F), 0);
  scene.section = SectionPlane{Vector3::UnitZ(), 0.3};
  const Image cut = draw(scene, camera, picture_size);
  EXPECT_LT(covered(cut), 0.97 * covered(whole));
  EXPECT_GT(covered(cut), 0.5 * covered(whole));
  EXPECT_GT(count_near(cut, accent, 0.15F), 60) << "the curve of the cut";
  scene.section = SectionPlane{-Vector3::UnitZ(), -0.8};  // only a cap is left
  EXPECT_LT(covered(draw(scene, camera, picture_size)), covered(whole) / 2);
  scene.section = SectionPlane{Vector3::UnitX(), -5.0};
  EXPECT_EQ(covered(draw(scene, camera, picture_size)), 0);
}

/// Long edges seen in perspective are cut where the plane is, as are points and the tint of selected faces.
TEST_F(LooksTest, ASectionCutsTheCageToo) {
  SceneObject object = golden_object("cube.obj", SurfaceMap::shaded);
  object.show_surface = false;
  object.show_polyhedron = true;
  object.selected.faces = {0, 1, 2, 3, 4, 5};
  object.selected.vertices = {0, 1, 2, 3, 4, 5, 6, 7};
  Scene scene = plain(object);
  scene.background = Background::transparent;
  Camera camera = looking(scene, StandardView::iso);
  camera.distance *= 0.7;  // strong perspective
  const Box3 box = scene.world_box();
  const double height = box.center().z() + 0.2 * box.sizes().z();
  const auto painted = [&] {
    const Image image = draw(scene, camera, picture_size);
    const Projector projector(camera, picture_size);
    std::pair<int, int> above_below;
    for (int y = 0; y < picture_size.height; ++y)
      for (int x = 0; x < picture_size.width; ++x) {
        if (pixel(image, x, y).a < 0.05F) continue;
        // Whatever is kept lies on the box below the plane (points are discs of some pixels).
        const Ray ray = projector.ray({x + 0.5, y + 0.5});
        Box3 kept = box;
        kept.max().z() = height;
        const double slack = 9 * projector.pixel_length_at(box.center());
        kept.min().array() -= slack;
        kept.max().array() += slack;
        double first = 0, last = 1e9;
        for (int k = 0; k < 3; ++k) {
          const double a = (kept.min()[k] - ray.origin[k]) / ray.direction[k];
          const double b = (kept.max()[k] - ray.origin[k]) / ray.direction[k];
          first = std::max(first, std::min(a, b));
          last = std::min(last, std::max(a, b));
        }
        ++(first <= last ? above_below.second : above_below.first);
      }
    return above_below;
  };
  EXPECT_GT(painted().first, 300) << "the whole cage reaches above";
  scene.section = SectionPlane{Vector3::UnitZ(), height};
  const auto [above, below] = painted();
  EXPECT_EQ(above, 0);
  EXPECT_GT(below, 2000);
  scene.objects[0].x_ray = true;
  EXPECT_EQ(painted().first, 0);
}

TEST_F(LooksTest, TheCurveOfTheCutHasNoGaps) {
  Scene scene = plain(object_of(sphere(1), SurfaceMap::shaded, 32));
  const Camera camera = looking(scene, StandardView::top);
  scene.section = SectionPlane{Vector3::UnitZ(), 0.0};
  const Image image = draw(scene, camera, picture_size);
  const Projector projector(camera, picture_size);
  int found = 0;
  constexpr int steps = 360;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * 3.14159265358979 * i / steps;
    const auto at = projector.project({std::cos(angle), std::sin(angle), 0});
    ASSERT_TRUE(at);
    const Color c = pixel(image, int(at->x()), int(at->y()));
    if (c.r > c.b + 0.15F) ++found;
  }
  EXPECT_GT(found, steps * 95 / 100);
}

TEST_F(LooksTest, IsophotesStayOnTheObjectWhereZebraMoves) {
  for (const bool isophotes : {true, false}) {
    Scene scene = plain(object_of(sphere(1), isophotes ? SurfaceMap::isophotes : SurfaceMap::zebra, 32));
    scene.zebra = {8, {0, 0, 1}, StripeLock::world};
    Camera camera = looking(scene, StandardView::front);
    camera.orthographic = true;
    const Image before = draw(scene, camera, picture_size);
    // Raised by some degrees: on a sphere, isophotes about z follow the same circles of latitude.
    const Camera raised = camera.orbit(0, 0.2);
    const Image after = draw(scene, raised, picture_size);
    int same = 0, total = 0;
    const Projector first(camera, picture_size), second(raised, picture_size);
    for (int i = -40; i <= 40; ++i) {
      const double latitude = i * 0.015;
      const Vector3 p(0, -std::cos(latitude), std::sin(latitude));
      const auto a = first.project(p), b = second.project(p);
      const bool white_a = pixel(before, int(a->x()), int(a->y())).g > 0.45F;
      const bool white_b = pixel(after, int(b->x()), int(b->y())).g > 0.45F;
      same += white_a == white_b ? 1 : 0;
      ++total;
    }
    if (isophotes)
      EXPECT_GE(same, total * 85 / 100);
    else
      EXPECT_LT(same, total * 85 / 100);
  }
}

TEST_F(LooksTest, MarksHaveTheirColours) {
  AnalyticOptions options;
  options.source_edges = true;
  for (int k = 0; k < 3; ++k) {
    SceneObject object = object_of(sphere(1, options), SurfaceMap::shaded, 16);
    object.marks = edge_marks(*object.mesh, std::vector<Continuity>(12, static_cast<Continuity>(k)));
    const Scene scene = plain(std::move(object));
    const Image image = draw(scene, looking(scene, StandardView::iso), picture_size);
    for (int other = 0; other < 3; ++other) {
      const int found = count_near(image, mark_color(static_cast<Continuity>(other)), 0.09F);
      if (other == k)
        EXPECT_GT(found, 60) << k;
      else
        EXPECT_LT(found, 5) << k << " " << other;
    }
  }
}

TEST_F(LooksTest, CombsHaveTheSameLengthAtAnyZoom) {
  AnalyticOptions options;
  options.source_edges = true;
  SceneObject object = object_of(sphere(1, options), SurfaceMap::shaded, 16);
  object.combs = comb_lines(curvature_combs(sphere(1, options), 16), Vector3::Zero());
  Scene scene = plain(std::move(object));
  scene.background = Background::transparent;
  std::vector<int> reaches;
  for (const double factor : {1.6, 3.2, 6.4}) {
    Camera camera = looking(scene, StandardView::front);
    camera.orthographic = true;
    camera.distance *= factor;
    const Image image = draw(scene, camera, picture_size);
    const Projector projector(camera, picture_size);
    const int edge = int(projector.project({1, 0, 0})->x());
    int last = 0;
    for (int x = 0; x < picture_size.width; ++x)
      for (int y = picture_size.height / 2 - 2; y <= picture_size.height / 2 + 2; ++y)
        if (image.pixel(x, y)[3] > 60) last = std::max(last, x);
    reaches.push_back(last - edge);
  }
  EXPECT_NEAR(reaches[0], 60, 6);
  EXPECT_NEAR(reaches[1], reaches[0], 3);
  EXPECT_NEAR(reaches[2], reaches[0], 3);
}

TEST_F(LooksTest, TensionsColourEdgesAndPoints) {
  const PolyhedronSurfaceInput input = golden_input("cube.obj", Mode::fair, {});
  Shaping shaping;
  shaping.beta.set(input.polyhedron.edge_id(0), 20.0);
  shaping.beta.set(input.polyhedron.edge_id(1), 0.05);
  shaping.alpha.set(input.polyhedron.vertex_id(0), 20.0);
  SceneObject object;
  object.polyhedron = DisplayPolyhedron::build(input.polyhedron, shaping, input.origin);
  object.show_polyhedron = true;
  Scene scene = plain(std::move(object));
  const Camera camera = looking(scene, StandardView::iso);
  const Color tight = tension_color(1), loose = tension_color(-1);
  const Image without = draw(scene, camera, picture_size);
  scene.objects[0].show_tensions = true;
  const Image with = draw(scene, camera, picture_size);
  EXPECT_EQ(count_near(without, tight, 0.06F), 0);
  EXPECT_EQ(count_near(without, loose, 0.06F), 0);
  EXPECT_GT(count_near(with, tight, 0.06F), 60);
  EXPECT_GT(count_near(with, loose, 0.06F), 30);
}

TEST_F(LooksTest, TagsAndPinsHaveMarksAndFailuresAreRed) {
  const PolyhedronSurfaceInput input = golden_input("cube.obj", Mode::fair, {});
  Shaping shaping;
  const auto picture = [&] {
    SceneObject object;
    object.polyhedron = DisplayPolyhedron::build(input.polyhedron, shaping, input.origin);
    object.show_polyhedron = true;
    const Scene scene = plain(std::move(object));
    return draw(scene, looking(scene, StandardView::iso), picture_size).rgba;
  };
  std::set<std::vector<std::uint8_t>> pictures{picture()};
  const VertexId id = input.polyhedron.vertex_id(6);
  shaping.tag.set(id, VertexTag::corner);
  EXPECT_TRUE(pictures.insert(picture()).second);
  shaping.tag.set(id, VertexTag::smooth);
  EXPECT_TRUE(pictures.insert(picture()).second);
  shaping.tag.erase(id);
  shaping.pin.set(id, {Pin::Kind::normal, {Vector3::UnitZ()}});
  EXPECT_TRUE(pictures.insert(picture()).second);

  SceneObject object;
  object.polyhedron = DisplayPolyhedron::build(input.polyhedron, {}, input.origin);
  Scene scene = plain(std::move(object));
  const Camera camera = looking(scene, StandardView::iso);
  const Color red = color_from_hex("#ff3b30");
  EXPECT_EQ(count_near(draw(scene, camera, picture_size), red, 0.06F), 0);
  scene.objects[0].failed.edges = {0, 1};
  EXPECT_GT(count_near(draw(scene, camera, picture_size), red, 0.06F), 60)
      << "even when the polyhedron is hidden";
}

TEST_F(LooksTest, ColourBlindSafeMapsHaveNoRed) {
  Scene scene = plain(
      object_of(height_field(1, 1, [](Index, Index) { return saddle(); }), SurfaceMap::principal_max, 12));
  const Camera camera = looking(scene, StandardView::top);
  const Image usual = draw(scene, camera, picture_size);
  scene.colour_blind_safe = true;
  const Image safe = draw(scene, camera, picture_size);
  const Color a = pixel(usual, picture_size.width / 2, picture_size.height / 2),
              b = pixel(safe, picture_size.width / 2, picture_size.height / 2);
  EXPECT_GT(a.r - a.g, 0.2F);
  EXPECT_LT(b.r - b.g, a.r - a.g - 0.1F);
}

}  // namespace
}  // namespace hariko
