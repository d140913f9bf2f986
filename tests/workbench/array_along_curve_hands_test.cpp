// Copies along curves by hand: along selected edges, straight or over a surface, and along the path of a
// skin.

#include <string>
#include <utility>
#include <vector>

#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

/// A box of 2, and a rail: a box of 20 whose edges are the curves.
Document post_and_rail(bool surface) {
  Document document = document_from_mesh(test::cube(), "Post").value();
  const auto rail =
      add_object(document, "Rail", PolyhedronSource::from_mesh(test::cube()).value(), {}).value();
  Similarity place{.scale = 10};
  document = set_transform(rail.document, rail.id, place).value();
  DisplaySettings display = document.find(rail.id)->display;
  display.surface = surface;
  return set_display(document, rail.id, display).value();
}

class AlongACurve : public BenchHands {
 protected:
  explicit AlongACurve(Document document = post_and_rail(false)) : BenchHands(std::move(document)) {}

  const Similarity& placed(std::size_t object) { return objects()[object]->transform; }
  Vector3 place(std::size_t object) { return placed(object).translation; }
  const Object& named(const std::string& name) {
    for (const auto& object : objects())
      if (object->name == name) return *object;
    ADD_FAILURE() << name;
    return *objects().front();
  }
  CommandTable::Outcome run(std::string_view id) {
    const auto outcome = bench_.workbench().commands().run(id);
    frames(4);
    return outcome;
  }
  /// Edges of the rail, then the post, as key 2, clicks, key 4 and a click choose them.
  void select(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
    bench_.key("2");
    editor().selection.clear_elements();
    const ObjectId rail = named("Rail").id;
    for (const auto& [a, b] : edges)
      editor().selection.select({rail, element_of(EdgeId::of({a}, {b}))}, Selection::How::add);
    bench_.key("4");
    choose_object("Post", Selection::How::replace);
  }
  void choose_object(const std::string& name, Selection::How how) {
    const ObjectId id = named(name).id;
    editor().selection.select({id, element_of(id)}, how);
    frames(2);
  }
};

TEST_F(AlongACurve, CopiesStandFromEndToEndOfTheSelectedEdges) {
  const Document before = editor().document();
  select({{0, 1}, {1, 2}});
  const auto outcome = run("object.array_curve");
  ASSERT_TRUE(outcome.ran) << outcome.reason;
  ASSERT_EQ(objects().size(), 7U);
  EXPECT_EQ(place(0), Vector3(0, 0, 0)) << "the original stays where it is";
  EXPECT_EQ(editor().selection.objects().size(), 6U) << "what is arranged is chosen, without the rail";
  EXPECT_EQ(editor().history.undo_label(), "Array along a curve");
  choose("array_turning", 2);
  EXPECT_LT((place(1) - Vector3(8, 0, 0)).norm(), 1e-9);
  EXPECT_LT((place(3) - Vector3(20, 4, 0)).norm(), 1e-9) << "round the corner";
  EXPECT_LT((place(5) - Vector3(20, 20, 0)).norm(), 1e-9);
  choose("array_begin", 1);
  EXPECT_LT((place(0) - Vector3(-10, -10, -10)).norm(), 1e-9) << "the original, too, stands on the curve";
  EXPECT_LT((place(5) - Vector3(10, 10, -10)).norm(), 1e-9);
  choose("array_turning", 0);
  EXPECT_LT((placed(5).rotation * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-9) << "turned with it";
  EXPECT_LT((placed(1).rotation * Vector3::UnitX() - Vector3::UnitX()).norm(), 1e-9);
  choose("array_direction", 1);
  EXPECT_LT((place(0) - Vector3(10, 10, -10)).norm(), 1e-9);
  choose("array_direction", 0);
  choose("array_places", 1);
  enter("array_spacing", "12");
  EXPECT_EQ(objects().size(), 5U) << "as many as there is room for: at 0, 12, 24 and 36";
  enter("array_offset", "10");
  EXPECT_EQ(objects().size(), 4U);
  EXPECT_LT((place(0) - Vector3(0, -10, -10)).norm(), 1e-9);
  EXPECT_EQ(editor().history.position(), 1U) << "one step, whatever was adjusted";
  editor().undo();
  EXPECT_EQ(editor().document(), before);
}

TEST_F(AlongACurve, NumbersForWhichTheCurveIsTooShortChangeNothing) {
  select({{0, 1}});
  ASSERT_TRUE(run("object.array_curve").ran);
  const Document before = editor().document();
  enter("array_offset", "30");
  EXPECT_EQ(editor().document(), before);
  ASSERT_FALSE(editor().notices().empty());
  EXPECT_EQ(editor().notices().back().kind, Notice::Kind::error);
  EXPECT_NE(editor().notices().back().text.find("shorter"), std::string::npos);
}

TEST_F(AlongACurve, ItSaysWhatIsMissing) {
  bench_.key("4");
  choose_object("Post", Selection::How::replace);
  EXPECT_NE(run("object.array_curve").reason.find("No curve"), std::string::npos);
  select({{0, 1}});
  choose_object("Rail", Selection::How::replace);
  EXPECT_NE(run("object.array_curve").reason.find("copied"), std::string::npos);
  select({{0, 1}, {2, 3}});
  const Document before = editor().document();
  run("object.array_curve");
  EXPECT_EQ(editor().document(), before);
  ASSERT_FALSE(editor().notices().empty());
  EXPECT_NE(editor().notices().back().text.find("one chain"), std::string::npos);
}

TEST_F(AlongACurve, ItIsRepeatedOnTheSameCurveForAnotherObject) {
  select({{0, 1}});
  ASSERT_TRUE(run("object.array_curve").ran);
  enter("array_count", "3");
  ASSERT_EQ(objects().size(), 4U);
  const ObjectId last = objects()[2]->id;
  editor().selection.clear_objects();
  editor().selection.select({last, element_of(last)}, Selection::How::replace);
  bench_.key("Shift+R");
  ASSERT_EQ(objects().size(), 6U);
  EXPECT_EQ(editor().history.position(), 2U);
}

class AlongACurveOfASurface : public AlongACurve {
 protected:
  AlongACurveOfASurface() : AlongACurve(post_and_rail(true)) {}
};

TEST_F(AlongACurveOfASurface, ALoopOfItsEdgesHasNoDoubledEnd) {
  bench_.wait_for_surfaces();
  select({{0, 1}, {1, 2}, {2, 3}, {0, 3}});
  const auto outcome = run("object.array_curve");
  ASSERT_TRUE(outcome.ran) << outcome.reason;
  enter("array_count", "8");
  choose("array_begin", 1);
  ASSERT_EQ(objects().size(), 9U);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((place(i) - place(j)).norm(), 5) << i << ", " << j;
  EXPECT_LT((place(0) - Vector3(-10, -10, -10)).norm(), 1e-6);
  EXPECT_LT((place(2) - Vector3(10, -10, -10)).norm(), 1e-3) << "four equal curves";
  EXPECT_LT(place(1).y(), -10.5) << "on the surface's curve, which bulges out";
}

/// A post, and a tube of two square sections along a straight path.
Document post_and_path() {
  Document document = document_from_mesh(test::cube(), "Post").value();
  Skin skin;
  skin.path = {{{0, 0, 0}, {30, 0, 0}, {60, 0, 0}}, false, {}};
  std::uint32_t id = 1;
  for (const double x : {0.0, 60.0}) {
    SkinSection section;
    section.id = x > 0 ? 2 : 1;
    section.v = x / 60;
    section.closed = true;
    for (const auto& [y, z] : {std::pair{-3, -3}, {3, -3}, {3, 3}, {-3, 3}})
      section.points.push_back({id++, {x, double(y), double(z)}, false});
    skin.sections.push_back(section);
  }
  return add_object(document, "Path", SkinSource{skin, {}}, {}).value().document;
}

class AlongAPath : public AlongACurve {
 protected:
  AlongAPath() : AlongACurve(post_and_path()) {}
};

TEST_F(AlongAPath, TheSkinThatIsChosenLastGivesThePath) {
  bench_.key("4");
  choose_object("Post", Selection::How::replace);
  choose_object("Path", Selection::How::add);
  const auto outcome = run("object.array_curve");
  ASSERT_TRUE(outcome.ran) << outcome.reason;
  ASSERT_EQ(objects().size(), 7U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LT((place(i) - Vector3(12 * double(i), 0, 0)).norm(), 1e-9) << "a straight path makes a row";
}

}  // namespace
}  // namespace hariko::test
