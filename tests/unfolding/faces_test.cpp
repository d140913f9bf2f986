// Faces of any number of sides: triangles of them, corners that are joined, and parts of large ones.

#include <cmath>
#include <numbers>

#include "core/geometry/polygon.hpp"
#include "core/polyhedron/repair.hpp"
#include "core/unfolding/cut_large_faces.hpp"
#include "core/unfolding/face_triangles.hpp"
#include "core/unfolding/join_corners.hpp"
#include "core/unfolding/pages/sheet_drawing.hpp"
#include "tests/support/random.hpp"
#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

using std::numbers::pi;

PolygonMesh box(const Vector3& size) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? size.x() : 0, i & 2 ? size.y() : 0, i & 4 ? size.z() : 0);
  mesh.add_face({0, 2, 3, 1});
  mesh.add_face({4, 5, 7, 6});
  mesh.add_face({0, 1, 5, 4});
  mesh.add_face({2, 6, 7, 3});
  mesh.add_face({0, 4, 6, 2});
  mesh.add_face({1, 3, 7, 5});
  return mesh;
}

/// A star of 2 n corners in a plane, every other one farther out.
std::vector<Vector3> star(int n, double inner, const Eigen::Quaterniond& turn, const Vector3& shift) {
  std::vector<Vector3> out;
  for (int i = 0; i < 2 * n; ++i) {
    const double a = pi * i / n, r = i % 2 ? inner : 1;
    out.push_back(turn * Vector3(r * std::cos(a), r * std::sin(a), 0) + shift);
  }
  return out;
}

/// Every face with corners of its own.
PolygonMesh unwelded(const PolygonMesh& mesh) {
  PolygonMesh out;
  std::vector<Index> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) {
      corners.push_back(static_cast<Index>(out.positions.size()));
      out.positions.push_back(mesh.positions[v]);
    }
    out.add_face(corners);
  }
  return out;
}

double area_of(const PolygonMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Vector3> corners;
    for (const Index v : mesh.face(f)) corners.push_back(mesh.positions[v]);
    sum += newell_normal(corners).norm() / 2;
  }
  return sum;
}

TEST(FaceTriangles, CoverConcaveFacesAtEveryScaleAndPlace) {
  for_random(3101, 60, [](std::mt19937_64& rng) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(uniform(rng, 0, 6), random_vector(rng).normalized()));
    const double scale = log_uniform(rng, 1e-3, 1e6);
    std::vector<Vector3> corners =
        star(uniform_int(rng, 3, 12), uniform(rng, 0.2, 0.9), turn, 10 * random_vector(rng));
    for (Vector3& p : corners) p *= scale;
    const auto triangles = face_triangles(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    const Vector3 normal = newell_normal(corners);
    Vector3 sum = Vector3::Zero();
    for (const auto& [i, j, k] : triangles) {
      const Vector3 own = (corners[j] - corners[i]).cross(corners[k] - corners[i]);
      EXPECT_GT(own.dot(normal), 0) << "the same way round";
      sum += own;
    }
    EXPECT_LT((sum - normal).norm(), 1e-9 * normal.norm());
  });
}

TEST(FaceTriangles, CornersWithinSidesAreFineAndCrossingFacesHaveNone) {
  std::vector<Vector3> corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                               {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {0, 1, 0}};
  EXPECT_EQ(face_triangles(corners).size(), 6U);
  corners = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(face_triangles(corners).empty());
  corners = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  EXPECT_TRUE(face_triangles(corners).empty());
}

TEST(FacetGraph, FlatFacesHaveInnerEdgesAndBentOnesFolds) {
  const auto cube = must(FacetGraph::build(box({1, 2, 3})));
  EXPECT_EQ(cube->face_count(), 6U);
  EXPECT_EQ(cube->facet_count(), 12U);
  EXPECT_EQ(cube->edge_count(), 18U);
  std::size_t inner = 0;
  for (const FacetEdge& edge : cube->edges()) {
    inner += edge.inner ? 1 : 0;
    EXPECT_EQ(edge.inner, cube->face(edge.facets[0]) == cube->face(edge.facets[1]));
  }
  EXPECT_EQ(inner, 6U);
  for (Index f = 0; f < 6; ++f)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [facet, corner] = cube->face_corners(f)[k];
      EXPECT_EQ(cube->face(facet), f);
      EXPECT_EQ(cube->triangle(facet)[corner], box({1, 2, 3}).face(f)[k]);
    }
  PolygonMesh saddle;
  saddle.positions = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0}, {0, 1, 0.2}};
  saddle.add_face({0, 1, 2, 3});
  const auto bent = must(FacetGraph::build(saddle));
  for (const FacetEdge& edge : bent->edges()) EXPECT_FALSE(edge.inner);
  // Front and back of one quad: two faces with the same diagonal.
  PolygonMesh both;
  both.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  both.add_face({0, 1, 2, 3});
  both.add_face({3, 2, 1, 0});
  EXPECT_TRUE(FacetGraph::build(both).ok());
}

TEST(Unfolding, FlatFacesStayWholeWhateverTheMethod) {
  for (const CutMethod method : {CutMethod::search, CutMethod::reference})
    for (const CutGoal goal : {CutGoal::fewest, CutGoal::easiest}) {
      const auto graph = shared_graph(box({40, 60, 80}));
      const auto made = must(unfold(graph, {}, {.goal = goal, .method = method, .steps = 2000}));
      for (Index e = 0; e < graph->edge_count(); ++e)
        if (graph->edge(e).inner) {
          EXPECT_TRUE(made->folds[e]);
        }
      const SheetDrawing drawing = draw_sheets(*made);
      ASSERT_EQ(drawing.faces.size(), 6U);
      for (const DrawnFace& face : drawing.faces) EXPECT_EQ(face.corners.size(), 4U);
      EXPECT_EQ(drawing.folds.size() + made->joints.size(), 12U);
      for (const DrawnFold& fold : drawing.folds) EXPECT_NE(fold.kind, FoldKind::flat);
    }
}

TEST(JoinCorners, EqualPlacesJoinWhereTwoSidesMeet) {
  for_random(3102, 20, [](std::mt19937_64& rng) {
    PolygonMesh welded = chance(rng, 0.5) ? icosphere(1) : box({1, 2, 3});
    PolygonMesh loose = unwelded(welded);
    const std::size_t before = loose.positions.size();
    EXPECT_EQ(join_equal_corners(loose), before - welded.positions.size());
    const auto graph = must(FacetGraph::build(loose));
    EXPECT_EQ(graph->component_count(), 1U);
    for (const FacetEdge& edge : graph->edges()) EXPECT_FALSE(edge.border());
    EXPECT_EQ(join_equal_corners(loose), 0U) << "once is enough";
  });
}

TEST(JoinCorners, SolidsThatTouchStayTwo) {
  PolygonMesh two = box({1, 1, 1});
  const PolygonMesh one = two;
  const auto first = static_cast<Index>(two.positions.size());
  for (const Vector3& p : one.positions) two.positions.push_back(p + Vector3(1, 1, 0));
  for (std::size_t f = 0; f < one.face_count(); ++f) {
    std::vector<Index> face(one.face(f).begin(), one.face(f).end());
    for (Index& v : face) v += first;
    two.add_face(face);
  }
  PolygonMesh loose = unwelded(two);
  join_equal_corners(loose);
  for (const PolygonMesh* mesh : {&two, &loose}) {
    const auto graph = must(FacetGraph::build(*mesh));
    EXPECT_EQ(graph->component_count(), 2U);
  }
}

TEST(CutLargeFaces, EveryPartFitsThePageAndNothingIsLost) {
  for_random(3103, 5, [](std::mt19937_64& rng) {
    PolygonMesh mesh = box(Vector3(uniform(rng, 50, 700), uniform(rng, 50, 700), uniform(rng, 50, 700)));
    const bool round = chance(rng, 0.3);
    if (round) {
      mesh = icosphere(0);
      for (Vector3& p : mesh.positions) p *= 450;
    }
    PaperSettings settings;
    settings.scale = log_uniform(rng, 1e-3, 1e6);
    for (Vector3& p : mesh.positions) p /= settings.scale;
    const auto cut = must(cut_large_faces(mesh, settings));
    EXPECT_NEAR(area_of(cut->mesh), area_of(mesh), 1e-9 * area_of(mesh));
    const auto graph = must(FacetGraph::build(cut->mesh));
    EXPECT_EQ(graph->component_count(), 1U);
    for (const FacetEdge& edge : graph->edges()) EXPECT_FALSE(edge.border());
    if (round) return;  // packing so many triangles takes long
    const auto made = must(unfold(std::make_shared<const FacetGraph>(*graph), settings, {.steps = 200}));
    for (const Message& message : unfolding_messages(*made))
      EXPECT_NE(message.severity, Severity::error) << message.text;
    EXPECT_TRUE(overlapping_pairs(printed_polygons(*made), paper_tolerance(*made)).empty());
  });
}

TEST(CutLargeFaces, WhatFitsStaysAsItIs) {
  const PolygonMesh mesh = box({100, 120, 90});
  const auto same = must(cut_large_faces(mesh, {}));
  EXPECT_EQ(same->cut, 0U);
  EXPECT_EQ(same->mesh.face_vertices, mesh.face_vertices);
  PaperSettings large;
  large.scale = 0.998 * largest_uncut_scale(mesh, large);
  EXPECT_GT(large.scale, 1.5);
  EXPECT_EQ(cut_large_faces(mesh, large)->cut, 0U);
  large.scale *= 1.02;
  EXPECT_GT(cut_large_faces(mesh, large)->cut, 0U);
  large.scale = 200;
  must_fail(cut_large_faces(mesh, large), e_paper_setting);
}

TEST(CutLargeFaces, ConcaveFacesAreCutToo) {
  PolygonMesh mesh;
  for (const Vector3& p : star(5, 0.4, Eigen::Quaterniond::Identity(), Vector3::Zero()))
    mesh.positions.push_back(400 * p);
  mesh.add_face({0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  const auto cut = must(cut_large_faces(mesh, {}));
  EXPECT_EQ(cut->cut, 1U);
  EXPECT_NEAR(area_of(cut->mesh), area_of(mesh), 1e-6);
  const auto graph = must(FacetGraph::build(cut->mesh));
  EXPECT_EQ(graph->component_count(), 1U);
}

TEST(JoinCorners, AOneSidedStripStaysCut) {
  for (const int count : {3, 7, 15}) {
    PolygonMesh strip;
    for (int k = 0; k < count; ++k)
      for (const int side : {-1, 1}) {
        const double a = 2 * pi * k / count, r = 4 + side * std::cos(a / 2);
        strip.positions.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2));
      }
    const auto at = [&](int k, int side) {
      return static_cast<Index>(2 * (k % count) + (k >= count ? 1 - side : side));
    };
    for (int k = 0; k < count; ++k) {
      strip.add_face({at(k, 0), at(k + 1, 0), at(k + 1, 1)});
      strip.add_face({at(k, 0), at(k + 1, 1), at(k, 1)});
    }
    EXPECT_FALSE(FacetGraph::build(strip).ok());
    const auto repaired = must(make_manifold(strip));
    PolygonMesh cut = repaired->mesh;
    EXPECT_EQ(join_equal_corners(cut), 0U) << count;
    const auto graph = must(FacetGraph::build(cut));
    EXPECT_EQ(graph->component_count(), 1U);
  }
}

}  // namespace
}  // namespace hariko::test
