// Border edges that take the sides of bicubic patches (kuriyama.md section 8).

#include "core/patching/joins/join_plan.hpp"

#include "core/analysis/continuity.hpp"
#include "core/patching/cross_boundary_fit.hpp"
#include "tests/patching/g2_support.hpp"
#include "tests/support/random_joins.hpp"

namespace hariko {
namespace {

using namespace test;

constexpr Mode modes[] = {Mode::paper, Mode::target, Mode::fair, Mode::g2};

JoinCase scaled(JoinCase given, double factor) {
  std::vector<Vector3> positions = given.polyhedron.positions();
  std::vector<Index> all;
  for (Index v = 0; v < positions.size(); ++v) {
    all.push_back(v);
    positions[v] *= factor;
  }
  given.polyhedron = given.polyhedron.with_positions(all, positions).value();
  for (Join& join : given.joins)
    for (auto* rows : {&join.curve, &join.row})
      for (Vector3& point : *rows) point *= factor;
  return given;
}

/// A square face and the sides round it, all of them smooth lines or corners as they come.
JoinCase square(std::uint64_t seed, bool both_smooth) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.add_face({0, 1, 2, 3});
  JoinCase out{Polyhedron::build(mesh).value(), {}, {}};
  std::mt19937_64 rng(seed);
  for (Index h = 0; h < 2; ++h) {
    const Vector3 a = mesh.positions[h], b = mesh.positions[h + 1], d = b - a;
    const Vector3 away = d.cross(Vector3::UnitZ()) / 3;
    Join join;
    join.half_edge = h;
    join.continuity = both_smooth || h == 0 ? Continuity::g1 : Continuity::g0;
    join.curve = {a, a + d / 3, b - d / 3, b};
    for (std::size_t i = 0; i < 4; ++i) join.row[i] = join.curve[i] + away;
    out.joins.push_back(join);
  }
  return out;
}

struct Largest {
  double jump = 0, gap = 0, inner = 0, curvature = 0;
  int joins = 0;
  ~Largest() {
    std::printf("joins %d  largest normal jump %.2e rad  gap %.2e of the size  inner seams %.2e rad", joins,
                jump, gap, inner);
    std::printf(curvature > 0 ? ", curvature %.2e rms\n" : "\n", curvature);
  }
};

/// A random case of any size: joined sides as they should be, and the rest of the surface as smooth as ever.
void expect_joined(std::mt19937_64& rng, std::span<const Mode> wanted, Largest& largest) {
  const double factor = chance(rng, 0.5) ? 1.0 : std::pow(10.0, uniform_int(rng, -3, 6));
  const JoinCase given = scaled(random_join_case(rng), factor);
  std::vector<std::pair<Mode, Frames>> ways;
  for (const Mode mode : wanted) {
    ways.emplace_back(mode, Frames::equal);
    if (mode != Mode::paper) ways.emplace_back(mode, Frames::metric);
  }
  for (const auto& [mode, frames] : ways) {
    PolyhedronSurfacer surfacer;
    PolyhedronSurfaceInput input = given.input(mode);
    input.frames = frames;
    const auto made = must(surfacer.rebuild(input));
    EXPECT_TRUE(made->report.fair_converged && made->report.g2_converged);
    for (const Join& join : given.joins) {
      const double open = gap(made->surface, join) / factor;
      EXPECT_LT(open, 1e-14);
      largest.gap = std::max(largest.gap, open);
      if (join.continuity == Continuity::g0) continue;
      ++largest.joins;
      const double jump = normal_jump(made->surface, join);
      EXPECT_LT(jump, 1e-10) << "mode " << int(mode) << " half-edge " << join.half_edge;
      largest.jump = std::max(largest.jump, jump);
    }
    const double inner = continuity(made->surface).largest_normal_jump.value_or(0);
    EXPECT_LT(inner, 1e-10);
    largest.inner = std::max(largest.inner, inner);
    if (mode != Mode::g2) continue;
    const Jumps jumps = jumps_of(made->surface);
    // A flat surface has the curvature that rounding gives it.
    EXPECT_LT(jumps.curvature, 1e-8 * std::max(jumps.rms, 1e-3 / factor));
    largest.curvature = std::max(largest.curvature, jumps.relative());
  }
}

TEST(Join, SurfaceTakesCurveAndTangentPlanes) {
  Largest largest;
  for_random(4101, 200,
             [&](std::mt19937_64& rng) { expect_joined(rng, std::span(modes).first(3), largest); });
}

TEST(Join, SurfaceOfModeG2TakesThemAndStaysCurvatureContinuous) {
  Largest largest;
  for_random(4102, 24, [&](std::mt19937_64& rng) { expect_joined(rng, std::span(modes).last(1), largest); });
}

/// A grid with one side joined: its corners keep one quadratic each, and curvature in the joined face tends
/// to it in proportion to the distance.
TEST(Join, VerticesKeepTheirCurvatureInModeG2) {
  int measured = 0;
  for_random(4103, 6, [&](std::mt19937_64& rng) {
    JoinCase given = random_join_case(rng, 1, 1);
    given.joins = {given.joins[rng() % given.joins.size()]};
    const auto made = must(PolyhedronSurfacer().rebuild(given.input(Mode::g2)));
    const G2PatchSet& set = g2_set(*made);
    for (Index p = 0; p < set.patch_count(); ++p)
      for (const int corner : {1, 2})
        ASSERT_EQ(set.second_order_at_corner(p, corner), CornerSecondOrder::exact);
    const double rms = jumps_of(made->surface).rms;
    const Index patch = given.joins.front().half_edge;
    for (const int corner : {1, 2}) {
      const auto away = [&](double radius, double turn) {
        const Vector2 at = corner_parameter(Domain::triangle, corner);
        const Vector2 to = side_parameter(Domain::triangle, corner == 1 ? 2 : 0, turn);
        return curvature(set.evaluate(patch, at + radius * (to - at), Order::second));
      };
      const auto limit = away(0, 0);
      // Sides that almost meet in one line make curvature so large that a radius of 1e-3 is not near.
      if (!limit || limit->tensor.norm() > 100) continue;
      ++measured;
      for (const double turn : {0.1, 0.5, 0.9}) {
        const auto near = away(1e-4, turn), far = away(1e-3, turn);
        ASSERT_TRUE(near && far);
        EXPECT_LT((near->tensor - limit->tensor).norm(),
                  0.2 * (far->tensor - limit->tensor).norm() + 1e-4 * rms);
      }
    }
  });
  EXPECT_GE(measured, repetitions(6));
}

/// Two sides that meet in a corner with different second fundamental forms: tangent planes still agree, and
/// the corner says that its curvature depends on the direction.
TEST(Join, SidesThatDisagreeInACornerKeepTheirTangentPlanesInModeG2) {
  JoinCase given = square(1, true);
  EXPECT_EQ(g2_set(PolyhedronSurfacer().rebuild(given.input(Mode::g2)).value()).second_order_at_corner(1, 1),
            CornerSecondOrder::exact);
  given.joins[0].row[2] += Vector3(0, 0, 0.2);  // a twist that the other side has not
  const auto made = PolyhedronSurfacer().rebuild(given.input(Mode::g2)).value();
  for (const Join& join : given.joins) EXPECT_LT(normal_jump(made.surface, join), 1e-10);
  EXPECT_EQ(g2_set(made).second_order_at_corner(1, 1), CornerSecondOrder::direction_dependent);
  EXPECT_EQ(g2_set(made).second_order_at_corner(0, 1), CornerSecondOrder::exact);
  const Jumps jumps = jumps_of(made.surface);
  EXPECT_LT(jumps.curvature, 1e-8 * jumps.rms);
}

Message refusal(const JoinCase& given, Mode mode = Mode::fair) {
  const auto made = PolyhedronSurfacer().rebuild(given.input(mode));
  EXPECT_FALSE(made.ok());
  return made.ok() ? Message{} : made.error();
}
const Element vertex_1 = element_of(VertexId{1});

TEST(Join, MessagesNameTheCorner) {
  EXPECT_TRUE(PolyhedronSurfacer().rebuild(square(1, true).input(Mode::fair)).ok());

  JoinCase twisted = square(1, true);  // the second patch rises: its plane at vertex 1 is another one
  twisted.joins[1].row[0] += Vector3(0, 0, 0.2);
  EXPECT_EQ(refusal(twisted).code, e_join_corner);
  EXPECT_EQ(refusal(twisted).element, vertex_1);
  EXPECT_NE(refusal(twisted).remedy.find("adapt"), std::string::npos);
  twisted.joins[1].continuity = Continuity::g0;  // then only its curve counts, which lies in the plane
  EXPECT_TRUE(PolyhedronSurfacer().rebuild(twisted.input(Mode::fair)).ok());
  twisted.joins[1].curve[1] += Vector3(0, 0, 0.2);
  EXPECT_EQ(refusal(twisted).code, e_join_corner);

  JoinCase open = square(1, true);
  open.joins[1].curve[0] += Vector3(1e-6, 0, 0);
  EXPECT_EQ(refusal(open).code, e_join_gap);
  EXPECT_EQ(refusal(open).element, vertex_1);

  JoinCase flat = square(1, true);  // almost one line
  for (auto* rows : {&flat.joins[1].curve, &flat.joins[1].row})
    for (Vector3& point : *rows) point = Vector3(1 + (point.y()), 0.02 * point.y() + (1 - point.x()), 0);
  EXPECT_EQ(refusal(flat).code, e_join_angle);
  EXPECT_EQ(refusal(flat).element, vertex_1);

  JoinCase fast = square(1, true);  // twice as fast across at one end as the sides beside allow
  fast.joins[1].continuity = Continuity::g0;
  fast.joins.push_back(fast.joins[1]);
  fast.joins[2].half_edge = 3;
  const Vector3 a(0, 1, 0), b(0, 0, 0);
  fast.joins[2].curve = {a, a + (b - a) / 3, b - (b - a) / 6, b};
  EXPECT_EQ(refusal(fast).code, e_join_twist);
  EXPECT_EQ(refusal(fast).element.kind, Element::Kind::vertex);

  JoinCase pinned = square(1, true);
  pinned.shaping.pin.set(VertexId{1}, {Pin::Kind::normal, {Vector3::UnitZ()}});
  EXPECT_EQ(refusal(pinned).code, e_join_pinned);

  JoinCase point = square(1, true);
  point.joins[0].curve[1] = point.joins[0].curve[0];
  EXPECT_EQ(refusal(point).code, e_join_degenerate);
}

void expect_live(std::mt19937_64& rng) {
  JoinCase given = random_join_case(rng);
  const Mode mode = modes[uniform_int(rng, 0, 3)];
  PolyhedronSurfacer surfacer;
  ASSERT_TRUE(surfacer.rebuild(given.input(mode)).ok());
  const auto largest = [&](const Surface& surface) {
    double out = 0;
    for (const Join& join : given.joins)
      out =
          std::max(out, join.continuity == Continuity::g0 ? gap(surface, join) : normal_jump(surface, join));
    return out;
  };
  // The polyhedron moves, first in a drag: joined vertices stay.
  const Index v = Index(uniform_int(rng, 0, int(given.polyhedron.vertex_count()) - 1));
  const Vector3 to = given.polyhedron.position(v) + random_vector(rng, 0.2);
  given.polyhedron = given.polyhedron.with_positions(std::span(&v, 1), std::span(&to, 1)).value();
  const auto dragged = must(surfacer.rebuild(given.input(mode), Quality::drag));
  EXPECT_LT(largest(dragged->surface), 1e-10);
  const auto released = must(surfacer.rebuild(given.input(mode)));
  EXPECT_LT(largest(released->surface), 1e-10);
  // All the sides move together.
  const Eigen::AngleAxisd turn(0.1, Vector3(1, 2, 3).normalized());
  for (Join& join : given.joins)
    for (auto* rows : {&join.curve, &join.row})
      for (Vector3& point : *rows) point = turn * point + Vector3(0.05, 0, 0.1);
  for (const Quality quality : {Quality::drag, Quality::final}) {
    const auto followed = must(surfacer.rebuild(given.input(mode), quality));
    EXPECT_LT(largest(followed->surface), 1e-10);
    if (quality == Quality::drag) continue;
    // Earlier rebuilds do not matter.
    const auto cold = PolyhedronSurfacer().rebuild(given.input(mode));
    for (Index h = 0; h < cold->surface.patch_count(); ++h)
      EXPECT_EQ(cold->surface.patches().evaluate(h, {0.3, 0.3}, Order::first).position,
                followed->surface.patches().evaluate(h, {0.3, 0.3}, Order::first).position);
  }
}

TEST(Join, StaysLiveWhenEitherSideMoves) {
  for_random(4501, 20, expect_live);
}

/// Cases where the moved vertex lies in a face with a joined half-turn corner.
TEST(Join, HalfTurnCornersStayInADrag) {
  for (const std::uint64_t seed : {85, 173, 4242471, 4242580}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 rng(seed);
    expect_live(rng);
  }
}

/// Surface first, by the curve alone; then the patch's row follows.
void expect_patch_adapts(std::uint64_t seed, int repeats, std::span<const Mode> wanted) {
  double largest = 0, share = 0;
  int count = 0;
  for_random(seed, repeats, [&](std::mt19937_64& rng) {
    const double factor = chance(rng, 0.5) ? 1.0 : std::pow(10.0, uniform_int(rng, -3, 6));
    JoinCase given = scaled(random_join_case(rng, 0.75, 0), factor);
    for (Join& join : given.joins) join.patch_follows = true;
    for (const Mode mode : wanted) {
      const auto made = must(PolyhedronSurfacer().rebuild(given.input(mode)));
      for (const Join& join : given.joins) {
        const AdaptedNet adapted =
            adapted_net(net_of(join), {{{0, 0}, cross_row(made->surface.patches(), join.half_edge)}});
        ASSERT_TRUE(adapted.adapted.front());
        Join after = join;
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_EQ(adapted.net.points[i], join.curve[i]);
          after.row[i] = adapted.net.points[4 + i];
          share = std::max(share, (after.row[i] - join.row[i]).norm() / factor);
        }
        const double jump = normal_jump(made->surface, after);
        EXPECT_LT(jump, 1e-10);
        largest = std::max(largest, jump);
        ++count;
      }
    }
  });
  std::printf("patches %d  largest normal jump %.2e rad  points moved up to %.2f\n", count, largest, share);
}

TEST(Join, PatchAdaptsToTheSurface) {
  expect_patch_adapts(4601, 200, std::span(modes).first(3));
}

TEST(Join, PatchAdaptsToTheSurfaceOfModeG2) {
  expect_patch_adapts(4602, 24, std::span(modes).last(1));
}

}  // namespace
}  // namespace hariko
