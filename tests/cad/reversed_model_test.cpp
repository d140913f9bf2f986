#include "core/cad/reversed_model.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "core/cad/cad_shells.hpp"
#include "tests/cad/producers.hpp"

namespace hariko::test {
namespace {

/// Begin of a side of a face, from its first edge.
Vector3 begin_of_side(const CadModel& model, Index face, int side) {
  const CadEdge& edge = model.edges[model.faces[face].sides[std::size_t(side)].front()];
  const bool first = edge.uses[0].piece == face && edge.uses[0].side == side;
  return model.vertices[first ? edge.begin : edge.end];
}

/// Point of a use at a share of an edge, on the face.
Vector3 point_of_use(const CadModel& model, const CadEdge& edge, std::size_t number, double share) {
  const CadUse& use = edge.uses[number];
  const double along = number == 0 ? share : 1 - share;
  const Vector2 at = model.pieces[use.piece].parameter(use.side, use.begin + along * (use.end - use.begin));
  return SplineEvaluator(model.faces[use.piece].surface).at(at.x(), at.y()).position;
}

TEST(ReversedModel, HasTheSameFacesThatMeetAsBefore) {
  for_produced([](const Surface& surface) {
    const auto made = must(make_cad_model(surface));
    const CadModel model = reversed(*made);
    ASSERT_EQ(model.faces.size(), made->faces.size());
    EXPECT_EQ(model.closed(), made->closed());
    for (Index f = 0; f < model.faces.size(); ++f) {
      const SplineSurface& s = model.faces[f].surface;
      const std::array<Vector3, 4> corners{s.points[0], s.points[s.s.size() - 1], s.points.back(),
                                           s.points[s.index(0, s.t.size() - 1)]};
      for (int side = 0; side < 4; ++side)
        EXPECT_EQ(corners[std::size_t(side)], begin_of_side(model, f, side)) << "face " << f;
    }
    for (const CadEdge& edge : model.edges) {
      EXPECT_EQ(edge.curve.points.front(), model.vertices[edge.begin]);
      EXPECT_EQ(edge.curve.points.back(), model.vertices[edge.end]);
      for (int u = 0; u < edge.use_count; ++u)
        for (const double share : {0.0, 0.3, 1.0}) {
          const Vector3 on_edge = evaluate(edge.curve, share * edge.curve.space.end()).position;
          const Vector3 on_face = point_of_use(model, edge, std::size_t(u), share);
          EXPECT_LT((on_edge - on_face).norm(), edge.deviation + 1e-9 * model.size);
        }
    }
  });
}

TEST(ReversedModel, LooksTheOtherWay) {
  for_produced([](const Surface& surface) {
    const auto made = must(make_cad_model(surface));
    const std::vector<CadShell> before = cad_shells(*made), after = cad_shells(reversed(*made));
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(after[k].closed, before[k].closed);
      EXPECT_NEAR(after[k].volume, -before[k].volume, 1e-9 * std::abs(before[k].volume));
    }
  });
}

TEST(ReversedModel, TwiceIsTheModelItself) {
  for_produced([](const Surface& surface) {
    const auto made = must(make_cad_model(surface));
    const CadModel twice = reversed(reversed(*made));
    for (Index f = 0; f < twice.faces.size(); ++f) {
      EXPECT_EQ(twice.faces[f].surface.points, made->faces[f].surface.points);
      EXPECT_EQ(twice.faces[f].sides, made->faces[f].sides);
    }
    for (std::size_t e = 0; e < twice.edges.size(); ++e) {
      EXPECT_EQ(twice.edges[e].begin, made->edges[e].begin);
      EXPECT_EQ(twice.edges[e].curve.points, made->edges[e].curve.points);
      EXPECT_EQ(twice.edges[e].uses[0].side, made->edges[e].uses[0].side);
    }
  });
}

}  // namespace
}  // namespace hariko::test
