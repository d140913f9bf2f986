// Long work on files: it says how far it is, and what is cancelled leaves files as they were.

#include <array>
#include <thread>

#include "app/files/export_surfaces.hpp"
#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "core/exchange/mesh_file.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

CancelToken cancelled_token() {
  const CancelToken token = CancelToken::make();
  token.cancel();
  return token;
}

TEST(FileWork, ACancelledExportLeavesTheOldFileOrNone) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(12, 9), "Torus").value();
  for (const char* name : {"a.obj", "a.ply", "a.stl"}) {
    SCOPED_TRACE(name);
    const auto file = folder.path() / name;
    // Before it has begun, and in the middle.
    for (const double at : {-1.0, 0.0, 0.3}) {
      for (const bool old : {false, true}) {
        std::filesystem::remove(file);
        if (old) test::spill(file, "old");
        const CancelToken cancel = CancelToken::make();
        const Progress progress = Progress::make();
        if (at < 0) cancel.cancel();
        Result<Done> result = Done{};
        std::thread worker([&] {
          const auto written = export_surfaces(document, file, 64, {}, cancel, progress);
          if (!written.ok()) result = written.error();
        });
        while (at >= 0 && progress.fraction() < at) std::this_thread::yield();
        cancel.cancel();
        worker.join();
        // In the middle the file may have been ready already; then it is the whole new one.
        if (result.ok()) {
          EXPECT_TRUE(open_file(file).document || open_file(file).broken_mesh);
          continue;
        }
        EXPECT_EQ(result.error().code, e_cancelled);
        EXPECT_EQ(std::filesystem::exists(file), old);
        if (old) {
          EXPECT_EQ(test::slurp(file), "old");
        }
        EXPECT_EQ(test::files_in(folder.path()), old ? 1U : 0U) << "something is left over";
      }
    }
    std::filesystem::remove(file);
  }
}

TEST(FileWork, AnExportReportsHowFarItIs) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(5, 4), "Torus").value();
  const Progress progress = Progress::make();
  ASSERT_TRUE(export_surfaces(document, folder.path() / "a.obj", 4, {}, {}, progress).ok());
  EXPECT_GE(progress.fraction(), 0.5);
  EXPECT_LE(progress.fraction(), 1);
}

TEST(FileWork, EveryReaderCanBeCancelledAndReports) {
  const test::TemporaryFolder folder;
  PolygonMesh mesh = test::torus(6, 5);
  const std::array<NamedPolygons, 1> meshes{{{"Torus", &mesh}}};
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.glb", "a.gltf", "a.3mf"})
    ASSERT_TRUE(write_mesh_file(folder.path() / name, meshes).ok());
  test::spill(folder.path() / "text.ply", write_ply(meshes, MeshEncoding::ascii));
  test::spill(folder.path() / "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  test::spill(folder.path() / "text.stl",
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
              "endloop\nendfacet\nendsolid a\n");
  for (const char* name :
       {"a.obj", "a.ply", "text.ply", "a.off", "a.stl", "text.stl", "a.glb", "a.gltf", "a.3mf"}) {
    SCOPED_TRACE(name);
    const Progress progress = Progress::make();
    const OpenedFile whole = open_file(folder.path() / name, {}, progress);
    EXPECT_TRUE(whole.document.has_value());
    EXPECT_GT(progress.fraction(), 0);
    ReadLimits limits;
    limits.cancel = cancelled_token();
    test::must_fail(read_mesh_file(folder.path() / name, limits), e_cancelled);
    const OpenedFile opened = open_file(folder.path() / name, cancelled_token());
    EXPECT_FALSE(opened.document.has_value());
    ASSERT_EQ(opened.messages.size(), 1U);
    EXPECT_EQ(opened.messages[0].code, e_cancelled);
    EXPECT_EQ(opened.messages[0].text, "The import was cancelled.");
  }
}

TEST(BackgroundWork, ACancelledJobEndsAndSaysSo) {
  Editor editor;
  BackgroundWork work(editor, {});
  EXPECT_EQ(editor.cancellable_job(), nullptr);
  bool cancelled = false, followed = false;
  work.run_cancellable(
      "Waiting",
      [](const CancelToken& cancel, const Progress& progress) {
        progress.report(0.5);
        while (!cancel.cancelled()) std::this_thread::yield();
        return true;
      },
      [&](bool ended) { cancelled = ended; });
  work.run(
      "Saving", [](const CancelToken&) { return true; }, [&](bool) { followed = true; });
  work.run(
      {}, [](const CancelToken&) { return true; }, [](bool) {});
  ASSERT_EQ(editor.jobs.size(), 2U) << "work without a name shows";
  EXPECT_EQ(editor.jobs[0]->text, "Waiting");
  while (editor.jobs[0]->progress.fraction() < 0) std::this_thread::yield();
  EXPECT_EQ(percent_of(*editor.jobs[0]), 50);
  ASSERT_NE(editor.cancellable_job(), nullptr);
  editor.cancellable_job()->cancel.cancel();
  EXPECT_EQ(editor.cancellable_job(), nullptr) << "saving cannot be cancelled";
  work.wait();
  work.publish();
  EXPECT_TRUE(cancelled);
  EXPECT_TRUE(followed) << "work behind the cancelled one is lost";
  EXPECT_TRUE(editor.jobs.empty());
}

TEST(BackgroundWork, TheEndOfTheProgramDoesNotWaitForCancellableWork) {
  Editor editor;
  BackgroundWork work(editor, {});
  work.run_cancellable(
      "Forever",
      [](const CancelToken& cancel, const Progress&) {
        while (!cancel.cancelled()) std::this_thread::yield();
        return true;
      },
      [](bool) {});
}

TEST(Progress, PartsAreNested) {
  const Progress whole = Progress::make();
  EXPECT_LT(whole.fraction(), 0);
  const Progress half = whole.part(0.5, 1);
  half.report(0);
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.5);
  half.part(0.5, 1).report(0.5);
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.875);
  half.report(7);
  EXPECT_DOUBLE_EQ(whole.fraction(), 1);
  Progress().report(0.3);  // to nobody
}

}  // namespace
}  // namespace hariko
