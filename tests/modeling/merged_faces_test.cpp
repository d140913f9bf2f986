// Faces in one plane merged on the way to the surface.

#include "core/modeling/surfacing/merged_faces.hpp"

#include <set>

#include "core/analysis/measures.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;

PolyhedronSource merging(const PolygonMesh& mesh) {
  return as_new(source_of(mesh));
}

/// Every face as a fan of triangles from one of its corners, the way STL files and tessellators have it.
PolygonMesh triangulated(const PolygonMesh& mesh) {
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      out.add_face(std::vector<Index>{face[0], face[i], face[i + 1]});
  }
  return out;
}

Surface surface_of(const PolyhedronSource& source) {
  PolyhedronSurfacer surfacer;
  return surfacer.rebuild(surface_input(source).value()).value().surface;
}

void expect_same_surface(const PolyhedronSource& a, const PolyhedronSource& b) {
  const Measures first = measure(surface_of(a)), second = measure(surface_of(b));
  EXPECT_NEAR(first.area, second.area, 1e-9 * second.area);
  EXPECT_NEAR(first.bending, second.bending, 1e-9 * second.bending);
  ASSERT_EQ(first.volume.has_value(), second.volume.has_value());
  if (first.volume) EXPECT_NEAR(*first.volume, *second.volume, 1e-9 * std::abs(*second.volume));
}

PolygonMesh flat_grid(int n, int m) {
  PolygonMesh mesh = grid(n, m);
  for (Vector3& p : mesh.positions) p.z() = 0;
  return mesh;
}

TEST(MergedFaces, TrianglesInOnePlaneMakeTheSurfaceOfTheirPolygon) {
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const Vector3& shift : {Vector3(0, 0, 0), Vector3(1e6, -1e6, 1e6)})
      for (PolygonMesh mesh : {cube(), prism(5), prism(32), pyramid(7)}) {
        if (scale < 1 && !shift.isZero(0)) continue;  // the digits of such files are not those of a plane
        for (Vector3& p : mesh.positions) p = scale * p + shift;
        const PolyhedronSource cage = merging(mesh), triangles = merging(triangulated(mesh));
        EXPECT_EQ(counts(with_merged_faces(triangles).value().source),
                  counts(with_merged_faces(cage)->source));
        expect_same_surface(triangles, cage);
      }
}

TEST(MergedFaces, FacesOfMoreSidesStay) {
  const PolyhedronSource source = merging(genus_box(1));
  EXPECT_TRUE(with_merged_faces(source)->groups.empty());
  EXPECT_EQ(with_merged_faces(source)->source, source);
}

TEST(MergedFaces, NothingIsMergedUnlessTheSourceSaysSo) {
  PolyhedronSource source = source_of(triangulated(cube()));
  EXPECT_FALSE(source.preparation.merge_coplanar);
  EXPECT_EQ(surface_input(source)->polyhedron.face_count(), 12U);
  source.preparation.merge_coplanar = true;
  EXPECT_EQ(surface_input(source)->polyhedron.face_count(), 6U);
}

TEST(MergedFaces, EdgesWithSettingsStay) {
  const PolyhedronSource plain = merging(triangulated(cube()));
  // The diagonal of the first face.
  const HalfEdgeMesh& mesh = plain.polyhedron.topology();
  EdgeId diagonal;
  for (Index e = 0; e < plain.polyhedron.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    if (mesh.face(h) <= 1 && mesh.face(mesh.twin(h)) <= 1) diagonal = plain.polyhedron.edge_id(e);
  }
  const auto faces_with = [&](const auto& change) {
    PolyhedronSource source = plain;
    Shaping shaping;
    change(shaping);
    source.shaping = shaping;
    return with_merged_faces(source)->source.polyhedron.face_count();
  };
  EXPECT_EQ(faces_with([](Shaping&) {}), 6U);
  EXPECT_EQ(faces_with([&](Shaping& s) { s.crease.set(diagonal, true); }), 7U);
  EXPECT_EQ(faces_with([&](Shaping& s) { s.beta.set(diagonal, 2); }), 7U);
  EXPECT_EQ(faces_with([&](Shaping& s) { s.alpha.set(diagonal.low, 2); }), 6U)
      << "a tension of a vertex needs no edge that goes";
  EXPECT_GT(faces_with([&](Shaping& s) {
              s.pin.set(diagonal.low, {Pin::Kind::tangents, {{0.1, 0, 0}, {0, 0.1, 0}}});
            }),
            6U)
      << "pinned tangents are those of the edges that are there";
}

TEST(MergedFaces, FacesThatLeanByMoreThanTheAngleStay) {
  PolygonMesh mesh = triangulated(flat_grid(2, 2));
  EXPECT_EQ(with_merged_faces(merging(mesh))->source.polyhedron.face_count(), 1U);
  for (const double lift : {1e-9, 1e-4}) {
    PolygonMesh bent = mesh;
    bent.positions[4].z() += lift;  // the one inside
    const auto merged = with_merged_faces(merging(bent));
    if (lift < 1e-6)
      EXPECT_EQ(merged->source.polyhedron.face_count(), 1U);
    else
      EXPECT_GT(merged->source.polyhedron.face_count(), 1U);
  }
}

TEST(MergedFaces, VerticesWithoutEdgesAreTold) {
  PolyhedronSource source = merging(triangulated(flat_grid(2, 2)));
  const auto warnings = merge_warnings_of(source);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, w_vertex_merged);
  EXPECT_EQ(warnings[0].element, element_of(VertexId{4}));
  Shaping shaping;
  shaping.tag.set({4}, VertexTag::smooth);
  source.shaping = shaping;
  EXPECT_TRUE(merge_warnings_of(source).empty()) << "a vertex with a setting keeps its edges";
  source.shaping = Shaping{};
  source.preparation.merge_coplanar = false;
  EXPECT_TRUE(merge_warnings_of(source).empty());
}

/// A frame round a hole: no polygon goes round it.
TEST(MergedFaces, RingsAreCutIntoDisks) {
  const PolygonMesh mesh = triangulated(flat_grid(5, 5));
  PolygonMesh ring;
  ring.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Vector3 middle = Vector3::Zero();
    for (const Index v : mesh.face(f)) middle += mesh.positions[v] / 3;
    const Vector3 all = (mesh.positions.front() + mesh.positions.back()) / 2;
    const double cell = (mesh.positions.back() - mesh.positions.front()).head<2>().cwiseAbs().minCoeff() / 5;
    if ((middle - all).head<2>().cwiseAbs().maxCoeff() > cell / 2)
      ring.add_face(std::vector<Index>(mesh.face(f).begin(), mesh.face(f).end()));
  }
  const PolyhedronSource source = merging(ring);
  const PolyhedronSource merged = with_merged_faces(source)->source;
  EXPECT_LT(merged.polyhedron.face_count(), source.polyhedron.face_count() / 4);
  EXPECT_GE(merged.polyhedron.face_count(), 2U);
  EXPECT_EQ(merged.polyhedron.topology().border_loop_count(), 2U);
  EXPECT_EQ(euler(merged), 0);
  expect_surface(source);
}

TEST(MergedFaces, NoFaceGetsMoreSidesThanTheModeTakes) {
  for (const Mode mode : {Mode::fair, Mode::g2}) {
    PolyhedronSource source = merging(triangulated(prism(200)));
    source.mode = mode;
    const Polyhedron polyhedron = with_merged_faces(source)->source.polyhedron;
    const Index most = largest_fair_side_count;
    Index found = 0;
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      found = std::max(found, polyhedron.topology().side_count(f));
    EXPECT_LE(found, most);
    EXPECT_GT(found, 4U);
    EXPECT_TRUE(PolyhedronSurfacer().rebuild(surface_input(source).value()).ok());
  }
}

TEST(MergedFaces, PatchesComeFromTheDesignersFaces) {
  const PolyhedronSource source = merging(triangulated(prism(6)));
  const Surface surface = surface_of(source);
  std::set<std::uint64_t> named;
  for (const Provenance& each : surface.provenance()) {
    ASSERT_EQ(each.element.kind, Element::Kind::face);
    EXPECT_NE(source.polyhedron.find(FaceId{static_cast<std::uint32_t>(each.element.id)}), no_index);
    named.insert(each.element.id);
  }
  // All triangles of the fans have an outer side but one in each cap at the most.
  EXPECT_GE(named.size(), source.polyhedron.face_count() - 4U);
  for (const Seam& seam : surface.seams())
    if (seam.source.kind == Element::Kind::edge)
      EXPECT_NE(source.polyhedron.find(EdgeId::from_packed(seam.source.id)), no_index);
}

TEST(MergedFaces, MergedFacesThatAreConcaveAreCut) {
  PolygonMesh mesh;
  // An L of three squares, as a prism: its caps are two squares and one, in one plane.
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {1.0, 0.0},
                               {2.0, 0.0},
                               {2.0, 1.0},
                               {1.0, 1.0},
                               {1.0, 2.0},
                               {0.0, 2.0},
                               {0.0, 1.0}})
      mesh.positions.emplace_back(x, y, z);
  const auto add = [&](std::vector<Index> face) { mesh.add_face(face); };
  add({7, 4, 1, 0});
  add({4, 3, 2, 1});
  add({6, 5, 4, 7});
  add({8, 9, 12, 15});
  add({9, 10, 11, 12});
  add({15, 12, 13, 14});
  for (Index i = 0; i < 8; ++i) add({i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8});
  const PolyhedronSource source = merging(triangulated(mesh));
  const auto merged = with_merged_faces(source);
  EXPECT_EQ(merged->groups.size(), 8U) << "two caps, two pairs of walls in one plane, four walls";
  const auto input = surface_input(source).value();
  for (Index f = 0; f < input.polyhedron.face_count(); ++f) {
    std::vector<Vector3> corners;
    for (const Index v : input.polyhedron.topology().face_vertices(f))
      corners.push_back(input.polyhedron.position(v));
    EXPECT_NE(classify_face(corners), FaceShape::concave);
  }
  expect_surface(source);
}

TEST(MergedFaces, WhatStaysTheSameKeepsItsTopology) {
  PolyhedronSource source = merging(triangulated(prism(8)));
  SurfaceInputCache cache;
  const auto before = surface_input(source, Quality::drag, &cache)->polyhedron.shared_topology();
  std::vector<Index> vertices;
  std::vector<Vector3> positions;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
    vertices.push_back(v);
    positions.push_back(1.5 * source.polyhedron.position(v));
  }
  source.polyhedron = source.polyhedron.with_positions(vertices, positions).value();
  const auto after = surface_input(source, Quality::drag, &cache);
  EXPECT_EQ(after->polyhedron.shared_topology(), before);
  EXPECT_EQ(after->polyhedron.positions(), surface_input(source)->polyhedron.positions());
}

}  // namespace
}  // namespace hariko
