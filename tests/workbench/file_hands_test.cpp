// Files: the dialog that asks for one, and what dense and sharp meshes become.

#include <array>
#include <filesystem>
#include <fstream>

#include "app/files/prepare_meshes.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/base/folder_list.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, std::size_t bytes, int hours_ago) {
  std::ofstream(path) << std::string(bytes, 'x');
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours_ago));
}

class FileHands : public ::testing::Test {
 protected:
  FileHands() : bench_(document(), {1280, 800}, &imports_) {
    write(folder_.path() / "a10.obj", 30, 1);
    write(folder_.path() / "a2.obj", 10, 3);
    write(folder_.path() / "b.stl", 20, 2);
    write(folder_.path() / "notes.txt", 5, 1);
    fs::create_directory(folder_.path() / "sub");
    bench_.editor().path = folder_.path() / "model.hariko";
    bench_.workbench().commands().run("file.import");
    for (int i = 0; i < 3; ++i) bench_.frame();
  }
  static Document document() { return document_from_mesh(test::prism(4), "Box").value(); }
  const std::map<std::string, Marks::Rect>& marks() { return bench_.workbench().marks().all(); }
  int top(const std::string& entry) {
    return marks().contains("entry." + entry) ? marks().at("entry." + entry).y : -1;
  }
  void click(const std::string& mark) {
    bench_.click(mark);
    for (int i = 0; i < 3; ++i) bench_.frame();
  }

  test::TemporaryFolder folder_;
  struct Imports final : test::NoServices {
    void import_file(const fs::path& path) override { files.push_back(path); }
    std::vector<fs::path> files;
  };
  Imports imports_;
  /// Frames in which a dialog that has changed its size comes to rest.
  void frames() {
    for (int i = 0; i < 4; ++i) bench_.frame();
  }
  HeadlessWorkbench bench_;
};

TEST_F(FileHands, ColumnsSortAndNamesCountUp) {
  EXPECT_LT(top("sub"), top("a2.obj")) << "folders first";
  EXPECT_LT(top("a2.obj"), top("a10.obj"));
  EXPECT_LT(top("a10.obj"), top("b.stl"));
  EXPECT_EQ(top("notes.txt"), -1);
  click("dialog.sort.modified");
  EXPECT_LT(top("a10.obj"), top("b.stl")) << "latest first";
  EXPECT_LT(top("b.stl"), top("a2.obj"));
  click("dialog.sort.modified");
  EXPECT_LT(top("a2.obj"), top("b.stl"));
  click("dialog.sort.size");
  EXPECT_LT(top("a10.obj"), top("b.stl"));
}

TEST_F(FileHands, OneFormatCanBeChosenFromAList) {
  click("dialog.format");
  click("dialog.format.stl");
  EXPECT_GT(top("b.stl"), 0);
  EXPECT_EQ(top("a2.obj"), -1);
  click("dialog.format");
  click("dialog.format.all");
  EXPECT_GT(top("a2.obj"), 0);
}

TEST_F(FileHands, ArrowsGoThroughTheListAndEnterTakesTheFile) {
  for (int i = 0; i < 3; ++i) bench_.tap("Down");  // the folder, a2, a10
  bench_.tap("Enter");
  bench_.frame();
  ASSERT_EQ(imports_.files.size(), 1U);
  EXPECT_EQ(imports_.files[0].filename(), "a10.obj");
}

TEST_F(FileHands, AClickBesideTheEntriesLeavesTheKeyboardAtTheName) {
  const Marks::Rect last = marks().at("entry.b.stl");
  bench_.move(last.x + 60, last.y + 120);
  bench_.press();
  bench_.release();
  for (int i = 0; i < 3; ++i) bench_.frame();
  bench_.enter("b.stl");
  bench_.frame();
  ASSERT_EQ(imports_.files.size(), 1U);
  EXPECT_EQ(imports_.files[0].filename(), "b.stl");
}

TEST_F(FileHands, AFolderCanBeMadeAndLeft) {
  click("dialog.new_folder");
  click("dialog.new_folder_name");
  bench_.enter("drafts");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_TRUE(fs::is_directory(folder_.path() / "drafts"));
  EXPECT_EQ(top("a2.obj"), -1) << "the dialog is in the new folder";
  click("dialog.crumb.1");
  EXPECT_GT(top("a2.obj"), 0);
  EXPECT_GT(top("drafts"), 0);
  EXPECT_TRUE(marks().contains("dialog.place.root"));
}

TEST_F(FileHands, TypingGoesToWhatBeginsSoAndEnterTakesIt) {
  bench_.type("B");
  frames();
  bench_.tap("Enter");
  bench_.frame();
  ASSERT_EQ(imports_.files.size(), 1U);
  EXPECT_EQ(imports_.files[0].filename(), "b.stl");
}

TEST_F(FileHands, WhatNothingBeginsWithIsRefused) {
  bench_.enter("no");
  frames();
  EXPECT_TRUE(imports_.files.empty());
  EXPECT_TRUE(marks().contains("dialog.accept")) << "it stays open";
}

TEST_F(FileHands, HiddenFilesShowWhenTheyAreAskedFor) {
  write(folder_.path() / ".secret.obj", 3, 1);
  click("dialog.hidden");
  EXPECT_GT(top(".secret.obj"), 0);
  click("dialog.hidden");
  EXPECT_EQ(top(".secret.obj"), -1);
  EXPECT_GT(top("a2.obj"), 0);
}

/// The order of the list is none of the settings that a replay begins with.
TEST_F(FileHands, ARecordingBeginsWithTheUsualOrder) {
  click("dialog.sort.modified");
  EXPECT_LT(top("a10.obj"), top("a2.obj"));
  bench_.key("Esc");
  frames();
  bench_.workbench().forget_interface();
  bench_.workbench().commands().run("file.import");
  frames();
  EXPECT_LT(top("a2.obj"), top("a10.obj"));
}

/// At 250 % in a small window the settings left no room for the list.
TEST_F(FileHands, FilesShowAtEveryScale) {
  std::ofstream(folder_.path() / "model.hariko") << "{}";
  bench_.key("Esc");
  frames();
  ImGui::GetIO().DisplaySize = {800, 600};
  for (const float scale : {1.0F, 1.5F, 2.5F})
    for (const char* id :
         {"file.open", "file.import", "file.export", "file.export_picture", "file.save_as"}) {
      SCOPED_TRACE(id + std::string(" at ") + std::to_string(scale));
      bench_.set_scale(scale);
      ASSERT_TRUE(bench_.workbench().commands().run(id).ran);
      frames();
      ASSERT_TRUE(marks().contains("dialog.files"));
      const Marks::Rect list = marks().at("dialog.files"), accept = marks().at("dialog.accept");
      EXPECT_GE(float(list.height), 3 * ImGui::GetTextLineHeightWithSpacing());
      EXPECT_LE(list.y + list.height, accept.y);
      EXPECT_LE(accept.y + accept.height, 600);
      ASSERT_TRUE(marks().contains("entry.sub"));
      const Marks::Rect entry = marks().at("entry.sub");
      EXPECT_GE(entry.y, list.y);
      EXPECT_LE(entry.y + entry.height, list.y + list.height);
      if (id != std::string("file.save_as")) {
        const bool folded = marks().contains("dialog.settings");
        EXPECT_EQ(folded, !marks().contains("dialog.format"));
        if (scale > 2) EXPECT_TRUE(folded);
        if (folded) click("dialog.settings");
        ASSERT_TRUE(marks().contains("dialog.format"));
        if (folded) EXPECT_FALSE(marks().contains("entry.sub"));
        if (folded) click("dialog.settings");
        EXPECT_TRUE(marks().contains("entry.sub")) << "back to the list";
      }
      bench_.key("Esc");
      frames();
      ASSERT_FALSE(marks().contains("dialog.files"));
    }
}

/// It began in the folder of the document.
TEST_F(FileHands, TheNextImportBeginsInTheFolderOfTheLast) {
  write(folder_.path() / "sub" / "deep.obj", 3, 1);
  bench_.enter("sub/deep.obj");
  frames();
  ASSERT_EQ(imports_.files.size(), 1U);
  bench_.workbench().commands().run("file.import");
  frames();
  EXPECT_GT(top("deep.obj"), 0);
  EXPECT_EQ(top("a2.obj"), -1);
  bench_.key("Esc");
  frames();
  // Other kinds of files have their own.
  bench_.workbench().commands().run("file.export");
  frames();
  EXPECT_GT(top("a2.obj"), 0);
  EXPECT_EQ(top("deep.obj"), -1);
  bench_.key("Esc");
  frames();
  // The next session begins there too, unless the folder is gone.
  const ExportMemory memory = bench_.workbench().files().remembered();
  EXPECT_EQ(fs::path(memory.folders.at("import")).filename(), "sub");
  fs::remove_all(folder_.path() / "sub");
  bench_.workbench().commands().run("file.import");
  frames();
  EXPECT_GT(top("a2.obj"), 0);
}

TEST_F(FileHands, NamesInOtherScriptsAreTakenUpForTheFonts) {
  write(folder_.path() / "\u7d05\u8336.obj", 3, 1);
  bench_.key("Esc");
  bench_.workbench().commands().run("file.import");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_EQ(bench_.editor().settings.language, english_id);
  EXPECT_TRUE(bench_.editor().shown_characters().contains(U'\u7d05'));
  EXPECT_TRUE(bench_.editor().shown_characters().contains(U'\u8336'));
}

TEST(FolderList, PlacesAreThoseOfTheDesktopOnce) {
  const test::TemporaryFolder folder;
  const fs::path home = folder.path() / "home", config = folder.path() / "config";
  for (const fs::path& each : {home / "Desk top", home / "Downloads", config}) fs::create_directories(each);
  std::ofstream(config / "user-dirs.dirs") << "# comment\nXDG_DESKTOP_DIR=\"$HOME/Desk top\"\n"
                                              "XDG_DOCUMENTS_DIR=\"$HOME/Missing\"\n"
                                              "XDG_DOWNLOAD_DIR=\"$HOME/Downloads\"\nXDG_MUSIC_DIR=\n\"\n";
  const std::vector<fs::path> recent{home / "Downloads" / "a.obj", config / "b.obj", config / "c.obj"};
  std::vector<std::string> ids;
  for (const Place& place : usual_places(home, config, recent)) ids.push_back(place.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"home", "desktop", "downloads", "root", "recent.0"}));
}

TEST(FolderList, MountedDisksAreAmongThem) {
  const std::string mounts =
      "/dev/sda1 / ext4 rw 0 0\nproc /proc proc rw 0 0\n"
      "/dev/sdb1 /media/ada/My\\040disk vfat rw 0 0\nhost:/share /mnt nfs rw 0 0\n"
      "none /mnt/program/cache tmpfs rw 0 0\n";
  const std::vector<Place> places = usual_places("/", "/nowhere", {}, mounts);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[1].id, "mounted.0");
  EXPECT_EQ(places[1].name, "My disk");
  EXPECT_EQ(places[2].folder, "/mnt");
}

OpenedFile opened(const PolygonMesh& mesh) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "mesh.obj";
  EXPECT_TRUE(write_mesh_file(file, std::array{NamedPolygons{"mesh", &mesh}}).ok());
  return open_file(file);
}

TEST(PrepareMeshes, SharpEdgesBecomeCreasesByTheirAngle) {
  // A housing of twelve sides with flat lids: 30 degrees from side to side, 90 at the rims.
  const PolygonMesh prism = make_primitive(PrismShape{12, 1, 2, {}}).value();
  for (const auto& [degrees, creases] : {std::pair(29.0, 36U), {31.0, 24U}, {91.0, 0U}}) {
    OpenedFile file = opened(prism);
    prepare_meshes(file, {MeshUse::cage, true, degrees});
    ASSERT_TRUE(file.document);
    EXPECT_EQ(file.document->objects[0]->polyhedron()->shaping->crease.size(), creases) << degrees;
  }
  OpenedFile plain = opened(prism);
  prepare_meshes(plain, {});
  EXPECT_EQ(plain.document->objects[0]->polyhedron()->shaping->crease.size(), 0U);
}

/// Twelve sides meet at 30 degrees, but for the digits of the file.
TEST(PrepareMeshes, AnAngleThatIsTheLimitItselfMakesNoCreaseWhateverTheDigits) {
  for (const double digits : {1e4, 1e5, 1e7}) {
    PolygonMesh prism = make_primitive(PrismShape{12, 40, 80, {}}).value();
    for (Vector3& p : prism.positions) p = (p * digits).array().round() / digits;
    OpenedFile file = opened(prism);
    prepare_meshes(file, {MeshUse::cage, true, 30});
    ASSERT_TRUE(file.document);
    EXPECT_EQ(file.document->objects[0]->polyhedron()->shaping->crease.size(), 24U) << digits;
  }
}

TEST(PrepareMeshes, DenseMeshesAreAskedAboutAndShowWithoutPoints) {
  const PolygonMesh torus = make_primitive(TorusShape{2, 0.5, 100, 60, {}}).value();
  ASSERT_GT(torus.face_count(), MeshImport::dense_faces);
  OpenedFile file = opened(torus);
  prepare_meshes(file, {});
  EXPECT_EQ(file.dense_faces, torus.face_count());
  ASSERT_TRUE(file.document && file.reference);
  EXPECT_TRUE(file.document->objects[0]->polyhedron());
  EXPECT_TRUE(file.reference->objects[0]->mesh());
  for (const auto& document : {file.document, file.reference}) {
    EXPECT_FALSE(document->objects[0]->display.points);
    EXPECT_FALSE(document->objects[0]->display.polyhedron);
  }
  OpenedFile chosen = opened(torus);
  prepare_meshes(chosen, {MeshUse::reference, false, 30});
  EXPECT_EQ(chosen.dense_faces, 0U);
  EXPECT_TRUE(chosen.document->objects[0]->mesh());
  OpenedFile small = opened(test::torus(5, 4));
  prepare_meshes(small, {});
  EXPECT_EQ(small.dense_faces, 0U);
  EXPECT_TRUE(small.document->objects[0]->display.points);
}

}  // namespace
}  // namespace hariko::test
