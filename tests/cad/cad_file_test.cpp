// STEP and IGES files, read back by OpenCASCADE.

#include "core/cad/kernel/cad_file.hpp"

#include <cstdio>
#include <numbers>

#include "core/analysis/measures.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/cad/cad_measure.hpp"
#include "tests/cad/producers.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#endif

namespace hariko::test {
namespace {

TEST(CadFile, EndingsTellTheFormat) {
  EXPECT_EQ(cad_format_of("a.step"), CadFormat::step_ap214);
  EXPECT_EQ(cad_format_of("a.b.STP"), CadFormat::step_ap214);
  EXPECT_EQ(cad_format_of("a.iges"), CadFormat::iges);
  EXPECT_EQ(cad_format_of("a.IgS"), CadFormat::iges);
  EXPECT_FALSE(cad_format_of("a.stl"));
  EXPECT_FALSE(cad_format_of("step"));
}

#ifndef HARIKO_OPENCASCADE

TEST(CadFile, SaysWhyThereIsNone) {
  ASSERT_TRUE(why_no_cad_files());
  EXPECT_EQ(why_no_cad_files()->code, e_no_cad_kernel);
  EXPECT_FALSE(make_cad_file({}, {}).ok());
}

#else

struct ReadPart {
  std::string name;
  TopoDS_Shape shape;
  std::array<int, 3> colour{-1, -1, -1};
};

std::string utf8(const TCollection_ExtendedString& text) {
  std::string out(std::size_t(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter at = out.data();
  text.ToUTF8CString(at);
  out.resize(out.size() - 1);
  return out;
}

/// The parts of a file, in millimetres.
std::vector<ReadPart> read_parts(const std::filesystem::path& path) {
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const bool iges = cad_format_of(path) == CadFormat::iges;
  bool fine = false;
  if (iges) {
    IGESCAFControl_Reader reader;
    fine = reader.ReadFile(path.c_str()) == IFSelect_RetDone && reader.Transfer(document);
  } else {
    STEPCAFControl_Reader reader;
    fine = reader.ReadFile(path.c_str()) == IFSelect_RetDone && reader.Transfer(document);
  }
  EXPECT_TRUE(fine) << path;
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  TDF_LabelSequence labels;
  shapes->GetFreeShapes(labels);
  std::vector<ReadPart> out;
  for (int i = 1; i <= labels.Length(); ++i) {
    ReadPart part{{}, XCAFDoc_ShapeTool::GetShape(labels.Value(i)), {}};
    Handle(TDataStd_Name) name;
    if (labels.Value(i).FindAttribute(TDataStd_Name::GetID(), name)) part.name = utf8(name->Get());
    Quantity_Color colour;
    TopExp_Explorer solid(part.shape, TopAbs_SOLID), shell(part.shape, TopAbs_SHELL),
        face(part.shape, TopAbs_FACE);
    bool coloured = false;
    for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
      coloured = coloured || colours->GetColor(part.shape, kind, colour);
      for (TopExp_Explorer* at : {&solid, &shell, &face})
        coloured = coloured || (at->More() && colours->GetColor(at->Current(), kind, colour));
    }
    if (coloured) {
      double r = 0, g = 0, b = 0;
      colour.Values(r, g, b, Quantity_TOC_sRGB);
      part.colour = {int(std::lround(255 * r)), int(std::lround(255 * g)), int(std::lround(255 * b))};
    }
    out.push_back(part);
  }
  XCAFApp_Application::GetApplication()->Close(document);
  return out;
}

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::size_t out = 0;
  for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++out;
  return out;
}

/// Edges that only one face has.
std::size_t open_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  std::size_t out = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
    out += faces(i).Extent() < 2 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i)));
  return out;
}

/// Largest distance between the faces as they were read and those of the model, at equal parameters. Faces
/// come in the order in which they were written.
double distance_of(const TopoDS_Shape& shape, const CadModel& model, int density) {
  double largest = 0;
  std::size_t number = 0;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next(), ++number) {
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(at.Current())));
    if (spline.IsNull() || number >= model.faces.size()) {
      ADD_FAILURE() << "face " << number << " is no B-spline of the model";
      return 1e9;
    }
    double s0 = 0, s1 = 0, t0 = 0, t1 = 0;
    spline->Bounds(s0, s1, t0, t1);
    const CadPiece& piece = model.pieces[number];
    const SplineEvaluator face(model.faces[number].surface);
    for (int j = 0; j <= density; ++j)
      for (int i = 0; i <= density; ++i) {
        const double x = double(i) / density, y = double(j) / density;
        const gp_Pnt p = spline->Value(s0 + x * (s1 - s0), t0 + y * (t1 - t0));
        const Vector3 want = model.origin + face.at(x * piece.s.back(), y * piece.t.back()).position;
        largest = std::max(largest, (Vector3(p.X(), p.Y(), p.Z()) - want).norm());
      }
  }
  EXPECT_EQ(number, model.faces.size());
  return largest;
}

std::size_t component_count(const CadModel& model) {
  DisjointSets parts(model.faces.size());
  for (const CadEdge& edge : model.edges)
    if (edge.use_count == 2) parts.join(edge.uses[0].piece, edge.uses[1].piece);
  std::size_t out = 0;
  for (Index f = 0; f < model.faces.size(); ++f) out += parts.find(f) == f;
  return out;
}

void check_measures(const TopoDS_Shape& shape, const CadModel& model, const Surface& surface) {
  const Measures measures = measure(surface);
  GProp_GProps area, volume;
  BRepGProp::SurfaceProperties(shape, area, 1e-6);
  EXPECT_NEAR(area.Mass(), measures.area, 1e-4 * measures.area);
  if (!measures.volume) return;
  BRepGProp::VolumeProperties(shape, volume, 1e-6);
  // A layer as thick as the tolerance over the whole surface.
  EXPECT_NEAR(volume.Mass(), *measures.volume,
              usual_cad_tolerance * model.size * measures.area + 1e-5 * *measures.volume);
}

CadFile written_object(const CadObject& object, const std::filesystem::path& path,
                       const CadFileOptions& options) {
  auto file = make_cad_file(std::span(&object, 1), options);
  if (!file.ok()) {
    ADD_FAILURE() << file.error().text;
    return {};
  }
  spill(path, file->bytes);
  return std::move(file).value();
}

void round_trip(const std::string& name, const Surface& surface, CadFormat format) {
  const auto model = must(make_cad_model(surface));
  const TemporaryFolder folder;
  const auto path = folder.path() / (format == CadFormat::iges ? "a.iges" : "a.step");
  const CadFile file = written_object({"part", &*model}, path, {.format = format});
  EXPECT_TRUE(file.report.valid);
  EXPECT_EQ(file.report.faces, model->faces.size());
  EXPECT_LE(file.report.edge_tolerance, 1e-6);
  EXPECT_EQ(file.report.solids + file.report.voids, model->closed() ? component_count(*model) : 0);
  const auto parts = read_parts(path);
  ASSERT_EQ(parts.size(), 1U);
  const TopoDS_Shape& shape = parts[0].shape;
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  EXPECT_EQ(count(shape, TopAbs_FACE), model->faces.size());
  EXPECT_EQ(count(shape, TopAbs_SOLID), file.report.solids);
  if (model->closed()) {
    EXPECT_EQ(open_edges(shape), 0U);
  }
  check_measures(shape, *model, surface);
  const CadMeasure measure = measure_cad(surface, *model);
  EXPECT_LE(measure.largest, usual_cad_tolerance * model->size);
  // Two ridges of a skin fade out into one, and tangent planes turn within a span: a warning says so.
  EXPECT_LE(measure.normal_jump, name.find("skin_merge_inside") == 0 ? 0.02 : usual_cad_angle);
  // OpenCASCADE's copy of an IGES file has fewer digits.
  const double distance = distance_of(shape, *model, 24);
  EXPECT_LE(distance, (format == CadFormat::iges ? 1e-9 : 1e-12) * model->size);
  if (repetitions(1) < 2) return;
  std::printf("| %s | %s | %zu | %zu | %zu | %zu | %.1e | %.1e | %.4f |\n", name.c_str(),
              format == CadFormat::iges ? "IGES" : "STEP", model->faces.size(), measure.exact,
              file.report.solids, file.bytes.size(), file.report.edge_tolerance, distance / model->size,
              measure.normal_jump * 180 / std::numbers::pi);
}

void print_head() {
  if (repetitions(1) > 1)
    std::printf(
        "| object | format | faces | exact | solids | bytes | edge tolerance, mm | distance / size | normal "
        "jump, degrees |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
}

TEST(CadFile, EveryProducerComesBackThroughStep) {
  print_head();
  for_named([](const std::string& name, const Surface& surface) {
    round_trip(name, surface, CadFormat::step_ap214);
  });
}

TEST(CadFile, EveryProducerComesBackThroughIges) {
  print_head();
  for_named(
      [](const std::string& name, const Surface& surface) { round_trip(name, surface, CadFormat::iges); });
}

TEST(CadFile, Ap242IsReadAsWell) {
  const auto produced = surfaces_of({"cube_crease"});
  ASSERT_EQ(produced.size(), 1U);
  round_trip("cube_crease", produced[0].surface, CadFormat::step_ap242);
}

TEST(CadFile, UnitsNamesAndColoursAreKept) {
  const auto produced = surfaces_of({"wheel_arch"});
  ASSERT_FALSE(produced.empty());
  const auto model = must(make_cad_model(produced[0].surface));
  GProp_GProps wanted;
  const TemporaryFolder folder;
  double area = 0;
  for (const CadFormat format : {CadFormat::step_ap214, CadFormat::iges})
    for (const CadUnit unit : {CadUnit::millimetre, CadUnit::metre, CadUnit::inch}) {
      const auto path = folder.path() / (format == CadFormat::iges ? "a.igs" : "a.stp");
      const std::string name = format == CadFormat::iges ? "arch" : "\u30db\u30a4\u30fc\u30eb arch";
      written_object({name, &*model, {200, 30, 90}}, path, {.format = format, .unit = unit});
      const auto parts = read_parts(path);
      ASSERT_EQ(parts.size(), 1U);
      GProp_GProps found;
      BRepGProp::SurfaceProperties(parts[0].shape, found);
      if (area == 0) area = found.Mass();
      EXPECT_NEAR(found.Mass(), area, 1e-6 * area) << int(unit);
      EXPECT_EQ(parts[0].colour, (std::array<int, 3>{200, 30, 90}));
      if (format != CadFormat::iges) {
        EXPECT_EQ(parts[0].name, name);
      }
    }
}

TEST(CadFile, SameInputSameBytes) {
  const auto produced = surfaces_of({"cube_crease"});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface));
  for (const CadFormat format : {CadFormat::step_ap214, CadFormat::iges}) {
    const CadObject object{"cube", &*model};
    const auto one = must(make_cad_file(std::span(&object, 1), {.format = format})),
               two = must(make_cad_file(std::span(&object, 1), {.format = format}));
    EXPECT_EQ(one->bytes, two->bytes);
  }
}

#endif

}  // namespace
}  // namespace hariko::test
