// Ends of tubes.

#include "core/skinning/columns/skin_caps.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "core/skinning/evaluate_skin.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Closed sections across x, all of as many points, bent and of different sizes.
Skin random_tube(std::mt19937_64& rng, int sections) {
  Skin skin;
  for (int i = 0; i < 5; ++i) skin.path.points.push_back(Vector3(2 * i, 0, 0) + random_vector(rng, 0.1));
  const int points = uniform_int(rng, 4, 9);
  for (int k = 0; k < sections; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = double(k) / (sections - 1);
    section.closed = true;
    const Vector3 centre = evaluate(skin.path, section.v).position;
    const double radius = uniform(rng, 0.8, 1.6);
    for (int i = 0; i < points; ++i) {
      const double a = 2 * std::numbers::pi * i / points;
      section.points.push_back(
          {std::uint32_t(100 * k + i),
           centre + radius * Vector3(0, std::cos(a), std::sin(a)) + random_vector(rng, 0.05), false});
    }
    skin.sections.push_back(section);
  }
  skin.caps = Caps::dome;
  return skin;
}

TEST(SkinCaps, ADomeClosesTheTubeAndIsRound) {
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::smooth})
    for_random(901, 12, [&](std::mt19937_64& rng) {
      Skin skin = random_tube(rng, uniform_int(rng, 2, 4));
      skin.method = method;
      skin.smooth.parameters = ColumnParameters::uniform;
      const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
      const ControlMesh& control = made->result.mesh.control;
      EXPECT_GT(tube_volume(control.mesh), 0);
      EXPECT_TRUE(control.creases.empty());
      EXPECT_TRUE(made->surface.boundary_sides().empty()) << "there is a hole";
      std::map<std::pair<Index, Index>, int> edges;
      std::size_t corners = 0;
      for (std::size_t f = 0; f < control.mesh.face_count(); ++f) {
        const auto face = control.mesh.face(f);
        corners += face.size();
        for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
      }
      for (const auto& [edge, count] : edges) EXPECT_EQ(count, 1);
      // Euler: V - E + F of a sphere.
      EXPECT_EQ(control.mesh.positions.size() + control.mesh.face_count(), corners / 2 + 2);
      // Both ends reach beyond their sections, outwards, by less than half of their radius.
      for (const bool first : {true, false}) {
        const SkinSection& section = first ? skin.sections.front() : skin.sections.back();
        double end = 0, farthest = -1e9;
        for (const SectionPoint& p : section.points) end += p.position.x() / section.size();
        for (Index patch = 0; patch < made->surface.patch_count(); ++patch) {
          const double x = made->surface.patches().evaluate(patch, {0.5, 0.5}, Order::first).position.x();
          farthest = std::max(farthest, first ? end - x : x - end);
        }
        EXPECT_GT(farthest, 0.1);
        EXPECT_LT(farthest, 0.8);
      }
    });
}

TEST(SkinCaps, EndSectionsStayOnTheSurfaceUnderADome) {
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::smooth})
    for_random(902, 12, [&](std::mt19937_64& rng) {
      Skin skin = random_tube(rng, 3);
      skin.method = method;
      skin.smooth.parameters = ColumnParameters::uniform;
      const auto open = [&] {
        Skin without = skin;
        without.caps = Caps::none;
        return SkinSurfacer().surface(without, Vector3::Zero());
      }();
      const auto made = SkinSurfacer().surface(skin, Vector3::Zero());
      ASSERT_TRUE(made.ok() && open.ok());
      const auto miss = section_misses(skin, made->result.mesh, made->surface);
      const auto before = section_misses(skin, open->result.mesh, open->surface);
      for (const std::size_t k : {std::size_t(0), skin.sections.size() - 1}) {
        // As exact as the open tube is: a pleat goes through the section, a grid is near it. (With caps faces
        // are cut, and the samples lie elsewhere.)
        EXPECT_NEAR(miss[k].largest, before[k].largest, 0.02 * before[k].largest + 1e-9);
        if (method == SkinMethod::pleat) {
          EXPECT_LT(miss[k].same_parameter, 1e-10);
        }
      }
    });
}

/// Circles about the z axis at even heights from 0 to 40, with as many points and radii as are given; each
/// begins elsewhere.
Skin unequal_tube(const std::vector<std::pair<int, double>>& circles) {
  Skin skin;
  for (int i = 0; i < 4; ++i) skin.path.points.push_back(Vector3(0, 0, 40.0 * i / 3));
  for (std::size_t k = 0; k < circles.size(); ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = double(k) / double(circles.size() - 1);
    section.closed = true;
    const auto [points, radius] = circles[k];
    for (int i = 0; i < points; ++i) {
      const double a = 0.4 * double(k) + 2 * std::numbers::pi * i / points;
      section.points.push_back({std::uint32_t(100 * k) + std::uint32_t(i),
                                Vector3(radius * std::cos(a), radius * std::sin(a), 40 * section.v), false});
    }
    skin.sections.push_back(section);
  }
  skin.caps = Caps::dome;
  return skin;
}

void expect_round_domes_through_sections(const Skin& skin) {
  const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  EXPECT_TRUE(made->surface.boundary_sides().empty());
  const auto misses = section_misses(skin, made->result.mesh, made->surface);
  ASSERT_EQ(misses.size(), skin.sections.size());
  for (const SectionMiss& miss : misses) EXPECT_LT(miss.largest, 1e-9);
  // Both domes are highest at the axis: a dent would be lower there than round it.
  for (const bool top : {true, false}) {
    double radius = 0, height = 0, where = 0;
    for (const SectionPoint& p : (top ? skin.sections.back() : skin.sections.front()).points)
      radius = std::max(radius, p.position.head<2>().norm());
    for (Index patch = 0; patch < made->surface.patch_count(); ++patch)
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j) {
          const Vector3 p =
              made->surface.patches().evaluate(patch, Vector2(i / 8.0, j / 8.0), Order::first).position;
          const double above = top ? p.z() - 40 : -p.z();
          if (above > height) height = above, where = p.head<2>().norm();
        }
    EXPECT_GT(height, 0.2 * radius) << (top ? "top" : "bottom");
    EXPECT_LT(height, 0.5 * radius) << (top ? "top" : "bottom");
    EXPECT_LT(where, 0.2 * radius) << (top ? "top" : "bottom");
  }
}

TEST(SkinCaps, DomesOverUnequalSectionsPassThroughThem) {
  const auto complaint = must(read_skin_layout(data_text("dome_unequal_sections.json")));
  expect_round_domes_through_sections(*complaint);
  using Circles = std::vector<std::pair<int, double>>;
  for (const Circles& circles : {Circles{{7, 8}, {12, 14}, {5, 6}}, Circles{{6, 10}, {13, 10}},
                                 Circles{{8, 5}, {11, 12}, {17, 9}, {6, 4}}}) {
    SCOPED_TRACE(std::to_string(circles.front().first) + " to " + std::to_string(circles.back().first));
    expect_round_domes_through_sections(unequal_tube(circles));
  }
}

TEST(SkinCaps, FlatOnesLieInThePlaneOfTheirSection) {
  for_random(903, 8, [](std::mt19937_64& rng) {
    Skin skin = random_tube(rng, 3);
    skin.caps = Caps::flat;
    for (SkinSection* section : {&skin.sections.front(), &skin.sections.back()})
      for (SectionPoint& p : section->points) p.position.x() = section == &skin.sections.front() ? 0 : 8;
    const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
    EXPECT_TRUE(made->surface.boundary_sides().empty());
    int flat = 0;
    const SubdivisionPatchSet& patches = *subdivision_patches(made->surface);
    for (Index patch = 0; patch < patches.patch_count(); ++patch) {
      const auto face = patches.topology().mesh().mesh.face(patches.topology().face_of(patch));
      bool cap = true;
      for (const Index v : face)
        cap = cap && made->result.mesh.vertices[v].section == made->result.mesh.vertices[face[0]].section;
      if (!cap || made->result.mesh.vertices[face[0]].section < 0) continue;
      ++flat;
      const double end = made->result.mesh.vertices[face[0]].section == 0 ? 0 : 8;
      for (const Vector2& at : {Vector2(0.1, 0.2), Vector2(0.5, 0.5), Vector2(0.9, 0.7)})
        EXPECT_NEAR(patches.evaluate(patch, at, Order::first).position.x(), end, 1e-9);
    }
    EXPECT_EQ(flat, 2 * (patches.topology().cut() ? skin.sections.front().size() : 1));
  });
}

}  // namespace
}  // namespace hariko::test
