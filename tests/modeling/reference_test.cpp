// Vertices onto a scan, and cages whose surfaces are fitted to one.

#include <Eigen/Geometry>

#include "core/modeling/surfacing/fit_to_reference.hpp"
#include "core/modeling/surfacing/mirrored.hpp"
#include "core/modeling/surfacing/project_to_reference.hpp"
#include "core/surface/surface_triangles.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

/// Dense triangles of the surface of a polyhedron.
struct Scan {
  SurfaceTriangles net;
  Vector3 origin;

  explicit Scan(const PolyhedronSource& source) {
    const Surface surface = PolyhedronSurfacer().rebuild(surface_input(source).value()).value().surface;
    net = surface_triangles(surface, 16);
    origin = surface.origin();
  }
  FacetPart part(const Similarity& place = {}) const { return {net.positions, net.triangles, origin, place}; }
  ReferenceFacets seen_from(const PolyhedronSource& source, const Similarity& place = {}) const {
    const FacetPart only = part(place);
    return ReferenceFacets({&only, 1}, source.origin, place);
  }
};

PolyhedronSource with_moves(const PolyhedronSource& source, const std::vector<Vector3>& moves) {
  std::vector<Index> all;
  std::vector<Vector3> places;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
    all.push_back(v);
    places.push_back(source.polyhedron.position(v) + moves[v]);
  }
  PolyhedronSource out = source;
  out.polyhedron = source.polyhedron.with_positions(all, places).value();
  return out;
}

std::vector<Vector3> random_moves(const PolyhedronSource& source, std::mt19937_64& rng, double amount) {
  std::vector<Vector3> out;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v)
    out.push_back(amount * random_vector(rng).cwiseMax(-1).cwiseMin(1));
  return out;
}

double farthest_between(const PolyhedronSource& a, const PolyhedronSource& b) {
  double out = 0;
  for (Index v = 0; v < a.polyhedron.vertex_count(); ++v)
    out = std::max(out, (a.polyhedron.position(v) - b.polyhedron.position(v)).norm());
  return out;
}

/// Distance from all triangles, one after the other.
double plain_distance(const FacetPart& part, const Vector3& point) {
  double out = infinity;
  for (const auto& t : part.triangles)
    out = std::min(
        out,
        ClosedTriangle({part.positions[t[0]], part.positions[t[1]], part.positions[t[2]]}).distance(point));
  return out;
}

std::vector<PolygonMesh> cages() {
  return {cube(), prism(6), octahedron(), torus(8, 6), grid(5, 5), genus_box(1)};
}

TEST(ProjectToReference, VerticesLieOnTheScanAtTheNearestPoint) {
  for_random(311, 20, [](std::mt19937_64& rng) {
    const PolyhedronSource truth = source_of(random_polyhedron(rng));
    const Scan scan(truth);
    const double size = size_of(truth);
    const PolyhedronSource cage = with_moves(truth, random_moves(truth, rng, 0.2 * size));
    const auto done = must(project_to_reference(cage, all_vertices(cage), scan.seen_from(cage)));
    const auto again = project_to_reference(done->source, all_vertices(cage), scan.seen_from(cage));
    EXPECT_TRUE(again->source == done->source) << "what lies on the scan stays";
    FacetPart part = scan.part();
    std::vector<Vector3> seen;
    for (const Vector3& p : part.positions) seen.push_back(p + scan.origin - cage.origin);
    part.positions = seen;
    for (Index v = 0; v < cage.polyhedron.vertex_count(); ++v) {
      const Vector3 &before = cage.polyhedron.position(v), &after = done->source.polyhedron.position(v);
      EXPECT_LT(plain_distance(part, after), 1e-14 * size);
      EXPECT_NEAR((after - before).norm(), plain_distance(part, before), 1e-13 * size);
    }
  });
}

TEST(ProjectToReference, OfSeveralReferencesTheNearestCounts) {
  const std::vector<Vector3> corners{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const Triangles triangle{{0, 1, 2}};
  Similarity high{.translation = {0, 0, 1.5}};
  const std::array parts{FacetPart{corners, triangle, {0, 0, -1.25}, {}},
                         FacetPart{corners, triangle, {0, 0, 0}, high}};
  const PolyhedronSource cage = source_of(cube());
  const auto done = project_to_reference(cage, all_vertices(cage), ReferenceFacets(parts, cage.origin, {}));
  ASSERT_TRUE(done.ok());
  for (Index v = 0; v < 8; ++v) {
    const Vector3 before = cage.origin + cage.polyhedron.position(v);
    const Vector3 after = done->source.origin + done->source.polyhedron.position(v);
    const double height = std::abs(before.z() + 1.25) < std::abs(before.z() - 1.5) ? -1.25 : 1.5;
    EXPECT_LT((after - Vector3(before.x(), before.y(), height)).norm(), 1e-14);
  }
}

TEST(ProjectToReference, PinnedAttachedAndUnselectedVerticesStayAndSeamsStayInTheirPlane) {
  PolyhedronSource cage = source_of(grid(4, 4));
  const Scan scan(with_moves(cage, std::vector<Vector3>(25, Vector3(0.3, 0, 1))));
  Shaping shaping;
  shaping.pin.set(cage.polyhedron.vertex_id(6), {Pin::Kind::normal, {Vector3::UnitZ()}});
  cage.shaping = shaping;
  const EdgeId attached =
      cage.polyhedron.edge_id(cage.polyhedron.topology().edge(cage.polyhedron.topology().outgoing(0)));
  Attachments attachments;
  attachments.set(attached, {});
  cage.attachments = attachments;
  std::vector<VertexId> chosen = all_vertices(cage);
  chosen.pop_back();
  const auto done = must(project_to_reference(cage, chosen, scan.seen_from(cage)));
  for (Index v = 0; v < 25; ++v) {
    const VertexId id = cage.polyhedron.vertex_id(v);
    const bool stays = v == 6 || v == 24 || id == attached.low || id == attached.high;
    EXPECT_EQ(done->source.polyhedron.position(v) == cage.polyhedron.position(v), stays) << v;
  }
  EXPECT_EQ(*done->source.shaping, *cage.shaping);
  EXPECT_EQ(done->selection.vertices.size(), 24U);

  const std::vector<VertexId> pinned{cage.polyhedron.vertex_id(6)};
  expect_error(project_to_reference(cage, pinned, scan.seen_from(cage)), e_wrong_selection);
  expect_error(project_to_reference(cage, {}, scan.seen_from(cage)), e_nothing_selected);
}

TEST(FitToReference, PerturbedVerticesFindTheirSurfaceAgain) {
  std::mt19937_64 rng(random_seed(17));
  SCOPED_TRACE(random_seed(17));
  for (const PolygonMesh& mesh : cages())
    for (const Mode mode : {Mode::fair, Mode::target, Mode::g2}) {
      if (mode == Mode::g2 && mesh.positions.size() > 12) continue;  // takes long
      PolygonMesh uneven = mesh;
      perturb(uneven, rng, 0.1);
      PolyhedronSource truth = as_new(source_of(uneven));
      truth.mode = mode;
      const Scan scan(truth);
      const PolyhedronSource cage = with_moves(truth, random_moves(truth, rng, 0.1 * shortest_edge(uneven)));
      const auto fit = must(fit_to_reference(cage, all_vertices(cage), scan.seen_from(cage), {}));
      EXPECT_LT(fit->after.largest, fit->before.largest / 5) << mesh.positions.size();
      EXPECT_LT(fit->after.mean, fit->before.mean / 10) << mesh.positions.size();
      EXPECT_LE(fit->after.root_mean_square, fit->before.root_mean_square);
      EXPECT_GE(fit->steps, 2);
      EXPECT_EQ(*fit->source.shaping, *cage.shaping);
    }
}

TEST(FitToReference, WhatIsReportedIsTheDistanceOfTheNewSurface) {
  const PolyhedronSource truth = as_new(source_of(prism(5)));
  const Scan scan(truth);
  std::mt19937_64 rng(random_seed(5));
  SCOPED_TRACE(random_seed(5));
  const PolyhedronSource cage = with_moves(truth, random_moves(truth, rng, 0.1));
  const auto reference = scan.seen_from(cage);
  const auto fit = must(fit_to_reference(cage, all_vertices(cage), reference, {3}));
  EXPECT_EQ(fit->steps, 3);
  const auto again = must(fit_to_reference(fit->source, all_vertices(cage), reference, {1}));
  EXPECT_EQ(again->before.largest, fit->after.largest);
  EXPECT_EQ(again->before.mean, fit->after.mean);
  // Points of the new surface, measured without the fit; those of the fit are among them.
  const Surface surface = PolyhedronSurfacer().rebuild(surface_input(fit->source).value()).value().surface;
  double largest = 0;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (const Vector2& at : GridPattern{Domain::triangle, 24}.parameters())
      largest = std::max(largest, reference
                                      .foot(surface.patches().evaluate(p, at, Order::first).position +
                                            surface.origin() - cage.origin)
                                      .distance);
  EXPECT_LE(fit->after.largest, (1 + 1e-9) * largest);
  EXPECT_GE(fit->after.largest, 0.5 * largest);
}

TEST(FitToReference, IsTheSameInEverySizeAndPlaceAndEveryTime) {
  std::mt19937_64 rng(random_seed(23));
  SCOPED_TRACE(random_seed(23));
  const PolygonMesh mesh = torus(6, 5);
  const PolyhedronSource truth = as_new(source_of(mesh));
  const std::vector<Vector3> moves = random_moves(truth, rng, 0.1);
  const PolyhedronSource cage = with_moves(truth, moves);
  const auto plain = must(fit_to_reference(cage, all_vertices(cage), Scan(truth).seen_from(cage), {4}));
  const auto twice = fit_to_reference(cage, all_vertices(cage), Scan(truth).seen_from(cage), {4});
  EXPECT_TRUE(twice->source == plain->source) << "the same bits";
  const double size = size_of(cage);
  for (const double scale : {1e-3, 1.0, 1e3})
    for (const double far : {0.0, 1e6}) {
      SCOPED_TRACE(std::to_string(scale) + " at " + std::to_string(far));
      PolygonMesh other = mesh;
      for (Vector3& p : other.positions) p = scale * p + far * Vector3(1, -1, 0.5);
      const PolyhedronSource there = as_new(source_of(other));
      std::vector<Vector3> scaled = moves;
      for (Vector3& move : scaled) move *= scale;
      const PolyhedronSource moved = with_moves(there, scaled);
      const auto fit = must(fit_to_reference(moved, all_vertices(moved), Scan(there).seen_from(moved), {4}));
      const double rounding = 1e-6 * size + 1e-14 * far / scale * 1e5;
      EXPECT_EQ(fit->steps, plain->steps);
      for (Index v = 0; v < cage.polyhedron.vertex_count(); ++v)
        EXPECT_LT(((there.origin - far * Vector3(1, -1, 0.5) + fit->source.polyhedron.position(v)) / scale -
                   plain->source.origin - plain->source.polyhedron.position(v))
                      .norm(),
                  rounding);
      EXPECT_NEAR(fit->after.mean / scale, plain->after.mean, rounding);
    }
}

TEST(FitToReference, OnlyChosenVerticesMoveAndPinnedOnesStay) {
  const PolyhedronSource truth = as_new(source_of(grid(5, 5)));
  std::mt19937_64 rng(random_seed(31));
  PolyhedronSource cage = with_moves(truth, random_moves(truth, rng, 0.05));
  Shaping shaping;
  shaping.pin.set(cage.polyhedron.vertex_id(14), {Pin::Kind::normal, {Vector3::UnitZ()}});
  cage.shaping = shaping;
  const std::vector<VertexId> chosen{cage.polyhedron.vertex_id(7), cage.polyhedron.vertex_id(14),
                                     cage.polyhedron.vertex_id(15)};
  const auto fit = must(fit_to_reference(cage, chosen, Scan(truth).seen_from(cage), {}));
  for (Index v = 0; v < cage.polyhedron.vertex_count(); ++v)
    EXPECT_EQ(fit->source.polyhedron.position(v) != cage.polyhedron.position(v), v == 7 || v == 15) << v;
  EXPECT_LT(fit->after.root_mean_square, fit->before.root_mean_square);
}

TEST(FitToReference, HalvesOfALiveMirrorAreFittedWithTheSeamInItsPlane) {
  PolygonMesh mesh = grid(4, 4);
  double least = infinity;
  for (const Vector3& p : mesh.positions) least = std::min(least, p.x());
  for (Vector3& p : mesh.positions) {
    p.x() -= least;
    p.z() = 0.2 * p.x() * p.x();
  }
  PolyhedronSource truth = as_new(source_of(mesh));
  truth.mirror = Mirror{Axis::x, 1e-6};
  const Scan scan(truth);
  std::mt19937_64 rng(random_seed(41));
  std::vector<Vector3> moves = random_moves(truth, rng, 0.05);
  const std::vector<char> seam = mirror_seam(truth.polyhedron, truth.origin, *truth.mirror);
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (seam[v]) moves[v].x() = 0;
  const PolyhedronSource cage = with_moves(truth, moves);
  const auto fit = must(fit_to_reference(cage, all_vertices(cage), scan.seen_from(cage), {}));
  EXPECT_LT(fit->after.mean, fit->before.mean / 5);
  for (Index v = 0; v < cage.polyhedron.vertex_count(); ++v) {
    if (!seam[v]) continue;
    EXPECT_EQ(fit->source.polyhedron.position(v).x(), cage.polyhedron.position(v).x());
  }
}

TEST(FitToReference, AScanOfAPartSaysNothingBeyondItsBorder) {
  PolygonMesh flat = grid(8, 8);
  for (Vector3& p : flat.positions) p.z() = 0;
  const PolyhedronSource cage = as_new(source_of(flat));
  // A sheet over the middle, higher than the cage.
  const double side = size_of(cage) / 4;
  const Vector3 centre = cage.origin + (cage.polyhedron.position(40)) + Vector3(0, 0, 0.1);
  const std::vector<Vector3> sheet{centre + Vector3(-side, -side, 0) / 2,
                                   centre + Vector3(side, -side, 0) / 2, centre + Vector3(side, side, 0) / 2,
                                   centre + Vector3(-side, side, 0) / 2};
  const Triangles triangles{{0, 1, 2}, {0, 2, 3}};
  const FacetPart part{sheet, triangles, Vector3::Zero(), {}};
  const ReferenceFacets reference({&part, 1}, cage.origin, {});
  const auto fit = must(fit_to_reference(cage, all_vertices(cage), reference, {}));
  EXPECT_GT(fit->before.beyond, fit->before.counted);
  EXPECT_NEAR(fit->before.mean, 0.1, 0.02);
  EXPECT_LT(fit->after.mean, 0.01);
  const Vector3 middle = fit->source.origin + fit->source.polyhedron.position(40);
  EXPECT_NEAR(middle.z(), centre.z(), 0.01);
  EXPECT_LT(farthest_between(fit->source, cage), 0.3) << "nothing flies away";

  PolyhedronSource beside = cage;
  beside.origin += Vector3(100, 0, 0);
  expect_error(
      fit_to_reference(beside, all_vertices(beside), ReferenceFacets({&part, 1}, beside.origin, {}), {}),
      e_wrong_selection);
  expect_error(fit_to_reference(cage, all_vertices(cage), reference, {0}), e_bad_amount);
  const CancelToken cancelled = CancelToken::make();
  cancelled.cancel();
  expect_error(fit_to_reference(cage, all_vertices(cage), reference, {}, cancelled), e_cancelled);
  const Progress progress = Progress::make();
  ASSERT_TRUE(fit_to_reference(cage, all_vertices(cage), reference, {2}, {}, progress).ok());
  EXPECT_GT(progress.fraction(), 0.3);
}

TEST(FitToReference, NoiseOfAScanMovesTheVerticesLittleFartherThanItself) {
  std::mt19937_64 rng(random_seed(53));
  SCOPED_TRACE(random_seed(53));
  const PolyhedronSource truth = as_new(source_of(torus(8, 6)));
  Scan scan(truth);
  const double noise = 0.01;
  for (Vector3& p : scan.net.positions) p += random_vector(rng, noise);
  const auto fit = must(fit_to_reference(truth, all_vertices(truth), scan.seen_from(truth), {}));
  EXPECT_LT(farthest_between(fit->source, truth), 3 * noise);
}

TEST(FitToReference, AnyPolyhedronIsFittedOrRefusedAndNeverFartherThanBefore) {
  int fitted = 0;
  for_random(6100, 40, [&](std::mt19937_64& rng) {
    const PolyhedronSource cage = random_shape_source(rng);
    const double size = size_of(cage);
    std::vector<Vector3> sheet;
    Triangles triangles;
    for (Index i = 0; i < 12; ++i) sheet.push_back(random_vector(rng, size));
    for (Index i = 0; i < 8; ++i)
      triangles.push_back({i, static_cast<Index>((i + 1) % 12), static_cast<Index>((i + 5) % 12)});
    const FacetPart part{sheet, triangles, cage.origin, {}};
    const auto chosen = random_vertices(cage, rng);
    const auto fit = fit_to_reference(cage, chosen, ReferenceFacets({&part, 1}, cage.origin, {}), {2});
    if (!fit) {
      EXPECT_TRUE(fit.error().code.name.starts_with("E_")) << to_string(fit.error());
      return;
    }
    ++fitted;
    EXPECT_LE(fit->after.root_mean_square, fit->before.root_mean_square);
    EXPECT_EQ(fit->source.polyhedron.shared_topology(), cage.polyhedron.shared_topology());
    for (const Vector3& p : fit->source.polyhedron.positions()) EXPECT_TRUE(p.allFinite());
  });
  EXPECT_GT(fitted, repetitions(40) / 3);
}

}  // namespace
}  // namespace hariko::test
