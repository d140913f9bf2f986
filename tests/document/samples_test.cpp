// The sample documents: each opens, is written as the program writes, and becomes a surface.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/analysis/continuity.hpp"
#include "core/base/file_io.hpp"
#include "core/document/file.hpp"
#include "core/document/format.hpp"
#include "core/modeling/mirrored.hpp"

namespace hariko {
namespace {

struct Expected {
  const char* name;
  Index vertices, edges, faces;
  std::size_t alpha, beta, crease;
};

const std::vector<Expected>& samples() {
  static const std::vector<Expected> list{
      {"fig2", 18, 30, 14, 0, 0, 0},      {"fig2_open", 18, 30, 13, 0, 0, 0},
      {"fig5c", 18, 30, 14, 0, 6, 0},     {"fig5d", 18, 30, 14, 6, 0, 0},
      {"concave", 16, 24, 10, 0, 0, 0},   {"concave_split", 16, 28, 14, 0, 0, 0},
      {"genus3", 64, 136, 68, 0, 0, 0},   {"cube", 8, 12, 6, 0, 0, 0},
      {"torus", 32, 64, 32, 0, 0, 0},     {"grid3", 16, 24, 9, 0, 0, 0},
      {"cube_crease", 8, 12, 6, 0, 0, 4}, {"car", 36, 66, 32, 0, 0, 0},
  };
  return list;
}

std::filesystem::path path_of(const std::string& name) {
  return std::filesystem::path(HARIKO_SOURCE_DIR) / "assets" / "samples" / (name + ".hariko");
}

TEST(Samples, AreAllListed) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HARIKO_SOURCE_DIR "/assets/samples"))
    count += entry.path().extension() == ".hariko" ? 1U : 0U;
  EXPECT_EQ(count, samples().size());
}

TEST(Samples, OpenWithTheirElements) {
  for (const Expected& sample : samples()) {
    SCOPED_TRACE(sample.name);
    const Result<Document> document = load_document(path_of(sample.name));
    ASSERT_TRUE(document) << to_string(document.error());
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

TEST(Samples, BecomeSmoothSurfacesInEveryMode) {
  for (const Expected& sample : samples())
    for (const Mode mode : {Mode::paper, Mode::target, Mode::fair}) {
      SCOPED_TRACE(sample.name + std::string(" mode ") + std::to_string(int(mode)));
      const Document document = load_document(path_of(sample.name)).value();
      PolyhedronSurfaceInput input = surface_input(*document.objects[0]->polyhedron()).value();
      input.mode = mode;
      PolyhedronSurfacer surfacer;
      const Result<PolyhedronSurface> result = surfacer.rebuild(input);
      ASSERT_TRUE(result) << to_string(result.error());
      EXPECT_EQ(result->surface.patch_count(), input.polyhedron.topology().half_edge_count());
      const ContinuityReport report = continuity(result->surface);
      EXPECT_LE(*report.largest_normal_jump, 1e-10);
      EXPECT_LE(report.largest_gap, 1e-13);
      EXPECT_EQ(report.degenerate_samples, 0U);
      EXPECT_EQ(report.folded_samples, 0U);
      const bool folds = std::any_of(result->warnings.begin(), result->warnings.end(),
                                     [](const Message& warning) { return warning.code == w_fold; });
      EXPECT_EQ(folds, sample.name == std::string("concave"));
    }
}

}  // namespace
}  // namespace hariko
