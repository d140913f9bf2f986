// STEP and IGES files that something went wrong with: each still loads, or is refused with a reason, in
// bounded time.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "core/surface/bezier_patch.hpp"
#include "tests/support/mutated.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <unistd.h>

#include "core/cad/kernel/opencascade/isolated.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;

void expect_sound(const CadScene& scene) {
  for (const CadPart& part : scene.parts) {
    EXPECT_TRUE(part.mesh.face_count() > 0 || !part.patches.empty());
    for (const Vector3& p : part.mesh.positions) EXPECT_TRUE(p.allFinite());
    for (const Index v : part.mesh.face_vertices) EXPECT_LT(v, part.mesh.positions.size());
    for (const auto* patches : {&part.patches, &part.also_exact})
      for (const BezierPatch& patch : *patches) EXPECT_FALSE(check_patch(patch, 0));
  }
}

TEST(MutatedFiles, AHundredOfEachFormatLoadOrAreRefusedWithAReason) {
  const fs::path tests = fs::path(source_folder()) / "tests";
  const std::vector<std::vector<fs::path>> formats{
      {tests / "cases" / "step_box_mixed.step", tests / "cases" / "step_box_planes.step",
       tests / "cad" / "fixtures" / "assembly_nauo.step"},
      {tests / "cad" / "fixtures" / "text_behind_end.igs"}};
  const TemporaryFolder folder;
  for (const auto& files : formats) {
    std::size_t loaded = 0;
    for_random(5300, 100, [&](std::mt19937_64& rng) {
      const fs::path& file = files[rng() % files.size()];
      const fs::path changed = folder.path() / ("a" + file.extension().string());
      spill(changed, mutated(rng, slurp(file)));
      const auto read = read_cad_file(changed);
      if (read.ok()) {
        expect_sound(*read);
        ++loaded;
        return;
      }
      EXPECT_FALSE(read.error().text.empty());
      EXPECT_FALSE(read.error().remedy.empty());
    });
    EXPECT_GT(loaded, 0U) << "some changes do not matter";
  }
}

TEST(MutatedFiles, WorkThatWaitsForAThreadThatIsNotThereIsGivenUp) {
  const auto bytes = isolated(
      [](const std::function<void(double)>&) -> std::string {
        for (;;) ::pause();
      },
      {.working = 60, .waiting = 0.2}, {}, {});
  EXPECT_FALSE(bytes);
  const auto whole =
      isolated([](const std::function<void(double)>&) { return std::string("whole"); }, {}, {}, {});
  EXPECT_EQ(whole, "whole");
}

}  // namespace
}  // namespace hariko::test
#endif
