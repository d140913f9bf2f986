// Local editing: what is fixed stays, what is far does not change.

#include "core/modeling/surfacing/local_edit.hpp"

#include <Eigen/Geometry>

#include <set>

#include "core/document/edits/edits.hpp"
#include "core/patching/compare_surfaces.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;

const QuarticPatch& patch_of(const Surface& surface, Index p) {
  return dynamic_cast<const QuarticPatchSet&>(surface.patches()).patch(p);
}

double difference(const QuarticPatch& a, const QuarticPatch& b) {
  double largest = 0;
  for (std::size_t i = 0; i < quartic_control_count; ++i)
    largest = std::max(largest, (a.control[i] - b.control[i]).norm());
  return largest;
}

PolyhedronSource with_vertex_at(PolyhedronSource source, VertexId id, const Vector3& position) {
  const Index v = source.polyhedron.find(id);
  source.polyhedron = source.polyhedron.with_positions(std::span(&v, 1), std::span(&position, 1)).value();
  return source;
}

/// Half-edges (patches) of faces that share a vertex with a face round `id`.
std::set<Index> touched_patches(const Polyhedron& polyhedron, VertexId id) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::set<Index> near;
  for (const VertexId v : vertices_around(polyhedron, std::span(&id, 1))) near.insert(polyhedron.find(v));
  std::set<Index> out;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face_vertices(f);
    if (std::none_of(corners.begin(), corners.end(), [&](Index v) { return near.contains(v); })) continue;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) out.insert(h);
  }
  return out;
}

PolyhedronSource plain_source(std::mt19937_64& rng) {
  PolyhedronSource source = random_shape_source(rng);
  Shaping shaping = *source.shaping;
  shaping.pin = {};
  source.shaping = std::move(shaping);
  return source;
}

VertexId any_vertex(const PolyhedronSource& source, std::mt19937_64& rng) {
  for (;;) {
    const auto v = Index(rng() % source.polyhedron.vertex_count());
    if (source.polyhedron.topology().outgoing(v) != no_index) return source.polyhedron.vertex_id(v);
  }
}

Matrix3 any_turn(std::mt19937_64& rng) {
  const Eigen::AngleAxisd turn(uniform(rng, -0.5, 0.5), random_vector(rng).normalized());
  return uniform(rng, 0.5, 1.5) * turn.toRotationMatrix();
}

TEST(LocalEdit, FreezingLeavesTheSurfaceAsItIs) {
  for_random(4201, 40, [](std::mt19937_64& rng) {
    PolyhedronSource source = plain_source(rng);
    source.mode = static_cast<Mode>(uniform_int(rng, 0, 2));
    const VertexId v = any_vertex(source, rng);
    const auto around = vertices_around(source.polyhedron, std::span(&v, 1));
    const auto frozen = must(freeze_tangents(source, around));
    for (const VertexId id : around) EXPECT_TRUE(frozen->shaping->pin.contains(id));
    const auto before = PolyhedronSurfacer().rebuild(surface_input(source).value());
    const auto after = PolyhedronSurfacer().rebuild(surface_input(*frozen).value());
    if (!before) return;  // more sides than the mode takes
    for (Index p = 0; p < before->surface.patch_count(); ++p)
      EXPECT_LE(difference(patch_of(before->surface, p), patch_of(after->surface, p)),
                1e-11 * size_of(source));
  });
}

/// In modes PAPER and TARGET, from the unpinned surface: the first drag, and the cold surface of what it
/// leaves in the document.
TEST(LocalEdit, PatchesFarFromItStayBitForBit) {
  for_random(4202, 60, [](std::mt19937_64& rng) {
    PolyhedronSource source = plain_source(rng);
    source.mode = chance(rng, 0.5) ? Mode::paper : Mode::target;
    const VertexId v = any_vertex(source, rng);
    PolyhedronSurfacer surfacer;
    const auto before = must(surfacer.rebuild(surface_input(source).value()));

    const PolyhedronSource frozen =
        freeze_tangents(source, vertices_around(source.polyhedron, std::span(&v, 1))).value();
    PolyhedronSource edited = with_vertex_at(
        frozen, v,
        source.polyhedron.position(source.polyhedron.find(v)) + random_vector(rng, 0.1 * size_of(source)));
    const bool turns = chance(rng, 0.5);
    if (turns) edited = with_turned_tangents(edited, std::span(&v, 1), any_turn(rng));

    const auto touched = touched_patches(source.polyhedron, v);
    const auto pinned = PolyhedronSurfacer().rebuild(surface_input(frozen).value());
    const auto cold = PolyhedronSurfacer().rebuild(surface_input(edited).value());
    const auto dragged = surfacer.rebuild(surface_input(edited).value(), Quality::drag);
    const SurfaceComparison counted = compare_surfaces(cold->surface, pinned->surface);
    EXPECT_EQ(counted.patches, before->surface.patch_count());
    EXPECT_EQ(counted.unmatched, 0U);
    EXPECT_EQ(counted.unchanged + counted.changed, counted.patches);
    EXPECT_LE(counted.changed, touched.size());
    for (Index p = 0; p < before->surface.patch_count(); ++p) {
      // 1e-13 in all but one case of 150; rings add up rounding to 4.2e-13 in the worst of 1,800.
      EXPECT_LE(difference(patch_of(dragged->surface, p), patch_of(cold->surface, p)),
                1e-12 * size_of(source));
      if (touched.contains(p)) continue;
      EXPECT_EQ(difference(patch_of(cold->surface, p), patch_of(pinned->surface, p)), 0);
      if (!turns) {
        EXPECT_EQ(difference(patch_of(dragged->surface, p), patch_of(before->surface, p)), 0);
      }
    }
  });
}

TEST(LocalEdit, TurnedTangentsAreTheSurfacesOwn) {
  const PolyhedronSource source = source_of(test::torus(8, 6));
  const VertexId v = source.polyhedron.vertex_id(5);
  const PolyhedronSource frozen = freeze_tangents(source, std::span(&v, 1)).value();
  const Matrix3 turn = Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const auto before = PolyhedronSurfacer().rebuild(surface_input(frozen).value());
  const auto after = PolyhedronSurfacer().rebuild(
      surface_input(with_turned_tangents(frozen, std::span(&v, 1), turn)).value());
  EXPECT_LE((after->network->normal[5] - turn * before->network->normal[5]).norm(), 1e-14);
}

TEST(LocalEdit, InTheMirrorsPlaneThePlaneIsFixed) {
  PolyhedronSource half = source_of(test::grid(4, 4));
  half.mirror = Mirror{Axis::x, 1e-6};
  const double left = half.polyhedron.position(0).x() + half.origin.x();
  std::vector<VertexId> all;
  std::vector<Index> dense;
  std::vector<Vector3> moved;
  for (Index i = 0; i < half.polyhedron.vertex_count(); ++i) {
    all.push_back(half.polyhedron.vertex_id(i));
    dense.push_back(i);
    moved.push_back(half.polyhedron.position(i) - left * Vector3::UnitX());
  }
  half.polyhedron = half.polyhedron.with_positions(dense, moved).value();
  const auto frozen = must(freeze_tangents(half, all));
  int planes = 0, tangents = 0;
  for (const auto& [id, pin] : frozen->shaping->pin) (pin.kind == Pin::Kind::normal ? planes : tangents) += 1;
  EXPECT_GT(planes, 0);
  EXPECT_GT(tangents, 0);
  expect_surface(*frozen);
}

TEST(LocalEdit, RefusesWhatHasNoTangents) {
  const PolyhedronSource source = source_of(test::cube());
  const VertexId none{99};
  expect_error(freeze_tangents(source, std::span(&none, 1)), e_unknown_element);
}

}  // namespace
}  // namespace hariko
