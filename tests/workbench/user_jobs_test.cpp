// Whole jobs of a new user done by hand, with a count of what the hands do: the guided first model, a body of
// solids, a paper model, imports, and a day's small things.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "core/document/angles.hpp"
#include "core/document/file.hpp"
#include "core/document/object_box.hpp"
#include "core/envelope/envelope.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "tests/workbench/paper_rig.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class FromTheStartPage : public ::testing::Test, protected ProgramHands {
 protected:
  FromTheStartPage() : ProgramHands(Begin::start_page) {}

  /// The middle of the curve that is nearest to the eye.
  Vector2 nearest_curve() {
    const SceneObject& object = bench().workbench().viewport().scene().scene().objects[0];
    Vector3 best;
    double least = 1e300;
    for (Index e = 0; e < object.polyhedron->edges.size(); ++e) {
      const std::vector<Vector3> curve = shown_curve(object, e);
      const Vector3 middle = curve[curve.size() / 2];
      if (depth(middle) < least) least = depth(middle), best = middle;
    }
    return pixel(best);
  }
};

/// The guide ticks off each step as it is done.
TEST_F(FromTheStartPage, TheFirstModelTakesAtMostFourteenActions) {
  click("start.guide");
  click("guide.box");
  wait();
  EXPECT_EQ(editor().guide.step(), GuideStep::pull);
  press({"1"});
  const Vector2 corner = nearest_corner();
  drag(corner, corner + Vector2(40, 60));
  wait();
  EXPECT_EQ(editor().guide.step(), GuideStep::tension);
  ASSERT_TRUE(marks().contains("slider.alpha"));
  const Marks::Rect slider = marks().at("slider.alpha");
  const double middle = slider.y + slider.height / 2.0;
  drag({slider.x + 8.0, middle}, {slider.x + 0.6 * slider.width, middle});
  wait();
  EXPECT_EQ(editor().guide.step(), GuideStep::crease);
  press({"2"});
  click(nearest_curve());
  EXPECT_EQ(editor().selection.of_active().edges.size(), 1U);
  press({"C"});
  wait();
  EXPECT_EQ(editor().guide.step(), GuideStep::zebra);
  press({"Alt+Z"});
  EXPECT_EQ(editor().guide.step(), GuideStep::export_file);
  press({"Ctrl+E"});
  name_file("first.obj");
  wait();
  EXPECT_EQ(editor().guide.step(), GuideStep::done) << notice();
  click("guide.leave");
  EXPECT_FALSE(editor().guide.shown());
  EXPECT_GT(test::slurp(folder() / "first.obj").size(), 1000U);
  expect_at_most(14, "first model");
}

class OfSolids : public FromTheStartPage {
 protected:
  const Solid& last() { return editor().active_object()->solids()->input->solids.back(); }
  void add(const char* solid) {
    click("menu.Solids");
    click(std::string("command.solid.") + solid);
    frames(4);
    ASSERT_TRUE(marks().contains("field.solid.x")) << "its numbers are not there";
  }
  /// Into a field and, by Tab, into those below it.
  void numbers(const std::string& field, std::initializer_list<const char*> values) {
    click("field." + field);
    bool first = true;
    for (const char* value : values) {
      if (!first) press({"Tab"});
      first = false;
      type(value);
    }
  }
  /// Upright things are laid down to the right: a quarter of a turn by the arc of the y axis.
  void lay_down() {
    ASSERT_TRUE(marks().contains("gizmo.rotate.y"));
    const Vector2 pivot = pixel(last().position), grip = middle_of("gizmo.rotate.y") - pivot;
    const Vector2 below(-grip.y(), grip.x());
    drag_in_steps(pivot + grip, pivot + below);
    frames(4);
    const Vector3 up = rotation_of(last().rotation) * Vector3::UnitZ();
    EXPECT_LT((up - Vector3::UnitX()).norm(), 1e-9) << up.transpose() << "  " << hint();
  }
  /// By a place of the solid that is beside all handles.
  void bring(const Vector3& to, const Vector3& held) {
    const std::size_t steps = editor().history.position();
    const Vector3 before = last().position;
    drag(pixel(before + held), pixel(to + held));
    frames(4);
    // The text typed last is a step of its own.
    EXPECT_GE(editor().history.position(), steps + 1) << editor().history.undo_label();
    EXPECT_LT((last().position - to).norm(), 1) << "it is at " << last().position.transpose();
  }
};

/// A foot, a grip, a body and a chuck, with the sizes of a hand drill.
TEST_F(OfSolids, AHandDrillOfFourSolidsTakesAtMostThirtyFiveActions) {
  click("start.solids");
  frames(8);
  ASSERT_TRUE(marks().contains("field.solid.width"));
  numbers("solid.width", {"70", "60", "30"});
  add("capsule");
  EXPECT_EQ(editor().active_object()->solids()->input->solids[0].size, Vector3(70, 60, 30))
      << "a click beside the field lost the number";
  numbers("solid.radius", {"18", "90"});
  press({"Enter", "Num 1"});
  frames(20);
  bench().move(600, 500);
  wheel(-4);
  frames(20);
  bring({-5, 0, 60}, {0, 0, -50});
  add("cylinder");
  lay_down();
  numbers("solid.radius", {"26", "120"});
  bring({10, 0, 125}, {-40, 0, -8});
  add("cone");
  lay_down();
  numbers("solid.radius", {"20", "40"});
  bring({85, 0, 125}, {-8, 0, -6});
  wait();

  const Object& drill = *editor().active_object();
  EXPECT_EQ(editor().document().objects.size(), 1U);
  EXPECT_EQ(drill.solids()->input->solids.size(), 4U);
  const SurfaceView* view = editor().view_of(drill.id);
  ASSERT_TRUE(view && view->mesh);
  EXPECT_FALSE(view->error) << view->error->text;
  for (const Message& message : view->warnings) EXPECT_NE(message.code, w_not_enclosed) << message.text;
  expect_at_most(35, "hand drill");
}

TEST_F(OnPaper, APaperMouseTakesAtMostFourteenActions) {
  const PolygonMesh body = make_primitive(BoxShape{{62, 110, 36}, {1, 1, 1}, {}}).value();
  ASSERT_TRUE(save_document(document_from_mesh(body, "Mouse").value(), folder() / "mouse.hariko").ok());
  press({"Ctrl+O"});
  name_file("mouse.hariko");
  wait();
  press({"Ctrl+P"});
  wait();
  press({"Ctrl+Shift+U"});
  wait();
  ASSERT_TRUE(editor().paper.layout) << notice();
  EXPECT_EQ(pages().overlaps, 0U);
  EXPECT_TRUE(pages().off_page.empty());
  const std::size_t faces = pages().unfolding.graph->face_count();
  EXPECT_GE(faces, 50U);
  EXPECT_LE(faces, 200U) << "nobody cuts that out";

  const Marks::Rect slider = marks().at("paper.fold");
  const double height = slider.y + slider.height / 2.0;
  drag({slider.x + slider.width - 8.0, height}, {slider.x + slider.width / 2.0, height});
  EXPECT_NEAR(editor().paper.folded, 0.5, 0.1);

  const std::size_t before = pieces();
  click("paper.folded." + std::to_string(lonely_fold()));
  wait();
  EXPECT_EQ(pieces(), before + 1) << editor().history.undo_label();
  EXPECT_EQ(pages().overlaps, 0U) << "the halves lie on each other";
  EXPECT_TRUE(pages().off_page.empty());
  const Vector2 piece = middle_of("paper.piece.0");
  drag(piece, piece + Vector2(12, 6));
  wait();
  EXPECT_EQ(editor().history.undo_label(), "Move a piece");
  press({"Ctrl+Z"});
  wait();
  EXPECT_EQ(pages().overlaps, 0U);

  click("menu.Paper");
  click("command.paper.export");
  ASSERT_EQ(bench().workbench().question(), nullptr) << bench().workbench().question()->text;
  name_file("mouse.pdf");
  wait();
  EXPECT_GT(test::slurp(folder() / "mouse.pdf").size(), 2000U) << notice();
  expect_at_most(14, "paper mouse");
}

/// A housing of twelve sides with flat lids and a knob on it, as two objects.
std::string housing_and_knob() {
  std::ostringstream out;
  int corners = 0;
  const auto prism = [&](const char* name, int sides, double radius, double low, double high) {
    out << "o " << name << '\n';
    for (const double z : {low, high})
      for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979 * i / sides;
        out << "v " << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << ' ' << z << '\n';
      }
    std::ostringstream bottom, top;
    for (int i = 0; i < sides; ++i) {
      const int next = (i + 1) % sides;
      bottom << ' ' << corners + sides - i;
      top << ' ' << corners + sides + i + 1;
      out << "f " << corners + i + 1 << ' ' << corners + next + 1 << ' ' << corners + sides + next + 1 << ' '
          << corners + sides + i + 1 << '\n';
    }
    out << 'f' << bottom.str() << "\nf" << top.str() << '\n';
    corners += 2 * sides;
  };
  prism("housing", 12, 40, 0, 60);
  prism("knob", 4, 10, 70, 85);
  return out.str();
}

class Importing : public ::testing::Test, protected ProgramHands {};

/// A housing with sharp rims, a scan of 12,000 triangles, and a cube whose faces look both ways.
TEST_F(Importing, ThreeMeshesComeInWithAtMostTwelveActions) {
  test::spill(folder() / "housing.obj", housing_and_knob());
  const PolygonMesh torus = make_primitive(TorusShape{60, 15, 100, 60, {}}).value();
  ASSERT_TRUE(write_mesh_file(folder() / "scan.stl", std::array{NamedPolygons{"scan", &torus}}).ok());
  test::spill(folder() / "turned.obj",
              "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
              "f 1 4 3 2\nf 5 8 7 6\nf 1 2 6 5\nf 7 3 2 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const auto& objects = [this]() -> const auto& {
    return editor().document().objects;
  };

  press({"Ctrl+I"});
  frames(4);
  type((folder() / "housing.obj").string());
  click("import.creases");
  click("dialog.accept");
  wait();
  ASSERT_EQ(objects().size(), 2U) << notice();
  EXPECT_EQ(objects()[0]->name, "housing");
  EXPECT_EQ(objects()[1]->name, "knob");
  EXPECT_EQ(objects()[0]->polyhedron()->shaping->crease.size(), 24U) << "the rims, and not the sides";

  press({"Ctrl+I"});
  name_file("scan.stl");
  wait();
  ASSERT_NE(bench().workbench().question(), nullptr) << "a scan becomes a cage without a question";
  press({"Enter"});
  wait();
  ASSERT_EQ(objects().size(), 3U);
  EXPECT_TRUE(objects()[2]->mesh());
  EXPECT_FALSE(objects()[2]->display.points);

  press({"Ctrl+I"});
  name_file("turned.obj");
  wait();
  ASSERT_NE(bench().workbench().question(), nullptr) << notice();
  press({"Enter"});
  wait();
  ASSERT_EQ(objects().size(), 4U);
  ASSERT_TRUE(objects()[3]->polyhedron());
  EXPECT_EQ(objects()[3]->polyhedron()->polyhedron.face_count(), 6U);
  EXPECT_EQ(editor().history.position(), 3U) << "one step each";
  expect_at_most(12, "imports");
}

/// A row of eight boxes, a name, views, undo, saving, a file for others, a crash, and all of it back.
TEST(ADay, TakesAtMostFiftyActions) {
  const ProgramHands::Folder user = std::make_shared<test::TemporaryFolder>();
  auto hands = std::make_unique<ProgramHands>(ProgramHands::Begin::start_page, user);
  const auto& objects = [&]() -> const auto& {
    return hands->editor().document().objects;
  };
  hands->click("start.polyhedron");
  hands->wait();
  hands->press({"4"});
  for (const char* way : {"120", "240", "480"}) {
    hands->press({"Ctrl+A", "Ctrl+D", "G", "X"});
    hands->type(way);
    hands->press({"Enter"});
  }
  ASSERT_EQ(objects().size(), 8U);
  std::vector<double> places;
  for (const auto& object : objects()) places.push_back(object->transform.translation.x());
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(places[i], 120.0 * double(i), 1e-9);
  hands->press({"Home"});
  hands->wait();

  // Taken back, made again, and a drag that is given up.
  const Document row = hands->editor().document();
  hands->press({"Ctrl+Z", "Ctrl+Shift+Z"});
  EXPECT_EQ(hands->editor().document(), row);
  const Vector2 grip = hands->pixel(world_box(*objects().back()).center());
  hands->begin_drag(grip, grip + Vector2(90, -40));
  EXPECT_FALSE(hands->editor().document() == row) << "the drag took nothing";
  hands->press({"Esc"});
  hands->bench().release();
  hands->frames(2);
  EXPECT_EQ(hands->editor().document(), row);

  const ObjectId named = hands->editor().selection.active;
  hands->press({"F2"});
  hands->frames(4);
  hands->type("Shelf");
  hands->press({"Enter"});
  EXPECT_EQ(hands->editor().document().find(named)->name, "Shelf");
  hands->press({"H", "Alt+H", "Ctrl+Alt+Q", "Ctrl+Alt+Q", "F3"});
  hands->frames(2);
  hands->type("zebra");
  hands->press({"Enter", "Alt+Z"});
  EXPECT_EQ(hands->bench().workbench().command_log().last.first, "analyse.zebra");

  hands->press({"Ctrl+S"});
  hands->name_file("shelf.hariko");
  hands->wait();
  EXPECT_FALSE(hands->editor().history.dirty()) << hands->notice();
  hands->press({"Ctrl+E"});
  hands->name_file("shelf.obj");
  hands->wait();
  EXPECT_GT(test::slurp(hands->folder() / "shelf.obj").size(), 1000U) << hands->notice();

  // Killed with work that is not saved.
  hands->press({"Ctrl+A", "G", "Z"});
  hands->type("7");
  hands->press({"Enter"});
  hands->frames(1);
  const Document last = hands->editor().document();
  hands->session().write_autosave();
  const int actions = hands->actions();
  hands.reset();
  hands = std::make_unique<ProgramHands>(ProgramHands::Begin::start_page, user);
  hands->count_from(actions);
  hands->find_offers();
  hands->click("recovery.recover");
  hands->wait();
  EXPECT_EQ(hands->editor().document(), last);
  hands->press({"Ctrl+S"});
  hands->wait();
  EXPECT_FALSE(hands->editor().history.dirty()) << hands->notice();
  const auto saved = load_document(hands->folder() / "shelf.hariko");
  ASSERT_TRUE(saved.ok());
  EXPECT_EQ(*saved, last);
  hands->expect_at_most(50, "a day");
}

}  // namespace
}  // namespace hariko::test
