// Contents of STEP and IGES files beside exact bodies: placements that scale or mirror, hidden shapes,
// curves, tessellated bodies, names of usages, lengths without a unit.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>
#endif

namespace hariko::test {
namespace {

#ifdef HARIKO_OPENCASCADE

namespace fs = std::filesystem;

fs::path fixture(const char* name) {
  return fs::path(source_folder()) / "tests" / "cad" / "fixtures" / name;
}

std::string replaced(std::string text, std::string_view was, std::string_view is) {
  const std::size_t at = text.find(was);
  EXPECT_NE(at, std::string::npos) << was;
  return at == std::string::npos ? text : text.replace(at, was.size(), is);
}

/// A box of 1 x 2 x 3 (#155), in a representation (#160) that is mapped (#165) to (100, 0, 0) with scale 2
/// (#171).
std::string mapped_box() {
  return slurp(fixture("mapped_box.step"));
}

std::string with_entities(const std::string& text, const std::string& entities) {
  return replaced(text, "ENDSEC;\nEND-ISO", entities + "ENDSEC;\nEND-ISO");
}

/// Style of the box: red (#207).
std::string red_style() {
  return "#200=COLOUR_RGB('',1.,0.,0.);\n#201=FILL_AREA_STYLE_COLOUR('',#200);\n#202=FILL_AREA_STYLE('',(#"
         "201));\n"
         "#203=SURFACE_STYLE_FILL_AREA(#202);\n#204=SURFACE_SIDE_STYLE('',(#203));\n"
         "#205=SURFACE_STYLE_USAGE(.BOTH.,#204);\n#206=PRESENTATION_STYLE_ASSIGNMENT((#205));\n"
         "#207=STYLED_ITEM('',(#206),#155);\n"
         "#208=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#207),#5);\n";
}

CadScene scene_from(const std::string& text) {
  const TemporaryFolder folder;
  spill(folder.path() / "a.step", text);
  auto read = read_cad_file(folder.path() / "a.step");
  if (read.ok()) return std::move(read).value();
  ADD_FAILURE() << to_string(read.error());
  return {};
}

std::vector<Code> codes_of(const CadScene& scene) {
  std::vector<Code> out;
  for (const Message& warning : scene.warnings) out.push_back(warning.code);
  return out;
}

/// Volume of a mesh that is closed, by the divergence theorem; negative where it looks inward.
double signed_volume(const PolygonMesh& mesh) {
  double out = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t k) { return mesh.positions[face[k]]; };
    out += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return out;
}

void expect_box(const CadPart& part, const Vector3& low, const Vector3& high) {
  ASSERT_FALSE(part.mesh.positions.empty());
  Vector3 least = part.mesh.positions.front(), most = least;
  for (const Vector3& at : part.mesh.positions) {
    least = least.cwiseMin(at);
    most = most.cwiseMax(at);
  }
  EXPECT_LE((least - low).norm(), 1e-9) << least.transpose();
  EXPECT_LE((most - high).norm(), 1e-9) << most.transpose();
  EXPECT_NEAR(signed_volume(part.mesh), (high - low).prod(), 1e-9);
}

TEST(ReadStepModel, PlacesMayScale) {
  const CadScene scene = scene_from(mapped_box());
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.parts.size(), 1U);
  EXPECT_EQ(scene.parts[0].name, "mapped");
  expect_box(scene.parts[0], {100, 0, 0}, {102, 4, 6});
}

TEST(ReadStepModel, PlacesAndScalesAreInTheUnitOfTheFile) {
  const CadScene scene = scene_from(replaced(mapped_box(), ".MILLI.", ".CENTI."));
  ASSERT_EQ(scene.parts.size(), 1U);
  expect_box(scene.parts[0], {1000, 0, 0}, {1020, 40, 60});
}

TEST(ReadStepModel, PlacesMayMirror) {
  const std::string mirrored =
      replaced(replaced(mapped_box(), "#166=DIRECTION('',(1.0,", "#166=DIRECTION('',(-1.0,"), "#169,2.0,",
               "#169,1.0,");
  const CadScene scene = scene_from(mirrored);
  ASSERT_EQ(scene.parts.size(), 1U);
  expect_box(scene.parts[0], {99, 0, 0}, {100, 2, 3});
}

TEST(ReadStepModel, PlacesInsidePlacesAreBothApplied) {
  const std::string nested =
      with_entities(replaced(mapped_box(), "REPRESENTATION(#184,#176)", "REPRESENTATION(#184,#223)"),
                    "#220=REPRESENTATION_MAP(#175,#176);\n"
                    "#221=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,#166,#167,#169,3.,#168);\n"
                    "#222=MAPPED_ITEM('',#220,#221);\n#223=SHAPE_REPRESENTATION('',(#175,#222),#5);\n");
  const CadScene scene = scene_from(nested);
  ASSERT_EQ(scene.parts.size(), 1U);
  expect_box(scene.parts[0], {400, 0, 0}, {406, 12, 18});
}

TEST(ReadStepModel, AShapeMayBePlacedWithAScaleAndWithout) {
  const std::string two =
      with_entities(replaced(mapped_box(), "(#175,#171)", "(#175,#171,#211)"),
                    "#210=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,#166,#167,#117,1.,#168);\n"
                    "#211=MAPPED_ITEM('',#165,#210);\n");
  const CadScene scene = scene_from(two);
  ASSERT_EQ(scene.parts.size(), 2U);
  expect_box(scene.parts[0], {100, 0, 0}, {102, 4, 6});
  expect_box(scene.parts[1], {1, 0, 0}, {2, 2, 3});
  // The placements have no names of their own.
  for (const CadPart& part : scene.parts) EXPECT_EQ(part.name, "mapped");
}

TEST(ReadStepModel, ScaledShapesKeepColoursAndVisibility) {
  for (const char* scale : {"1.0", "2.0"})
    for (const bool hidden : {false, true}) {
      SCOPED_TRACE(std::string(scale) + (hidden ? ", hidden" : ""));
      const CadScene scene =
          scene_from(with_entities(replaced(mapped_box(), "#169,2.0,", std::string("#169,") + scale + ","),
                                   red_style() + (hidden ? "#209=INVISIBILITY((#207));\n" : "")));
      ASSERT_EQ(scene.parts.size(), 1U);
      EXPECT_EQ(scene.parts[0].visible, !hidden);
      ASSERT_TRUE(scene.parts[0].colour);
      EXPECT_EQ(*scene.parts[0].colour, (std::array<std::uint8_t, 3>{255, 0, 0}));
    }
}

TEST(ReadStepModel, FacesHiddenInIgesAreAPartOfTheirOwn) {
  const auto read = must(read_cad_file(fixture("hidden_face.igs")));
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_TRUE(read->parts[0].visible);
  EXPECT_EQ(read->parts[0].patches.size(), 5U);
  EXPECT_FALSE(read->parts[1].visible);
  EXPECT_EQ(read->parts[1].patches.size(), 1U);
}

TEST(ReadStepModel, CurvesAndPointsThatAreLeftOutAreCounted) {
  const auto iges = must(read_cad_file(fixture("box_and_curve.igs")));
  ASSERT_EQ(codes_of(*iges), std::vector{w_cad_left_out});
  EXPECT_NE(iges->warnings[0].text.find("curves: 1, points: 1"), std::string::npos) << iges->warnings[0].text;
  const std::string curves =
      "#200=POLYLINE('',(#156,#161,#169));\n#201=POLYLINE('',(#117,#169));\n"
      "#202=GEOMETRIC_CURVE_SET('',(#200,#201));\n";
  const CadScene step =
      scene_from(with_entities(replaced(mapped_box(), "(#175,#171)", "(#175,#171,#202)"), curves));
  ASSERT_EQ(codes_of(step), std::vector{w_cad_left_out});
  EXPECT_NE(step.warnings[0].text.find("curves: 2, points: 0"), std::string::npos) << step.warnings[0].text;
  ASSERT_EQ(step.parts.size(), 1U);
}

TEST(ReadStepModel, AFileOfCurvesSaysThatItHoldsNothingElse) {
  const TemporaryFolder folder;
  const std::string only =
      with_entities(replaced(mapped_box(), "(#175,#171)", "(#175,#202)"),
                    "#200=POLYLINE('',(#117,#169));\n#202=GEOMETRIC_CURVE_SET('',(#200));\n");
  spill(folder.path() / "a.step", only);
  const auto read = read_cad_file(folder.path() / "a.step");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().text.find("curves (1)"), std::string::npos) << read.error().text;
}

/// A tetrahedron of triangles, as the part "mesh"; `link`: the exact body that it stands for.
std::string tessellated(const std::string& link) {
  return "#200=COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),(0.,0.,1.)));\n"
         "#201=TRIANGULATED_FACE('',#200,4,(),$,(),((1,3,2),(1,2,4),(2,3,4),(3,1,4)));\n"
         "#202=TESSELLATED_SOLID('t',(#201)," +
         link +
         ");\n"
         "#203=TESSELLATED_SHAPE_REPRESENTATION('',(#202),#5);\n#204=PRODUCT('mesh','mesh','',(#179));\n"
         "#205=PRODUCT_DEFINITION_FORMATION('','',#204);\n#206=PRODUCT_DEFINITION('design','',#205,#180);\n"
         "#207=PRODUCT_DEFINITION_SHAPE('','',#206);\n#208=SHAPE_DEFINITION_REPRESENTATION(#207,#203);\n";
}

TEST(ReadStepModel, TessellatedBodiesAreReadOrNamed) {
  const CadScene scene = scene_from(with_entities(mapped_box(), tessellated("$")));
  const auto mesh =
      std::find_if(scene.parts.begin(), scene.parts.end(), [](const auto& p) { return p.name == "mesh"; });
  if (mesh != scene.parts.end()) {  // newer kernels read them
    EXPECT_EQ(mesh->mesh.face_count(), 4U);
    EXPECT_TRUE(scene.warnings.empty());
    return;
  }
  ASSERT_EQ(codes_of(scene), std::vector{w_cad_tessellated});
  EXPECT_NE(scene.warnings[0].text.find("mesh"), std::string::npos) << scene.warnings[0].text;
  EXPECT_EQ(scene.parts.size(), 1U);
}

TEST(ReadStepModel, TrianglesBesideTheirExactBodyAreNotMissed) {
  EXPECT_EQ(codes_of(scene_from(with_entities(mapped_box(), tessellated("#155")))), std::vector<Code>{});
}

TEST(ReadStepModel, LengthsWithoutAUnitAreToldOf) {
  const std::string without =
      replaced(mapped_box(),
               "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#4)) GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#3)) ", "");
  const CadScene scene = scene_from(without);
  EXPECT_EQ(codes_of(scene), std::vector{w_cad_unit});
  ASSERT_EQ(scene.parts.size(), 1U);
  expect_box(scene.parts[0], {100, 0, 0}, {102, 4, 6});
}

TEST(ReadStepModel, UsagesThatSayNothingGiveWayToProducts) {
  for (const char* usage :
       {"=>[0:1:1:2]", "Next assembly relationship", "NEXT_ASSEMBLY_USAGE_OCCURRENCE", "NAUO12"}) {
    SCOPED_TRACE(usage);
    std::string text = slurp(fixture("assembly_nauo.step"));
    for (const char* id : {"'NAUO1'", "'NAUO2'"})
      text = replaced(text, std::string(id) + ",' '", std::string(id) + ",'" + usage + "'");
    const CadScene scene = scene_from(text);
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(scene.parts[0].name, "left_door");
    EXPECT_EQ(scene.parts[1].name, "right_door");
  }
}

TEST(ReadStepModel, APartAloneInItsAssemblyHasItsOwnName) {
  const std::string text = slurp(fixture("assembly_alone.step"));
  const std::pair<const char*, const char*> cases[] = {{"'NAUO1','odd'", "odd"}, {"'NAUO1',''", "Bölt"}};
  for (const auto& [usage, name] : cases) {
    const CadScene scene = scene_from(replaced(text, "'NAUO1','odd'", usage));
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(scene.parts[0].name, name);
    EXPECT_EQ(scene.parts[1].name, "Bölt");
  }
  // A usage of the assembly says more than the product in it.
  const CadScene scene =
      scene_from(replaced(replaced(text, "'NAUO1','odd'", "'NAUO1',''"), "'NAUO2',''", "'NAUO2','upper'"));
  ASSERT_EQ(scene.parts.size(), 2U);
  EXPECT_EQ(scene.parts[0].name, "upper");
}

TEST(ReadStepModel, APoleIsTheReasonGivenForFacets) {
  const auto read = must(read_cad_file(fixture("rational_ball.step")));
  ASSERT_EQ(codes_of(*read), std::vector{w_cad_mixed});
  EXPECT_NE(read->warnings[0].text.find("with a pole: 1"), std::string::npos) << read->warnings[0].text;
  EXPECT_NE(read->warnings[0].text.find("other kinds: 0"), std::string::npos) << read->warnings[0].text;
}

#endif

}  // namespace
}  // namespace hariko::test
