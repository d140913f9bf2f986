// `hariko run`: scripts as a user writes them.

#include <algorithm>
#include <cmath>
#include <set>

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/document/object_box.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "ui/editor/paper_edits.hpp"

namespace hariko::test {
namespace {

class Scripts : public ProgramTest {
 protected:
  /// A file with these steps.
  std::string script(const Json& steps) const {
    const Json all = {{"format", "hariko-script"}, {"version", 1}, {"steps", steps}};
    write_text(path("script.json"), all.dump());
    return path("script.json");
  }
  static Json step(const std::string& command, Json arguments = Json::object()) {
    return {{"command", command}, {"arguments", std::move(arguments)}};
  }
  /// A list: braces round a single value would be the value itself.
  template <class... Steps>
  static Json list(Steps... steps) {
    Json out = Json::array();
    (out.push_back(std::move(steps)), ...);
    return out;
  }
  Outcome run_steps(const Json& steps, const std::string& options = {}) const {
    return run("run " + script(steps) + " " + options);
  }
  Document saved(const std::string& name) const {
    auto document = load_document(path(name));
    EXPECT_TRUE(document.ok()) << name;
    return document.ok() ? *document : Document();
  }
  /// Expects a script not to run, to write nothing, and its error to have every sentence.
  void expect_refused(const Json& steps, const std::vector<std::string>& sentences) const {
    SCOPED_TRACE(steps.dump());
    const Outcome result = run_steps(steps, "--out " + path("refused.hariko"));
    EXPECT_EQ(result.exit_code, 1);
    for (const std::string& sentence : sentences)
      EXPECT_NE(result.error.find(sentence), std::string::npos) << sentence << "\n" << result.error;
    EXPECT_FALSE(std::filesystem::exists(path("refused.hariko")));
  }
};

TEST_F(Scripts, TwentyBoxesInARow) {
  Json steps = Json::array();
  for (int i = 0; i < 20; ++i)
    steps.push_back(
        step("add.box", {{"width", 10}, {"depth", "2 cm"}, {"height", 30}, {"at", {15 * i, 0, 0}}}));
  steps.push_back(step("file.save", {{"path", path("row.hariko")}}));
  const Outcome result = run_steps(steps);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(result.error.empty()) << result.error;
  const Document document = saved("row.hariko");
  ASSERT_EQ(document.objects.size(), 20U);
  std::set<std::string> names;
  for (std::size_t i = 0; i < 20; ++i) {
    const Object& box = *document.objects[i];
    names.insert(box.name);
    EXPECT_EQ(box.transform.translation, Vector3(15.0 * double(i), 0, 0));
    ASSERT_TRUE(box.polyhedron());
    EXPECT_LT((world_box(box).sizes() - Vector3(10, 20, 30)).norm(), 1e-9);
  }
  EXPECT_EQ(names.size(), 20U);
}

TEST_F(Scripts, ImportedDocumentsKeepTheirSizesAndMayHaveViewsAlone) {
  const Json first =
      list(step("file.new", {{"unit", "cm"}}), step("add.cube", {{"radius", 1}, {"name", "A"}}));
  ASSERT_EQ(run_steps(first, "--out " + path("a.hariko")).exit_code, 0);
  SavedView view;
  view.name = "Front";
  const auto looks = add_view(Document(), view);
  ASSERT_TRUE(looks.ok());
  ASSERT_TRUE(save_document(*looks, path("views.hariko")).ok());
  const Json second = list(step("file.new"), step("file.import", {{"path", path("views.hariko")}}),
                           step("file.import", {{"path", path("a.hariko")}}));
  const Outcome result = run_steps(second, "--out " + path("both.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document one = saved("a.hariko"), both = saved("both.hariko");
  ASSERT_EQ(one.objects.size(), 1U);
  ASSERT_EQ(both.objects.size(), 1U);
  EXPECT_EQ(both.saved_views->size(), 1U);
  EXPECT_EQ(one.unit, Unit::centimetre);
  EXPECT_EQ(both.unit, Unit::millimetre);
  EXPECT_LT((world_box(*both.objects[0]).sizes() - 10 * world_box(*one.objects[0]).sizes()).norm(), 1e-9);
}

TEST_F(Scripts, AnImportTellsOfThePaperModelThatStaysBehind) {
  const Document model = document_from_mesh(prism(5), "Prism").value();
  ASSERT_TRUE(save_document(set_paper(model, default_paper(model)), path("paper.hariko")).ok());
  const Outcome result =
      run_steps(list(step("file.new"), step("file.import", {{"path", path("paper.hariko")}})),
                "--out " + path("o.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.error.find("W_NOT_IMPORTED"), std::string::npos) << result.error;
  EXPECT_FALSE(saved("o.hariko").paper);
}

TEST_F(Scripts, DocumentsComeInAndGoOut) {
  const Json first = list(step("add.cube", {{"radius", 10}, {"name", "A"}}));
  ASSERT_EQ(run_steps(first, "--out " + path("a.hariko")).exit_code, 0);
  const Json second =
      list(step("select.objects", {{"names", {"A"}}}), step("object.duplicate"),
           step("transform.move", {{"by", {"1 in", 0, -5}}}), step("object.rename", {{"name", "B"}}));
  const Outcome result = run_steps(second, "--in " + path("a.hariko") + " --out " + path("b.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document document = saved("b.hariko");
  ASSERT_EQ(document.objects.size(), 2U);
  EXPECT_EQ(document.objects[0]->name, "A");
  EXPECT_EQ(document.objects[1]->name, "B");
  EXPECT_LT((document.objects[1]->transform.translation - Vector3(25.4, 0, -5)).norm(), 1e-12);
  EXPECT_EQ(saved("a.hariko").objects.size(), 1U) << "the input is not written";
}

TEST_F(Scripts, StandardStreamsAreFiles) {
  script(list(step("add.torus"), step("object.rename", {{"name", "Ring"}})));
  const Outcome piped = succeed("run - --out -", path("script.json"));
  write_text(path("ring.hariko"), piped.out);
  EXPECT_EQ(saved("ring.hariko").objects.at(0)->name, "Ring");
  const Outcome both = run("run - --in -", path("script.json"));
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.error.find("only one file can come from the standard input"), std::string::npos)
      << both.error;
}

TEST_F(Scripts, FacesAreExtrudedAndTensionsSet) {
  const Json steps =
      list(step("add.box", {{"width", 10}, {"depth", 10}, {"height", 10}, {"name", "Block"}}),
           step("select.faces", {{"object", "Block"}, {"from", {-6, -6, 4.9}}, {"to", {6, 6, 5.1}}}),
           step("mesh.extrude", {{"distance", 4}}), step("mesh.inset", {{"width", "1 mm"}}),
           step("select.edges", {{"from", {-6, -6, -6}}, {"to", {6, 6, -4}}}),
           step("shape.tension", {{"beta", 5}}), step("shape.crease", {{"on", true}}),
           step("select.vertices", {{"ids", {0}}}), step("shape.tension", {{"alpha", 2}}));
  const Outcome result = run_steps(steps, "--out " + path("block.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document document = saved("block.hariko");
  const PolyhedronSource& source = *document.objects.at(0)->polyhedron();
  EXPECT_EQ(source.polyhedron.vertex_count(), 16U);
  EXPECT_EQ(source.polyhedron.face_count(), 14U);
  EXPECT_LT(std::abs(world_box(*document.objects.at(0)).max().z() - 9), 1e-9);
  for (const EdgeId edge :
       {EdgeId::of({0}, {1}), EdgeId::of({1}, {2}), EdgeId::of({2}, {3}), EdgeId::of({0}, {3})})
    EXPECT_EQ(source.shaping->beta.get_or(edge, 1), 5);
  EXPECT_EQ(source.shaping->crease.size(), 4U);
  EXPECT_EQ(source.shaping->alpha.get_or(VertexId{0}, 0), 2);
}

TEST_F(Scripts, LoopsAreCutAndFacesSubdivided) {
  const Json steps =
      list(step("add.box", {{"name", "Block"}}),
           step("select.edges", {{"object", "Block"}, {"from", {-60, -60, -60}}, {"to", {60, -40, -40}}}),
           step("mesh.loop_cut", {{"cuts", 3}}));
  ASSERT_EQ(run_steps(steps, "--out " + path("cut.hariko")).exit_code, 0);
  EXPECT_EQ(saved("cut.hariko").objects.at(0)->polyhedron()->polyhedron.face_count(), 6U + 4U * 3U);
  const Json more = list(step("select.faces"), step("select.all"), step("mesh.subdivide"));
  ASSERT_EQ(run_steps(more, "--in " + path("cut.hariko") + " --out " + path("fine.hariko")).exit_code, 0);
  EXPECT_EQ(saved("fine.hariko").objects.at(0)->polyhedron()->polyhedron.face_count(), 4U * 18U);
}

TEST_F(Scripts, CagesAreBroughtToScans) {
  // A cube from -1 to 1, and a flat scan above it.
  Document document = document_from_mesh(cube(), "Cage").value();
  PolygonMesh sheet;
  const double top = 1.25;
  sheet.positions = {{-9, -9, top}, {9, -9, top}, {0, 9, top}};
  sheet.add_face({0, 1, 2});
  document = add_object(document, "Scan", MeshSource::from_mesh(sheet).value())->document;
  ASSERT_TRUE(save_document(document, path("scan.hariko")).ok());
  const Json projected = list(step("select.objects", {{"names", {"Cage"}}}), step("select.vertices"),
                              step("select.all"), step("mesh.project_reference"));
  const Outcome first = run_steps(projected, "--in " + path("scan.hariko") + " --out " + path("flat.hariko"));
  ASSERT_EQ(first.exit_code, 0) << first.error;
  const Document brought = saved("flat.hariko");
  const PolyhedronSource& flat = *brought.objects.at(0)->polyhedron();
  for (const Vector3& p : flat.polyhedron.positions()) EXPECT_NEAR(flat.origin.z() + p.z(), top, 1e-12);
  const Json fitted =
      list(step("select.objects", {{"names", {"Cage"}}}), step("mesh.fit_reference", {{"steps", 2}}));
  const Outcome second = run_steps(fitted, "--in " + path("scan.hariko") + " --out " + path("fitted.hariko"));
  ASSERT_EQ(second.exit_code, 0) << second.error;
  EXPECT_FALSE(saved("fitted.hariko") == document);
  expect_refused(list(step("add.box"), step("mesh.fit_reference")), {"No reference facets are shown"});
  const Json reduced =
      list(step("select.objects", {{"names", {"Scan"}}}), step("mesh.reduce_reference", {{"distance", 0.1}}));
  const Outcome third = run_steps(reduced, "--in " + path("scan.hariko") + " --out " + path("light.hariko"));
  EXPECT_EQ(third.exit_code, 0) << third.error;
  EXPECT_EQ(saved("light.hariko").objects.at(1)->mesh()->mesh->face_count(), 1U);
}

TEST_F(Scripts, TurnsAndScalesGoAboutAPoint) {
  const Json steps = list(step("add.cube", {{"at", {10, 0, 0}}, {"name", "A"}}),
                          step("transform.rotate", {{"angle", 90}, {"about", {0, 0, 0}}}),
                          step("transform.scale", {{"factor", 3}, {"about", {0, 4, 0}}}));
  const Outcome result = run_steps(steps, "--out " + path("turned.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document document = saved("turned.hariko");
  const Similarity& placed = document.objects.at(0)->transform;
  EXPECT_LT((placed.translation - Vector3(0, 22, 0)).norm(), 1e-9) << placed.translation.transpose();
  EXPECT_NEAR(placed.scale, 3, 1e-12);
}

TEST_F(Scripts, CopiesStandAlongSelectedEdges) {
  const auto along = [&](const Json& arguments) {
    return list(
        step("add.box", {{"width", 40}, {"depth", 40}, {"height", 40}, {"at", {0, 0, 0}}, {"name", "Rail"}}),
        step("add.box", {{"width", 2}, {"depth", 2}, {"height", 6}, {"at", {100, 0, 0}}, {"name", "Post"}}),
        step("select.edges", {{"object", "Rail"}, {"from", {-21, -21, -21}}, {"to", {21, -19, -19}}}),
        step("select.objects", {{"names", "Post"}}), step("object.array_curve", arguments));
  };
  const Outcome result = run_steps(along({{"count", 5}, {"turning", "none"}, {"on_curve", true}}),
                                   "--out " + path("rail.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document document = saved("rail.hariko");
  ASSERT_EQ(document.objects.size(), 6U);
  const auto place = [&](std::size_t post) { return document.objects[1 + post]->transform.translation; };
  EXPECT_LT((place(0) + place(4) - Vector3(0, -40, -40)).norm(), 1e-6) << "one stands at either end";
  EXPECT_NEAR(std::abs(place(0).x()), 20, 1e-6);
  EXPECT_NEAR(place(1).x() + place(3).x(), 0, 1e-3);
  EXPECT_LT(place(2).y(), -21) << "on the curve of the surface, which bulges out";
  expect_refused(along({{"count", 5}, {"spacing", 3}}), {"E_SCRIPT_STEP", "by \"count\" or by \"spacing\""});
  expect_refused(along({{"spacing", "1 m"}}), {"E_SCRIPT_STEP", "The curve is shorter than the spacing"});
  expect_refused(list(step("add.box"), step("object.array_curve", {{"count", 3}})),
                 {"E_SCRIPT_STEP", "No curve is selected"});
}

TEST_F(Scripts, PropertiesAreSetAndObjectsHidden) {
  const Json steps = list(step("add.box", {{"name", "A"}}), step("property.location.x", {{"z", 7}}),
                          step("property.rotation.x", {{"y", 30}}), step("property.mode", {{"value", "g2"}}),
                          step("property.material", {{"value", "metal"}}),
                          step("property.size.x", {{"axis", "y"}, {"value", 50}}),
                          step("solid.sphere", {{"radius", 10}, {"new_object", true}}),
                          step("property.clearance", {{"value", 1.5}}),
                          step("select.objects", {{"names", "A"}}), step("object.hide"));
  const Outcome result = run_steps(steps, "--out " + path("set.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Document document = saved("set.hariko");
  ASSERT_EQ(document.objects.size(), 2U);
  const Object& box = *document.objects[0];
  EXPECT_FALSE(box.visible);
  EXPECT_NEAR(box.transform.translation.z(), 7, 1e-6);
  EXPECT_EQ(box.polyhedron()->mode, Mode::g2);
  EXPECT_EQ(box.display.material, Material::metal);
  EXPECT_TRUE(document.objects[1]->visible);
  EXPECT_EQ(document.objects[1]->solids()->input->settings.clearance, 1.5);
}

TEST_F(Scripts, SurfacesAreExportedAndConverted) {
  const Json steps =
      list(step("solid.box", {{"width", 10}, {"depth", 10}, {"height", 10}}),
           step("file.export", {{"path", path("solid.obj")}, {"density", 2}}), step("solid.to_polyhedron"));
  const Outcome result = run_steps(steps, "--out " + path("made.hariko"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("Exported solid.obj"), std::string::npos) << result.out;
  EXPECT_TRUE(read_text(path("solid.obj")).find("\nf ") != std::string::npos);
  const Document document = saved("made.hariko");
  ASSERT_EQ(document.objects.size(), 2U);
  EXPECT_TRUE(document.objects[1]->polyhedron());
}

TEST_F(Scripts, WallsAreExported) {
  const Json steps =
      list(step("add.box", {{"width", 10}, {"depth", 10}, {"height", 10}}),
           step("file.export", {{"path", path("bare.obj")}, {"density", 2}}),
           step("file.export",
                {{"path", path("wall.obj")}, {"density", 2}, {"thickness", "1 mm"}, {"side", "outside"}}));
  const Outcome result = run_steps(steps);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto faces_in = [&](const char* name) {
    const std::string text = read_text(path(name));
    std::size_t count = 0;
    for (std::size_t at = text.find("\nf "); at != std::string::npos; at = text.find("\nf ", at + 1)) ++count;
    return count;
  };
  EXPECT_GT(faces_in("bare.obj"), 0U);
  EXPECT_EQ(faces_in("wall.obj"), 2 * faces_in("bare.obj"));
}

TEST_F(Scripts, AWrongCommandIsToldWithTheNearest) {
  expect_refused(list(step("add.box"), step("add.boks")),
                 {"step 2 \"add.boks\"", "Did you mean \"add.box\"?"});
  expect_refused(list(step("mesh.knife")), {"step 1 \"mesh.knife\"", "needs the window"});
}

TEST_F(Scripts, WrongArgumentsAreToldByStepAndName) {
  expect_refused(list(step("add.box"), step("add.box", {{"width", true}})),
                 {"step 2 \"add.box\"", "\"width\" must be a length"});
  expect_refused(list(step("add.box", {{"width", "3 apples"}})), {"step 1", "\"width\" is no number"});
  expect_refused(list(step("add.box", {{"width", 0}})), {"step 1", "\"width\" is 0, but must be"});
  expect_refused(list(step("add.prism", {{"sides", 2}})), {"\"sides\" is 2, but must be 3 to"});
  expect_refused(list(step("add.prism", {{"sides", 100000}})), {"\"sides\" is 100000, but must be 3 to"});
  expect_refused(list(step("add.prism", {{"sides", 5.5}})), {"\"sides\" must be a whole number"});
  expect_refused(list(step("add.box", {{"widht", 3}})), {"no argument \"widht\"", "Did you mean \"width\"?"});
  expect_refused(list(step("add.box", {{"at", {1, 2}}})), {"\"at\" must be a list of three numbers"});
  expect_refused(list(step("add.box"), step("property.mode", {{"value", "fairest"}})),
                 {"step 2", "\"value\" is \"fairest\", but must be one of"});
  expect_refused(list(step("add.box"), step("transform.move")), {"step 2", "\"by\" is missing"});
  expect_refused(list(step("edit.undo", {{"steps", 3}})), {"takes no arguments"});
}

TEST_F(Scripts, WhatACommandRefusesStopsTheScript) {
  expect_refused(list(step("edit.undo")), {"step 1 \"edit.undo\"", "There is nothing to undo."});
  expect_refused(list(step("add.box"), step("select.faces", {{"ids", {99}}})),
                 {"step 2", "has no face \"99\""});
  expect_refused(list(step("add.box", {{"name", "Box"}}), step("select.objects", {{"names", "Bux"}})),
                 {"no object called \"Bux\"", "Did you mean \"Box\"?"});
  expect_refused(
      list(step("add.box"), step("select.faces"), step("select.all"), step("mesh.inset", {{"width", 1000}})),
      {"step 4 \"mesh.inset\"", "E_"});
}

TEST_F(Scripts, FilesOfEarlierStepsStayAndAreNamed) {
  const Json steps =
      list(step("add.box"), step("file.save_copy", {{"path", path("copy.hariko")}}), step("edit.redo"));
  const Outcome result = run_steps(steps);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("W_SCRIPT_WRITTEN"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("copy.hariko"), std::string::npos) << result.error;
  EXPECT_EQ(saved("copy.hariko").objects.size(), 1U);
}

TEST_F(Scripts, UnsavedChangesAreTold) {
  const Outcome result = run_steps(list(step("add.box")));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.error.find("W_SCRIPT_UNSAVED"), std::string::npos) << result.error;
}

TEST_F(Scripts, EditsThatARecordedScriptLacksAreTold) {
  const auto run_with = [&](int left_out) {
    const Json all = {{"format", "hariko-script"},
                      {"version", 1},
                      {"left_out", left_out},
                      {"notes", list("At the beginning an edit is missing: Knife")},
                      {"steps", list(step("add.box"))}};
    write_text(path("recorded.json"), all.dump());
    return run("run " + path("recorded.json") + " --out " + path("out.hariko"));
  };
  const Outcome missing = run_with(2);
  EXPECT_EQ(missing.exit_code, 0) << missing.error;
  EXPECT_NE(missing.error.find("W_SCRIPT_LEFT_OUT"), std::string::npos) << missing.error;
  EXPECT_NE(missing.error.find("2 edits"), std::string::npos) << missing.error;
  EXPECT_EQ(saved("out.hariko").objects.size(), 1U);
  const Outcome whole = run_with(0);
  EXPECT_EQ(whole.exit_code, 0) << whole.error;
  EXPECT_TRUE(whole.error.empty()) << whole.error;
}

TEST_F(Scripts, WhatIsNoScriptIsTold) {
  const auto refused = [&](const std::string& text, const std::string& sentence) {
    write_text(path("bad.json"), text);
    const Outcome result = run("run " + path("bad.json"));
    EXPECT_EQ(result.exit_code, 1) << text;
    EXPECT_NE(result.error.find(sentence), std::string::npos) << text << "\n" << result.error;
  };
  refused("not JSON", "E_PARSE");
  refused("[]", "no JSON object");
  refused("{}", "\"format\" is not \"hariko-script\"");
  refused(R"({"format": "hariko-script", "version": 2, "steps": []})", "Version 2 of scripts is unknown");
  refused(R"({"format": "hariko-script", "version": 1})", "no list \"steps\"");
  refused(R"({"format": "hariko-script", "version": 1, "steps": [], "stps": []})", "unknown member \"stps\"");
  refused(R"({"format": "hariko-script", "version": 1, "steps": [{"comand": "add.box"}]})",
          "Step 1 has the unknown member \"comand\". Did you mean \"command\"?");
  refused(R"({"format": "hariko-script", "version": 1, "steps": [{"command": "add.box", "arguments": 3}]})",
          "The arguments of step 1 \"add.box\" are no object");
  refused(
      R"({"format": "hariko-script", "version": 1, "steps": [{"command": "add.box", "arguments": {"at": {}}}]})",
      "The argument \"at\" of step 1");
  EXPECT_EQ(run("run " + path("missing.json")).exit_code, 1);
}

TEST_F(Scripts, WrongUsageGivesTwo) {
  const std::string file = script(Json::array());
  for (const std::string& arguments :
       {std::string("run"), "run --list " + file, "run --json " + file, "run " + file + " --out a.obj",
        "run " + file + " " + file, "run " + file + " --density 3"}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments << "\n" << result.error;
  }
}

TEST_F(Scripts, TheListHasEveryCommandWithItsArguments) {
  const Outcome text = succeed("run --list");
  const Outcome result = succeed("run --list --json");
  const Json list = result.json();
  ASSERT_TRUE(list.is_object() && list["commands"].is_array());
  std::set<std::string> ids;
  for (const Json& command : list["commands"]) {
    const std::string id = command["id"];
    EXPECT_TRUE(ids.insert(id).second) << id;
    EXPECT_NE(text.out.find(id), std::string::npos) << id;
    std::set<std::string> names;
    for (const Json& argument : command["arguments"])
      EXPECT_TRUE(names.insert(argument["name"]).second) << id << " " << argument["name"];
  }
  for (const char* id : {"add.box", "select.objects", "transform.move", "mesh.loop_cut", "file.export",
                         "property.scale", "help.about"})
    EXPECT_TRUE(ids.contains(id)) << id;
}

}  // namespace
}  // namespace hariko::test
