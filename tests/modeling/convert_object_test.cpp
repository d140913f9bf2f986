#include "core/modeling/surfacing/convert_object.hpp"

#include <algorithm>

#include "core/approximation/surface_projector.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/document/format/read_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/envelope.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

Document with_outline(const std::string& name, bool g2, Frames frames = Frames::metric) {
  const auto text = read_file(test::source_folder() + "/tests/golden/gaussmap/" + name + ".json", 1 << 20);
  OutlineSource source;
  source.outline = read_outline(*text).value();
  source.settings = usual_settings(*source.outline);
  source.settings.curvature_continuous = g2;
  source.settings.frames = frames;
  return add_object({}, "Outline", std::move(source)).value().document;
}

TEST(ConvertObject, TheSurfaceStaysAsItIsToTheLastBit) {
  for (const auto* name : {"sphere_cap", "sphere_band", "three_holes", "catenoid"})
    for (const auto& [g2, frames] :
         {std::pair{false, Frames::equal}, {false, Frames::metric}, {true, Frames::metric}}) {
      if (g2 && name != std::string("sphere_cap")) continue;  // one is enough of the slow ones
      SCOPED_TRACE(name + std::string(g2 ? " g2" : " fair") +
                   (frames == Frames::metric ? " by measure" : ""));
      const Document document = with_outline(name, g2, frames);
      const ObjectId id = document.objects[0]->id;
      const auto converted = test::must(convert_outline(document, id));
      const PolyhedronSource* polyhedron = converted->objects[0]->polyhedron();
      ASSERT_TRUE(polyhedron);
      EXPECT_EQ(converted->objects[0]->name, "Outline");
      EXPECT_EQ(polyhedron->mode, g2 ? Mode::g2 : Mode::fair);
      EXPECT_EQ(polyhedron->frames, frames);
      const auto before = test::must(object_surface(document, *document.objects[0]));
      const auto after = test::must(object_surface(*converted, *converted->objects[0]));
      ASSERT_EQ(before->surface.patch_count(), after->surface.patch_count());
      EXPECT_EQ(before->surface.origin(), after->surface.origin());
      for (Index patch = 0; patch < before->surface.patch_count(); ++patch)
        for (const Vector2& at : {Vector2(0.2, 0.3), Vector2(0, 1), Vector2(0.5, 0.5)})
          ASSERT_EQ(before->surface.patches().evaluate(patch, at, Order::first).position,
                    after->surface.patches().evaluate(patch, at, Order::first).position);
      // The outline's points are the first vertices, every normal is pinned.
      const Outline& outline = *document.objects[0]->outline()->outline;
      EXPECT_GT(polyhedron->polyhedron.vertex_count(), outline.point_count());
      EXPECT_EQ(polyhedron->shaping->pin.size(), polyhedron->polyhedron.vertex_count());
      const auto points = control_points(outline, gauss_options(document.objects[0]->outline()->settings));
      ASSERT_TRUE(points.ok());
      for (Index v = 0; v < polyhedron->polyhedron.vertex_count(); ++v)
        EXPECT_LE((polyhedron->origin + polyhedron->polyhedron.position(v) - points->points[v]).norm(),
                  1e-12 * outline.size());
    }
}

TEST(ConvertObject, AnOutlineWithoutFramesHasTheSurfaceOfEqualOnes) {
  const Document document = with_outline("ellipsoid_cap", false, Frames::equal);
  const OutlineSource& outline = *document.objects[0]->outline();
  const auto points = test::must(control_points(*outline.outline, gauss_options(outline.settings)));
  const auto polyhedron = test::must(outline_polyhedron(*points));
  EXPECT_TRUE(polyhedron->shaping.form.empty());
  const auto before = PolyhedronSurfacer().rebuild(
      {polyhedron->polyhedron, polyhedron->shaping, Mode::fair, polyhedron->origin});
  const auto now = object_surface(document, *document.objects[0]);
  ASSERT_TRUE(before.ok() && now.ok());
  ASSERT_EQ(before->surface.patch_count(), now->surface.patch_count());
  for (Index patch = 0; patch < now->surface.patch_count(); ++patch)
    ASSERT_EQ(before->surface.patches().evaluate(patch, {0.2, 0.3}, Order::first).position,
              now->surface.patches().evaluate(patch, {0.2, 0.3}, Order::first).position);
}

Document with_solids(const std::string& name, EnvelopeMethod method) {
  const auto text = read_file(test::source_folder() + "/tests/golden/envelope/" + name + ".json", 1 << 20);
  EnvelopeInput input = read_scene(*text).value();
  input.settings.method = method;
  return add_object({}, "Solids", SolidsSource{std::move(input), {}}).value().document;
}

/// Measures again how far the conversion says that its surface is from the original.
void expect_told_distances(const SolidsPolyhedron& converted, const EnvelopeSurface& made,
                           const EnvelopeInput& input, const Surface& surface) {
  // A network has few corners, between which a polyhedron's surface goes its own way.
  EXPECT_LE(converted.distance, (made.network ? 0.1 : 0.01) * made.diagonal);
  EXPECT_NEAR(farthest_from(surface, made.surface), converted.distance, 1e-9 * made.diagonal);
  std::vector<SolidShape> shapes;
  for (const Solid& solid : input.solids) shapes.emplace_back(solid, surface.origin());
  const EnclosureReport seen = check_enclosure(
      surface, shapes, {.points = 2000, .spacing = 1e-3 * made.diagonal, .covered = false}, 0);
  EXPECT_LE(seen.worst, std::max(1.2 * converted.outside, 3e-4 * made.diagonal));
}

TEST(ConvertObject, ANetworksVerticesAreInterpolatedWithTheirNormals) {
  for (const auto* name : {"two_apart", "four_boxes"}) {
    SCOPED_TRACE(name);
    const Document document = with_solids(name, EnvelopeMethod::network);
    const SolidsSource& solids = *document.objects[0]->solids();
    const auto converted = test::must(solids_polyhedron(solids));
    EXPECT_EQ(converted->source.frames, Frames::metric);
    const auto made = EnvelopeSurfacer().rebuild(*solids.input);
    ASSERT_TRUE(made.ok() && made->network);
    const auto added = add_object({}, "Polyhedron", converted->source).value();
    const auto surface = test::must(object_surface(added.document, *added.document.objects[0]));
    const auto& vertices = made->network->cage.vertices;
    ASSERT_EQ(converted->source.polyhedron.vertex_count(), vertices.size());
    EXPECT_TRUE(surface->surface.boundary_sides().empty());
    expect_told_distances(*converted, *made, *solids.input, surface->surface);
    // Every corner of a patch that lies on a vertex has the vertex's normal.
    std::vector<char> met(vertices.size(), 0);
    for (Index patch = 0; patch < surface->surface.patch_count(); ++patch)
      for (const Vector2& corner : {Vector2(0, 0), Vector2(1, 0), Vector2(0, 1)}) {
        const PatchPoint at = surface->surface.patches().evaluate(patch, corner, Order::first);
        for (std::size_t v = 0; v < vertices.size(); ++v)
          if ((at.position + surface->surface.origin() - vertices[v].position - made->origin).norm() <
              1e-9 * made->diagonal) {
            met[v] = 1;
            EXPECT_GT(unit_normal(at).dot(vertices[v].normal), 1 - 1e-9);
          }
      }
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), long(vertices.size()));
  }
}

TEST(ConvertObject, TheBallsQuadsKeepTheirCornersAndNormals) {
  Document document = with_solids("ell_tight", EnvelopeMethod::network);
  EnvelopeInput input = *document.objects[0]->solids()->input;
  choose_ball(input);
  input.settings.rounding *= 2.5;
  const SolidsSource solids{input, {}};
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok() && made->cage);
  const auto converted = test::must(solids_polyhedron(solids));
  const PolyhedronSource& source = converted->source;
  ASSERT_EQ(source.polyhedron.vertex_count(), made->surface.node_count());
  EXPECT_EQ(source.polyhedron.face_count(), made->surface.patch_count());
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
    const Pin* pin = source.shaping->pin.find(VertexId{v});
    ASSERT_TRUE(pin);
    EXPECT_EQ(pin->vectors[0], made->surface.node_normal(v));
  }
  const auto added = add_object({}, "Polyhedron", source).value();
  const auto surface = test::must(object_surface(added.document, *added.document.objects[0]));
  expect_told_distances(*converted, *made, input, surface->surface);
}

TEST(ConvertObject, SaysWhatItCannotDo) {
  const Document bad = with_outline("bad_inward", false);
  const ObjectId id = bad.objects[0]->id;
  EXPECT_EQ(convert_outline(bad, id).error().code, e_not_convex);
  EXPECT_EQ(convert_outline(bad, ObjectId{77}).error().code, e_unknown_object);
  EXPECT_EQ(convert_outline(set_locked(bad, id, true).value(), id).error().code, e_locked);
  const Document cap = with_outline("sphere_cap", false);
  const auto once = test::must(convert_outline(cap, id));
  EXPECT_EQ(convert_outline(*once, id).error().code, e_wrong_kind);
}

}  // namespace
}  // namespace hariko
