// Tension for short new edges: narrow bands must not make curves loop.

#include "core/modeling/operations/short_edges.hpp"

#include "core/modeling/cuts/loop_cut.hpp"
#include "core/modeling/operations/bevel_edges.hpp"
#include "core/modeling/operations/bevel_vertices.hpp"
#include "core/modeling/operations/extrude.hpp"
#include "core/modeling/operations/inset.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

int long_tangents(const PolyhedronSource& source) {
  const auto made = must(PolyhedronSurfacer().rebuild(surface_input(source).value()));
  int count = 0;
  for (const Message& message : made->warnings) count += message.code == w_long_tangent ? 1 : 0;
  return count;
}

TEST(ShortEdges, NarrowBandsDoNotLoop) {
  const PolyhedronSource cube = source_of(test::cube());
  const std::vector<FaceId> top{{1}};
  for (const double width : {0.02, 0.05, 0.1}) {
    const std::vector<PolyhedronSource> results{
        bevel_edges(cube, all_edges(cube), width).value().source,
        bevel_edges(cube, std::vector<EdgeId>{EdgeId::of({5}, {6})}, width).value().source,
        bevel_vertices(cube, all_vertices(cube), {width, BevelVerticesOptions::Measure::distance})
            .value()
            .source,
        inset_faces(cube, top, {.amount = width}).value().source,
        extrude_faces(cube, top, {.distance = width}).value().source,
        loop_cut(cube, EdgeId::of({0}, {4}), {.slide = -1 + width}).value().source};
    for (const PolyhedronSource& result : results) {
      EXPECT_EQ(long_tangents(result), 0);
      PolyhedronSource plain = result;
      plain.shaping = Shaping{};
      EXPECT_GT(long_tangents(plain), 0) << "without the tension they do";
    }
  }
}

TEST(ShortEdges, GivenTensionsAndOldEdgesAreLeftAlone) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.beta.set(EdgeId::of({5}, {6}), 0.5);
  cube.shaping = shaping;
  const EditResult out = extrude_faces(cube, std::vector<FaceId>{{1}}, {.distance = 0.1}).value();
  EXPECT_EQ(edges_of_tension(out.source, 0.5), 2) << "old and new rim";
  EXPECT_NEAR(out.source.shaping->beta.get_or(EdgeId::of({4}, {8}), 1), 400, 1e-9) << "(2 / 0.1) squared";
  EXPECT_EQ(out.source.shaping->beta.size(), 2U + 4U);
  const EditResult in_place = extrude_faces(cube, std::vector<FaceId>{{1}}).value();
  EXPECT_EQ(in_place.source.shaping->beta.size(), 2U) << "the drag that follows decides";
  const EditResult wide = extrude_faces(cube, std::vector<FaceId>{{1}}, {.distance = 1}).value();
  EXPECT_EQ(wide.source.shaping->beta.size(), 2U);
}

}  // namespace
}  // namespace hariko::test
