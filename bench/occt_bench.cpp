// Meshes under a verified tolerance, beside those of OpenCASCADE's BRepMesh_IncrementalMesh: the same
// surfaces, its deflection lowered until its mesh passes the same check of distances both ways. Prints a
// table.
//   hariko_occt_bench [TOLERANCE] [with-optimiser: 0 or 1]

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "core/approximation/approximate.hpp"
#include "core/base/parallel.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/surfaces.hpp"

namespace {

using namespace hariko;

constexpr int repeats = 5;
constexpr int check_density = 150;
/// Angular deflection wide enough for the linear one alone to decide.
constexpr double any_angle = 1.5;
constexpr double lower = 0.85;  ///< factor on the deflection until the mesh passes

/// Time of the processor, of all threads: what else runs on the machine does not count.
double processor_milliseconds() {
  return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC;
}

template <class Run>
double least_milliseconds(const Run& run, int times = repeats) {
  double best = 1e300;
  for (int i = 0; i < times; ++i) {
    const double start = processor_milliseconds();
    run();
    best = std::min(best, processor_milliseconds() - start);
  }
  return best;
}

TopoDS_Shape shape_of(const std::vector<BezierPatch>& patches) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const BezierPatch& patch : patches) {
    TColgp_Array2OfPnt poles(1, patch.degree_s + 1, 1, patch.degree_t + 1);
    for (int j = 0; j <= patch.degree_t; ++j)
      for (int i = 0; i <= patch.degree_s; ++i) {
        const Vector3& p = patch.points[patch.index(i, j)];
        poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
      }
    const Handle(Geom_BSplineSurface) surface =
        GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles));
    sewing.Add(BRepBuilderAPI_MakeFace(surface, 1e-7).Face());
  }
  sewing.Perform();
  return sewing.SewedShape();
}

TriangleMesh mesh_of(const TopoDS_Shape& shape) {
  TriangleMesh out;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
    if (mesh.IsNull()) continue;
    const auto base = static_cast<Index>(out.positions.size());
    for (int k = 1; k <= mesh->NbNodes(); ++k) {
      const gp_Pnt p = mesh->Node(k).Transformed(location.Transformation());
      out.positions.emplace_back(p.X(), p.Y(), p.Z());
    }
    for (int k = 1; k <= mesh->NbTriangles(); ++k) {
      int a = 0, b = 0, c = 0;
      mesh->Triangle(k).Get(a, b, c);
      out.triangles.push_back({base + Index(a - 1), base + Index(b - 1), base + Index(c - 1)});
    }
  }
  return out;
}

bool passes(const Surface& surface, const TriangleMesh& mesh, double tolerance) {
  const test::MeshCheck check = test::check_mesh(surface, mesh, check_density, tolerance);
  return check.surface_to_mesh <= tolerance && check.mesh_to_surface <= tolerance + check.slack;
}

struct Measured {
  std::size_t triangles = 0;
  double milliseconds = 0, deflection = 0;
  double reported = 0;  ///< milliseconds with normals and measured errors, which theirs does not find
};

Measured theirs(const Surface& surface, const TopoDS_Shape& shape, double tolerance) {
  Measured out;
  for (double deflection = tolerance; deflection > tolerance / 50; deflection *= lower) {
    BRepTools::Clean(shape);
    const BRepMesh_IncrementalMesh once(shape, deflection, Standard_False, any_angle, Standard_False);
    const TriangleMesh mesh = mesh_of(shape);
    if (!passes(surface, mesh, tolerance)) continue;
    out = {mesh.triangles.size(), 0, deflection};
    break;
  }
  out.milliseconds = least_milliseconds([&] {
    BRepTools::Clean(shape);
    const BRepMesh_IncrementalMesh again(shape, out.deflection, Standard_False, any_angle, Standard_False);
  });
  return out;
}

MeshOptions bisection_from(MeshStart start, SplitRule split = SplitRule::midpoint) {
  MeshOptions options;
  options.start = start;
  options.split = split;
  return options;
}

Measured ours(const Surface& surface, double tolerance, MeshOptions options) {
  options.criteria.distance = tolerance;
  const auto made = approximate(surface, options);
  if (!made.ok() || !passes(surface, made->mesh, tolerance)) return {};
  Measured out{made->mesh.triangles.size()};
  const int times = options.optimise ? 1 : repeats;
  out.reported = least_milliseconds([&] { (void)approximate(surface, options); }, times);
  options.report = MeshReport::none;
  out.milliseconds = least_milliseconds([&] { (void)approximate(surface, options); }, times);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const double tolerance = argc > 1 ? std::atof(argv[1]) : 0.01;
  const bool optimiser = argc < 3 || std::atoi(argv[2]) != 0;
  // One thread each: their mesher works on one face at a time here.
  const ParallelLimit limit(1);
  MeshOptions searched;
  searched.optimise = true;
  std::printf(
      "| surface | OpenCASCADE: deflection | triangles | ms | patches: triangles | ms | with report | "
      "cells: triangles | ms | with report | Gauss: triangles | ms | optimised: triangles | ms |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* name : {"dome", "saddle", "wave", "quarterpipe", "fender", "ridge", "quintic", "pair"}) {
    const Surface surface = test::golden_surface(name);
    const Measured occt = theirs(surface, shape_of(test::golden_patches(name)), tolerance);
    const Measured whole = ours(surface, tolerance, bisection_from(MeshStart::patches)),
                   cells = ours(surface, tolerance, bisection_from(MeshStart::cells)),
                   gauss = ours(surface, tolerance, bisection_from(MeshStart::patches, SplitRule::gauss)),
                   best = optimiser ? ours(surface, tolerance, searched) : Measured{};
    std::printf(
        "| %s | %.4g | %zu | %.2f | %zu | %.2f | %.2f | %zu | %.3f | %.3f | %zu | %.2f | %zu | %.0f |\n",
        name, occt.deflection, occt.triangles, occt.milliseconds, whole.triangles, whole.milliseconds,
        whole.reported, cells.triangles, cells.milliseconds, cells.reported, gauss.triangles,
        gauss.milliseconds, best.triangles, best.milliseconds);
    std::fflush(stdout);
  }
}
