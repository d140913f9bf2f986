// Files as other programs write them: names, loose faces, letters, and what does not belong into the text.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <numbers>
#include <vector>

#include "core/analysis/measures.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/support/must.hpp"
#endif

namespace hariko::test {
namespace {

#ifdef HARIKO_OPENCASCADE

namespace fs = std::filesystem;

Result<CadScene> read_fixture(const char* name) {
  return read_cad_file(fs::path(source_folder()) / "tests" / "cad" / "fixtures" / name);
}

/// By the divergence theorem; nothing where an edge does not have one facet in each direction.
std::optional<double> closed_volume_of(const PolygonMesh& mesh) {
  double volume = 0;
  std::map<std::pair<Index, Index>, int> balance;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t k) { return mesh.positions[face[k]]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      ++balance[{face[k], face[(k + 1) % 3]}];
      --balance[{face[(k + 1) % 3], face[k]}];
    }
  }
  for (const auto& [edge, count] : balance)
    if (count != 0) return {};
  return volume;
}

/// The faces of shapes as an IGES file of trimmed surfaces, which share nothing.
fs::path loose_faces(const fs::path& folder, const std::vector<TopoDS_Shape>& shapes) {
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  IGESControl_Writer writer("MM", 0);
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
      writer.AddShape(BRepBuilderAPI_Copy(face.Current()).Shape());
  writer.ComputeModel();
  fs::path path = folder / "loose.igs";
  EXPECT_TRUE(writer.Write(path.c_str()));
  return path;
}

TEST(OtherPrograms, ComponentsHaveTheNamesOfTheirProducts) {
  const auto read = must(read_fixture("assembly_nauo.step"));
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[0].name, "left_door");
  EXPECT_EQ(read->parts[1].name, "right_door");
}

TEST(OtherPrograms, TextBehindTheEndOfIgesIsNoReasonToRefuseIt) {
  const auto read = must(read_fixture("text_behind_end.igs"));
  ASSERT_EQ(read->parts.size(), 1U);
  EXPECT_EQ(read->parts[0].patches.size(), 2U);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_cad_behind);
}

TEST(OtherPrograms, ByteOrderMarksAreNoReasonToRefuseAFile) {
  const TemporaryFolder folder;
  for (const char* name : {"assembly_nauo.step", "text_behind_end.igs"}) {
    const fs::path from = fs::path(source_folder()) / "tests" / "cad" / "fixtures" / name;
    const fs::path marked = folder.path() / name;
    spill(marked, "\xef\xbb\xbf" + slurp(from));
    const auto read = must(read_cad_file(marked));
    ASSERT_FALSE(read->warnings.empty());
    EXPECT_EQ(read->warnings[0].code, w_cad_mark);
  }
}

TEST(OtherPrograms, OldLettersInNamesAreReadOrLostAlone) {
  const TemporaryFolder folder;
  const std::string whole =
      slurp(fs::path(source_folder()) / "tests" / "cad" / "fixtures" / "assembly_nauo.step");
  const std::pair<std::string, std::string> cases[] = {
      {"T\xfcr", "Tür"},
      {"Tür", "Tür"},
      {"T\\X2\\00FC\\X0\\r", "Tür"},
      {"T\\X\\FCr", "Tür"},
      // Shift-JIS, with a letter whose second byte is a backslash, and half-width kana
      {"\x89\xba\x94\xa0", "下箱"},
      {"\x95\x5c\x96\xca 2", "表面 2"},
      {"\x8e\xb2\xb1\x8e\xb3", "軸ｱ宍"}};
  for (const auto& [written, name] : cases) {
    std::string text = whole;
    for (std::size_t at = 0; (at = text.find("left_door", at)) != std::string::npos; at += written.size())
      text.replace(at, std::string("left_door").size(), written);
    const fs::path path = folder.path() / "a.step";
    spill(path, text);
    const auto read = must(read_cad_file(path));
    ASSERT_EQ(read->parts.size(), 2U);
    EXPECT_EQ(read->parts[0].name, name) << written;
    const bool old = written == "T\xfcr" || written.starts_with('\x89') || written.starts_with('\x95') ||
                     written.starts_with('\x8e');
    EXPECT_EQ(read->warnings.size(), old ? 1U : 0U);
  }
}

TEST(OtherPrograms, FacesThatLieEdgeToEdgeBecomeOneObject) {
  const TemporaryFolder folder;
  // 6 and 3 faces, which do not know of each other, and a face alone.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 10, 20, 30).Shape(),
                     tin = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(50, 0, 0), gp_Dir(0, 0, 1)), 5, 8).Shape();
  TopExp_Explorer first(BRepPrimAPI_MakeBox(gp_Pnt(100, 0, 0), 1, 1, 1).Shape(), TopAbs_FACE);
  const auto read = must(read_cad_file(loose_faces(folder.path(), {box, tin, first.Current()})));
  ASSERT_EQ(read->parts.size(), 3U);
  std::vector<double> volumes;
  for (const CadPart& part : read->parts) {
    EXPECT_EQ(part.name.find("FACE"), std::string::npos);
    // Flat faces come as planes or as splines, as the kernel likes.
    if (part.patches.empty()) {
      if (const auto volume = closed_volume_of(part.mesh)) volumes.push_back(*volume);
    } else if (part.mesh.face_count() == 0) {
      const auto welded = must(weld_patches(Vector3::Zero(), part.patches));
      if (const auto volume = measure(*welded).volume) volumes.push_back(std::abs(*volume));
    }
  }
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes[0], 6000, 1e-6);
  EXPECT_NEAR(volumes[1], std::numbers::pi * 25 * 8, 0.02 * volumes[1]);
}

#endif

}  // namespace
}  // namespace hariko::test
