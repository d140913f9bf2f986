// Every kind of file that is written, on a disk that fails: the old file or the whole new one, and a
// sentence.

#include <array>
#include <cerrno>
#include <functional>
#include <memory>

#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/sheet_file.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/file.hpp"
#include "render/image.hpp"
#include "tests/files/system_faults.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;
using Writer = std::function<Result<Done>(const fs::path&)>;
struct Kind {
  std::string ending;
  Writer write;
};

Document one_patch() {
  BicubicNet net{1, 1, {}};
  for (int k = 0; k < 16; ++k) net.points.push_back({double(k % 4), double(k / 4), 0.3 * (k % 3)});
  return add_object({}, "patch", PatchSource::from_net(net).value()).value().document;
}

Document sample(const std::string& name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko").value();
}

/// Without what was reported.
template <class Report>
Result<Done> done(const Result<Report>& written) {
  return written.ok() ? Result<Done>(Done{}) : Result<Done>(written.error());
}

std::vector<Kind> kinds() {
  std::vector<Kind> out;
  const auto document = std::make_shared<const Document>(one_patch());
  for (const char* ending : {".obj", ".off", ".ply", ".stl", ".3mf", ".glb", ".gltf"})
    out.push_back({ending, [=](const fs::path& path) { return done(export_surfaces(*document, path, 3)); }});
  if (!why_no_cad_files())
    for (const char* ending : {".step", ".iges"})
      out.push_back({ending, [=](const fs::path& path) {
                       return done(export_cad(*document, path, {}, "2026-11-22T12:00:00"));
                     }});
  const auto skin = std::make_shared<const Document>(sample("skin_smooth"));
  out.push_back({" control.obj", [=](const fs::path& path) { return export_control_meshes(*skin, path); }});
  PaperSettings settings{.scale = 30};
  const auto paper = must(unfold(shared_graph(icosphere(0)), settings, {.steps = 10}));
  const auto drawing = std::make_shared<const SheetDrawing>(draw_sheets(*paper));
  for (const char* ending : {".pdf", ".svg", ".dxf", ".json", " pages.png"})
    out.push_back({ending, [=](const fs::path& path) { return write_sheet_file(path, *drawing); }});
  out.push_back({".png", [](const fs::path& path) { return write_png(path, Image(20, 10)); }});
  out.push_back({".hariko", [=](const fs::path& path) { return save_document(*document, path); }});
  return out;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path().filename().string());
  return out;
}

/// Lets call after call fail until the writer makes fewer of them.
void fail_everywhere(const Kind& kind, bool replaces, std::mt19937_64& rng) {
  const std::string old = "what was there before";
  std::string whole;
  {
    const TemporaryFolder folder;
    ASSERT_TRUE(kind.write(folder.path() / ("a" + kind.ending)).ok());
    whole = slurp(folder.path() / ("a" + kind.ending));
    ASSERT_GT(whole.size(), old.size());
  }
  for (int failing = 0;; ++failing) {
    ASSERT_LT(failing, 100) << "the writer goes on for ever";
    SCOPED_TRACE("call " + std::to_string(failing));
    const TemporaryFolder folder;
    const fs::path path = folder.path() / ("a" + kind.ending);
    if (replaces) spill(path, old);
    constexpr std::array errors{ENOSPC, EIO, EDQUOT, EFBIG, EROFS};
    const int error = errors[std::size_t(uniform_int(rng, 0, int(errors.size()) - 1))];
    Result<Done> done = Done{};
    int calls = 0;
    {
      const SystemFaults faults(folder.path(), failing, error, whole.size() / 3 + 1);
      done = kind.write(path);
      calls = faults.calls();
      EXPECT_EQ(faults.exposed(), std::vector<std::string>{});
    }
    if (calls <= failing) {
      EXPECT_TRUE(done.ok());
      EXPECT_GT(failing, 8) << "create, three writes, flush, close, rename, and the folder's";
      return;
    }
    const std::string found = slurp(path);
    if (done.ok() || done.error().text.find("was written") != std::string::npos) {
      EXPECT_EQ(found, whole);
    } else {
      EXPECT_EQ(done.error().code, e_file_write);
      EXPECT_NE(done.error().text.find("a" + kind.ending), std::string::npos) << done.error().text;
      EXPECT_EQ(found, replaces ? old : "");
      EXPECT_EQ(fs::exists(path), replaces);
    }
    EXPECT_EQ(names_in(folder.path()).size(), fs::exists(path) ? 1U : 0U) << "something was left behind";
  }
}

TEST(AtomicWrites, NoCallThatFailsLeavesHalfAFile) {
  const std::uint64_t seed = random_seed(5100);
  SCOPED_TRACE("HARIKO_SEED=" + std::to_string(seed));
  std::mt19937_64 rng(seed);
  for (const Kind& kind : kinds()) {
    const bool chosen = chance(rng, 0.5);
    for (const bool replaces : {false, true}) {
      if (repetitions(1) < 2 && replaces != chosen) continue;
      SCOPED_TRACE(kind.ending + (replaces ? ", replacing" : ""));
      fail_everywhere(kind, replaces, rng);
    }
  }
}

/// The test above would see who writes otherwise.
TEST(AtomicWrites, OtherWaysOfWritingAreSeen) {
  const TemporaryFolder folder;
  const SystemFaults faults(folder.path(), -1, EIO, 1);
  spill(folder.path() / "a.txt", "some text");
  EXPECT_EQ(faults.exposed(), std::vector<std::string>{(folder.path() / "a.txt").string()});
}

}  // namespace
}  // namespace hariko::test
