// Solids of a CAD program whose faces are partly whole splines, partly trimmed: each is one closed mesh.

#include "core/analysis/measures.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

#include <BRepBuilderAPI_Transform.hxx>
#include <functional>
#include <map>

namespace hariko::test {
namespace {

namespace fs = std::filesystem;

TopoDS_Shape filleted_box(bool all_edges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  int number = 0;
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next(), ++number)
    if (all_edges || number < 3) fillet.Add(2, TopoDS::Edge(edge.Current()));
  return fillet.Shape();
}

TopoDS_Shape drilled_plate() {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(60, 40, 5).Shape();
  for (const double x : {15.0, 40.0})
    plate = BRepAlgoAPI_Cut(
                plate, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 20, -1), gp_Dir(0, 0, 1)), x / 5, 7).Shape())
                .Shape();
  return plate;
}

/// A profile with a curve that is turned round the z axis, between two discs.
TopoDS_Shape revolved_knob() {
  TColgp_Array1OfPnt poles(1, 4);
  poles.SetValue(1, gp_Pnt(10, 0, 0));
  poles.SetValue(2, gp_Pnt(16, 0, 6));
  poles.SetValue(3, gp_Pnt(4, 0, 9));
  poles.SetValue(4, gp_Pnt(7, 0, 15));
  const Handle(Geom_BezierCurve) side = new Geom_BezierCurve(poles);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(side).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(7, 0, 15), gp_Pnt(0, 0, 15)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 15), gp_Pnt(0, 0, 0)).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                               gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
      .Shape();
}

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return std::abs(properties.Mass());
}

/// Directed edges without a single opposite one, corners joined where they are equal bit for bit.
std::size_t open_half_edges(const PolygonMesh& mesh) {
  std::map<std::array<double, 3>, Index> numbers;
  const auto number = [&](Index v) {
    const Vector3& p = mesh.positions[v];
    return numbers.try_emplace({p.x(), p.y(), p.z()}, Index(numbers.size())).first->second;
  };
  std::map<std::pair<Index, Index>, int> uses;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k)
      ++uses[{number(face[k]), number(face[(k + 1) % face.size()])}];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    open += count != 1 || opposite == uses.end() || opposite->second != 1 ? 1 : 0;
  }
  return open;
}

double volume_of(const PolygonMesh& mesh) {
  double out = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out += mesh.positions[face[0]].dot(mesh.positions[face[1]].cross(mesh.positions[face[2]])) / 6;
  }
  return out;
}

CadPart only_part(const fs::path& path, std::size_t mixed_warnings) {
  auto read = read_cad_file(path);
  if (!read.ok() || read->parts.size() != 1) {
    ADD_FAILURE() << (read.ok() ? "several parts" : to_string(read.error()));
    return {};
  }
  EXPECT_EQ(read->warnings.size(), mixed_warnings);
  for (const Message& warning : read->warnings) EXPECT_EQ(warning.code, w_cad_mixed) << to_string(warning);
  return std::move(read).value().parts[0];
}

/// Every face is a whole spline, as the kernel's rounding has it at some scales: then the patches close.
bool whole(const fs::path& path, double volume) {
  const auto read = read_cad_file(path);
  if (!read.ok() || read->parts.size() != 1 || read->parts[0].mesh.face_count() > 0) return false;
  const auto surface = weld_patches(Vector3::Zero(), read->parts[0].patches);
  if (!surface.ok()) {
    ADD_FAILURE() << to_string(surface.error());
    return true;
  }
  EXPECT_TRUE(surface->boundary_sides().empty()) << surface->boundary_sides().size() << " open sides";
  EXPECT_NEAR(std::abs(measure(*surface).volume.value_or(0)), volume, 0.01 * volume);
  return true;
}

TEST(MixedSolids, FacesThatShareCurvedEdgesShareTheirPoints) {
  const std::map<std::string, std::function<TopoDS_Shape()>> shapes{
      {"box with three fillets", [] { return filleted_box(false); }},
      {"box with all fillets", [] { return filleted_box(true); }},
      {"drilled plate", drilled_plate},
      {"revolved knob", revolved_knob}};
  for (const auto& [name, make] : shapes)
    for (const bool splines : {false, true})
      for (const double scale : {1e-2, 1.0, 1e2}) {
        SCOPED_TRACE(name + (splines ? " as splines, times " : ", times ") + std::to_string(scale));
        gp_Trsf enlarge;
        enlarge.SetScale(gp_Pnt(0, 0, 0), scale);
        TopoDS_Shape shape = BRepBuilderAPI_Transform(make(), enlarge, true).Shape();
        const double volume = volume_of(shape);
        if (splines) shape = BRepBuilderAPI_NurbsConvert(shape, true).Shape();
        const TemporaryFolder folder;
        STEPControl_Writer writer;
        ASSERT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
        ASSERT_EQ(writer.Write((folder.path() / "a.step").c_str()), IFSelect_RetDone);
        if (splines && whole(folder.path() / "a.step", volume)) continue;
        const CadPart part = only_part(folder.path() / "a.step", splines ? 1 : 0);
        EXPECT_TRUE(part.patches.empty());
        EXPECT_EQ(part.also_exact.empty(), !splines);
        EXPECT_EQ(open_half_edges(part.mesh), 0U);
        EXPECT_NEAR(volume_of(part.mesh), volume, 0.01 * volume);
      }
}

TEST(MixedSolids, PlanesBesideASplineMakeABox) {
  const fs::path cases = source_folder() + "/tests/cases";
  const CadPart mixed = only_part(cases / "step_box_mixed.step", 1);
  EXPECT_TRUE(mixed.patches.empty());
  ASSERT_EQ(mixed.also_exact.size(), 1U);
  EXPECT_EQ(mixed.also_exact[0].points.size(), 4U);
  EXPECT_EQ(open_half_edges(mixed.mesh), 0U);
  EXPECT_NEAR(volume_of(mixed.mesh), 6000, 1e-9);
  const CadPart planes = only_part(cases / "step_box_planes.step", 0);
  EXPECT_EQ(planes.mesh.face_count(), 12U);
  EXPECT_TRUE(planes.also_exact.empty());
  EXPECT_NEAR(volume_of(planes.mesh), 6000, 1e-9);
}

/// A bilinear face over four corners. `uneven`: its first parameter runs faster at one end.
TopoDS_Face spline_face(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d, bool uneven) {
  const auto between = [](const gp_Pnt& from, const gp_Pnt& to, double part) {
    return gp_Pnt(from.XYZ() * (1 - part) + to.XYZ() * part);
  };
  TColgp_Array2OfPnt poles(1, uneven ? 3 : 2, 1, 2);
  poles.SetValue(1, 1, a);
  poles.SetValue(poles.UpperRow(), 1, b);
  poles.SetValue(poles.UpperRow(), 2, c);
  poles.SetValue(1, 2, d);
  if (uneven) {
    poles.SetValue(2, 1, between(a, b, 0.2));
    poles.SetValue(2, 2, between(d, c, 0.2));
  }
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

/// A box of spline faces. `uneven`: its top meets its neighbours with other parameters.
TopoDS_Shape spline_box(double place, bool uneven) {
  const auto at = [place](int x, int y, int z) { return gp_Pnt(place + 10 * x, 20 * y, 30 * z); };
  BRepBuilderAPI_Sewing sewing(1e-4);
  sewing.Add(spline_face(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0), false));
  sewing.Add(spline_face(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1), uneven));
  sewing.Add(spline_face(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1), false));
  sewing.Add(spline_face(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1), false));
  sewing.Add(spline_face(at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), false));
  sewing.Add(spline_face(at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), false));
  sewing.Perform();
  TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TEST(MixedSolids, OneBodyOfAPartBecomesFacetsAndTheOtherKeepsItsPatches) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, spline_box(0, true));
  builder.Add(both, spline_box(50, false));
  const TemporaryFolder folder;
  STEPControl_Writer writer;  // makes the settings known
  ASSERT_TRUE(Interface_Static::SetIVal("write.step.assembly", 0)) << "one product";
  ASSERT_EQ(writer.Transfer(both, STEPControl_AsIs), IFSelect_RetDone);
  ASSERT_EQ(writer.Write((folder.path() / "a.step").c_str()), IFSelect_RetDone);
  const CadPart part = only_part(folder.path() / "a.step", 1);
  EXPECT_EQ(part.also_exact.size(), 6U);
  EXPECT_EQ(open_half_edges(part.mesh), 0U);
  EXPECT_NEAR(volume_of(part.mesh), 6000, 1e-6);
  ASSERT_EQ(part.patches.size(), 6U);
  const auto surface = weld_patches(Vector3::Zero(), part.patches);
  ASSERT_TRUE(surface.ok());
  EXPECT_NEAR(std::abs(measure(*surface).volume.value_or(0)), 6000, 1e-6);
}

TEST(MixedSolids, MirroredBodiesLookOutward) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(3, 0, 0), gp_Dir(1, 0, 0)));
  for (const bool copied : {false, true}) {
    const TopoDS_Shape plate = drilled_plate();
    const TopoDS_Shape mirrored = BRepBuilderAPI_Transform(plate, mirror, copied).Shape();
    const TemporaryFolder folder;
    STEPControl_Writer writer;
    ASSERT_EQ(writer.Transfer(mirrored, STEPControl_AsIs), IFSelect_RetDone);
    ASSERT_EQ(writer.Write((folder.path() / "a.step").c_str()), IFSelect_RetDone);
    const CadPart part = only_part(folder.path() / "a.step", 0);
    EXPECT_EQ(open_half_edges(part.mesh), 0U);
    const double volume = volume_of(plate);
    EXPECT_NEAR(volume_of(part.mesh), volume, 0.01 * volume);
    for (const Vector3& p : part.mesh.positions) EXPECT_LE(p.x(), 6 + 1e-9);
  }
}

}  // namespace
}  // namespace hariko::test
#endif
