// Live mirrors: the whole is a symmetric manifold, smooth across the plane, with names of the half; and
// mirrored objects.

#include <limits>

#include "core/analysis/continuity.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/cuts/bisect.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/modeling/operation_cases.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

/// The right half of a box: x = 0 .. 1, open at x = 0, where the vertices are off by up to 1e-4.
PolyhedronSource half_box() {
  PolygonMesh mesh = *make_primitive(BoxShape{{1, 2, 2}, {1, 2, 2}, {}});
  for (Vector3& p : mesh.positions) p.x() = p.x() < 0 ? 1e-4 * p.y() : 1;
  PolygonMesh open;
  open.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (std::any_of(mesh.face(f).begin(), mesh.face(f).end(),
                    [&](Index v) { return mesh.positions[v].x() > 0.5; }))
      open.add_face(mesh.face(f));
  PolyhedronSource source = source_of(remove_isolated_vertices(open));
  source.mirror = Mirror{Axis::x, 1e-3};
  return source;
}

/// A random mesh on one side of a random plane, with some stretches of border in it.
PolyhedronSource random_half(std::mt19937_64& rng) {
  PolyhedronSource source = test::random_source(rng);
  source.mirror = Mirror{static_cast<Axis>(test::uniform_int(rng, 0, 2)), 0};
  const Eigen::Index axis = index_of(source.mirror->axis);
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  double size = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    size = std::max(size, polyhedron.position(v).cwiseAbs().maxCoeff());
  source.mirror->weld_distance = 1e-3 * size;
  if (test::chance(rng, 0.7)) source.origin[axis] = 0;
  const bool whole_borders = test::chance(rng, 0.6);
  std::vector<Index> vertices;
  std::vector<Vector3> positions;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Vector3 p = polyhedron.position(v);
    const bool in_plane = mesh.is_border_vertex(v) && (whole_borders || test::chance(rng, 0.6));
    p[axis] = in_plane ? test::uniform(rng, -9e-4, 9e-4) * size : 0.1 * size + std::abs(p[axis]);
    p[axis] -= source.origin[axis];
    vertices.push_back(v);
    positions.push_back(p);
  }
  source.polyhedron = polyhedron.with_positions(vertices, positions).value();
  return source;
}

Vector3 reflected(Vector3 p, Axis axis) {
  p[index_of(axis)] *= -1;
  return p;
}

/// The largest distance of a point of the surface from the image of its image. The two halves of the patches
/// are half-edges [0, n) and [n, 2n), face by face.
double asymmetry(const Surface& surface, const HalfEdgeMesh& half, Axis axis) {
  double largest = 0;
  for (Index f = 0; f < half.face_count(); ++f)
    for (Index h = half.face_begin(f); h < half.face_end(f); ++h) {
      const Index image = half.half_edge_count() + half.face_begin(f) + half.face_end(f) - 1 - h;
      for (const Vector2& at : {Vector2(0.2, 0.5), Vector2(1.0 / 3, 1.0 / 3), Vector2(0.9, 0.05)}) {
        const Vector3 own = surface.patches().evaluate(h, at, Order::first).position;
        const Vector3 other = surface.patches().evaluate(image, {at.y(), at.x()}, Order::first).position;
        largest = std::max(largest, (own - reflected(other, axis)).norm());
      }
    }
  return largest;
}

TEST(Mirror, HalfABoxBecomesABox) {
  const PolyhedronSource half = half_box();
  const auto whole = test::must(mirrored(half));
  const Polyhedron& box = whole->polyhedron;
  EXPECT_EQ(half.polyhedron.vertex_count(), 17U);
  EXPECT_EQ(box.vertex_count(), 26U);
  EXPECT_EQ(box.face_count(), 24U);
  EXPECT_EQ(euler_number(box), 2);
  EXPECT_EQ(box.topology().border_loop_count(), 0U);
  EXPECT_NEAR(closed_component_volumes(box.topology(), box.positions())[0], 8, 1e-12);
  for (Index v = 0; v < box.vertex_count(); ++v)
    EXPECT_TRUE(std::abs(box.position(v).x()) == 1 || box.position(v).x() == 0);
  // Names: those of the half first, then the images'.
  for (Index f = 0; f < 12; ++f) {
    EXPECT_EQ(box.face_id(f), half.polyhedron.face_id(f));
    EXPECT_EQ(whole->aliases->original(box.face_id(12 + f)), half.polyhedron.face_id(f));
    EXPECT_TRUE(whole->aliases->is_copy(box.face_id(12 + f)));
  }
}

TEST(Mirror, SurfacesAreSmoothAcrossThePlaneAndSymmetric) {
  for (const Mode mode : {Mode::paper, Mode::target, Mode::fair}) {
    PolyhedronSource half = half_box();
    half.mode = mode;
    Shaping shaping;
    shaping.alpha.set(half.polyhedron.vertex_id(3), 2);
    shaping.beta.set(half.polyhedron.edge_id(5), 3);
    half.shaping = shaping;
    const auto input = test::must(surface_input(half));
    const auto made = test::must(PolyhedronSurfacer().rebuild(*input));
    const ContinuityReport report = continuity(made->surface);
    EXPECT_LE(*report.largest_normal_jump, 1e-10);
    EXPECT_LE(report.largest_gap, 1e-13);
    EXPECT_TRUE(made->surface.boundary_sides().empty());
    EXPECT_LE(asymmetry(made->surface, half.polyhedron.topology(), Axis::x),
              1e-12 * size_of(input->polyhedron));
    // Seams of the plane are inner and smooth; every name is one of the half.
    std::size_t across = 0;
    const Index first_image = half.polyhedron.topology().half_edge_count();
    for (const Seam& seam : made->surface.seams()) {
      if (seam.source.kind == Element::Kind::none) continue;
      EXPECT_NE(half.polyhedron.find(EdgeId::from_packed(seam.source.id)), no_index);
      if ((seam.first.patch < first_image) == (seam.second.patch < first_image)) continue;
      ++across;
      EXPECT_EQ(seam.intended, Continuity::g1);
    }
    EXPECT_EQ(across, 8U);
    for (Index p = 0; p < made->surface.patch_count(); ++p) {
      const Provenance& from = made->surface.provenance()[p];
      const Index f = half.polyhedron.find(FaceId{static_cast<std::uint32_t>(from.element.id)});
      ASSERT_NE(f, no_index);
      const Index own = half.polyhedron.topology().face_begin(f) + from.side;
      EXPECT_TRUE(p >= first_image || p == own);
    }
  }
}

TEST(Mirror, RandomHalves) {
  int done_count = 0, welded_count = 0;
  test::for_random(111, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource half = random_half(rng);
    const auto seam = mirror_seam(half.polyhedron, half.origin, *half.mirror);
    const auto whole = mirrored(half);
    if (!whole.ok()) {
      EXPECT_EQ(whole.error().code, e_mirror_nonmanifold);
      return test::expect_refusal(whole.error());
    }
    ++done_count;
    const HalfEdgeMesh& mesh = half.polyhedron.topology();
    const Polyhedron& polyhedron = whole->polyhedron;
    int seam_vertices = 0, seam_edges = 0;
    for (const char on : seam) seam_vertices += on;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const Index h = mesh.half_edge_of_edge(e);
      seam_edges += mesh.is_border_edge(e) && seam[mesh.origin(h)] && seam[mesh.target(h)];
    }
    welded_count += seam_edges > 0;
    EXPECT_EQ(euler_number(polyhedron), 2 * euler_number(half.polyhedron) - seam_vertices + seam_edges);
    EXPECT_EQ(polyhedron.face_count(), 2 * half.polyhedron.face_count());
    // Symmetric to the last bit, half by half.
    const Eigen::Index axis = index_of(half.mirror->axis);
    EXPECT_EQ(whole->origin[axis], 0);
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      const VertexId original = whole->aliases->original(polyhedron.vertex_id(v));
      const Index own = half.polyhedron.find(original);
      ASSERT_NE(own, no_index);
      const Vector3& p = polyhedron.position(polyhedron.find(original));
      EXPECT_TRUE(!seam[own] || polyhedron.position(v)[axis] == 0);
      if (!seam[own] && whole->aliases->is_copy(polyhedron.vertex_id(v))) {
        EXPECT_EQ(polyhedron.position(v), reflected(p, half.mirror->axis));
      }
    }
    // The same input gives the same result.
    const auto again = mirrored(half);
    EXPECT_TRUE(again->polyhedron == polyhedron && again->shaping == whole->shaping);
  });
  EXPECT_GT(done_count, test::repetitions(200));
  EXPECT_GT(welded_count, test::repetitions(80));
}

/// Checks the surface of a random half; false where it has none.
bool random_surface_is_symmetric_and_smooth(std::mt19937_64& rng) {
  PolyhedronSource half = random_half(rng);
  half.mode = static_cast<Mode>(test::uniform_int(rng, 0, 2));
  half.shaping = test::random_shaping(half.polyhedron, rng, 5, 0.3, 3);
  const auto input = surface_input(half);
  if (!input.ok()) return false;
  const auto made = test::must(PolyhedronSurfacer().rebuild(*input));
  const double size = size_of(input->polyhedron);
  EXPECT_LE(asymmetry(made->surface, half.polyhedron.topology(), half.mirror->axis), 1e-12 * size);
  EXPECT_LE(continuity(made->surface).largest_normal_jump.value_or(0), 1e-10);
  return true;
}

TEST(Mirror, RandomSurfacesAreSymmetricAndSmooth) {
  int done_count = 0;
  test::for_random(112, 40, [&](std::mt19937_64& rng) {
    if (random_surface_is_symmetric_and_smooth(rng)) ++done_count;
  });
  EXPECT_GT(done_count, test::repetitions(20));
}

/// Along one of its seams the derivatives are parallel to 3e-5 at a point, where normals are known to 1e-9
/// only.
TEST(Mirror, ANearlySingularPointOfASeamIsNoJump) {
  std::mt19937_64 rng(1952930211);
  EXPECT_TRUE(random_surface_is_symmetric_and_smooth(rng));
}

TEST(Mirror, MovingKeepsTheConnectivity) {
  test::for_random(113, 100, [](std::mt19937_64& rng) {
    PolyhedronSource half = random_half(rng);
    SurfaceInputCache kept;
    const auto first = surface_input(half, Quality::final, &kept);
    if (!first.ok()) return;
    const Index v = static_cast<Index>(rng() % half.polyhedron.vertex_count());
    const auto seam = mirror_seam(half.polyhedron, half.origin, *half.mirror);
    Vector3 p = half.polyhedron.position(v);
    for (Eigen::Index k = 0; k < 3; ++k)
      if (k != index_of(half.mirror->axis)) p[k] += half.mirror->weld_distance;
    half.polyhedron = half.polyhedron.with_positions(std::span(&v, 1), std::span(&p, 1)).value();
    const auto second = test::must(surface_input(half, Quality::final, &kept));
    EXPECT_EQ(second->polyhedron.shared_topology(), first->polyhedron.shared_topology());
    EXPECT_EQ(second->aliases, first->aliases);
    const auto fresh = surface_input(half);
    EXPECT_TRUE(fresh->polyhedron == second->polyhedron);
    EXPECT_TRUE(fresh->shaping == second->shaping);
    // A vertex that leaves the seam changes it.
    if (!seam[v]) return;
    p[index_of(half.mirror->axis)] += 10 * half.mirror->weld_distance;
    half.polyhedron = half.polyhedron.with_positions(std::span(&v, 1), std::span(&p, 1)).value();
    const auto third = surface_input(half, Quality::final, &kept);
    EXPECT_TRUE(!third.ok() || third->polyhedron.shared_topology() != first->polyhedron.shared_topology());
  });
}

TEST(Mirror, TheSeamStaysInThePlaneWhenMoved) {
  const PolyhedronSource half = half_box();
  const Document document = add_object({}, "Half", half)->document;
  const auto seam = mirror_seam(half.polyhedron, half.origin, *half.mirror);
  std::vector<VertexId> ids;
  std::vector<Vector3> positions;
  for (Index v = 0; v < half.polyhedron.vertex_count(); ++v) {
    ids.push_back(half.polyhedron.vertex_id(v));
    positions.push_back(half.polyhedron.position(v) + Vector3(0.5, 0.25, 0));
  }
  const auto moved = test::must(move_vertices(document, {1}, ids, positions));
  const PolyhedronSource& after = *moved->objects[0]->polyhedron();
  for (Index v = 0; v < after.polyhedron.vertex_count(); ++v) {
    const Vector3 p = after.origin + after.polyhedron.position(v);
    EXPECT_EQ(p.y(), half.origin.y() + half.polyhedron.position(v).y() + 0.25);
    EXPECT_TRUE(!seam[v] || p.x() == 0);
  }
  EXPECT_EQ(mirror_seam(after.polyhedron, after.origin, *after.mirror), seam);
}

TEST(Mirror, ApplyingGivesTheSameSurface) {
  PolyhedronSource half = half_box();
  Shaping shaping;
  shaping.alpha.set(half.polyhedron.vertex_id(2), 4);
  shaping.crease.set(half.polyhedron.edge_id(7), true);
  half.shaping = shaping;
  const Document document = add_object({}, "Half", half)->document;
  const auto applied = test::must(edit_polyhedron(document, {1}, apply_mirror));
  const PolyhedronSource& whole = *applied->document.objects[0]->polyhedron();
  EXPECT_FALSE(whole.mirror.has_value());
  EXPECT_EQ(applied->selection.faces.size(), half.polyhedron.face_count());
  EXPECT_EQ(whole.shaping->alpha.size(), 2U);
  EXPECT_EQ(whole.shaping->crease.size(), 2U);
  const auto live = PolyhedronSurfacer().rebuild(*surface_input(half));
  const auto own = PolyhedronSurfacer().rebuild(*surface_input(whole));
  for (Index p = 0; p < own->surface.patch_count(); ++p)
    EXPECT_EQ(own->surface.patches().evaluate(p, {0.3, 0.2}, Order::first).position,
              live->surface.patches().evaluate(p, {0.3, 0.2}, Order::first).position);
  EXPECT_EQ(edit_polyhedron(applied->document, {1}, apply_mirror).error().code, e_wrong_selection);
}

TEST(Mirror, PinsOfTheSeamAreTheirOwnImage) {
  PolyhedronSource half = half_box();
  const auto seam = mirror_seam(half.polyhedron, half.origin, *half.mirror);
  Index on = 0, off = 0;
  for (Index v = 0; v < half.polyhedron.vertex_count(); ++v) (seam[v] ? on : off) = v;
  Shaping shaping;
  const VertexId on_id = half.polyhedron.vertex_id(on), off_id = half.polyhedron.vertex_id(off);
  shaping.pin.set(on_id, {Pin::Kind::normal, {Vector3(1, 2, 3)}});
  shaping.pin.set(off_id, {Pin::Kind::normal, {Vector3(1, 2, 3)}});
  half.shaping = shaping;
  const auto whole = test::must(mirrored(half));
  EXPECT_EQ(whole->shaping.pin.find(on_id)->vectors[0], Vector3(0, 2, 3));
  EXPECT_EQ(whole->shaping.pin.find(off_id)->vectors[0], Vector3(1, 2, 3));
  bool found = false;
  for (const auto& [id, pin] : whole->shaping.pin)
    if (whole->aliases->is_copy(id)) {
      EXPECT_EQ(whole->aliases->original(id), off_id);
      EXPECT_EQ(pin.vectors[0], Vector3(-1, 2, 3));
      found = true;
    }
  EXPECT_TRUE(found);
}

TEST(Mirror, RefusesDoubledEdgesAndSillyDistances) {
  // The first of three quads in a row lies in the plane: its inner edge would have four faces.
  PolygonMesh strip = test::grid(3, 1);
  for (Vector3& p : strip.positions) p.x() = p.x() < 0 ? 0 : 1;
  PolyhedronSource source = source_of(strip);
  source.mirror = Mirror{Axis::x, 1e-6};
  const auto whole = mirrored(source);
  test::must_fail(whole, e_mirror_nonmanifold);
  EXPECT_EQ(whole.error().element, element_of(EdgeId{{1}, {5}}));
  test::expect_refusal(whole.error());
  const Document document = document_from_mesh(test::cube(), "Cube").value();
  for (const double bad :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    test::must_fail(set_mirror(document, {1}, Mirror{Axis::y, bad}), e_mirror_invalid);
  }
  const auto set = test::must(set_mirror(document, {1}, Mirror{Axis::y, 0.5}));
  EXPECT_FALSE(*set == document);
  EXPECT_TRUE(set_mirror(*set, {1}, std::nullopt).value() == document);
}

TEST(Halve, ABoxBecomesItsHalfAndTheMirrorGivesItBack) {
  for (const int segments : {1, 2, 3})
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      PolyhedronSource box =
          source_of(*make_primitive(BoxShape{{2, 4, 6}, {segments, segments, segments}, {}}));
      const Mirror mirror{axis, 1e-6};
      const auto half = test::must(halved(box, mirror));
      PolyhedronSource source = half->source;
      EXPECT_EQ(euler_number(source.polyhedron), 1);
      source.mirror = mirror;
      const auto whole = test::must(mirrored(source));
      EXPECT_EQ(euler_number(whole->polyhedron), 2);
      EXPECT_NEAR(closed_component_volumes(whole->polyhedron.topology(), whole->polyhedron.positions())[0],
                  48, 1e-12);
      EXPECT_EQ(halved(source, mirror)->source.polyhedron, source.polyhedron) << "a half is its own half";
    }
}

TEST(Halve, RandomMeshes) {
  int done_count = 0;
  test::for_random(116, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Mirror mirror{static_cast<Axis>(test::uniform_int(rng, 0, 2)), 0};
    const auto half = halved(source, mirror);
    if (!half.ok()) return test::expect_refusal(half.error());
    ++done_count;
    test::expect_sound(*half, source);
    for (Index v = 0; v < half->source.polyhedron.vertex_count(); ++v)
      EXPECT_GE(
          source.origin[index_of(mirror.axis)] + half->source.polyhedron.position(v)[index_of(mirror.axis)],
          0);
    PolyhedronSource live = half->source;
    live.mirror = mirror;
    const auto whole = mirrored(live);
    if (!whole.ok()) test::expect_refusal(whole.error());
  });
  EXPECT_GT(done_count, test::repetitions(120));
}

TEST(MirrorObject, TwiceIsTheSame) {
  test::for_random(114, 300, [](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Axis axis = static_cast<Axis>(test::uniform_int(rng, 0, 2));
    const EditResult image = mirror_object(source, axis);
    EXPECT_EQ(euler_number(image.source.polyhedron), euler_number(source.polyhedron));
    const auto volumes =
        closed_component_volumes(source.polyhedron.topology(), source.polyhedron.positions());
    const auto after =
        closed_component_volumes(image.source.polyhedron.topology(), image.source.polyhedron.positions());
    for (std::size_t i = 0; i < volumes.size(); ++i)
      EXPECT_NEAR(after[i], volumes[i], 1e-9 * std::abs(volumes[i])) << "outward stays outward";
    EXPECT_TRUE(mirror_object(image.source, axis).source == source);
  });
}

TEST(MirrorObject, PinnedTangentsGiveTheMirroredSurface) {
  test::for_random(115, 60, [](std::mt19937_64& rng) {
    PolyhedronSource source = source_of(test::random_polyhedron(rng));
    source.mode = Mode::target;
    Shaping shaping = test::random_shaping(source.polyhedron, rng, 5, 0.3, 3);
    const auto frames = test::must(build_vertex_frames(source.polyhedron, shaping));
    for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
      if (!test::chance(rng, 0.3)) continue;
      Pin pin{Pin::Kind::tangents, {}};
      for (Index b = frames->basis_begin[v]; b < frames->basis_begin[v + 1]; ++b)
        pin.vectors.push_back(test::random_vector(rng));
      if (!pin.vectors.empty()) shaping.pin.set(source.polyhedron.vertex_id(v), pin);
    }
    source.shaping = shaping;
    const EditResult image = mirror_object(source, Axis::y);
    const auto own = PolyhedronSurfacer().rebuild(*surface_input(source));
    const auto other = PolyhedronSurfacer().rebuild(*surface_input(image.source));
    ASSERT_TRUE(own.ok() && other.ok()) << to_string((own.ok() ? other : own).error());
    const HalfEdgeMesh& mesh = source.polyhedron.topology();
    const double size = size_of(source.polyhedron);
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        const Index opposite = mesh.face_begin(f) + mesh.face_end(f) - 1 - h;
        const Vector3 p = own->surface.patches().evaluate(h, {0.2, 0.5}, Order::first).position;
        const Vector3 q = other->surface.patches().evaluate(opposite, {0.5, 0.2}, Order::first).position;
        EXPECT_LE((p + own->surface.origin() - reflected(q + other->surface.origin(), Axis::y)).norm(),
                  1e-11 * size);
      }
  });
}

}  // namespace
}  // namespace hariko::test
