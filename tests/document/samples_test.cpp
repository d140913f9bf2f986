// The sample documents: each opens, is written as the program writes, and becomes a surface.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/analysis/continuity.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/file.hpp"
#include "core/document/format/format.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/patching/g2_support.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

struct Expected {
  const char* name;
  Index vertices, edges, faces;
  std::size_t alpha, beta, crease;
};

const std::vector<Expected>& samples() {
  static const std::vector<Expected> list{
      {"fig2", 18, 30, 14, 0, 0, 0},       {"fig2_open", 18, 30, 13, 0, 0, 0},
      {"fig5c", 18, 30, 14, 0, 6, 0},      {"fig5d", 18, 30, 14, 6, 0, 0},
      {"concave", 16, 24, 10, 0, 0, 0},    {"concave_split", 16, 28, 14, 0, 0, 0},
      {"genus3", 64, 136, 68, 0, 0, 0},    {"cube", 8, 12, 6, 0, 0, 0},
      {"torus", 32, 64, 32, 0, 0, 0},      {"grid3", 16, 24, 9, 0, 0, 0},
      {"cube_crease", 8, 12, 6, 0, 0, 4},  {"car", 36, 66, 32, 0, 0, 0},
      {"knot", 1000, 2000, 1000, 0, 0, 0},
  };
  return list;
}

std::filesystem::path path_of(const std::string& name) {
  return std::filesystem::path(test::source_folder()) / "assets" / "samples" / (name + ".hariko");
}

const std::vector<std::pair<std::string, std::size_t>>& solid_samples() {
  static const std::vector<std::pair<std::string, std::size_t>> list{
      {"solids_one", 1},    {"solids_apart", 2}, {"solids_touching", 2}, {"solids_four", 4},
      {"solids_ten", 10},   {"solids_l", 2},     {"solids_t", 2},        {"solids_u", 3},
      {"solids_bottle", 3}, {"solids_dryer", 2}, {"solids_car", 2},      {"solids_camera", 3}};
  return list;
}

/// Name and number of loops.
const std::vector<std::pair<std::string, std::size_t>>& outline_samples() {
  static const std::vector<std::pair<std::string, std::size_t>> list{
      {"sphere_cap", 1},   {"ellipsoid_cap", 1}, {"paraboloid", 1}, {"sphere_band", 2},
      {"sphere_holes", 3}, {"catenoid", 2},      {"saddle", 1},     {"shell", 1}};
  return list;
}

struct ExpectedSkin {
  const char* name;
  int sections;
  std::size_t links, merges;
};

const std::vector<ExpectedSkin>& skin_samples() {
  static const std::vector<ExpectedSkin> list{
      {"skin_smooth", 2, 0, 0},  {"skin_ridges", 2, 0, 0},       {"skin_joined", 2, 2, 0},
      {"skin_grouped", 2, 2, 0}, {"skin_between", 2, 2, 0},      {"skin_car_smooth", 7, 28, 0},
      {"skin_car", 7, 28, 0},    {"skin_merge_inside", 2, 0, 1}, {"skin_merge_end", 2, 1, 0}};
  return list;
}

TEST(Samples, AreAllListed) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() + "/assets/samples"))
    count += entry.path().extension() == ".hariko" ? 1U : 0U;
  EXPECT_EQ(count, samples().size() + solid_samples().size() + outline_samples().size() +
                       skin_samples().size() + 1);  // and the wheel arch
}

TEST(Samples, OfSolidsOpenAndAreWrittenAsTheyAre) {
  for (const auto& [name, solids] : solid_samples()) {
    SCOPED_TRACE(name);
    const Result<Document> document = test::must(load_document(path_of(name)));
    ASSERT_EQ(document->objects.size(), 1U);
    const SolidsSource* source = document->objects[0]->solids();
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->input->solids.size(), solids);
    EXPECT_EQ(write_document(*document), read_file(path_of(name)).value());
  }
}

TEST(Samples, OfOutlinesOpenAndHaveSmoothSurfaces) {
  for (const auto& [name, loops] : outline_samples()) {
    SCOPED_TRACE(name);
    const Result<Document> document = test::must(load_document(path_of(name)));
    ASSERT_EQ(document->objects.size(), 1U);
    const OutlineSource* source = document->objects[0]->outline();
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->outline->loops.size(), loops);
    EXPECT_EQ(write_document(*document), read_file(path_of(name)).value());
    const auto made = test::must(object_surface(*document, *document->objects[0]));
    for (const Message& warning : made->warnings) ADD_FAILURE() << to_string(warning);
    const ContinuityReport report = continuity(made->surface);
    EXPECT_LE(*report.largest_normal_jump, 1e-10);
    EXPECT_LE(report.largest_gap, 1e-12);
    EXPECT_EQ(report.folded_samples, 0U);
  }
}

TEST(Samples, OfSkinsOpenAndBecomeSmoothSurfaces) {
  for (const ExpectedSkin& sample : skin_samples()) {
    SCOPED_TRACE(sample.name);
    const Result<Document> document = test::must(load_document(path_of(sample.name)));
    ASSERT_EQ(document->objects.size(), 1U);
    const SkinSource* source = document->objects[0]->skin();
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->skin->section_count(), sample.sections);
    EXPECT_EQ(source->skin->links.size(), sample.links);
    EXPECT_EQ(source->skin->merges.size(), sample.merges);
    EXPECT_EQ(write_document(*document), read_file(path_of(sample.name)).value());
    const auto made = test::must(object_surface(*document, *document->objects[0]));
    // Steep ridges have sides that look away from each other, and say so.
    for (const Message& warning : made->warnings) EXPECT_EQ(warning.code, w_fold) << to_string(warning);
    const ContinuityReport report = continuity(made->surface);
    EXPECT_EQ(report.largest_gap, 0);
    EXPECT_LE(*report.largest_normal_jump, 1e-8);
    EXPECT_EQ(report.folded_samples, 0U);
  }
}

TEST(Samples, OpenWithTheirElements) {
  for (const Expected& sample : samples()) {
    SCOPED_TRACE(sample.name);
    const Result<Document> document = test::must(load_document(path_of(sample.name)));
    ASSERT_EQ(document->objects.size(), 1U);
    const PolyhedronSource* source = document->objects[0]->polyhedron();
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->polyhedron.vertex_count(), sample.vertices);
    EXPECT_EQ(source->polyhedron.edge_count(), sample.edges);
    EXPECT_EQ(source->polyhedron.face_count(), sample.faces);
    EXPECT_EQ(source->shaping->alpha.size(), sample.alpha);
    EXPECT_EQ(source->shaping->beta.size(), sample.beta);
    EXPECT_EQ(source->shaping->crease.size(), sample.crease);
    EXPECT_EQ(write_document(*document), read_file(path_of(sample.name)).value());
  }
}

Document in_mode_g2(Document document) {
  for (auto& object : document.objects) {
    if (!object->polyhedron()) continue;
    auto changed = std::make_shared<Object>(*object);
    std::get<PolyhedronSource>(changed->source).mode = Mode::g2;
    object = std::move(changed);
  }
  return document;
}

/// Every object of every sample, the wheel arch's joined ones included (must be as smooth as g2.md says).
TEST(Samples, AreCurvatureContinuousInModeG2) {
  std::vector<std::string> names{"wheel_arch"};
  for (const Expected& sample : samples()) names.emplace_back(sample.name);
  for (const std::string& name : names) {
    const Document document = in_mode_g2(load_document(path_of(name)).value());
    for (const auto& object : document.objects) {
      if (!object->polyhedron()) continue;
      SCOPED_TRACE(name + " " + object->name);
      const auto made = test::must(object_surface(document, *object));
      EXPECT_TRUE(std::get<SolveReport>(made->details).g2_converged);
      const test::Jumps jumps = test::jumps_of(made->surface);
      EXPECT_EQ(jumps.gap, 0);
      EXPECT_LE(jumps.normal, 1e-11);
      EXPECT_LE(jumps.curvature, 1e-8 * jumps.rms);
    }
  }
}

TEST(Samples, BecomeSmoothSurfacesInEveryMode) {
  for (const Expected& sample : samples())
    for (const Mode mode : {Mode::paper, Mode::target, Mode::fair}) {
      SCOPED_TRACE(sample.name + std::string(" mode ") + std::to_string(int(mode)));
      const Document document = load_document(path_of(sample.name)).value();
      PolyhedronSurfaceInput input = surface_input(*document.objects[0]->polyhedron()).value();
      input.mode = mode;
      PolyhedronSurfacer surfacer;
      const Result<PolyhedronSurface> result = test::must(surfacer.rebuild(input));
      EXPECT_EQ(result->surface.patch_count(), input.polyhedron.topology().half_edge_count());
      const ContinuityReport report = continuity(result->surface);
      EXPECT_LE(*report.largest_normal_jump, 1e-10);
      EXPECT_LE(report.largest_gap, 1e-13);
      EXPECT_EQ(report.degenerate_samples, 0U);
      EXPECT_EQ(report.folded_samples, 0U);
      const bool folds = std::any_of(result->warnings.begin(), result->warnings.end(),
                                     [](const Message& warning) { return warning.code == w_fold; });
      EXPECT_EQ(folds, sample.name == std::string("concave") && mode != Mode::fair);
    }
}

void expect_smooth_joints(const Document& document) {
  ASSERT_EQ(document.objects.size(), 2U);
  const Object &fender = *document.objects[0], &cover = *document.objects[1];
  ASSERT_TRUE(fender.patches() && cover.polyhedron());
  const auto outside = object_surface(document, fender), inside = object_surface(document, cover);
  ASSERT_TRUE(outside.ok() && inside.ok());
  EXPECT_TRUE(outside->warnings.empty());
  EXPECT_TRUE(inside->warnings.empty());
  for (const Seam& seam : outside->surface.seams()) EXPECT_EQ(seam.intended, Continuity::g1);
  EXPECT_LE(*continuity(inside->surface).largest_normal_jump, 1e-10);
  const Polyhedron& polyhedron = cover.polyhedron()->polyhedron;
  EXPECT_EQ(cover.polyhedron()->attachments->size(), 8U);
  double largest = 0, gap = 0;
  for (const auto& [edge, attachment] : *cover.polyhedron()->attachments) {
    const Index h = polyhedron.topology().half_edge_of_edge(polyhedron.find(edge));
    const Index patch = patch_of(fender.patches()->control_net(), attachment.side);
    for (int i = 0; i <= 32; ++i) {
      const Vector2 own = side_parameter(Domain::triangle, 1, i / 32.0);
      const Vector2 theirs = side_parameter(Domain::square, attachment.side.side, 1 - i / 32.0);
      const Vector3 a = inside->surface.normal(h, own), b = outside->surface.normal(patch, theirs);
      largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
      gap = std::max(gap, (inside->surface.patches().evaluate(h, own, Order::first).position +
                           inside->surface.origin() - outside->surface.origin() -
                           outside->surface.patches().evaluate(patch, theirs, Order::first).position)
                              .norm());
    }
  }
  std::printf("wheel arch: largest normal jump %.2e rad, gap %.2e mm\n", largest, gap);
  EXPECT_LE(largest, 1e-10);
  EXPECT_LE(gap, 1e-12);
}

/// A hole between patches that a polyhedron closes: the joints are as smooth as the rest.
TEST(Samples, WheelArchHasNoKinkAtItsJoints) {
  const Document document = load_document(path_of("wheel_arch")).value();
  EXPECT_EQ(write_document(document), read_file(path_of("wheel_arch")).value());
  expect_smooth_joints(document);
  expect_smooth_joints(in_mode_g2(document));
}

}  // namespace
}  // namespace hariko
