// Meshes that are opened: broken ones, open ones, dense ones, and what the dialog says of them.

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "core/exchange/mesh_file.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/workbench/program_hands.hpp"
#include "tests/workbench/session_rig.hpp"

namespace hariko {
namespace {

using test::OpenFile;

/// A cube of which two faces are turned and one edge has a third face.
std::string broken_obj() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 2 0 2\nv 2 1 2\n"
         "f 1 4 3 2\nf 5 8 7 6\nf 1 2 6 5\nf 7 3 2 6\nf 3 4 8 7\nf 4 1 5 8\nf 6 7 10 9\n";
}

TEST_F(OpenFile, ABrokenMeshIsRepairedKeptAsFacetsOrLeft) {
  const auto mesh = folder_.path() / "broken.obj";
  test::spill(mesh, broken_obj());
  (*session_)->open(mesh);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.repair"));
  const std::string text = session_->bench().workbench().question()->text;
  EXPECT_NE(text.find("broken.obj"), std::string::npos) << text;
  EXPECT_NE(text.find("edge "), std::string::npos) << "no element is named: " << text;
  session_->click("prompt.cancel");
  EXPECT_EQ(session_->editor().path, file_) << "Cancel opened something";

  (*session_)->open(mesh);
  session_->settle();
  session_->click("prompt.reference");
  ASSERT_TRUE(session_->editor().document().objects[0]->mesh());
  EXPECT_EQ(session_->editor().document().objects[0]->mesh()->mesh->face_count(), 7U);

  (*session_)->open(mesh);
  session_->settle();
  session_->click("prompt.repair");
  const PolyhedronSource* source = session_->editor().document().objects[0]->polyhedron();
  ASSERT_NE(source, nullptr);
  EXPECT_EQ(source->polyhedron.face_count(), 7);
  EXPECT_FALSE(session_->editor().path.has_value());
  EXPECT_NE(last_notice().find("turned"), std::string::npos) << last_notice();
}

TEST_F(OpenFile, AMeshOfWhichNothingIsLeftSaysSo) {
  const auto mesh = folder_.path() / "empty.obj";
  test::spill(mesh, "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\nf 1 1 2\n");
  (*session_)->open(mesh);
  session_->settle();
  EXPECT_FALSE(session_->shows("prompt.repair"));
}

/// A unit cube of six loose squares. The corners of the last lie `near` beside those of the others, and two
/// of them `far`.
std::string loose_cube(double near, double far) {
  std::ostringstream text;
  const int squares[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                             {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}};
  const int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int square = 0; square < 6; ++square)
    for (int corner = 0; corner < 4; ++corner) {
      const int* at = corners[squares[square][corner]];
      const double aside = square < 5 ? 0 : corner < 2 ? near : far;
      text << "v " << at[0] << ' ' << at[1] << ' ' << std::setprecision(10) << at[2] + aside << '\n';
    }
  for (int first = 1; first < 24; first += 4)
    text << "f " << first << ' ' << first + 1 << ' ' << first + 2 << ' ' << first + 3 << '\n';
  return text.str();
}

TEST_F(OpenFile, CornersThatAreNearlyTheSameAreJoinedAsFarAsIsTyped) {
  const auto mesh = folder_.path() / "loose.obj";
  test::spill(mesh, loose_cube(2e-7, 0.004));
  const auto vertices = [this] {
    const PolyhedronSource* source = session_->editor().document().objects[0]->polyhedron();
    return source ? source->polyhedron.vertex_count() : 0;
  };
  (*session_)->open(mesh);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.join"));
  EXPECT_NE(session_->bench().workbench().question()->text.find("loose.obj"), std::string::npos);
  session_->click("prompt.join");
  EXPECT_EQ(vertices(), 10) << "two corners are further off than the tolerance";

  (*session_)->open(mesh);
  session_->settle();
  session_->click("prompt.keep");
  EXPECT_EQ(vertices(), 12) << "corners at one place are joined, others are not";

  (*session_)->open(mesh);
  session_->settle();
  session_->bench().click("export.join_tolerance");
  session_->bench().type("0.01");
  session_->click("prompt.join");
  EXPECT_EQ(vertices(), 8);
  EXPECT_EQ(session_->editor().document().objects[0]->polyhedron()->polyhedron.edge_count(), 12);
}

TEST_F(OpenFile, TheToleranceOfALargeMeshRuinsNoSmallOneBesideIt) {
  // A millionth of the plate, of which one face lies a little higher, is longer than the whole sheet.
  const auto mesh = folder_.path() / "sizes.obj";
  test::spill(mesh,
              "o plate\nv 0 0 0\nv 10000 0 0\nv 10000 10000 0\nv 0 10000 0\nv 20000 0 0\nv 20000 10000 0\n"
              "v 0 0 0.004\nv 0 10000 0.004\nv -10000 5000 0\nf 1 2 3 4\nf 2 5 6 3\nf 7 8 9\n"
              "o sheet\nv 0 0 50\nv 0.01 0 50\nv 0.01 0.01 50\nv 0 0.01 50\nv 0.02 0 50\nv 0.02 0.01 50\n"
              "f 10 11 12 13\nf 11 14 15 12\n");
  (*session_)->open(mesh);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.join"));
  session_->click("prompt.join");
  const auto& objects = session_->editor().document().objects;
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0]->polyhedron()->polyhedron.vertex_count(), 7U);
  EXPECT_EQ(objects[1]->polyhedron()->polyhedron.vertex_count(), 6U);
  EXPECT_EQ(objects[1]->polyhedron()->polyhedron.face_count(), 2U);
}

/// A tetrahedron of which one face is two triangles that divide an edge, and another one that is inside out.
const char* joint_and_turned() {
  return "o joint\nv 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nv 1 0 0\n"
         "f 1 3 2\nf 1 4 3\nf 2 3 4\nf 1 5 4\nf 5 2 4\n"
         "o turned\nv 9 0 0\nv 12 0 0\nv 9 3 0\nv 9 0 3\nf 6 7 8\nf 6 8 9\nf 7 9 8\nf 6 9 7\n";
}

/// State of these two in a document: borders of the first one, and whether the second one looks outwards.
struct JointAndTurned {
  std::size_t border_loops = 0;
  bool outwards = false;
  friend bool operator==(const JointAndTurned&, const JointAndTurned&) = default;
};

JointAndTurned state_of(const std::vector<std::shared_ptr<const Object>>& objects) {
  const PolyhedronSource &joint = *objects.at(objects.size() - 2)->polyhedron(),
                         &turned = *objects.back()->polyhedron();
  const std::vector<Vector3> points = turned.polyhedron.positions();
  return {joint.polyhedron.topology().border_loop_count(),
          closed_component_volumes(turned.polyhedron.topology(), points).at(0) > 0};
}

TEST_F(OpenFile, CornersOnEdgesAndPartsInsideOutAreRepairedAsChosen) {
  const auto mesh = folder_.path() / "faults.obj";
  test::spill(mesh, joint_and_turned());
  const auto state = [this] { return state_of(session_->editor().document().objects); };
  const auto begin = [&] {
    (*session_)->open(mesh);
    session_->settle();
    ASSERT_TRUE(session_->shows("prompt.repair"));
    ASSERT_TRUE(session_->shows("prompt.keep"));
  };
  begin();
  const std::string text = session_->bench().workbench().question()->text;
  EXPECT_NE(text.find("faults.obj"), std::string::npos) << text;
  EXPECT_NE(text.find("edges of other faces: 1."), std::string::npos) << text;
  EXPECT_NE(text.find("inside out: 1."), std::string::npos) << text;
  EXPECT_TRUE(session_->happened("repairable"));
  session_->click("prompt.cancel");
  EXPECT_EQ(session_->editor().path, file_) << "Cancel opened something";

  begin();
  session_->click("prompt.keep");
  EXPECT_EQ(state(), (JointAndTurned{1, false})) << "nothing is changed that nobody wants";

  begin();
  session_->click("prompt.repair");
  EXPECT_EQ(state(), (JointAndTurned{0, true}));
  EXPECT_NE(last_notice().find("4 faces"), std::string::npos) << last_notice();

  begin();
  session_->click("import.split_edges");
  session_->click("prompt.repair");
  EXPECT_EQ(state(), (JointAndTurned{1, true}));

  begin();
  session_->click("import.turn_parts");
  session_->click("prompt.repair");
  EXPECT_EQ(state(), (JointAndTurned{0, false}));
}

class ImportOfFaults : public ::testing::Test, protected test::ProgramHands {};

TEST_F(ImportOfFaults, AsksTheSame) {
  test::spill(folder() / "faults.obj", joint_and_turned());
  for (const bool repaired : {false, true}) {
    press({"Ctrl+I"});
    name_file("faults.obj");
    wait();
    ASSERT_NE(bench().workbench().question(), nullptr) << notice();
    if (repaired)
      press({"Enter"});
    else
      click("prompt.keep");
    wait();
    ASSERT_EQ(editor().document().objects.size(), repaired ? 4U : 2U);
    EXPECT_EQ(state_of(editor().document().objects),
              (JointAndTurned{repaired ? std::size_t{0} : std::size_t{1}, repaired}));
  }
}

/// Objects chosen before would be deleted and moved with it.
TEST_F(ImportOfFaults, WhatIsImportedIsChosenAlone) {
  test::spill(folder() / "tent.obj",
              "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  exchange().import_file(folder() / "tent.obj");
  wait();
  ASSERT_EQ(editor().document().objects.size(), 1U);
  const ObjectId first = editor().selection.active;
  editor().mode = ElementMode::object;
  editor().selection.select({first, element_of(first)}, Selection::How::add);
  exchange().import_file(folder() / "tent.obj");
  wait();
  ASSERT_EQ(editor().document().objects.size(), 2U);
  EXPECT_EQ(chosen_ids(editor()), std::vector{editor().document().objects.back()->id});
}

TEST_F(ImportOfFaults, AFileForADocumentThatIsGoneIsNotPutIntoTheNextOne) {
  test::spill(folder() / "tent.obj",
              "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  exchange().import_file(folder() / "tent.obj");
  editor().open(test::box("Other"), {});
  wait();
  ASSERT_EQ(editor().document().objects.size(), 1U);
  EXPECT_EQ(editor().document().objects[0]->name, "Other");
  EXPECT_NE(notice().find("was not imported"), std::string::npos) << notice();
}

TEST_F(OpenFile, TheRepairOfABrokenFileSplitsEdgesToo) {
  const auto mesh = folder_.path() / "faults.obj";
  test::spill(mesh, std::string(joint_and_turned()) + "f 6 7 8\n");  // three faces at each of its edges
  (*session_)->open(mesh);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.reference")) << "it is not broken";
  const std::string text = session_->bench().workbench().question()->text;
  EXPECT_NE(text.find("edges split: 1"), std::string::npos) << text;
  session_->settle();  // a question with many lines takes its place over several frames
  session_->click("prompt.repair");
  EXPECT_FALSE(session_->shows("prompt.repair")) << "it asks again";
  EXPECT_EQ(state_of(session_->editor().document().objects), (JointAndTurned{0, true}));
  EXPECT_NE(last_notice().find("faces dropped: 1"), std::string::npos) << last_notice();
}

TEST_F(OpenFile, WhatABrokenFileLeavesOutIsToldAfterItsRepair) {
  const auto mesh = folder_.path() / "broken.obj";
  test::spill(mesh, broken_obj() + "l 1 7\nl 2 8\n");
  for (const char* answer : {"prompt.repair", "prompt.reference"}) {
    (*session_)->open(mesh);
    session_->settle();
    session_->click(answer);
    const auto& notices = session_->editor().notices();
    EXPECT_TRUE(std::any_of(notices.begin(), notices.end(), [](const Notice& notice) {
      return notice.text.find("2 sets of points or lines were left out") != std::string::npos;
    })) << answer;
  }
}

TEST_F(OpenFile, ADenseMeshIsAskedAboutAndBecomesWhatIsChosen) {
  const auto mesh = folder_.path() / "dense.obj";
  const PolygonMesh torus = make_primitive(TorusShape{2, 0.5, 100, 60, {}}).value();
  ASSERT_TRUE(write_mesh_file(mesh, std::array{NamedPolygons{"torus", &torus}}).ok());
  (*session_)->open(mesh);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.reference"));
  EXPECT_NE(session_->bench().workbench().question()->text.find("6000"), std::string::npos);
  session_->click("prompt.cancel");
  EXPECT_EQ(session_->editor().path, file_) << "Cancel opened something";
  (*session_)->open(mesh);
  session_->settle();
  session_->click("prompt.reference");
  EXPECT_TRUE(session_->editor().document().objects[0]->mesh());
  (*session_)->open(mesh);
  session_->settle();
  session_->click("prompt.cage");
  EXPECT_TRUE(session_->editor().document().objects[0]->polyhedron());
}

TEST_F(OpenFile, TheDialogSaysWhatMeshesBecome) {
  const PolygonMesh prism = make_primitive(PrismShape{16, 1, 2, {}}).value();
  ASSERT_TRUE(
      write_mesh_file(folder_.path() / "housing.obj", std::array{NamedPolygons{"housing", &prism}}).ok());
  const auto open_by_dialog = [this](const std::vector<std::string>& clicks) {
    session_->bench().workbench().commands().run("file.open");
    for (int i = 0; i < 3; ++i) session_->bench().frame();
    session_->bench().click("entry.housing.obj");
    for (const std::string& mark : clicks) {
      for (int i = 0; i < 3; ++i) session_->bench().frame();
      session_->bench().click(mark);
    }
    for (int i = 0; i < 3; ++i) session_->bench().frame();
    session_->click("dialog.accept");
    EXPECT_FALSE(session_->shows("dialog.accept")) << "the file that was clicked was not opened";
  };
  open_by_dialog({"import.creases"});  // above 30 degrees
  const PolyhedronSource* cage = session_->editor().document().objects[0]->polyhedron();
  ASSERT_NE(cage, nullptr);
  EXPECT_EQ(cage->shaping->crease.size(), 32U) << "the rims of the lids, sharper than 30 degrees";
  // The dialog begins in the folder of the file before.
  open_by_dialog({"import.use", "import.use.2"});
  EXPECT_TRUE(session_->editor().document().objects[0]->mesh());
}

TEST_F(OpenFile, EachObjectOfAnObjFileStaysOneOfItsOwn) {
  const auto mesh = folder_.path() / "two.obj";
  const PolygonMesh housing = make_primitive(PrismShape{12, 1, 2, {}}).value();
  const PolygonMesh knob = make_primitive(BoxShape{{1, 1, 1}, {1, 1, 1}, {}}).value();
  ASSERT_TRUE(
      write_mesh_file(mesh, std::array{NamedPolygons{"Housing", &housing}, NamedPolygons{"Knob", &knob}})
          .ok());
  (*session_)->open(mesh);
  session_->settle();
  const auto& objects = session_->editor().document().objects;
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0]->name, "Housing");
  EXPECT_EQ(objects[1]->name, "Knob");
  EXPECT_EQ(objects[0]->polyhedron()->polyhedron.face_count(), 14U);
  EXPECT_EQ(objects[1]->polyhedron()->polyhedron.face_count(), 6U);
}

}  // namespace
}  // namespace hariko
