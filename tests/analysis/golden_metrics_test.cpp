// Area, bending and curvature jump of the published control points, against an independent implementation.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

using Json = nlohmann::json;

/// The patches of a golden file with their seams; edges in `crease` are sharp.
Surface surface_of(const Json& golden, const std::vector<std::pair<Index, Index>>& crease) {
  std::vector<QuarticPatch> patches;
  for (const Json& patch : golden["patches"]) {
    QuarticPatch own;
    for (std::size_t k = 0; k < 18; ++k)
      for (int d = 0; d < 3; ++d) own.control[k][d] = patch["D"][k][std::size_t(d)];
    patches.push_back(own);
  }
  Index centre = 0;
  for (const Json& face : golden["faces"])
    for (const Json& v : face["vertices"]) centre = std::max(centre, v.get<Index>() + 1);
  std::vector<Index> nodes;
  for (const Json& face : golden["faces"]) {
    const auto v = face["vertices"].get<std::vector<Index>>();
    for (std::size_t j = 0; j < v.size(); ++j)
      nodes.insert(nodes.end(), {centre, v[j], v[(j + 1) % v.size()]});
    ++centre;
  }
  const std::size_t count = patches.size();
  // The formulas only serve to derive the seams.
  const Surface frame = test::make_surface(Domain::triangle, std::vector<test::PatchFormula>(count), nodes);
  Surface::Parts parts;
  parts.patches =
      std::make_shared<QuarticPatchSet>(QuarticPatchArray(patches), std::make_shared<QuarticTables>());
  std::vector<Seam> seams = frame.seams();
  for (Seam& seam : seams) {
    const Index a = frame.node(seam.first.patch, seam.first.side);
    const Index b = frame.node(seam.first.patch, (seam.first.side + 1) % 3);
    for (const auto& [p, q] : crease)
      if ((a == p && b == q) || (a == q && b == p)) seam.intended = Continuity::g0;
  }
  parts.seams = std::make_shared<const std::vector<Seam>>(std::move(seams));
  parts.provenance = std::make_shared<const std::vector<Provenance>>(count);
  parts.corner_nodes = std::make_shared<const std::vector<Index>>(nodes);
  parts.node_count = centre;
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(centre, Vector3::Zero());
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>();
  parts.boundary_sources = std::make_shared<const std::vector<Element>>();
  return Surface(std::move(parts));
}

Json read(const std::filesystem::path& path) {
  return Json::parse(std::ifstream(path));
}

TEST(GoldenMetrics, AreReproduced) {
  const std::filesystem::path folder = std::filesystem::path(test::source_folder()) / "tests/golden";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() != ".json" || name.find(".tension.") != std::string::npos) continue;
    SCOPED_TRACE(name);
    ++files;
    const Json golden = read(entry.path());
    std::vector<std::pair<Index, Index>> crease;
    const Json sharp = read(folder / "cube_crease.tension.json")["crease"];
    if (name.starts_with("cube_crease"))
      for (const Json& edge : sharp) crease.emplace_back(edge[0].get<Index>(), edge[1].get<Index>());
    const Surface surface = surface_of(golden, crease);
    const Json& metrics = golden["metrics"];

    const Measures measures = measure(surface);
    EXPECT_NEAR(measures.area / metrics["area"].get<double>(), 1, 1e-11);
    EXPECT_NEAR(measures.bending / metrics["bend"].get<double>(), 1, 1e-9);
    EXPECT_EQ(measures.volume.has_value(), golden["euler"] == 2);

    const ContinuityReport report = continuity(surface);
    ASSERT_TRUE(report.rms_curvature_jump && report.largest_normal_jump);
    const double jump = metrics["jump_rms_rel"];
    EXPECT_NEAR(*report.rms_curvature_jump, jump, 1e-7 * jump + 2e-10);
    // The control points are printed to twelve digits.
    EXPECT_LT(*report.largest_normal_jump, 1e-10);
    EXPECT_LT(report.largest_gap, 1e-11);
    EXPECT_EQ(report.folded_samples, 0U);
    EXPECT_EQ(report.degenerate_samples, 0U);
  }
  EXPECT_GE(files, 20);
}

}  // namespace
}  // namespace hariko
