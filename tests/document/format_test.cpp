// The file format: what is written comes back, and what is not known is kept.

#include "core/document/format/format.hpp"

#include <clocale>
#include <cmath>

#include "core/document/edits/edits.hpp"
#include "tests/document/file_texts.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko::test {
namespace {

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
    const Result<Document> again = test::must(read_document(write_document(other)));
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
  changed([](Object& o) { o.copies = LiveCopies{MirrorOfCopies{Vector3(1, 0, 0)}}; });
  changed([](Object& o) { o.copies = LiveCopies{MirrorOfCopies{Vector3(1, 0, 0), Vector3(0, 1, 0)}}; });
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
    const Result<Document> again = test::must(read_document(write_document(with(other))));
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

/// An origin goes into the place of its object, to which live copies are relative.
TEST(Format, LiveCopiesAreRelativeToAnOrigin) {
  std::string text = file_text("tests/document/fixtures/v8_origins.hariko");
  const std::size_t at = text.find("\"transform\"");
  ASSERT_NE(at, std::string::npos);
  text.insert(
      at,
      "\"copies\": [{\"kind\": \"ring\", \"count\": 2, \"point\": [3, 0, 0], \"direction\": [0, 0, 1], "
      "\"angle\": 180}],\n      ");
  const Result<Document> read = test::must(read_document(text));
  const Object& object = *read->objects[0];
  EXPECT_EQ(std::get<RingOfCopies>((*object.copies)[0]).point, Vector3(3, 0, 0));
  EXPECT_EQ(places_of(object)[1].translation, object.transform.apply(Vector3(6, 0, 0)));
}

/// Kinds that the fixtures of versions have not, with every member unlike its default.
TEST(Format, EveryMemberOfTheOtherKindsHasItsPlaceInTheText) {
  const std::string text = file_text("tests/document/fixtures/v7_kinds.hariko");
  const Result<Document> read = test::must(read_document(text));
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
  const Result<Document> metric = test::must(set_frames(*read, id, Frames::metric));
  const std::string text = write_document(*metric);
  EXPECT_NE(text.find("\"mode\": \"g2\",\n        \"frames\": \"metric\"\n"), std::string::npos) << text;
  const Result<Document> again = test::must(read_document(text));
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
  const Result<Document> read = test::must(read_document(text));
  EXPECT_EQ(read->objects[0]->polyhedron()->shaping->form.find({4})->edges[1].lean, 0.03125);
  EXPECT_EQ(write_document(*read), text);
  text.replace(text.find(leaning), leaning.size(), "-0.0625, 101, 0]");
  EXPECT_EQ(std::string(read_document(text).error().code.name), "E_FORM_INVALID");
}

TEST(Format, BridgesOfSolidsNameTwoSolids) {
  const std::string text = file_text("tests/document/fixtures/v5_solids.hariko");
  const auto with = [&](const std::string& bridge) {
    std::string changed = text;
    const std::string after = "\"length\": 1.5";
    return read_document(
        changed.replace(changed.find(after), after.size(), after + ", \"bridge\": " + bridge));
  };
  const auto read = test::must(with("{\"between\": [0, 1], \"ball_radius\": 0.75}"));
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
  const auto read = test::must(with("[{\"place\": [0.5, 0, 1.25], \"radius\": 0.75}]"));
  const std::vector<Pull> pulls{{{0.5, 0, 1.25}, 0.75}};
  EXPECT_EQ(read->objects[0]->solids()->input->solids[2].pulls, pulls);
  const auto again = test::must(read_document(write_document(*read)));
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
      "{\n  \"format\": \"hariko\",\n  \"version\": 10,\n  \"unit\": \"mm\",\n  \"next_object_id\": 1,\n  "
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
}  // namespace hariko::test
