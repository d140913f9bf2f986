// Closed shells inside others come out of STEP and IGES as voids of one solid.

#include "core/cad/cad_shells.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "tests/cad/round_boxes.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>

namespace hariko::test {
namespace {

struct WrittenSolids {
  CadFileReport report;
  TopoDS_Shape shape;  ///< as the kernel reads it
  std::string text;
};

WrittenSolids written_solids(const std::vector<RoundBox>& boxes, bool iges) {
  const auto model = must(make_cad_model(surface_of(boxes), {.exact = true}));
  const CadObject object{"part", &*model};
  auto file =
      must(make_cad_file(std::span(&object, 1), {.format = iges ? CadFormat::iges : CadFormat::step_ap214}));
  const TemporaryFolder folder;
  const auto path = folder.path() / (iges ? "a.igs" : "a.step");
  spill(path, file->bytes);
  const auto read = [&](auto reader) {
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    return reader.OneShape();
  };
  return {file->report, iges ? read(IGESControl_Reader()) : read(STEPControl_Reader()), file->bytes};
}

std::size_t count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::size_t out = 0;
  for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++out;
  return out;
}

void expect_solids(const std::vector<RoundBox>& boxes, std::size_t solids, std::size_t voids, double volume) {
  for (const bool iges : {false, true}) {
    SCOPED_TRACE(iges ? "IGES" : "STEP");
    const WrittenSolids made = written_solids(boxes, iges);
    EXPECT_TRUE(made.report.valid);
    EXPECT_EQ(made.report.solids, solids);
    EXPECT_EQ(made.report.voids, voids);
    ASSERT_FALSE(made.shape.IsNull());
    EXPECT_TRUE(BRepCheck_Analyzer(made.shape).IsValid());
    EXPECT_EQ(count_of(made.shape, TopAbs_SOLID), solids);
    EXPECT_EQ(count_of(made.shape, TopAbs_SHELL), solids + voids);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(made.shape, properties, 1e-9);
    EXPECT_NEAR(properties.Mass(), volume, 1e-6 * volume);
    if (!iges) {
      EXPECT_EQ(made.text.find("BREP_WITH_VOIDS") != std::string::npos, voids > 0);
    }
  }
}

double volume_of_box(double size) {
  const auto model = make_cad_model(surface_of({{size}}), {.exact = true});
  return cad_shells(*model).at(0).volume;
}

TEST(HollowSolids, AWallIsOneSolidWithAVoid) {
  const Vector3 zero = Vector3::Zero();
  for (const double inner : {0.5, 0.97}) {
    const double volume = volume_of_box(20) - volume_of_box(20 * inner);
    expect_solids({{20}, {20 * inner, zero, true}}, 1, 1, volume);
    expect_solids({{20, zero, true}, {20 * inner}}, 1, 1, volume);  // inside out
  }
}

TEST(HollowSolids, FarFromZeroAsWell) {
  const Vector3 far(1e6, 0, 0);
  const WrittenSolids made = written_solids({{20, far}, {18, far, true}}, false);
  EXPECT_TRUE(made.report.valid);
  EXPECT_EQ(count_of(made.shape, TopAbs_SOLID), 1U);
  EXPECT_EQ(count_of(made.shape, TopAbs_SHELL), 2U);
}

TEST(HollowSolids, ASolidInAVoidIsOneOfItsOwn) {
  const Vector3 zero = Vector3::Zero();
  expect_solids({{20}, {15, zero, true}, {10}}, 2, 1,
                volume_of_box(20) - volume_of_box(15) + volume_of_box(10));
}

TEST(HollowSolids, ShellsThatLookTheSameWayOrLieApartStaySolids) {
  expect_solids({{20}, {10, {50, 0, 0}, true}}, 2, 0, volume_of_box(20) + volume_of_box(10));
  expect_solids({{20}, {10}}, 2, 0, volume_of_box(20) + volume_of_box(10));
}

}  // namespace
}  // namespace hariko::test
#endif
