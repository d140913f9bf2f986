// Files that something went wrong with: each still loads, or is refused with a reason. No more memory and
// time than the limits allow: a test that hangs is a failure.

#include "core/exchange/archive_3mf/read_3mf.hpp"
#include "core/exchange/read_patches.hpp"
#include "tests/exchange/fixture_files.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/mutated.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

/// Files of a format, among the seeds of the fuzzers and the cases.
std::vector<std::string> files_of(const std::string& seeds, const std::vector<std::string>& endings) {
  std::vector<fs::path> paths;
  const fs::path tests = fs::path(test::source_folder()) / "tests";
  for (const fs::path& folder :
       {tests / "fuzz" / "seeds" / seeds, tests / "exchange" / "fixtures", tests / "cases"})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (std::find(endings.begin(), endings.end(), entry.path().extension()) != endings.end())
        paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> out;
  for (const fs::path& path : paths) out.push_back(test::slurp(path));
  return out;
}

ReadLimits small_limits() {
  ReadLimits limits{.vertices = 20'000, .corners = 60'000};
  return limits;
}

void expect_loads_or_is_refused(const Result<ImportedScene>& read) {
  if (!read.ok()) {
    EXPECT_FALSE(read.error().text.empty());
    EXPECT_TRUE(read.error().code.name.starts_with("E_"));
    return;
  }
  EXPECT_FALSE(read->parts.empty() && read->patches.empty());
  for (const ImportedPart& part : read->parts) {
    test::expect_sound(part.mesh);
    for (const auto& [a, b] : part.creases) EXPECT_LT(std::max(a, b), part.mesh.positions.size());
    for (const Index v : part.corners) EXPECT_LT(v, part.mesh.positions.size());
  }
  for (const NamedPatches& patches : read->patches)
    for (const BezierPatch& patch : patches.patches) EXPECT_FALSE(check_patch(patch, 0));
}

/// A hundred mutations of the files of a format.
template <class Read>
void try_mutations(std::uint64_t seed, const std::vector<std::string>& files, Read&& read) {
  ASSERT_FALSE(files.empty());
  test::for_random(seed, 100,
                   [&](std::mt19937_64& rng) { read(test::mutated(rng, files[rng() % files.size()])); });
}

void try_format(std::uint64_t seed, MeshFormat format, const std::string& seeds,
                const std::vector<std::string>& endings) {
  const SidecarReader beside = [](const std::string&) -> Result<std::string> { return std::string(64, '?'); };
  try_mutations(seed, files_of(seeds, endings), [&](const std::string& bytes) {
    expect_loads_or_is_refused(read_parts(bytes, format, small_limits(), beside));
  });
}

TEST(Mutations, Obj) {
  try_format(100, MeshFormat::obj, "obj", {".obj"});
}
TEST(Mutations, Off) {
  try_format(200, MeshFormat::off, "off", {".off"});
}
TEST(Mutations, Ply) {
  try_format(300, MeshFormat::ply, "ply", {".ply"});
}
TEST(Mutations, Stl) {
  try_format(400, MeshFormat::stl, "stl", {".stl"});
}
TEST(Mutations, Gltf) {
  try_format(500, MeshFormat::gltf, "gltf", {".glb", ".gltf"});
}
TEST(Mutations, ThreeMf) {
  try_format(600, MeshFormat::three_mf, "three_mf", {".3mf"});
  // Packed text hardly changes in small ways.
  try_mutations(700, files_of("three_mf", {".model"}), [](const std::string& text) {
    expect_loads_or_is_refused(read_3mf_model(text, small_limits()));
  });
}
TEST(Mutations, Patches) {
  try_mutations(800, files_of("patches", {".bpt", ".json"}), [](const std::string& text) {
    const auto expect_patches = [](const std::vector<BezierPatch>& patches) {
      for (const BezierPatch& patch : patches) EXPECT_FALSE(check_patch(patch, 0));
    };
    if (const auto plain = read_bezier_text(text); plain.ok()) expect_patches(*plain);
    if (const auto named = read_bezier_json(text); named.ok())
      for (const NamedPatches& group : *named) expect_patches(group.patches);
  });
}

}  // namespace
}  // namespace hariko
