// STEP and IGES files as patches and triangles.

#include "core/cad/kernel/read_cad_file.hpp"

#include "core/cad/kernel/cad_file.hpp"
#include "tests/cad/producers.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom_BezierSurface.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <array>
#include <atomic>
#include <gp_Trsf.hxx>
#include <map>
#include <numbers>

#include "core/analysis/measures.hpp"
#include "core/cad/kernel/opencascade/isolated.hpp"
#include "core/surface/weld_patches.hpp"
#endif

namespace hariko::test {
namespace {

#ifndef HARIKO_OPENCASCADE

TEST(ReadCadFile, SaysWhyItCannot) {
  must_fail(read_cad_file("a.step"), e_no_cad_kernel);
}

#else

namespace fs = std::filesystem;

std::vector<CadPart> parts_of(const fs::path& path, const CadReadOptions& options = {}) {
  auto read = read_cad_file(path, options);
  if (!read.ok()) {
    ADD_FAILURE() << to_string(read.error());
    return {};
  }
  for (const Message& warning : read->warnings) ADD_FAILURE() << to_string(warning);
  return std::move(read).value().parts;
}

/// File that make_cad_file writes of a model.
fs::path written(const fs::path& folder, const CadModel& model, CadFormat format, CadUnit unit) {
  const CadObject object{"the part", &model, {200, 30, 90}};
  const auto file = must(make_cad_file(std::span(&object, 1), {.format = format, .unit = unit}));
  const fs::path path = folder / (format == CadFormat::iges ? "a.igs" : "a.stp");
  spill(path, file->bytes);
  return path;
}

/// Volume below triangles (by the divergence theorem) and whether every edge has one in each direction.
struct Solid {
  double volume = 0;
  bool closed = true;
};
Solid solid_of(const PolygonMesh& mesh) {
  Solid out;
  std::map<std::pair<Index, Index>, int> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t k) { return mesh.positions[face[k]]; };
    out.volume += at(0).dot(at(1).cross(at(2))) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{face[k], face[(k + 1) % 3]}];
      --edges[{face[(k + 1) % 3], face[k]}];
    }
  }
  for (const auto& [edge, balance] : edges) out.closed = out.closed && balance == 0;
  return out;
}

fs::path written(const fs::path& folder, const Surface& surface, CadFormat format, CadUnit unit) {
  const auto model = must(make_cad_model(surface));
  return written(folder, *model, format, unit);
}

/// Patches that its splines consist of.
std::size_t spline_patches(const CadModel& model) {
  std::size_t count = 0;
  for (const CadFace& face : model.faces) count += face.surface.s.span_count() * face.surface.t.span_count();
  return count;
}

double area_of(const PolygonMesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vector3& a = mesh.positions[face[0]];
    area += (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a).norm() / 2;
  }
  return area;
}

TEST(ReadCadFile, OwnFilesComeBackAsTheSamePatches) {
  for_produced([](const Surface& surface) {
    if (surface.domain() != Domain::square && repetitions(1) < 2) return;
    const Measures wanted = measure(surface);
    const auto model = must(make_cad_model(surface));
    const bool too_many = spline_patches(*model) > max_cad_patches;
    for (const CadFormat format : {CadFormat::step_ap214, CadFormat::iges}) {
      if (format == CadFormat::iges && surface.patch_count() > 10 && repetitions(1) < 2) continue;
      const TemporaryFolder folder;
      const auto path = written(folder.path(), *model, format, CadUnit::centimetre);
      auto read = must(read_cad_file(path));
      auto& parts = read->parts;
      ASSERT_EQ(parts.size(), 1U);
      EXPECT_EQ(parts[0].name, "the part");
      EXPECT_EQ(parts[0].colour, (std::array<std::uint8_t, 3>{200, 30, 90}));
      EXPECT_EQ(read->warnings.size(), too_many ? 1U : 0U);
      for (const Message& warning : read->warnings) EXPECT_EQ(warning.code, w_cad_patches);
      if (too_many) {
        EXPECT_TRUE(parts[0].patches.empty());
        EXPECT_NEAR(area_of(parts[0].mesh), wanted.area, 1e-2 * wanted.area);
        continue;
      }
      EXPECT_EQ(parts[0].mesh.face_count(), 0U);
      const auto welded = must(weld_patches(Vector3::Zero(), std::move(parts[0].patches)));
      EXPECT_NEAR(measure(*welded).area, wanted.area, 1e-4 * wanted.area);
    }
  });
}

TEST(ReadCadFile, OwnSolidsBecomeClosedTriangles) {
  const auto produced = surfaces_of({"solids_one"});
  ASSERT_EQ(produced.size(), 1U);
  const double volume = measure(produced[0].surface).volume.value();
  const TemporaryFolder folder;
  const fs::path path =
      written(folder.path(), produced[0].surface, CadFormat::step_ap214, CadUnit::millimetre);
  std::size_t before = 0;
  for (const double tolerance : {0.02, 0.002}) {
    const auto parts = parts_of(path, {.tolerance = tolerance, .angle = 1, .patches = false});
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(parts[0].patches.empty());
    const Solid solid = solid_of(parts[0].mesh);
    EXPECT_TRUE(solid.closed);
    EXPECT_NEAR(solid.volume, volume, 40 * tolerance);
    EXPECT_GT(parts[0].mesh.face_count(), before);
    before = parts[0].mesh.face_count();
  }
}

/// A document of the kernel for files of other programs.
struct OtherProgram {
  Handle(TDocStd_Document) document;
  Handle(XCAFDoc_ShapeTool) shapes;
  OtherProgram() {
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  }
  ~OtherProgram() { XCAFApp_Application::GetApplication()->Close(document); }
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  TDF_Label add(const TopoDS_Shape& shape, const char* name) {
    const TDF_Label label = shapes->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    return label;
  }
  void write(const fs::path& path, const std::string& unit) {
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    STEPCAFControl_Writer writer;
    writer.ChangeWriter().Model()->SetWriteLengthUnit(unit == "M" ? 1000 : unit == "INCH" ? 25.4 : 1);
    ASSERT_TRUE(writer.Transfer(document, STEPControl_AsIs));
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  }
};

TEST(ReadCadFile, OtherSurfacesBecomeTrianglesInMillimetres) {
  const TemporaryFolder folder;
  for (const char* unit : {"MM", "INCH", "M"}) {
    OtherProgram other;
    const TDF_Label label = other.add(BRepPrimAPI_MakeSphere(gp_Pnt(10, 20, 30), 5).Shape(), "ball");
    XCAFDoc_DocumentTool::ColorTool(other.document->Main())
        ->SetColor(label, Quantity_Color(1, 0.5, 0, Quantity_TOC_sRGB), XCAFDoc_ColorGen);
    other.write(folder.path() / "a.step", unit);
    const auto parts = parts_of(folder.path() / "a.step", {.tolerance = 0.01});
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "ball");
    EXPECT_EQ(parts[0].colour, (std::array<std::uint8_t, 3>{255, 128, 0}));
    EXPECT_TRUE(parts[0].patches.empty());
    const Solid solid = solid_of(parts[0].mesh);
    EXPECT_TRUE(solid.closed);
    const double volume = 4.0 / 3 * std::numbers::pi * 125;
    EXPECT_NEAR(solid.volume, volume, 0.01 * volume);
    EXPECT_LT(solid.volume, volume) << "corners lie on the sphere, and the outside is outside";
    for (const Vector3& p : parts[0].mesh.positions) EXPECT_NEAR((p - Vector3(10, 20, 30)).norm(), 5, 1e-6);
  }
}

TEST(ReadCadFile, AssembliesStandInTheirPlaces) {
  const TemporaryFolder folder;
  OtherProgram other;
  const TDF_Label box = other.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box"),
                  all = other.shapes->NewShape();
  TDataStd_Name::Set(all, "all");
  for (const double x : {0.0, 10.0}) {
    gp_Trsf move;
    move.SetTranslation(gp_Vec(x, 0, 0));
    TDataStd_Name::Set(other.shapes->AddComponent(all, box, TopLoc_Location(move)),
                       x == 0 ? "left" : "right");
  }
  other.shapes->UpdateAssemblies();
  other.write(folder.path() / "a.step", "MM");
  const auto parts = parts_of(folder.path() / "a.step");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "left");
  EXPECT_EQ(parts[1].name, "right");
  for (std::size_t k = 0; k < 2; ++k) {
    const Solid solid = solid_of(parts[k].mesh);
    EXPECT_TRUE(solid.closed);
    EXPECT_NEAR(solid.volume, 6, 1e-9);
    double least = 1e9;
    for (const Vector3& p : parts[k].mesh.positions) least = std::min(least, p.x());
    EXPECT_NEAR(least, k == 0 ? 0 : 10, 1e-9);
  }
}

using ColourBytes = std::array<std::uint8_t, 3>;
constexpr std::array<ColourBytes, 2> red_and_blue{ColourBytes{255, 0, 0}, ColourBytes{0, 0, 255}};

Quantity_Color colour_from(const ColourBytes& bytes) {
  return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0, Quantity_TOC_sRGB};
}

/// Two boxes of 6000 mm^3, the first at zero.
std::array<TopoDS_Shape, 2> two_boxes() {
  return {BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 10, 20, 30).Shape(),
          BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), 10, 20, 30).Shape()};
}

void expect_boxes_in_colours(const std::vector<CadPart>& parts) {
  ASSERT_EQ(parts.size(), 2U);
  for (const CadPart& part : parts) {
    Eigen::AlignedBox3d box;
    for (const Vector3& p : part.mesh.positions) box.extend(p);
    for (const BezierPatch& patch : part.patches)
      for (const Vector3& p : patch.points) box.extend(p);
    ASSERT_FALSE(box.isEmpty());
    EXPECT_LT(box.sizes().maxCoeff(), 31) << "one box";
    ASSERT_TRUE(part.colour.has_value());
    EXPECT_EQ(*part.colour, red_and_blue[box.min().x() > 25 ? 1 : 0]);
  }
}

TEST(ReadCadFile, SolidsOfOnePartWithColoursOfTheirOwnBecomeObjectsOfTheirOwn) {
  const TemporaryFolder folder;
  for (const bool same : {false, true}) {
    OtherProgram other;
    const auto boxes = two_boxes();
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    for (const TopoDS_Shape& box : boxes) builder.Add(both, box);
    const TDF_Label label = other.add(both, "boxes");
    const auto colours = XCAFDoc_DocumentTool::ColorTool(other.document->Main());
    for (std::size_t i = 0; i < 2; ++i)
      colours->SetColor(other.shapes->AddSubShape(label, boxes[i]), colour_from(red_and_blue[same ? 1 : i]),
                        XCAFDoc_ColorSurf);
    other.write(folder.path() / "a.step", "MM");
    const auto parts = parts_of(folder.path() / "a.step");
    if (!same) {
      expect_boxes_in_colours(parts);
      continue;
    }
    ASSERT_EQ(parts.size(), 1U) << "nothing tells the solids of the part from each other";
    EXPECT_EQ(parts[0].colour, red_and_blue[1]);
  }
}

TEST(ReadCadFile, BodiesSewnOfLooseFacesHaveColoursOfTheirOwn) {
  const TemporaryFolder folder;
  OtherProgram other;
  const auto boxes = two_boxes();
  const auto colours = XCAFDoc_DocumentTool::ColorTool(other.document->Main());
  for (std::size_t i = 0; i < 2; ++i)
    for (TopExp_Explorer face(boxes[i], TopAbs_FACE); face.More(); face.Next())
      colours->SetColor(other.add(BRepBuilderAPI_Copy(face.Current()).Shape(), "FACE"),
                        colour_from(red_and_blue[i]), XCAFDoc_ColorSurf);
  IGESCAFControl_Writer writer;
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  writer.SetColorMode(true);
  ASSERT_TRUE(writer.Transfer(other.document));
  writer.ComputeModel();
  ASSERT_TRUE(writer.Write((folder.path() / "loose.igs").c_str()));
  expect_boxes_in_colours(parts_of(folder.path() / "loose.igs"));
}

/// A bicubic patch over the square of 3 x 3, of which a disc can be cut out.
TopoDS_Shape bump(bool hole) {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int j = 1; j <= 4; ++j)
    for (int i = 1; i <= 4; ++i)
      poles.SetValue(i, j, gp_Pnt(i - 1, j - 1, (i == 2 || i == 3) && (j == 2 || j == 3) ? 1 : 0));
  const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles);
  BRepBuilderAPI_MakeFace face(surface, 1e-7);
  if (!hole) return face.Shape();
  const Handle(Geom2d_Circle) circle =
      new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1, 0)), 0.2, false);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, surface).Edge();
  return BRepBuilderAPI_MakeFace(face.Face(), BRepBuilderAPI_MakeWire(edge).Wire()).Shape();
}

TEST(ReadCadFile, WholeSplinesBecomePatchesAndTrimmedOnesTriangles) {
  const TemporaryFolder folder;
  for (const bool hole : {false, true}) {
    OtherProgram other;
    other.add(bump(hole), "bump");
    other.write(folder.path() / "a.stp", "MM");
    const auto parts = parts_of(folder.path() / "a.stp");
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].patches.size(), hole ? 0U : 1U);
    EXPECT_EQ(parts[0].mesh.face_count() > 0, hole);
    if (hole) continue;
    EXPECT_EQ(parts[0].patches[0].degree_s, 3);
    EXPECT_FALSE(parts[0].patches[0].rational());
    EXPECT_LT((parts[0].patches[0].points[5] - Vector3(1, 1, 1)).norm(), 1e-12);
    EXPECT_EQ(parts_of(folder.path() / "a.stp", {.patches = false})[0].patches.size(), 0U);
  }
}

TEST(ReadCadFile, WorkThatComesToNoEndIsGivenUp) {
  // OpenCASCADE 7.6 now and then numbers the entities of a damaged file for ever.
  const auto bytes = isolated(
      [](const std::function<void(double)>&) -> std::string {
        for (std::atomic<unsigned> turn = 0;; ++turn) {
        }
      },
      {.working = 1}, {}, {});
  EXPECT_FALSE(bytes);
}

TEST(ReadCadFile, DamagedFilesAreRefusedOrReadButNeverCrash) {
  const TemporaryFolder folder;
  OtherProgram other;
  other.add(bump(true), "bump");
  other.write(folder.path() / "a.step", "MM");
  const auto produced = surfaces_of({"wheel_arch"});
  ASSERT_FALSE(produced.empty());
  const fs::path iges = written(folder.path(), produced[0].surface, CadFormat::iges, CadUnit::millimetre);
  for (const fs::path& good : {folder.path() / "a.step", iges}) {
    const std::string whole = slurp(good);
    const fs::path bad = folder.path() / ("bad" + good.extension().string());
    for_random(5200, 12, [&](std::mt19937_64& rng) {
      std::string bytes = whole;
      const int changes = uniform_int(rng, 1, 5);
      for (int k = 0; k < changes; ++k) {
        char& byte = bytes[std::size_t(uniform_int(rng, 0, int(bytes.size()) - 1))];
        // Mostly other digits and signs, which get past the first look.
        constexpr std::string_view likely = "0123456789#-,.()$*;'";
        byte = chance(rng, 0.9) ? likely[std::size_t(uniform_int(rng, 0, int(likely.size()) - 1))]
                                : char(uniform_int(rng, 0, 255));
      }
      spill(bad, bytes);
      const auto read = read_cad_file(bad);
      if (!read.ok()) {
        EXPECT_FALSE(read.error().text.empty());
        EXPECT_FALSE(read.error().remedy.empty());
      }
    });
    spill(bad, whole.substr(0, whole.size() / 2));
    must_fail(read_cad_file(bad), e_cad_read);
  }
}

TEST(ReadCadFile, WhatIsNoCadFileIsRefused) {
  const TemporaryFolder folder;
  for (const char* ending : {"step", "iges"}) {
    const fs::path path = folder.path() / (std::string("a.") + ending);
    must_fail(read_cad_file(path), e_file_open);
    for (const std::string text : {"", "solid a\nendsolid\n", "\x00\x01\x02"}) {
      spill(path, text);
      const auto read = read_cad_file(path);
      ASSERT_FALSE(read.ok());
      EXPECT_EQ(read.error().code, e_cad_read) << read.error().text;
    }
  }
  spill(folder.path() / "empty.step",
        "ISO-10303-21;HEADER;FILE_DESCRIPTION((''),'2;1');FILE_NAME('','',(''),(''),'','','');"
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));ENDSEC;DATA;ENDSEC;END-ISO-10303-21;");
  EXPECT_FALSE(read_cad_file(folder.path() / "empty.step").ok());
}

TEST(ReadCadFile, CanBeCancelled) {
  const TemporaryFolder folder;
  OtherProgram other;
  other.add(bump(true), "bump");
  other.write(folder.path() / "a.step", "MM");
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  must_fail(read_cad_file(folder.path() / "a.step", {}, cancel), e_cancelled);
}

#endif

}  // namespace
}  // namespace hariko::test
