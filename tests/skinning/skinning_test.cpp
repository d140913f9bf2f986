// Properties of both methods beyond the acceptance table.

#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "core/skinning/columns/column_parameters.hpp"
#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

const std::vector<std::string>& input_names() {
  static const std::vector<std::string> names{
      "car_default", "car_edited", "fig5", "fig6a", "fig6b",  "fig6c", "fig9_interior", "fig9_section",
      "merge_split", "patch",      "ring", "sharp", "sharp3", "tube",  "tworail"};
  return names;
}

TEST(Pleat, EqualCountsGiveTheVirtualSurface) {
  Skin skin = skin_input("fig5");
  set_options(skin, "pleat_paper");
  auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  const VirtualSurface wanted(skin, made->result.plan);
  // Ten spans along the sections, four along the path; faces go along v first.
  const auto& mesh = made->result.mesh;
  for (Index f = 0; f < made->surface.patch_count(); ++f) {
    const auto face = mesh.control.mesh.face(f);
    const SkinVertex& a = mesh.vertices[face[0]];
    const int row = a.section == 0 ? 0 : a.row, line = a.section == 0 ? a.point : a.line;
    for (const Vector2& at : {Vector2(0, 0), Vector2(0.3, 0.8), Vector2(0.5, 0.5), Vector2(1, 0.25)}) {
      const Vector3 p = made->surface.patches().evaluate(f, at, Order::first).position;
      EXPECT_LT((p - wanted.point((line + at.y()) / 10, (row + at.x()) / 4)).norm(), 1e-13);
    }
  }
}

TEST(Pleat, PatchIsBilinear) {
  auto made = must(SkinSurfacer().surface(skin_input("patch"), Vector3::Zero()));
  const Vector3 p = made->surface.patches().evaluate(0, {0.5, 0.5}, Order::first).position;
  EXPECT_LT((p - Vector3(0.5, 0.5, 0.25)).norm(), 1e-15);
}

TEST(Pleat, InteriorSectionsAreInterpolatedOnAllInputs) {
  for (const std::string& name : input_names())
    for (const SectionFit fit : {SectionFit::local, SectionFit::fair}) {
      SCOPED_TRACE(name);
      Skin skin = skin_input(name);
      skin.method = SkinMethod::pleat;
      skin.pleat.fit = fit;
      auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
      EXPECT_TRUE(made->result.mesh.inexact.empty());
      for (const SectionMiss& miss : section_misses(skin, made->result.mesh, made->surface))
        EXPECT_LT(miss.same_parameter, 1e-10);
    }
}

TEST(Pleat, MergesAndLinksBesideInteriorSectionsStayExact) {
  for_random(711, 30, [](std::mt19937_64& rng) {
    // Random sections along a bent path, with random links.
    Skin skin;
    for (int i = 0; i < 6; ++i) skin.path.points.push_back(Vector3(i, std::sin(i * 0.7), 0.2 * i));
    skin.frame = chance(rng, 0.5) ? FrameMode::translate : FrameMode::rotation_minimising;
    const int count = uniform_int(rng, 3, 5);
    std::uint32_t id = 0;
    for (int k = 0; k < count; ++k) {
      SkinSection section;
      section.id = std::uint32_t(k);
      section.v = double(k) / (count - 1);
      const Vector3 base = evaluate(skin.path, section.v).position;
      const int n = uniform_int(rng, 3, 9);
      for (int i = 0; i < n; ++i)
        section.points.push_back(
            {id++, base + Vector3(0, 4.0 * i / (n - 1) - 2, 0) + random_vector(rng, 0.3), false});
      skin.sections.push_back(section);
    }
    for (int k = 0; k + 1 < count; ++k) {
      const SkinSection &a = skin.sections[std::size_t(k)], &b = skin.sections[std::size_t(k) + 1];
      if (a.size() >= 5 && b.size() >= 3 && chance(rng, 0.5)) {
        SkinMerge merge;
        merge.id = skin.free_link_id();
        merge.first = a.id, merge.second = b.id;
        const int at = uniform_int(rng, 1, a.size() - 4);
        for (int i = 0; i < uniform_int(rng, 2, 3); ++i)
          merge.members.push_back(a.points[std::size_t(at + i)].id);
        merge.target = b.points[std::size_t(uniform_int(rng, 1, b.size() - 2))].id;
        merge.v = uniform(rng, 0.2, 0.8);
        skin.merges.push_back(merge);
      } else if (chance(rng, 0.5)) {
        SkinLink link;
        link.id = skin.free_link_id();
        link.first = a.id, link.second = b.id;
        link.a = {a.points[std::size_t(uniform_int(rng, 0, a.size() - 1))].id};
        link.b = {b.points[std::size_t(uniform_int(rng, 0, b.size() - 1))].id};
        skin.links.push_back(link);
      }
    }
    auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
    // A merge and other lines may share a point of an interior section; that is told.
    const bool exact = made->result.mesh.inexact.empty();
    for (const SectionMiss& miss : section_misses(skin, made->result.mesh, made->surface)) {
      if (exact) {
        EXPECT_LT(miss.same_parameter, 1e-10);
      }
    }
    const auto& warnings = made->result.warnings;
    EXPECT_EQ(!exact, std::any_of(warnings.begin(), warnings.end(),
                                  [](const Message& m) { return m.code.name == "W_SECTION_NOT_EXACT"; }));
  });
}

TEST(Pleat, SymmetricCarHasASymmetricMesh) {
  Skin skin = skin_input("car_edited");
  auto result = must(evaluate_skin(skin));
  const auto& points = result->mesh.control.mesh.positions;
  EXPECT_EQ(result->mesh.control.mesh.face_count(), 170U);
  for (const Vector3& p : points) {
    const Vector3 image(p.x(), -p.y(), p.z());
    double nearest = 1;
    for (const Vector3& q : points) nearest = std::min(nearest, (q - image).norm());
    EXPECT_LT(nearest, 1e-12);
  }
}

/// Largest distance of the sides of a surface from the rails.
double miss_of_rails(const Skin& skin, const SkinSurface& made) {
  const auto& patches = *subdivision_patches(made.surface);
  double out = 0;
  for (const auto& strip : made.result.mesh.representative)
    for (std::size_t q = 0; q + 1 < strip.size(); ++q)
      for (const bool second : {false, true}) {
        const Index a = second ? strip[q].back() : strip[q].front();
        const Index b = second ? strip[q + 1].back() : strip[q + 1].front();
        auto sides = patches.topology().edge_sides(a, b);
        if (sides.empty()) sides = patches.topology().edge_sides(b, a);
        EXPECT_FALSE(sides.empty());
        for (const PatchSide& side : sides)
          for (const double x : {0.0, 0.3, 0.7, 1.0}) {
            const Vector3 p =
                patches.evaluate(side.patch, side_parameter(Domain::square, side.side, x), Order::first)
                    .position;
            out = std::max(out, nearest_point(second ? *skin.second_rail : skin.path, p).distance);
          }
      }
  return out;
}

TEST(Pleat, TwoRailSidesLieOnTheRails) {
  const Skin skin = skin_input("tworail");
  auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  // The ends of its middle section are written with six digits and lie 4.7e-7 beside the rails.
  EXPECT_LT(miss_of_rails(skin, *made), 5e-7);
}

/// The ends of its sections lie `beside` the rails in each coordinate; sections have 2 to `most` points.
Skin random_skin_between_rails(std::mt19937_64& rng, double beside, int most) {
  Skin skin;
  skin.frame = FrameMode::two_rail;
  skin.second_rail.emplace();
  const int count = uniform_int(rng, 3, 5);
  // Three spans a strip: rows lie on the rails' control points.
  for (int i = 0; i <= 3 * (count - 1); ++i) {
    skin.path.points.push_back(Vector3(i, -2, 0) + random_vector(rng, 0.3));
    skin.second_rail->points.push_back(Vector3(i, 2, 0) + random_vector(rng, 0.3));
  }
  std::uint32_t id = 0;
  for (int k = 0; k < count; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = double(k) / (count - 1);
    const Vector3 from = evaluate(skin.path, section.v).position + random_vector(rng, beside),
                  to = evaluate(*skin.second_rail, section.v).position + random_vector(rng, beside);
    const int n = uniform_int(rng, 2, most);
    for (int i = 0; i < n; ++i) {
      const double t = double(i) / (n - 1);
      const bool end = i == 0 || i + 1 == n;
      section.points.push_back(
          {id++, Vector3((1 - t) * from + t * to + (end ? Vector3(0, 0, 0) : random_vector(rng, 0.3))),
           false});
    }
    skin.sections.push_back(section);
  }
  return skin;
}

void check_between_rails(const Skin& skin, double beside) {
  auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  EXPECT_TRUE(made->result.mesh.inexact.empty());
  for (const SectionMiss& miss : section_misses(skin, made->result.mesh, made->surface))
    EXPECT_LT(miss.same_parameter, 1e-10);
  EXPECT_LT(miss_of_rails(skin, *made), 1e-9 + 2 * beside);
}

TEST(Pleat, BetweenRailsSectionsAreExactAndSidesAsNearAsTheirEnds) {
  for_random(713, 20, [](std::mt19937_64& rng) {
    const double beside = chance(rng, 0.5) ? 1e-6 : 0;
    Skin skin = random_skin_between_rails(rng, beside, 7);
    skin.pleat.fit = chance(rng, 0.5) ? SectionFit::fair : SectionFit::local;
    check_between_rails(skin, beside);
  });
}

/// All vertices beside the sections are held by the rails then.
TEST(Pleat, BetweenRailsSectionsOfTwoPointsAreExact) {
  for_random(714, 4, [](std::mt19937_64& rng) {
    Skin skin = random_skin_between_rails(rng, 1e-6, 2);
    for (const SectionFit fit : {SectionFit::fair, SectionFit::local}) {
      skin.pleat.fit = fit;
      check_between_rails(skin, 1e-6);
    }
  });
}

TEST(Pleat, CapsCloseTheTube) {
  for (const Caps caps : {Caps::flat, Caps::dome}) {
    Skin skin = skin_input("tube");
    skin.caps = caps;
    auto result = must(evaluate_skin(skin));
    EXPECT_GT(tube_volume(result->mesh.control.mesh), 0);
    std::map<std::pair<Index, Index>, int> directed;
    const PolygonMesh& mesh = result->mesh.control.mesh;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      for (std::size_t i = 0; i < mesh.face(f).size(); ++i)
        ++directed[{mesh.face(f)[i], mesh.face(f)[(i + 1) % mesh.face(f).size()]}];
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(directed.contains({edge.second, edge.first}));
    }
  }
}

TEST(Pleat, TipsAreAllowedAtBothEnds) {
  Skin skin = skin_input("tube");
  skin.sections.front().points.resize(1);
  skin.sections.back().points.resize(1);
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::smooth}) {
    skin.method = method;
    auto made = SkinSurfacer().surface(skin, Vector3::Zero());
    ASSERT_TRUE(made.ok()) << to_string(made.error());
  }
}

TEST(Smooth, WeightsAddUpAndAreCardinal) {
  for_random(712, 60, [](std::mt19937_64& rng) {
    const bool closed = chance(rng, 0.5);
    const int n = uniform_int(rng, 2, 7);
    std::vector<double> places{0};
    for (int k = 1; k < n; ++k) places.push_back(places.back() + uniform(rng, 0.2, 1));
    const double scale = closed ? 1 / (places.back() + 0.5) : 1 / places.back();
    for (double& v : places) v *= scale;
    for (const Blend blend : {Blend::automatic, Blend::linear, Blend::natural, Blend::hermite}) {
      const BlendWeights weights(places, closed, blend);
      for (int i = 0; i <= 40; ++i) {
        double sum = 0;
        for (const double w : weights.at(i / 40.0)) sum += w;
        ASSERT_NEAR(sum, 1, 1e-12);
      }
      for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
          ASSERT_NEAR(weights.at(places[std::size_t(k)])[std::size_t(j)], j == k, 1e-12);
    }
  });
}

TEST(Smooth, LimitPointsLieOnTheVirtualSurface) {
  for (const std::string& name : std::vector<std::string>{"fig5", "tube", "ring", "car_edited"}) {
    Skin skin = skin_input(name);
    skin.method = SkinMethod::smooth;
    skin.smooth.parameters = ColumnParameters::uniform;
    auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
    const SkinMesh& mesh = made->result.mesh;
    const VirtualSurface surface(skin, made->result.plan);
    const auto& patches = *subdivision_patches(made->surface);
    const int rows = mesh.grid_rows, columns = mesh.grid_columns;
    // Rows of sections are where the path's places are known without the distribution of rows.
    for (int k = 0; k < skin.section_count(); ++k)
      for (int c = 0; c < columns; ++c) {
        const Index v = mesh.section_rows[std::size_t(k)][std::size_t(c)];
        EXPECT_LT((patches.limit_position(v) -
                   surface.point(mesh.parameters[0][std::size_t(c)], skin.sections[std::size_t(k)].v))
                      .norm(),
                  1e-12)
            << name << rows;
      }
  }
}

TEST(Smooth, OptimisedParametersAreAsNearAsTheSpecificationFound) {
  const Skin skin = skin_input("fig5");
  const auto first = optimised_parameters({skin.sections[0].curve()}, 8);
  const auto second = optimised_parameters({skin.sections[1].curve()}, 8);
  EXPECT_LT(parameter_error({skin.sections[0].curve()}, first), 1.02 * 0.00426);
  EXPECT_LT(parameter_error({skin.sections[1].curve()}, second), 1.02 * 0.00191);
  EXPECT_GT(parameter_error({skin.sections[0].curve()}, uniform_parameters(8, false)), 0.01);
  for (const auto& u : {first, second})
    for (std::size_t c = 0; c + 1 < u.size(); ++c) EXPECT_LT(u[c], u[c + 1]);
}

TEST(Smooth, CornersOfAllSectionsBecomeCreasedColumns) {
  Skin skin = skin_input("sharp3");
  for (SkinSection& section : skin.sections)
    for (int i = 0; i < section.size(); ++i) section.points[std::size_t(i)].sharp = i == 2;
  skin.method = SkinMethod::smooth;
  skin.smooth.columns = 13;
  auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  EXPECT_EQ(int(made->result.mesh.control.creases.size()), made->result.mesh.grid_rows - 1);
  const auto& patches = *subdivision_patches(made->surface);
  const SubdivisionCurve curve = skin.sections[1].curve();
  double nearest = 1;
  for (const Index v : made->result.mesh.section_rows[1])
    nearest = std::min(nearest, (patches.limit_position(v) - curve.points[2]).norm());
  EXPECT_LT(nearest, 1e-12) << "the corner is on the surface";
}

TEST(Smooth, AnchorsOfLinksAlignFeatures) {
  Skin skin = skin_input("fig6b");
  skin.method = SkinMethod::anchored;
  auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  const VirtualSurface surface(skin, made->result.plan, *skin_anchors(skin, made->result.plan));
  ASSERT_EQ(surface.anchor_places().size(), 2U);
  // Links 2-3 and 6-5 of nine and seven points.
  EXPECT_NEAR(surface.parameter(0, surface.anchor_places()[0]), 2.0 / 8, 1e-14);
  EXPECT_NEAR(surface.parameter(1, surface.anchor_places()[0]), 3.0 / 6, 1e-14);
  EXPECT_NEAR(surface.parameter(0, surface.anchor_places()[1]), 6.0 / 8, 1e-14);
  EXPECT_NEAR(surface.parameter(1, surface.anchor_places()[1]), 5.0 / 6, 1e-14);
}

TEST(Frames, RotationMinimisingFramesCloseOnAClosedPath) {
  const Skin skin = skin_input("ring");
  auto plan = must(plan_skin(skin));
  EXPECT_LT((plan->frames.frame(0) - plan->frames.frame(1 - 1e-12)).norm(), 1e-6);
  for (int i = 0; i < 50; ++i) {
    const Matrix3 f = plan->frames.frame(i / 50.0);
    EXPECT_LT((f.transpose() * f - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_GT(f.col(2).dot(plan->frames.tangent(i / 50.0)), 0);
  }
}

TEST(Frames, AutomaticModeFollowsTheTurning) {
  Skin skin = skin_input("car_default");
  skin.frame = FrameMode::automatic;
  EXPECT_EQ(plan_skin(skin)->frames.mode(), FrameMode::translate);
  skin = skin_input("tube");
  skin.frame = FrameMode::automatic;
  EXPECT_EQ(plan_skin(skin)->frames.mode(), FrameMode::rotation_minimising);
}

TEST(SkinSurfacer, ADraggedPointKeepsTheTopology) {
  Skin skin = skin_input("car_edited");
  SkinSurfacer surfacer;
  auto before = must(surfacer.surface(skin, Vector3::Zero()));
  skin.sections[3].points[5].position.z() += 0.1;
  auto after = must(surfacer.surface(skin, Vector3::Zero()));
  EXPECT_TRUE(after->surface.same_adjacency(before->surface));
  auto fresh = SkinSurfacer().surface(skin, Vector3::Zero());
  EXPECT_EQ(fresh->result.mesh.control.mesh.positions, after->result.mesh.control.mesh.positions);
}

TEST(SkinSurfacer, FiftySectionsOfFortyPointsWork) {
  Skin skin;
  for (int i = 0; i < 60; ++i) skin.path.points.push_back(Vector3(i, 0, 0));
  std::uint32_t id = 0;
  for (int k = 0; k < 50; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = k / 49.0;
    const int n = 40 - k % 3;
    for (int i = 0; i < n; ++i) {
      const double angle = std::numbers::pi * i / (n - 1);
      const double r = 5 + std::sin(0.3 * k) + 0.3 * std::sin(6 * angle);
      section.points.push_back(
          {id++, Vector3(59.0 * section.v, r * std::cos(angle), r * std::sin(angle)), false});
    }
    skin.sections.push_back(section);
  }
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::smooth}) {
    skin.method = method;
    skin.smooth.parameters = ColumnParameters::uniform;
    auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
    EXPECT_GT(made->surface.patch_count(), 1000U);
  }
}

}  // namespace
}  // namespace hariko::test
