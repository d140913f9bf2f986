// The file format: what is written comes back, and what is not known is kept.

#include "core/document/format/format.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/document/edits/edits.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(test::source_folder() + "/" + path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string message_of(const Result<Document>& result) {
  return result ? "fine" : to_string(result.error());
}

/// Equality of values takes -0 for 0; the file must not.
void expect_same_bits(const PolyhedronSource& a, const PolyhedronSource& b) {
  for (Index v = 0; v < a.polyhedron.vertex_count(); ++v)
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(std::signbit(a.polyhedron.position(v)[i]), std::signbit(b.polyhedron.position(v)[i]));
}

TEST(Format, RandomDocumentsComeBackEqual) {
  test::for_random(1, 200, [](std::mt19937_64& rng) {
    const Document document = test::any_document(rng);
    const std::string text = write_document(document);
    const Result<Document> again = read_document(text);
    ASSERT_TRUE(again) << message_of(again) << "\n" << text;
    ASSERT_TRUE(*again == document) << text;
    ASSERT_EQ(write_document(*again), text);
    for (std::size_t i = 0; i < document.objects.size(); ++i)
      if (const auto* source = document.objects[i]->polyhedron())
        expect_same_bits(*source, *again->objects[i]->polyhedron());
  });
}

TEST(Format, EqualityNoticesEveryField) {
  const Document document = test::cube_document();
  const auto changed = [&](auto&& change) {
    Object object = *document.objects[0];
    change(object);
    Document other = document;
    other.objects[0] = std::make_shared<const Object>(std::move(object));
    EXPECT_FALSE(other == document);
    const Result<Document> again = read_document(write_document(other));
    ASSERT_TRUE(again) << message_of(again);
    EXPECT_TRUE(*again == other);
  };
  const auto source_of = [](Object& object) -> PolyhedronSource& {
    return std::get<PolyhedronSource>(object.source);
  };
  const auto shape = [&](auto&& change) {
    changed([&](Object& object) {
      Shaping shaping;
      change(shaping);
      source_of(object).shaping = shaping;
    });
  };
  changed([](Object& o) { o.id.value = 0; });
  changed([](Object& o) { o.name = "Other"; });
  changed([](Object& o) { o.visible = false; });
  changed([](Object& o) { o.locked = true; });
  changed([](Object& o) { o.transform.scale = 2; });
  changed([](Object& o) { o.transform.translation.z() = 1; });
  changed([](Object& o) { o.transform.rotation = Eigen::Quaterniond(0, 1, 0, 0); });
  changed([](Object& o) { o.copies = LiveCopies{RowOfCopies{2, Vector3(1, 0, 0)}}; });
  changed([](Object& o) { o.copies = LiveCopies{RowOfCopies{3, Vector3(1, 0, 0)}}; });
  changed([](Object& o) { o.copies = LiveCopies{RingOfCopies{2, Vector3(1, 0, 0)}}; });
  changed([](Object& o) { o.copies = LiveCopies{RingOfCopies{2, Vector3(1, 0, 0), Vector3(0, 1, 0), 90}}; });
  changed([](Object& o) { o.copies = LiveCopies{ListOfCopies{{Similarity{}}}}; });
  changed([](Object& o) { o.display.surface = false; });
  changed([](Object& o) { o.display.polyhedron = false; });
  changed([](Object& o) { o.display.network = false; });
  changed([](Object& o) { o.display.map = SurfaceMap::zebra; });
  changed([](Object& o) { o.display.density = 9; });
  changed([](Object& o) { o.display.colour.blue = 1; });
  changed([](Object& o) { o.display.map = SurfaceMap::isophotes; });
  changed([](Object& o) { o.display.material = Material::plastic; });
  changed([](Object& o) { o.display.points = false; });
  changed([](Object& o) { o.display.wire = PatchWire::mesh; });
  changed([](Object& o) { o.display.tensions = true; });
  changed([](Object& o) { o.display.marks = true; });
  changed([](Object& o) { o.display.combs.shown = true; });
  changed([](Object& o) { o.display.combs.density = 17; });
  changed([](Object& o) { o.display.combs.scale = 0.1; });
  for (std::size_t i = 0; i < DisplaySettings{}.ranges.size(); ++i) {
    changed([i](Object& o) { o.display.ranges[i].mode = RangeMode::full; });
    changed([i](Object& o) { o.display.ranges[i].low = -0.125; });
    changed([i](Object& o) { o.display.ranges[i].high = 1e-3; });
  }
  changed([](Object& o) { o.kept = KeptMembers{{"x", "1"}}; });
  changed([&](Object& o) { source_of(o).mode = Mode::paper; });
  changed([&](Object& o) { source_of(o).frames = Frames::metric; });
  changed([&](Object& o) { source_of(o).origin.x() = 4; });
  changed([&](Object& o) { source_of(o).kept = KeptMembers{{"x", "1"}}; });
  shape([](Shaping& s) { s.alpha.set({3}, 2); });
  shape([](Shaping& s) { s.beta.set(EdgeId::of({0}, {1}), 2); });
  shape([](Shaping& s) { s.crease.set(EdgeId::of({0}, {1}), true); });
  shape([](Shaping& s) { s.tag.set({3}, VertexTag::smooth); });
  shape([](Shaping& s) { s.pin.set({3}, {Pin::Kind::normal, {{0, 0, 1}}}); });
  shape([](Shaping& s) { s.kept_area.set({3}, 2); });
  Document other = document;
  other.unit = Unit::inch;
  EXPECT_FALSE(other == document);
  other = document;
  other.next_object_id.value = 7;
  EXPECT_FALSE(other == document);
  other = document;
  other.kept = KeptMembers{{"x", "1"}};
  EXPECT_FALSE(other == document);
}

TEST(Format, EqualityNoticesEveryFieldOfADimension) {
  const Dimension plain{DimensionId{3},
                        DimensionKind::distance,
                        {VertexAnchor{test::cube_id, VertexId{0}}, SpaceAnchor{Vector3(1, 2, 3)}},
                        Vector3::Zero()};
  const auto with = [](const Dimension& dimension) {
    Document document = test::cube_document();
    document.dimensions = Dimensions{dimension};
    return document;
  };
  const Document document = with(plain);
  EXPECT_EQ(*read_document(write_document(document)), document);
  const auto changed = [&](auto&& change) {
    Dimension other = plain;
    change(other);
    EXPECT_FALSE(with(other) == document);
    const Result<Document> again = read_document(write_document(with(other)));
    ASSERT_TRUE(again) << message_of(again);
    EXPECT_TRUE(*again == with(other)) << write_document(*again);
  };
  changed([](Dimension& d) { d.id.value = 4; });
  changed([](Dimension& d) { d.label.y() = 0.5; });
  changed([](Dimension& d) {
    d.kind = DimensionKind::angle;
    d.anchors.push_back(SpaceAnchor{});
  });
  const std::vector<Anchor> others{
      SpaceAnchor{Vector3(1, 2, 4)},
      ObjectAnchor{test::cube_id, Vector3(1, 2, 3), {}},
      ObjectAnchor{test::cube_id, Vector3(1, 2, 3), 7U},
      VertexAnchor{test::cube_id, VertexId{1}},
      VertexAnchor{test::cube_id, VertexId{0}, true},
      VertexAnchor{ObjectId{9}, VertexId{0}},
      EdgeAnchor{test::cube_id, EdgeId::of({0}, {1}), 0.25, false},
      EdgeAnchor{test::cube_id, EdgeId::of({0}, {1}), 0.25, true},
      EdgeAnchor{test::cube_id, EdgeId::of({0}, {1}), 1, true},
      PatchAnchor{test::cube_id, element_of(FaceId{2}), 3, {0.25, 0.5}},
      PatchAnchor{test::cube_id, element_of(EdgeId::of({4}, {6})), 65537, {0, 1}},
      NearestAnchor{test::cube_id, Vector3(1, 2, 3)}};
  for (const Anchor& anchor : others) changed([&](Dimension& d) { d.anchors[1] = anchor; });
}

TEST(Format, DimensionsOutOfAllOrderAreRefused) {
  const std::string text = file_text("tests/document/fixtures/v7.hariko");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    changed.replace(changed.find(from), from.size(), to);
    return read_document(changed);
  };
  ASSERT_TRUE(with("\"share\": 0.25", "\"share\": 1"));
  const std::pair<const char*, const char*> faults[] = {
      {"{\"id\": 2,", "{\"id\": 1,"},
      {"\"kind\": \"angle\"", "\"kind\": \"distance\""},
      {"\"kind\": \"angle\"", "\"kind\": \"bend\""},
      {"\"share\": 0.25", "\"share\": 1.25"},
      {"\"edge\": [4, 5]", "\"edge\": [5, 4]"},
      {"\"at\": [0.25, 0.5]", "\"at\": [0.25, 1.5]"},
      {"\"patch\": [\"face\", 1]", "\"patch\": [\"edge\", 1]"},
      {"{\"object\": 2, \"nearest\": [3, 0, 0.5]}", "{\"object\": 1, \"vertex\": 4}"},
      {"{\"point\": [1, 2, 3]}", "{\"vertex\": 3}"},
      {"{\"point\": [1, 2, 3]}", "{}"},
      {"{\"point\": [1, 2, 3]}", "{\"point\": [1, 2, 3], \"object\": 1, \"vertex\": 3}"},
      {"{\"point\": [1, 2, 3]}", "{\"point\": [1, 2, 3], \"later\": 1}"},
      {"\"label\": [0, -0.5, 1.25]", "\"label\": [0, -0.5]"},
      {"\"label\": [0, -0.5, 1.25]", "\"colour\": 1"}};
  for (const auto& [from, to] : faults) {
    const Result<Document> read = with(from, to);
    ASSERT_FALSE(read) << to;
    EXPECT_EQ(read.error().code, e_schema) << to;
    EXPECT_NE(read.error().text.find("dimensions"), std::string::npos) << read.error().text;
  }
}

TEST(Format, FixtureOfVersion1ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v1.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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

/// Text that this version writes of a document of an older one that nothing else changes in.
std::string as_written_now(std::string text, int version) {
  const std::string of = "\"version\": ";
  text.replace(text.find(of + std::to_string(version)), of.size() + 1, of + std::to_string(format_version));
  return text;
}

/// Rows of kept forms ended in three numbers of a force before version 6, and end in a lean and a part of a
/// side since.
std::string with_rows_of_forms_now(std::string text) {
  const std::pair<const char*, const char*> rows[] = {
      {"[0, 0, 0, 0, 0, 0.0078125, 0, 0, 0]", "[0, 0, 0, 0, 0, 0.0078125, 0, 0]"},
      {"[5, 0.25, -0.5, 0.125, 0, -0.0625, 0, 0.5, 150]", "[5, 0.25, -0.5, 0.125, 0, -0.0625, 0, 0]"},
      {"[7, -0.25, 0.5, 0, 0, 0, 0, 0, 0]", "[7, -0.25, 0.5, 0, 0, 0, 0, 0]"}};
  for (const auto& [before, now] : rows) text.replace(text.find(before), std::string(before).size(), now);
  return text;
}

TEST(Format, SkinsOfVersion2ReadForEver) {
  const std::string text = file_text("tests/document/fixtures/v2_skin.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const auto found = read_document(text);
  ASSERT_TRUE(found) << message_of(found);
  text.replace(text.find("\"version\": 2"), 12, "\"version\": 1");
  const auto drawn = read_document(text);
  ASSERT_TRUE(drawn) << message_of(drawn);
  for (const int k : {0, 1}) {
    EXPECT_FALSE(found->objects[0]->skin()->skin->sections[std::size_t(k)].start_chosen);
    EXPECT_TRUE(drawn->objects[0]->skin()->skin->sections[std::size_t(k)].start_chosen);
  }
}

TEST(Format, FixtureOfVersion2ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v2.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  ASSERT_EQ(read->objects.size(), 2U);
  EXPECT_EQ(read->objects[0]->polyhedron()->frames, Frames::metric);
  EXPECT_TRUE(read->objects[0]->polyhedron()->preparation.split_concave);
  EXPECT_EQ(read->objects[1]->polyhedron()->frames, Frames::equal) << "nothing old changes by itself";
  EXPECT_EQ(write_document(*read), as_written_now(text, 2))
      << "the fixture is written as this version writes";
}

TEST(Format, SolidsOfVersion2GetTheBall) {
  const std::string text = file_text("tests/document/fixtures/v2_solids.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  ASSERT_EQ(read->objects.size(), 3U);
  const auto settings = [&](std::size_t i) { return read->objects[i]->solids()->input->settings; };
  EXPECT_EQ(settings(0).method, EnvelopeMethod::ball) << "auto, tight";
  EXPECT_TRUE(settings(0).from_before);
  EXPECT_NEAR(settings(0).rounding, 0.045 * 3, 1e-12);
  EXPECT_NEAR(*settings(0).ball_radius, 3 * 0.045 * 3, 1e-12) << "tightness 1";
  EXPECT_EQ(settings(1).method, EnvelopeMethod::network) << "auto at tightness 0";
  EXPECT_EQ(settings(2).method, EnvelopeMethod::ball) << "a field, at tightness 0 the hull";
  EXPECT_FALSE(settings(2).ball_radius.has_value());
  const Result<Document> again = read_document(write_document(*read));
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_FALSE(again->objects[0]->solids()->input->settings.from_before) << "saved by this version";
  EXPECT_EQ(again->objects[0]->solids()->input->settings.ball_radius, settings(0).ball_radius);
}

TEST(Format, FixtureOfVersion3ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v3.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  ASSERT_EQ(read->objects.size(), 2U);
  const auto settings = [&](std::size_t i) { return read->objects[i]->solids()->input->settings; };
  EXPECT_EQ(settings(0).method, EnvelopeMethod::network);
  EXPECT_EQ(settings(0).lost, "tightness, waist, offsets");
  EXPECT_EQ(settings(0).clearance, 0.125);
  EXPECT_EQ(settings(1).method, EnvelopeMethod::ball);
  EXPECT_EQ(settings(1).lost, "") << "they meant nothing to the ball";
  EXPECT_EQ(settings(1).ball_radius, 0.5);
  const std::string written = write_document(*read);
  for (const char* name :
       {"\"waist\"", "\"tightness\"", "\"offsets\"", "\"surface\": \"fair\"", "\"detail\""})
    EXPECT_EQ(written.find(name), std::string::npos) << name;
  const Result<Document> again = read_document(written);
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(again->objects[0]->solids()->input->settings.lost, "") << "said once";
}

TEST(Format, FixtureOfVersion4ReadsForEver) {
  std::string text = file_text("tests/document/fixtures/v4.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  const Shaping& shaping = *read->objects[0]->polyhedron()->shaping;
  EXPECT_EQ(shaping.kept_area.get_or(FaceId{0}, 1), 1.5);
  EXPECT_EQ(shaping.form.find({4})->edges[1], (KeptForm::Edge{{5}, 0.25, -0.5, {0.125, 0, -0.0625}}))
      << "forces are gone";
  EXPECT_EQ(write_document(*read), with_rows_of_forms_now(as_written_now(text, 5)));
}

TEST(Format, FixtureOfVersion6ReadsForEver) {
  const std::string text = file_text("tests/document/fixtures/v6.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
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
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  const LiveCopies& copies = *read->objects[0]->copies;
  ASSERT_EQ(copies.size(), 3U);
  EXPECT_EQ(copies[0], CopyArray(RowOfCopies{3, Vector3(4, 0, 0.5)}));
  EXPECT_EQ(copies[1], CopyArray(RingOfCopies{4, Vector3(0, 10, 0), Vector3(0, 0, 2), -180}));
  Similarity turned, moved;
  turned.rotation = Eigen::Quaterniond(0, 0, 0, 1);
  moved.translation = {0, 0, 5};
  EXPECT_EQ(copies[2], CopyArray(ListOfCopies{{turned, moved}}));
  EXPECT_EQ(place_count(*read->objects[0]), 36U);
  EXPECT_EQ(write_document(*read), text);
}

/// An origin goes into the place of its object, to which live copies are relative.
TEST(Format, LiveCopiesAreRelativeToAnOrigin) {
  std::string text = file_text("tests/document/fixtures/v8_origins.hariko");
  const std::size_t at = text.find("\"transform\"");
  ASSERT_NE(at, std::string::npos);
  text.insert(
      at,
      "\"copies\": [{\"kind\": \"ring\", \"count\": 2, \"point\": [3, 0, 0], \"direction\": [0, 0, 1], "
      "\"angle\": 180}],\n      ");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  const Object& object = *read->objects[0];
  EXPECT_EQ(std::get<RingOfCopies>((*object.copies)[0]).point, Vector3(3, 0, 0));
  EXPECT_EQ(places_of(object)[1].translation, object.transform.apply(Vector3(6, 0, 0)));
}

/// Kinds that the fixtures of versions have not, with every member unlike its default.
TEST(Format, EveryMemberOfTheOtherKindsHasItsPlaceInTheText) {
  const std::string text = file_text("tests/document/fixtures/v7_kinds.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  EXPECT_EQ(write_document(*read), as_written_now(text, 7));
  ASSERT_EQ(read->objects.size(), 4U);
  for (const auto& object : read->objects) EXPECT_EQ(*object->kept, (KeptMembers{{"note", "[ 1,2 ]"}}));
  EXPECT_EQ(*read->objects[0]->patches()->kept, (KeptMembers{{"later", "true"}}));
  EXPECT_TRUE(read->objects[1]->bezier()->kept->empty());
  EXPECT_TRUE(read->objects[2]->outline()->kept->empty());
  EXPECT_TRUE(read->objects[3]->skin()->kept->empty());
  EXPECT_EQ(read->paper->kept, (KeptMembers{{"later", "{\"x\":1}"}}));
  EXPECT_TRUE(read->kept->empty());
}

TEST(Format, OutlinesWithoutFramesHaveEqualOnes) {
  const Result<Document> read = read_document(file_text("tests/document/fixtures/v7_kinds.hariko"));
  ASSERT_TRUE(read) << message_of(read);
  const ObjectId id = read->objects[2]->id;
  ASSERT_TRUE(read->objects[2]->outline());
  EXPECT_EQ(read->objects[2]->outline()->settings.frames, Frames::equal) << "nothing old changes by itself";
  const std::string plain = write_document(*read);
  EXPECT_EQ(plain.find("\"frames\""), std::string::npos);
  const Result<Document> metric = set_frames(*read, id, Frames::metric);
  ASSERT_TRUE(metric) << message_of(metric);
  const std::string text = write_document(*metric);
  EXPECT_NE(text.find("\"mode\": \"g2\",\n        \"frames\": \"metric\"\n"), std::string::npos) << text;
  const Result<Document> again = read_document(text);
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(*again, *metric);
  EXPECT_EQ(write_document(set_frames(*again, id, Frames::equal).value()), plain);
  std::string wrong = text;
  wrong.replace(wrong.find("\"metric\""), 8, "\"golden\"");
  EXPECT_EQ(std::string(read_document(wrong).error().code.name), "E_SCHEMA");
}

TEST(Format, LeansAndSidesOfKeptFormsAreSaved) {
  std::string text =
      with_rows_of_forms_now(as_written_now(file_text("tests/document/fixtures/v5.hariko"), 5));
  const std::string plain = "-0.0625, 0, 0]", leaning = "-0.0625, 0.03125, 0.75]";
  text.replace(text.find(plain), plain.size(), leaning);
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  EXPECT_EQ(read->objects[0]->polyhedron()->shaping->form.find({4})->edges[1].lean, 0.03125);
  EXPECT_EQ(write_document(*read), text);
  text.replace(text.find(leaning), leaning.size(), "-0.0625, 101, 0]");
  EXPECT_EQ(std::string(read_document(text).error().code.name), "E_FORM_INVALID");
}

TEST(Format, SolidsOfVersion5KeepTheirShape) {
  const std::string text = file_text("tests/document/fixtures/v5_solids.hariko");
  const Result<Document> read = read_document(text);
  ASSERT_TRUE(read) << message_of(read);
  const EnvelopeInput& input = *read->objects[0]->solids()->input;
  EXPECT_FALSE(input.settings.on_faces) << "the surface contains them";
  EXPECT_FALSE(input.settings.finer_patches);
  EXPECT_FALSE(input.settings.from_before);
  for (const Solid& solid : input.solids) EXPECT_FALSE(solid.bridge.has_value());
  EXPECT_EQ(input.solids[0].roundness, 0.25);
  const std::string written = write_document(*read);
  for (const char* name : {"on_faces", "finer_patches", "bridge"})
    EXPECT_EQ(written.find(name), std::string::npos) << name;
}

TEST(Format, BridgesOfSolidsNameTwoSolids) {
  const std::string text = file_text("tests/document/fixtures/v5_solids.hariko");
  const auto with = [&](const std::string& bridge) {
    std::string changed = text;
    const std::string after = "\"length\": 1.5";
    return read_document(
        changed.replace(changed.find(after), after.size(), after + ", \"bridge\": " + bridge));
  };
  const auto read = with("{\"between\": [0, 1], \"ball_radius\": 0.75}");
  ASSERT_TRUE(read) << message_of(read);
  EXPECT_EQ(read->objects[0]->solids()->input->solids[2].bridge, (Bridge{{0, 1}, 0.75}));
  for (const char* bad : {"3", "{}", "{\"between\": [0]}", "{\"between\": [0, 1, 2]}",
                          "{\"between\": [0, -1]}", "{\"between\": [0, 1], \"ball_radius\": \"hull\"}"})
    EXPECT_EQ(with(bad).error().code, e_schema) << bad;
  EXPECT_FALSE(with("{\"between\": [0, 1], \"ball_radius\": -1}"));
}

TEST(Format, PullsOfSolidsComeBack) {
  const std::string text = file_text("tests/document/fixtures/v5_solids.hariko");
  const auto with = [&](const std::string& pulls) {
    std::string changed = text;
    const std::string after = "\"length\": 1.5";
    return read_document(changed.replace(changed.find(after), after.size(), after + ", \"pulls\": " + pulls));
  };
  const auto read = with("[{\"place\": [0.5, 0, 1.25], \"radius\": 0.75}]");
  ASSERT_TRUE(read) << message_of(read);
  const std::vector<Pull> pulls{{{0.5, 0, 1.25}, 0.75}};
  EXPECT_EQ(read->objects[0]->solids()->input->solids[2].pulls, pulls);
  const auto again = read_document(write_document(*read));
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(again->objects[0]->solids()->input->solids[2].pulls, pulls);
  for (const char* bad :
       {"3", "[3]", "[{}]", "[{\"place\": [0, 0], \"radius\": 1}]", "[{\"place\": [0, 0, 1]}]"})
    EXPECT_EQ(with(bad).error().code, e_schema) << bad;
  EXPECT_FALSE(with("[{\"place\": [0, 0, 1], \"radius\": -1}]"));
}

TEST(Format, KeptFormsOutOfAllProportionAreRefused) {
  const std::string text = file_text("tests/document/fixtures/v3.hariko");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return read_document(changed);
  };
  const auto code = [](const Result<Document>& read) {
    return read ? std::string() : std::string(read.error().code.name);
  };
  EXPECT_EQ(code(with("[5, 0.25, -0.5,", "[5, 101, -0.5,")), "E_FORM_INVALID");
  EXPECT_EQ(code(with("[5, 0.25, -0.5,", "[55, 0.25, -0.5,")), "E_SCHEMA") << "no such vertex";
  EXPECT_EQ(code(with("[5, 0.25, -0.5,", "[0, 0.25, -0.5,")), "E_SCHEMA") << "ids ascend";
  EXPECT_EQ(code(with("[5, 0.25, -0.5, 0.125, 0, -0.0625, 0, 0.5, 150]", "[5, 0.25]")), "E_SCHEMA");
}

TEST(Format, KeptAreasOutOfAllProportionAreRefused) {
  const std::string text = file_text("tests/document/fixtures/v3.hariko");
  const auto with = [&](const std::string& rows) {
    std::string changed = text;
    changed.insert(changed.find("\"form\""), "\"kept_area\": " + rows + ", ");
    const auto read = read_document(changed);
    return read ? std::string() : std::string(read.error().code.name);
  };
  EXPECT_EQ(with("[[0, 2.5]]"), "");
  EXPECT_EQ(with("[[0, 1e7]]"), "E_FORM_INVALID");
  EXPECT_EQ(with("[[0, 0]]"), "E_FORM_INVALID");
  EXPECT_EQ(with("[[0, -1]]"), "E_FORM_INVALID");
  EXPECT_EQ(with("[[999, 2]]"), "E_SCHEMA") << "no such face";
  EXPECT_EQ(with("[[1, 2], [0, 2]]"), "E_SCHEMA") << "ids ascend";
  EXPECT_EQ(with("[[0]]"), "E_SCHEMA");
}

TEST(Format, UnknownPartsStayByteForByte) {
  const std::string source =
      "{ \"kind\" : \"felt\",\n\"sections\":[ 1.0,1e2 , -0,\t\"\\u00e9\\/\" ] ,\"z\":{}}";
  const std::string text =
      R"({"future": [ 1 ,2], "format":"hariko","version":1,"objects":[{"id":3,"name":"Skin","source":)" +
      source + R"(,"last":12.50}]  ,"end":true})";
  const Document document = read_document(text).value();
  EXPECT_EQ(*std::get<UnknownSource>(document.objects[0]->source).json, source);
  EXPECT_EQ(*document.objects[0]->kept, (KeptMembers{{"last", "12.50"}}));
  EXPECT_EQ(*document.kept, (KeptMembers{{"future", "[ 1 ,2]"}, {"end", "true"}}));
  const std::string written = write_document(document);
  EXPECT_NE(written.find(source), std::string::npos);
  // Edits of something else leave them alone.
  const Document renamed = rename_object(document, {3}, "Other").value();
  EXPECT_EQ(std::get<UnknownSource>(renamed.objects[0]->source),
            std::get<UnknownSource>(document.objects[0]->source));
  EXPECT_EQ(renamed.objects[0]->kept, document.objects[0]->kept);
  EXPECT_EQ(renamed.kept, document.kept);
}

TEST(Format, OnlyEssentialsAreNeeded) {
  const Result<Document> read = read_document(
      "\xef\xbb\xbf{\"format\":\"hariko\",\"version\":1,\"objects\":[{\"id\":7,\"name\":\"T\",\"source\":{"
      "\"kind\":"
      "\"polyhedron\",\"vertices\":[[0,0,0,0],[1,1,0,0],[2,0,1,0]],\"faces\":[[0,0,1,2]]}}]}\r\n");
  ASSERT_TRUE(read) << message_of(read);
  Document expected;
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face({0, 1, 2});
  expected.next_object_id = {7};
  expected = add_object(expected, "T", PolyhedronSource::from_mesh(mesh).value()).value().document;
  EXPECT_TRUE(*read == expected);
}

TEST(Format, EmptyDocument) {
  EXPECT_EQ(
      write_document({}),
      "{\n  \"format\": \"hariko\",\n  \"version\": 9,\n  \"unit\": \"mm\",\n  \"next_object_id\": 1,\n  "
      "\"objects\": []\n}\n");
}

TEST(Format, NumbersDoNotDependOnTheLocale) {
  const Document document = test::cube_document();
  const Document moved = move_vertices(document, test::cube_id, std::vector<VertexId>{{0}},
                                       std::vector<Vector3>{{0.5, 1.25, 1e-7}})
                             .value();
  const std::string text = write_document(moved);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) {
    if (!std::setlocale(LC_ALL, name)) continue;  // whichever the machine has
    EXPECT_EQ(write_document(moved), text);
    EXPECT_TRUE(read_document(text).value() == moved);
  }
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_NE(text.find("[0, 0.5, 1.25, 1e-07]"), std::string::npos);
}

}  // namespace
}  // namespace hariko
