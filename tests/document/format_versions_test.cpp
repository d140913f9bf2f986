// Files of older versions: they open for ever, and mean what they meant.

#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "tests/document/file_texts.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

TEST(Format, FixtureOfVersion1ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v1.hariko");
  const Result<Document> read = test::must(read_document(text));
  const Document& document = *read;
  EXPECT_EQ(document.unit, Unit::centimetre);
  EXPECT_EQ(document.next_object_id.value, 12U);
  ASSERT_EQ(document.objects.size(), 3U);
  EXPECT_EQ(*document.kept, (KeptMembers{{"studies", "[{\"kind\": \"paper\",  \"page\": \"A4\"}]"}}));

  const Object& roof = *document.objects[0];
  EXPECT_EQ(roof.id, ObjectId{5});
  EXPECT_EQ(roof.name, "Roof 屋根");
  EXPECT_FALSE(roof.visible);
  EXPECT_TRUE(roof.locked);
  EXPECT_EQ(roof.transform.rotation.coeffs(), Eigen::Vector4d(0.6, 0, 0, 0.8));
  EXPECT_EQ(roof.transform.scale, 2.5);
  EXPECT_EQ(roof.transform.translation, Vector3(1, -2, 1e-3));
  EXPECT_EQ(roof.display, (DisplaySettings{false, true, false, SurfaceMap::zebra, 16, {0xff, 0x80, 0x00}}));
  EXPECT_EQ(*roof.kept, (KeptMembers{{"note", "\"keep me\""}}));
  const PolyhedronSource& source = *roof.polyhedron();
  EXPECT_EQ(source.mode, Mode::target);
  EXPECT_EQ(source.origin, Vector3(1024, 0, -0.5));
  EXPECT_EQ(source.polyhedron.vertex_id(4), VertexId{14});
  EXPECT_EQ(source.polyhedron.face_id(0), FaceId{3});
  EXPECT_EQ(source.polyhedron.position(4), Vector3(0.1, 0, 1.7976931348623157e308));
  EXPECT_EQ(source.polyhedron.face_count(), 4U);
  Shaping shaping;
  shaping.alpha.set({14}, 10);
  shaping.beta.set(EdgeId{{10}, {11}}, 0.001);
  shaping.crease.set(EdgeId{{11}, {14}}, true);
  shaping.tag.set({10}, VertexTag::corner);
  shaping.tag.set({12}, VertexTag::smooth);
  shaping.pin.set({11}, {Pin::Kind::tangents, {{1, 0, 0}, {0, 1, 0}}});
  shaping.pin.set({14}, {Pin::Kind::normal, {{0, 0, 1}}});
  EXPECT_EQ(*source.shaping, shaping);

  const MeshSource& mesh = *document.objects[1]->mesh();
  EXPECT_EQ(mesh.origin, Vector3(0, 0, 8));
  EXPECT_EQ(mesh.mesh->positions.size(), 4U);
  EXPECT_EQ(mesh.mesh->face(1)[2], 3U);
  EXPECT_EQ(document.objects[1]->display, DisplaySettings{});

  const auto& unknown = std::get<UnknownSource>(document.objects[2]->source);
  EXPECT_EQ(unknown.kind, "envelope");
  EXPECT_EQ(*unknown.json, "{\"kind\": \"envelope\", \"solids\": [{\"r\": 1.50}, 12345678901234567890123]}");

  EXPECT_EQ(*read_document(write_document(document)), document);
  std::string now = text;
  now.replace(now.find("\"version\": 1"), 12, "\"version\": " + std::to_string(format_version));
  EXPECT_EQ(write_document(document), now) << "the fixture is written as this version writes";
}

TEST(Format, SkinsOfVersion2ReadForEver) {
  const std::string text = file_text("tests/document/fixtures/v2_skin.hariko");
  const Result<Document> read = test::must(read_document(text));
  const Skin& skin = *read->objects[0]->skin()->skin;
  ASSERT_EQ(skin.sections.size(), 2U);
  EXPECT_FALSE(skin.sections[0].start_chosen);
  EXPECT_TRUE(skin.sections[1].start_chosen);
  EXPECT_EQ(write_document(*read), as_written_now(text, 2))
      << "the fixture is written as this version writes";
}

TEST(Format, ClosedSectionsOfVersion1BeginWhereTheyWereDrawn) {
  std::string text = file_text("tests/document/fixtures/v2_skin.hariko");
  const std::string chosen = "            \"start_chosen\": true,\n";
  text.erase(text.find(chosen), chosen.size());
  const auto found = test::must(read_document(text));
  text.replace(text.find("\"version\": 2"), 12, "\"version\": 1");
  const auto drawn = test::must(read_document(text));
  for (const int k : {0, 1}) {
    EXPECT_FALSE(found->objects[0]->skin()->skin->sections[std::size_t(k)].start_chosen);
    EXPECT_TRUE(drawn->objects[0]->skin()->skin->sections[std::size_t(k)].start_chosen);
  }
}

TEST(Format, FixtureOfVersion2ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v2.hariko");
  const Result<Document> read = test::must(read_document(text));
  ASSERT_EQ(read->objects.size(), 2U);
  EXPECT_EQ(read->objects[0]->polyhedron()->frames, Frames::metric);
  EXPECT_TRUE(read->objects[0]->polyhedron()->preparation.split_concave);
  EXPECT_EQ(read->objects[1]->polyhedron()->frames, Frames::equal) << "nothing old changes by itself";
  EXPECT_EQ(write_document(*read), as_written_now(text, 2))
      << "the fixture is written as this version writes";
}

TEST(Format, SolidsOfVersion2GetTheBall) {
  const std::string text = file_text("tests/document/fixtures/v2_solids.hariko");
  const Result<Document> read = test::must(read_document(text));
  ASSERT_EQ(read->objects.size(), 3U);
  const auto settings = [&](std::size_t i) { return read->objects[i]->solids()->input->settings; };
  EXPECT_EQ(settings(0).method, EnvelopeMethod::ball) << "auto, tight";
  EXPECT_TRUE(settings(0).converted.method);
  EXPECT_NEAR(settings(0).rounding, 0.045 * 3, 1e-12);
  EXPECT_NEAR(*settings(0).ball_radius, 3 * 0.045 * 3, 1e-12) << "tightness 1";
  EXPECT_EQ(settings(1).method, EnvelopeMethod::network) << "auto at tightness 0";
  EXPECT_EQ(settings(2).method, EnvelopeMethod::ball) << "a field, at tightness 0 the hull";
  EXPECT_FALSE(settings(2).ball_radius.has_value());
  const Result<Document> again = test::must(read_document(write_document(*read)));
  EXPECT_FALSE(again->objects[0]->solids()->input->settings.converted.method) << "saved by this version";
  EXPECT_EQ(again->objects[0]->solids()->input->settings.ball_radius, settings(0).ball_radius);
}

TEST(Format, LostSettingsAreNoPartOfTheDocument) {
  // An input that the document fuzzer found: the network is kept, and of its settings one means nothing any
  // more.
  const Result<Document> read = test::must(read_document(R"({
    "format": "hariko", "version": 3, "unit": "mm", "next_object_id": 1,
    "objects": [{"id": 0, "name": "Bar", "source": {"kind": "solids", "merge_deg": 0.35,
      "primitives": [{"type": "cylinder", "radius": 0.5, "height": 2}]}}]})"));
  const ConvertedSettings& converted = read->objects[0]->solids()->input->settings.converted;
  EXPECT_EQ(converted.lost, "merge_deg");
  const Result<Document> again = test::must(read_document(write_document(*read)));
  EXPECT_EQ(again->objects[0]->solids()->input->settings.converted.lost, "") << "said once";
  EXPECT_TRUE(*again == *read);
}

TEST(Format, FixtureOfVersion3ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v3.hariko");
  const Result<Document> read = test::must(read_document(text));
  const PolyhedronSource& source = *read->objects[0]->polyhedron();
  EXPECT_TRUE(source.preparation.merge_coplanar);
  const KeptForm* form = source.shaping->form.find({4});
  ASSERT_TRUE(form);
  ASSERT_EQ(form->edges.size(), 3U);
  EXPECT_EQ(form->edges[1], (KeptForm::Edge{{5}, 0.25, -0.5, {0.125, 0, -0.0625}}));
  EXPECT_EQ(write_document(*read), with_rows_of_forms_now(as_written_now(text, 3)))
      << "the fixture is written as this version writes";
}

TEST(Format, SolidsOfVersion3LoseWhatMeansNothingAnyMore) {
  const std::string text = file_text("tests/document/fixtures/v3_solids.hariko");
  const Result<Document> read = test::must(read_document(text));
  ASSERT_EQ(read->objects.size(), 2U);
  const auto settings = [&](std::size_t i) { return read->objects[i]->solids()->input->settings; };
  EXPECT_EQ(settings(0).method, EnvelopeMethod::network);
  EXPECT_EQ(settings(0).converted.lost, "tightness, waist, offsets");
  EXPECT_EQ(settings(0).clearance, 0.125);
  EXPECT_EQ(settings(1).method, EnvelopeMethod::ball);
  EXPECT_EQ(settings(1).converted.lost, "") << "they meant nothing to the ball";
  EXPECT_EQ(settings(1).ball_radius, 0.5);
  const std::string written = write_document(*read);
  for (const char* name :
       {"\"waist\"", "\"tightness\"", "\"offsets\"", "\"surface\": \"fair\"", "\"detail\""})
    EXPECT_EQ(written.find(name), std::string::npos) << name;
  const Result<Document> again = test::must(read_document(written));
  EXPECT_EQ(again->objects[0]->solids()->input->settings.converted.lost, "") << "said once";
}

TEST(Format, FixtureOfVersion4ReadsForEver) {
  std::string text = file_text("tests/document/fixtures/v4.hariko");
  const Result<Document> read = test::must(read_document(text));
  const PolyhedronSource& source = *read->objects[0]->polyhedron();
  EXPECT_EQ(source.mode, Mode::g2);
  EXPECT_EQ(source.frames, Frames::metric);
  const std::string round = "        \"round\": true,\n";
  text.erase(text.find(round), round.size());
  EXPECT_EQ(write_document(*read), with_rows_of_forms_now(as_written_now(text, 4)))
      << "round surfaces are a choice no more";
}

TEST(Format, FixtureOfVersion5ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v5.hariko");
  const Result<Document> read = test::must(read_document(text));
  const Shaping& shaping = *read->objects[0]->polyhedron()->shaping;
  EXPECT_EQ(shaping.kept_area.get_or(FaceId{0}, 1), 1.5);
  EXPECT_EQ(shaping.form.find({4})->edges[1], (KeptForm::Edge{{5}, 0.25, -0.5, {0.125, 0, -0.0625}}))
      << "forces are gone";
  EXPECT_EQ(write_document(*read), with_rows_of_forms_now(as_written_now(text, 5)));
}

TEST(Format, FixtureOfVersion6ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v6.hariko");
  const Result<Document> read = test::must(read_document(text));
  ASSERT_EQ(read->objects.size(), 3U);
  EXPECT_EQ(read->objects[0]->polyhedron()->shaping->form.find({4})->edges[0].lean, 0.03125);
  EXPECT_TRUE(read->objects[1]->solids()->input->settings.on_faces);
  EXPECT_EQ(read->objects[1]->solids()->input->solids[2].bridge, (Bridge{{0, 1}, 0.75}));
  EXPECT_EQ(read->objects[2]->picture()->look.layer, PictureLayer::behind);
  EXPECT_TRUE(read->dimensions->empty());
  EXPECT_EQ(write_document(*read), as_written_now(text, 6));
}

TEST(Format, FixtureOfVersion7ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v7.hariko");
  const Result<Document> read = test::must(read_document(text));
  const Dimensions& dimensions = *read->dimensions;
  ASSERT_EQ(dimensions.size(), 6U);
  EXPECT_EQ(dimensions[0].anchors[1], Anchor(VertexAnchor{ObjectId{1}, VertexId{5}}));
  EXPECT_EQ(dimensions[1].anchors[0], Anchor(EdgeAnchor{ObjectId{1}, EdgeId::of({4}, {5}), 0.25, false}));
  EXPECT_EQ(dimensions[1].anchors[1], Anchor(EdgeAnchor{ObjectId{1}, EdgeId::of({5}, {6}), 0.5, true}));
  EXPECT_EQ(dimensions[1].label, Vector3(0, -0.5, 1.25));
  EXPECT_EQ(dimensions[2].kind, DimensionKind::angle);
  EXPECT_EQ(dimensions[2].anchors[1], Anchor(ObjectAnchor{ObjectId{2}, Vector3(0.5, 0, 0), 0U}));
  EXPECT_EQ(dimensions[2].anchors[2], Anchor(SpaceAnchor{Vector3(1, 2, 3)}));
  EXPECT_EQ(dimensions[3].id, DimensionId{5});
  EXPECT_EQ(dimensions[3].anchors[0],
            Anchor(PatchAnchor{ObjectId{1}, element_of(FaceId{1}), 2, Vector2(0.25, 0.5)}));
  EXPECT_EQ(dimensions[4].anchors[0], Anchor(NearestAnchor{ObjectId{2}, Vector3(3, 0, 0.5)}));
  EXPECT_EQ(dimensions[5].anchors[0], Anchor(ObjectAnchor{ObjectId{3}, Vector3(-60, 0, 0), {}}));
  EXPECT_EQ(write_document(*read), as_written_now(text, 7));
}

TEST(Format, FixtureOfVersion8ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v8.hariko");
  const Result<Document> read = test::must(read_document(text));
  ASSERT_EQ(read->groups->size(), 2U);
  const Group& inner = (*read->groups)[1];
  EXPECT_EQ(inner.name, "Tools");
  EXPECT_EQ(inner.parent, GroupId{1});
  EXPECT_TRUE(!inner.visible && inner.locked && inner.colour);
  // The second object lies in the hidden group, and keeps its own switches.
  const Object& solids = *read->objects[1];
  EXPECT_EQ(solids.group, GroupId{2});
  EXPECT_TRUE(!solids.visible && solids.locked);
  EXPECT_TRUE(solids.visible_itself() && !solids.locked_itself());
  ASSERT_EQ(read->saved_views->size(), 1U);
  EXPECT_EQ((*read->saved_views)[0].name, "Three quarters");
  EXPECT_EQ(write_document(*read), as_written_now(text, 8));
}

TEST(Format, FixtureOfVersion9ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v9.hariko");
  const Result<Document> read = test::must(read_document(text));
  const LiveCopies& copies = *read->objects[0]->copies;
  ASSERT_EQ(copies.size(), 3U);
  EXPECT_EQ(copies[0], CopyArray(RowOfCopies{3, Vector3(4, 0, 0.5)}));
  EXPECT_EQ(copies[1], CopyArray(RingOfCopies{4, Vector3(0, 10, 0), Vector3(0, 0, 2), -180}));
  Similarity turned, moved;
  turned.rotation = Eigen::Quaterniond(0, 0, 0, 1);
  moved.translation = {0, 0, 5};
  EXPECT_EQ(copies[2], CopyArray(ListOfCopies{{turned, moved}}));
  EXPECT_EQ(place_count(*read->objects[0]), 36U);
  EXPECT_EQ(write_document(*read), as_written_now(text, 9));
}

TEST(Format, OutlinesOfVersion9InAModeThatIsGoneBecomeRound) {
  const std::string text = file_text("tests/document/fixtures/v9_outline.hariko");
  const Result<Document> read = test::must(read_document(text));
  const OutlineSettings& settings = read->objects[0]->outline()->settings;
  EXPECT_EQ(settings.mode, GaussMode::umbilic);
  EXPECT_TRUE(settings.mode_replaced);
  EXPECT_EQ(settings.radius, 0.75);
  std::string now = as_written_now(text, 9);
  now.replace(now.find("minkowski"), 9, "umbilic");
  EXPECT_EQ(write_document(*read), now);
  const Result<Document> again = test::must(read_document(now));
  EXPECT_EQ(again->objects[0]->outline()->settings.mode, GaussMode::umbilic);
  EXPECT_FALSE(again->objects[0]->outline()->settings.mode_replaced) << "said once";
  EXPECT_TRUE(*again == *read) << "saving compares the two";
  now.replace(now.find("umbilic"), 7, "convex");
  EXPECT_EQ(std::string(read_document(now).error().code.name), "E_SCHEMA");
}

TEST(Format, FixtureOfVersion10ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v10.hariko");
  const Result<Document> read = test::must(read_document(text));
  const LiveCopies& copies = *read->objects[0]->copies;
  ASSERT_EQ(copies.size(), 2U);
  EXPECT_EQ(copies[0], CopyArray(RowOfCopies{2, Vector3(4, 0, 0.5)}));
  EXPECT_EQ(copies[1], CopyArray(MirrorOfCopies{Vector3(0, 10, 0), Vector3(0, 2, 0)}));
  EXPECT_EQ(place_count(*read->objects[0]), 4U);
  EXPECT_EQ(write_document(*read), text);
}

TEST(Format, SolidsOfVersion5KeepTheirShape) {
  const std::string text = file_text("tests/document/fixtures/v5_solids.hariko");
  const Result<Document> read = test::must(read_document(text));
  const EnvelopeInput& input = *read->objects[0]->solids()->input;
  EXPECT_FALSE(input.settings.on_faces) << "the surface contains them";
  EXPECT_FALSE(input.settings.finer_patches);
  EXPECT_FALSE(input.settings.converted.method);
  for (const Solid& solid : input.solids) EXPECT_FALSE(solid.bridge.has_value());
  EXPECT_EQ(input.solids[0].roundness, 0.25);
  const std::string written = write_document(*read);
  for (const char* name : {"on_faces", "finer_patches", "bridge"})
    EXPECT_EQ(written.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace hariko::test
