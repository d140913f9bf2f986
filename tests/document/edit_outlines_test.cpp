#include "core/document/edits/edit_outlines.hpp"

#include "core/base/files/file_io.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/gaussmap/outlines/border_outline.hpp"
#include "core/gaussmap/outlines/edit_outline.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

Document with_cap() {
  const auto text = read_file(test::source_folder() + "/tests/golden/gaussmap/sphere_cap.json", 1 << 20);
  OutlineSource source;
  source.outline = read_outline(*text).value();
  return add_object({}, "Cap", std::move(source)).value().document;
}

Result<Document> moved(const Document& document, ObjectId id, const Vector3& to) {
  return edit_outline(document, id, [&](const Outline& outline) -> Result<Outline> {
    return with_points(outline, std::array{Index(3)}, std::array{to});
  });
}

TEST(EditOutlines, ChangeOneObjectAndShareTheRest) {
  const Document document = with_cap();
  const ObjectId id = document.objects[0]->id;
  const auto done = test::must(moved(document, id, {1, 2, 3}));
  EXPECT_EQ(done->objects[0]->outline()->outline->loops[0].points[3], Vector3(1, 2, 3));
  EXPECT_EQ(done->objects[0]->outline()->settings, document.objects[0]->outline()->settings);
  // Nothing changes: the same object.
  const auto same =
      edit_outline(document, id, [](const Outline& outline) -> Result<Outline> { return outline; });
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same->objects[0], document.objects[0]);
}

TEST(EditOutlines, RefuseWhatCannotBe) {
  const Document document = with_cap();
  const ObjectId id = document.objects[0]->id;
  EXPECT_EQ(moved(document, id, Vector3::Constant(HUGE_VAL)).error().code, e_nonfinite);
  EXPECT_EQ(moved(document, ObjectId{99}, {0, 0, 0}).error().code, e_unknown_object);
  EXPECT_EQ(moved(set_locked(document, id, true).value(), id, {0, 0, 0}).error().code, e_locked);
  const auto large = edit_outline(document, id, [](const Outline& outline) -> Result<Outline> {
    return resampled(outline, max_outline_points + 1, LoopMeasure::arc);
  });
  EXPECT_EQ(large.error().code, e_outline_limit);
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face(std::array<Index, 3>{0, 1, 2});
  const auto added = add_object(document, "Triangle", PolyhedronSource::from_mesh(mesh).value());
  EXPECT_EQ(moved(added->document, added->id, {0, 0, 0}).error().code, e_wrong_kind);
  EXPECT_EQ(set_outline_settings(added->document, added->id, {}).error().code, e_wrong_kind);
}

TEST(EditOutlines, SettingsHaveRanges) {
  const Document document = with_cap();
  const ObjectId id = document.objects[0]->id;
  OutlineSettings settings;
  settings.mode = GaussMode::position;
  settings.radius = 0.4;
  settings.gap = 0.01;
  const auto done = test::must(set_outline_settings(document, id, settings));
  EXPECT_EQ(done->objects[0]->outline()->settings, settings);
  const auto refused = [&](auto&& change) {
    OutlineSettings bad = settings;
    change(bad);
    const auto result = set_outline_settings(document, id, bad);
    EXPECT_FALSE(result.ok());
    if (!result.ok()) {
      EXPECT_EQ(result.error().code, e_outline_settings);
    }
  };
  refused([](OutlineSettings& bad) { bad.radius = 0; });
  refused([](OutlineSettings& bad) { bad.radius = std::nan(""); });
  refused([](OutlineSettings& bad) { bad.gap = -1; });
  refused([](OutlineSettings& bad) { bad.gap = HUGE_VAL; });
  refused([](OutlineSettings& bad) { bad.most_points = OutlineSettings::point_limit + 1; });
}

TEST(EditOutlines, FramesAreSetAsThoseOfPolyhedra) {
  const Document document = with_cap();
  const ObjectId id = document.objects[0]->id;
  ASSERT_EQ(surface_frames(document.objects[0]->source), Frames::equal) << "what files without them mean";
  const auto metric = test::must(set_frames(document, id, Frames::metric));
  EXPECT_EQ(metric->objects[0]->outline()->settings.frames, Frames::metric);
  EXPECT_EQ(surface_frames(metric->objects[0]->source), Frames::metric);
  EXPECT_EQ(metric->objects[0]->outline()->outline.get(), document.objects[0]->outline()->outline.get());
  EXPECT_FALSE(*metric == document);
  EXPECT_EQ(*set_frames(*metric, id, Frames::equal), document);
  EXPECT_EQ(set_frames(*metric, id, Frames::metric)->objects[0], metric->objects[0]) << "the same object";

  EXPECT_EQ(set_frames(set_locked(document, id, true).value(), id, Frames::metric).error().code, e_locked);
  EXPECT_EQ(set_frames(document, ObjectId{99}, Frames::metric).error().code, e_unknown_object);
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face(std::array<Index, 3>{0, 1, 2});
  const auto facets = add_object(document, "Facets", MeshSource::from_mesh(mesh).value());
  EXPECT_EQ(set_frames(facets->document, facets->id, Frames::metric).error().code, e_wrong_kind);
  EXPECT_FALSE(surface_frames(facets->document.find(facets->id)->source).has_value());
}

TEST(EditOutlines, NewOnesBeginByMeasure) {
  const Outline outline = *with_cap().objects[0]->outline()->outline;
  EXPECT_EQ(usual_settings(outline).frames, Frames::metric);
  EXPECT_EQ(new_outline_settings().frames, Frames::metric);
  EXPECT_EQ(border_fill(outline.loops[0]).settings.frames, Frames::metric);
}

}  // namespace
}  // namespace hariko
