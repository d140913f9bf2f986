#include "core/cad/cad_model.hpp"

#include <algorithm>
#include <numbers>

#include "core/analysis/measures.hpp"
#include "core/base/parallel.hpp"
#include "core/cad/cad_measure.hpp"
#include "core/cad/fit/curve_fit.hpp"
#include "core/cad/fit/side_tie.hpp"
#include "core/subdivision/subdivision_surface.hpp"
#include "tests/cad/producers.hpp"

namespace hariko::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

bool is_closed(const Surface& surface) {
  return surface.boundary_sides().empty();
}

Vector3 start_of_side(const CadModel& model, Index face, int side) {
  const CadEdge& edge = model.edges[model.faces[face].sides[std::size_t(side)].front()];
  const bool first = edge.uses[0].piece == face && edge.uses[0].side == side;
  return model.vertices[first ? edge.begin : edge.end];
}

TEST(CadModel, FacesShareEdgesAndVerticesBitForBit) {
  std::size_t compared = 0;  // edges whose faces have no further knots along them
  for_produced([&](const Surface& surface) {
    const auto made = must(make_cad_model(surface));
    const CadModel& model = *made;
    EXPECT_EQ(model.closed(), is_closed(surface));
    for (const CadEdge& edge : model.edges) {
      EXPECT_EQ(edge.curve.points.front(), model.vertices[edge.begin]);
      EXPECT_EQ(edge.curve.points.back(), model.vertices[edge.end]);
      EXPECT_LE(edge.deviation, exact_face * model.size);
    }
    for (Index f = 0; f < model.faces.size(); ++f) {
      const SplineSurface& s = model.faces[f].surface;
      const std::array<Vector3, 4> corners{s.points[0], s.points[s.s.size() - 1], s.points.back(),
                                           s.points[s.index(0, s.t.size() - 1)]};
      for (int side = 0; side < 4; ++side)
        EXPECT_EQ(corners[std::size_t(side)], start_of_side(model, f, side)) << "face " << f;
    }
    // Both faces of an edge have its control points along it, where they have its knots.
    for (const CadEdge& edge : model.edges)
      for (int u = 0; u < edge.use_count; ++u) {
        const CadUse& use = edge.uses[std::size_t(u)];
        const SplineSurface& s = model.faces[use.piece].surface;
        const SplineSpace& space = use.side % 2 == 0 ? s.s : s.t;
        const SplineSpace along = (u == 0) == (use.side < 2) ? space : space.reversed();
        if (!(along == edge.curve.space)) continue;
        ++compared;
        for (std::size_t i = 0; i < space.size(); ++i) {
          const std::size_t at = (u == 0) == (use.side < 2) ? i : space.size() - 1 - i;
          const std::size_t point = use.side == 0   ? s.index(at, 0)
                                    : use.side == 1 ? s.index(s.s.size() - 1, at)
                                    : use.side == 2 ? s.index(at, s.t.size() - 1)
                                                    : s.index(0, at);
          ASSERT_EQ(s.points[point], edge.curve.points[i]);
        }
      }
  });
  EXPECT_GT(compared, 100U);
}

TEST(CadModel, KeepsTheToleranceAndStaysSmooth) {
  for_produced([](const Surface& surface) {
    const auto model = must(make_cad_model(surface));
    const CadMeasure measure = measure_cad(surface, *model);
    EXPECT_LE(measure.largest, usual_cad_tolerance * model->size);
    EXPECT_LE(measure.normal_jump, usual_cad_angle) << "edge " << measure.jump_edge;
  });
}

/// By the divergence theorem, with five places a span.
double volume_of(const CadModel& model) {
  double out = 0;
  const SpanPlaces& gauss = span_places(5);
  for (const CadFace& face : model.faces) {
    const SplineEvaluator spline(face.surface);
    for (std::size_t j = 0; j < face.surface.t.span_count(); ++j)
      for (std::size_t i = 0; i < face.surface.s.span_count(); ++i)
        for (std::size_t a = 0; a < gauss.at.size(); ++a)
          for (std::size_t b = 0; b < gauss.at.size(); ++b) {
            const double width = span_width(face.surface.s, i), height = span_width(face.surface.t, j);
            const PatchPoint p = spline.at(face.surface.s.breaks[i] + gauss.at[a] * width,
                                           face.surface.t.breaks[j] + gauss.at[b] * height);
            out += width * height * gauss.weight[a] * gauss.weight[b] * p.position.dot(p.ds.cross(p.dt)) / 3;
          }
  }
  return out;
}

TEST(CadModel, FitsKeepTheVolume) {
  // Least squares alone leave all of a face on the side where its surface bends away: 7e-5 of a cube.
  for (const WantedSample& wanted : {WantedSample{"cube"}, WantedSample{"cube", Mode::g2}}) {
    const auto produced = surfaces_of(wanted);
    ASSERT_EQ(produced.size(), 1U);
    const auto model = must(make_cad_model(produced[0].surface));
    const std::optional<double> volume = measure(produced[0].surface).volume;
    ASSERT_TRUE(volume.has_value());
    EXPECT_NEAR(volume_of(*model) / *volume, 1, 1e-5);
  }
}

TEST(CadModel, CornersCostFewKnots) {
  // Curves that meet in a corner without a common quadratic form would crowd knots there.
  const auto produced = surfaces_of({"car"});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface, {.tolerance = 0.01}));
  const CadMeasure measured = measure_cad(produced[0].surface, *model);
  // Knots are halved at thresholds: builds that round differently differ by up to a tenth.
  EXPECT_LE(measured.control_points, 9000U);
  EXPECT_LE(measured.largest, std::max(0.01, usual_cad_tolerance * model->size));
  EXPECT_LE(measured.normal_jump, usual_cad_angle);
}

TEST(CadModel, DistancesAreNotOverestimatedWhereDerivativesJump) {
  // Across the diagonals of its squares the car's derivatives jump, and Newton's steps lead away from the
  // foot.
  const auto produced = surfaces_of({"car"});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface));
  for (const CadFace& face : model->faces) EXPECT_TRUE(face.reached);
  EXPECT_LE(measure_cad(produced[0].surface, *model).largest, usual_cad_tolerance * model->size);
}

TEST(CadModel, TighterTolerancesGiveNearerFaces) {
  const auto produced = surfaces_of({"fig2_open"});
  ASSERT_EQ(produced.size(), 1U);
  std::size_t before = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const auto model =
        must(make_cad_model(produced[0].surface, {.tolerance = tolerance, .share = 0, .angle = 0.1}));
    const CadMeasure measure = measure_cad(produced[0].surface, *model);
    EXPECT_LE(measure.largest, tolerance);
    EXPECT_GT(measure.control_points, before);
    before = measure.control_points;
  }
}

TEST(CadModel, FacesOfFourSidesAreOneFaceEach) {
  const auto smooth = surfaces_of({"cube", Mode::g2}), split = surfaces_of({"cube"});
  ASSERT_TRUE(smooth.size() == 1 && split.size() == 1);
  const auto model = must(make_cad_model(smooth[0].surface));
  EXPECT_EQ(model->faces.size(), 6U);
  EXPECT_EQ(model->edges.size(), 12U);
  EXPECT_EQ(model->vertices.size(), 8U);
  EXPECT_TRUE(model->closed());
  EXPECT_EQ(cad_pieces(split[0].surface, CadPieces::faces).size(), 6U);
  EXPECT_EQ(cad_pieces(split[0].surface, CadPieces::patches).size(), 72U);
}

TEST(CadModel, FansAreTheSurfaceOfTheirTriangles) {
  const auto produced = surfaces_of({"cube"});
  ASSERT_EQ(produced.size(), 1U);
  const Surface& surface = produced[0].surface;
  for (const CadPiece& piece : cad_pieces(surface, CadPieces::faces)) {
    ASSERT_EQ(piece.cells[0].fan.size(), 4U);
    // The middle is the split point, and sides run as those of the triangles.
    const PieceEvaluator points(surface, piece);
    const PatchPoint middle = points.at(0.5, 0.5);
    EXPECT_LT(
        (middle.position - surface.patches().evaluate(piece.cells[0].fan[0], {0, 0}, Order::first).position)
            .norm(),
        1e-12);
    for (int side = 0; side < 4; ++side)
      for (const double x : {0.0, 0.3, 1.0}) {
        const Vector2 at = piece.parameter(side, x);
        const Vector3 want = surface.patches()
                                 .evaluate(piece.cells[0].fan[std::size_t(side)],
                                           side_parameter(Domain::triangle, 1, x), Order::first)
                                 .position;
        EXPECT_LT((points.at(at.x(), at.y()).position - want).norm(), 1e-12);
      }
  }
}

TEST(CadModel, AnglesAreMetAndCostKnots) {
  const auto produced = surfaces_of({"cube", Mode::g2});
  ASSERT_EQ(produced.size(), 1U);
  std::size_t before = 0;
  for (const double angle : {1.0, 0.2, 0.02}) {
    const auto model =
        must(make_cad_model(produced[0].surface, {.tolerance = 0.05, .share = 0, .angle = angle * degree}));
    const CadMeasure measure = measure_cad(produced[0].surface, *model);
    EXPECT_LE(measure.normal_jump, angle * degree);
    EXPECT_GE(measure.control_points, before);
    before = measure.control_points;
  }
}

/// At the quality "fine", on surfaces that are smooth beside their vertices, closed, bordered and creased.
TEST(CadModel, FacesOfModeG2HaveCurvaturesInCommon) {
  for (const char* name : {"cube", "torus", "fig2", "fig2_open", "grid3", "cube_crease"}) {
    SCOPED_TRACE(name);
    const auto produced = surfaces_of({name, Mode::g2});
    ASSERT_EQ(produced.size(), 1U);
    const auto model =
        must(make_cad_model(produced[0].surface, {.tolerance = 1e-3, .share = 1e-5, .angle = 0.02 * degree}));
    const CadMeasure measure = measure_cad(produced[0].surface, *model);
    EXPECT_LE(measure.curvature_jump, 0.02);
    EXPECT_LE(measure.normal_jump, 0.02 * degree);
    EXPECT_LE(measure.largest, std::max(1e-3, 1e-5 * model->size));
  }
}

/// Pointed rims of high tension all but fold beside their vertices. Knots there follow rounding: 10,868
/// points in an optimised build, 12,069 in one with sanitizers.
TEST(CadModel, TiesOfCurvatureCostLittleWhereFacesAllButFold) {
  const auto produced = surfaces_of({"fig5d", Mode::g2});
  const auto model = make_cad_model(produced[0].surface, {.tolerance = 0.05, .share = 0, .angle = degree});
  ASSERT_TRUE(model.ok());
  EXPECT_LE(measure_cad(produced[0].surface, *model).largest, 0.05);
  std::size_t points = 0;
  for (const CadFace& face : model->faces) points += face.surface.points.size();
  EXPECT_LE(points, 14000U);
}

/// The tie is linear in the control points and gives the face's own normal curvature across its side.
TEST(CadModel, BendTiesReadTheCurvatureAcrossASide) {
  const auto produced = surfaces_of({"torus", Mode::g2});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface));
  const SplineSurface& face = model->faces[0].surface;
  const SplineEvaluator spline(face);
  for (int side = 0; side < 4; ++side)
    for (const double f : {0.1, 0.45, 0.8}) {
      const bool horizontal = side % 2 == 0;
      const SplineSpace &along = horizontal ? face.s : face.t, &across = horizontal ? face.t : face.s;
      const double x = along.begin() + f * (along.end() - along.begin()),
                   y = side == 1 || side == 2 ? across.end() : across.begin();
      const PatchPoint point = horizontal ? spline.at(x, y, Order::second) : spline.at(y, x, Order::second);
      const Vector3 normal = unit_normal(point),
                    left = normal.cross(horizontal ? point.ds : point.dt).normalized();
      const Vector2 move = move_in(point, left);
      const double curvature = normal_bend(point, left).across;
      const SideTie tie =
          bend_tie(face, side, x, normal, horizontal ? move.x() : move.y(), horizontal ? move.y() : move.x());
      EXPECT_NEAR(tie.of(face), curvature, 1e-9 * std::max(1.0, std::abs(curvature)));
      EXPECT_GT(std::abs(curvature), 1e-3);
    }
}

TEST(CadModel, ExactFacesStayWhereTheyAreAskedFor) {
  const auto produced = surfaces_of({"cube", Mode::paper});
  ASSERT_EQ(produced.size(), 1U);
  const auto fitted = must(make_cad_model(produced[0].surface)),
             exact = must(make_cad_model(produced[0].surface, {.exact = true}));
  EXPECT_LE(measure_cad(produced[0].surface, *fitted).control_points,
            measure_cad(produced[0].surface, *exact).control_points);
}

TEST(CadModel, FacesStayWholeWhereThatIsAskedFor) {
  const auto produced = surfaces_of({"cube"});
  ASSERT_EQ(produced.size(), 1U);
  const Surface& surface = produced[0].surface;
  for (const double share : {1e-3, 2e-4}) {
    const auto model = must(make_cad_model(surface, {.share = share, .angle = degree, .whole_faces = true}));
    EXPECT_EQ(model->faces.size(), 6U);
    EXPECT_LE(measure_cad(surface, *model).largest, share * model->size);
  }
}

TEST(CadModel, PolynomialPatchesAreExact) {
  for (const WantedSample& wanted : {WantedSample{"wheel_arch"}, WantedSample{"skin_smooth"}}) {
    for (const Produced& produced : surfaces_of(wanted)) {
      if (produced.surface.domain() != Domain::square) continue;
      const auto model = must(make_cad_model(produced.surface));
      const CadMeasure measure = measure_cad(produced.surface, *model, 9);
      EXPECT_EQ(measure.exact, model->faces.size()) << produced.name;
      EXPECT_LE(measure.largest, 1e-12 * model->size);
    }
  }
}

TEST(CadModel, RegularFacesAreMergedIntoRectangles) {
  const auto produced = surfaces_of({"skin_smooth"});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface));
  // A tube of patches that all are one spline: two halves.
  EXPECT_LE(model->faces.size(), 4U);
  EXPECT_GT(produced[0].surface.patch_count(), 20U);
}

TEST(CadModel, NeighboursOfDividedSidesAreDivided) {
  const auto produced = surfaces_of({"skin_merge_inside"});
  ASSERT_EQ(produced.size(), 1U);
  const auto model = must(make_cad_model(produced[0].surface));
  // Each edge runs between two vertices that no other edge passes through: Euler's number is the surface's.
  const std::ptrdiff_t euler = std::ptrdiff_t(model->vertices.size()) - std::ptrdiff_t(model->edges.size()) +
                               std::ptrdiff_t(model->faces.size());
  EXPECT_EQ(euler, 1) << "a strip";
  std::size_t divided = 0;
  for (const CadFace& face : model->faces)
    for (const auto& side : face.sides) divided += side.size() > 1;
  EXPECT_GT(divided, 0U);
}

TEST(CadModel, SameForAnyNumberOfThreadsAndCanBeCancelled) {
  const auto produced = surfaces_of({"cube_crease"});
  ASSERT_EQ(produced.size(), 1U);
  const auto one = [&] {
    const ParallelLimit serial(1);
    return make_cad_model(produced[0].surface);
  }();
  const auto two = make_cad_model(produced[0].surface);
  ASSERT_TRUE(one.ok() && two.ok());
  for (std::size_t f = 0; f < one->faces.size(); ++f)
    EXPECT_EQ(one->faces[f].surface.points, two->faces[f].surface.points);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  must_fail(make_cad_model(produced[0].surface, {}, cancel), e_cancelled);
}

}  // namespace
}  // namespace hariko::test
