// Reference pictures by hand: dropped, pasted, placed, made the right size by two clicks, hidden, packed,
// lost and found.

#include <thread>

#include "app/engines/reference_loader.hpp"
#include "app/jobs/reference_jobs.hpp"
#include "core/base/files/file_uri.hpp"
#include "core/document/file.hpp"
#include "core/document/object_box.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/reference_pictures.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

class ReferencePicturesByHand : public ::testing::Test, protected test::NoServices {
 protected:
  ReferencePicturesByHand() { frames(3); }

  void add_pictures(const std::vector<fs::path>& files) override { jobs.add(files); }
  void pack_pictures(const std::vector<ObjectId>& pictures) override { jobs.pack(pictures); }
  void unpack_picture(ObjectId id, const fs::path& file) override { jobs.unpack(id, file); }
  void replace_picture(ObjectId id, const fs::path& file) override { jobs.replace(id, file); }
  void find_pictures(const fs::path& file) override { jobs.find(file); }
  void drop_files(const std::vector<fs::path>& files) override { bench.workbench().take_files(files); }
  void import_file(const fs::path& path) override { imported.push_back(path); }
  void open(const fs::path& path) override { opened.push_back(path); }
  void frames(int count) {
    for (int i = 0; i < count; ++i) bench.frame();
  }
  /// Waits until files are read and pictures are decoded and shown.
  void settle() {
    for (int i = 0; i < 4; ++i) {
      while (!work.idle()) {
        work.publish();
        std::this_thread::yield();
      }
      loader.sync();
      loader.wait();
      loader.publish();
      loader.sync();
      bench.frame();
    }
    frames(8);  // flights, and pictures that come to the GPU bit by bit
  }
  void run(const char* id) {
    const auto outcome = bench.workbench().commands().run(id);
    EXPECT_TRUE(outcome.ran) << id << ": " << outcome.reason;
    settle();
  }
  /// From the front, with room round the cube.
  void look_at_front() {
    run("view.front");
    Camera camera = editor.camera();
    camera.distance *= 3;
    editor.set_camera(camera);
    frames(3);
  }
  std::string why_not(const char* id) {
    const Command* command = bench.workbench().commands().find(id);
    const auto reason = command->why_not();
    return reason.value_or("");
  }
  /// Red, of a shape that shows which side is which: twice as wide as high.
  fs::path red_file(const std::string& name = "red.png") {
    Image image(40, 20);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) image.rgba[i] = image.rgba[i + 3] = 255;
    const fs::path path = folder.path() / name;
    EXPECT_TRUE(write_png(path, image).ok());
    return path;
  }
  void drop(const std::vector<fs::path>& files) {
    drop_files(files);
    settle();
  }
  void paste(const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
    bench.key("Ctrl+V");
    settle();
  }
  const Object& picture() { return *editor.document().objects.back(); }
  /// Whether the view shows the red of the picture at a place of the document's space.
  bool red_at(const Vector3& point) {
    frames(4);
    const Image image = bench.renderer().read(editor.layout.active());
    const auto place = Projector(editor.camera(), editor.viewport).project(point);
    if (!place || place->x() < 0 || place->y() < 0 || place->x() >= image.width || place->y() >= image.height)
      return false;
    const std::uint8_t* p = image.pixel(int(place->x()), int(place->y()));
    return p[0] > p[1] + 40 && p[0] > p[2] + 40;
  }
  /// Window pixels of a point of the document's space.
  Vector2 on_window(const Vector3& point) {
    const Vector3 place = Projector(editor.camera(), editor.viewport).project(point).value();
    const PanelRect rect = bench.workbench().viewport().rect();
    return {double(rect.min.x) + place.x(), double(rect.min.y) + place.y()};
  }
  void click_at(const Vector3& point) {
    const Vector2 at = on_window(point);
    bench.move(at.x(), at.y());
    bench.press();
    bench.release();
    bench.frame();
  }
  std::size_t notices(const std::string& part) {
    std::size_t count = 0;
    for (const Notice& notice : editor.notices()) count += notice.text.find(part) != std::string::npos;
    return count;
  }

  test::TemporaryFolder folder;
  std::vector<fs::path> imported, opened;
  test::HeadlessWorkbench bench{document_from_mesh(test::cube(), "Cube").value(), {1100, 760}, this};
  Editor& editor = bench.editor();
  BackgroundWork work{editor, [] {}};
  ReferenceJobs jobs{editor, work, [](const char*, const auto&) {}};
  ReferenceLoader loader{editor, [] {}};
};

TEST_F(ReferencePicturesByHand, DroppedOnASideViewItLiesBehindTheModelOfThatViewAlone) {
  look_at_front();
  const std::size_t steps = editor.history.position();
  drop({red_file()});
  ASSERT_EQ(editor.document().objects.size(), 2U);
  EXPECT_EQ(editor.history.position(), steps + 1) << "one step";
  const PictureSource& source = *picture().picture();
  EXPECT_EQ(picture().name, "red");
  EXPECT_EQ(source.look.layer, PictureLayer::behind);
  EXPECT_EQ(source.look.only_from, PictureSide::front);
  EXPECT_EQ(source.height() * 2, source.width);
  EXPECT_EQ(editor.mode, ElementMode::object);
  EXPECT_TRUE(editor.selection.contains({picture().id, element_of(picture().id)}));
  const double width = source.width;
  EXPECT_LT(width, editor.camera().view_height() * editor.viewport.aspect()) << "all of it is in sight";
  EXPECT_GT(width, 0.3 * editor.camera().view_height());
  const Vector3 beside(0.45 * width, 0, 0.07 * width), middle(0.1, 0, 0.1);
  EXPECT_TRUE(red_at(beside));
  EXPECT_FALSE(red_at(middle)) << "the cube stands before it";
  run("view.iso");
  EXPECT_FALSE(red_at(beside)) << "hidden in other views";
  run("view.front");
  EXPECT_TRUE(red_at(beside));
  run("edit.undo");
  EXPECT_EQ(editor.document().objects.size(), 1U);
  EXPECT_FALSE(red_at(beside));
  run("edit.redo");
  EXPECT_TRUE(red_at(beside));
}

TEST_F(ReferencePicturesByHand, DroppedOnAFreeViewItStandsInSpace) {
  drop({red_file("a.png"), red_file("b.png")});
  ASSERT_EQ(editor.document().objects.size(), 3U);
  const Object &first = *editor.document().objects[1], &second = *editor.document().objects[2];
  EXPECT_EQ(first.picture()->look.layer, PictureLayer::space);
  EXPECT_FALSE(first.picture()->look.only_from);
  EXPECT_EQ(faced_side(first.transform.rotation), PictureSide::front);
  EXPECT_NEAR(first.transform.translation.y(), 0, 1e-12);
  EXPECT_TRUE(world_box(first).intersection(world_box(second)).isEmpty()) << "side by side";
}

TEST_F(ReferencePicturesByHand, WhatIsNoPictureIsTold) {
  test::spill(folder.path() / "text.png", "no picture");
  drop({folder.path() / "text.png", folder.path() / "gone.jpg"});
  EXPECT_EQ(editor.document().objects.size(), 1U);
  EXPECT_EQ(notices("text.png: The file is no PNG"), 1U);
  EXPECT_EQ(notices("gone.jpg"), 1U);
}

TEST_F(ReferencePicturesByHand, PastedPathsArriveAsDroppedFilesDo) {
  look_at_front();
  const std::size_t steps = editor.history.position();
  const fs::path second = red_file("b.png");
  paste(file_uri(red_file("my side.png")) + "\r\n\"" + second.string() + "\"\n");
  ASSERT_EQ(editor.document().objects.size(), 3U);
  EXPECT_EQ(editor.history.position(), steps + 1) << "one step";
  const Object &first = *editor.document().objects[1], &other = *editor.document().objects[2];
  EXPECT_EQ(first.name, "my side");
  EXPECT_EQ(first.picture()->path, (folder.path() / "my side.png").generic_string());
  EXPECT_EQ(first.picture()->look.only_from, PictureSide::front) << "the view that it was pasted over";
  EXPECT_EQ(other.picture()->path, second.generic_string());
  EXPECT_TRUE(world_box(first).intersection(world_box(other)).isEmpty()) << "side by side";
  run("edit.undo");
  EXPECT_EQ(editor.document().objects.size(), 1U);
}

TEST_F(ReferencePicturesByHand, NothingLandsInADocumentThatWasOpenedMeanwhile) {
  drop_files({red_file()});
  editor.open(document_from_mesh(test::cube(), "Other").value(), {});
  settle();
  EXPECT_EQ(editor.document().objects.size(), 1U);
  EXPECT_EQ(notices("red.png was not added"), 1U);

  drop({red_file()});
  ASSERT_EQ(editor.document().objects.size(), 2U);
  jobs.replace(picture().id, red_file("other.png"));
  const Document same = editor.document();
  editor.open(same, {});
  settle();
  EXPECT_EQ(picture().picture()->path, (folder.path() / "red.png").generic_string());
}

TEST_F(ReferencePicturesByHand, OfFilesDroppedOnTheStartPageTheFirstIsOpenedAndTheOthersImported) {
  const fs::path first = folder.path() / "tent.obj", second = folder.path() / "pole.obj";
  editor.has_document = false;
  drop({first, second});
  EXPECT_EQ(opened, std::vector{first});
  EXPECT_EQ(imported, std::vector{second});
}

TEST_F(ReferencePicturesByHand, APastedModelIsImportedAndAPastedDocumentOpened) {
  const fs::path mesh = folder.path() / "tent.obj", model = folder.path() / "cup.hariko";
  paste(mesh.string());
  EXPECT_EQ(imported, std::vector{mesh});
  paste(model.string());
  EXPECT_EQ(opened, std::vector{model});
  editor.has_document = false;
  frames(2);
  paste(mesh.string());
  EXPECT_EQ(opened, (std::vector{model, mesh})) << "on the start page a mesh is opened";
  EXPECT_EQ(imported.size(), 1U);
}

TEST_F(ReferencePicturesByHand, TextThatNamesNoFileChangesNothingAndIsExplained) {
  const std::size_t steps = editor.history.position();
  for (const char* text : {"118 mm", "", "/home/ada/notes.txt"}) {
    editor.notices().clear();
    paste(text);
    EXPECT_EQ(notices("names no picture"), 1U) << text;
  }
  paste("pictures/front.png");
  EXPECT_EQ(notices("front.png: The path is relative"), 1U);
  paste("file://server/share/front.png");
  EXPECT_EQ(notices("another computer"), 1U);
  paste((folder.path() / "gone.png").string());
  EXPECT_EQ(notices("gone.png"), 1U) << "as when it is dropped";
  EXPECT_EQ(editor.history.position(), steps);
  EXPECT_TRUE(imported.empty() && opened.empty());
}

TEST_F(ReferencePicturesByHand, WhileAFieldTakesTextPastingIsItsOwn) {
  const std::string path = red_file().string();
  bench.tap("F2");
  frames(3);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput) << "the name is being typed";
  paste(path);
  EXPECT_EQ(editor.document().objects.size(), 1U);
  bench.tap("Enter");
  frames(3);
  paste(path);
  EXPECT_EQ(editor.document().objects.size(), 2U);
}

TEST_F(ReferencePicturesByHand, TwoClicksAndALengthMakeItTheRightSize) {
  look_at_front();
  drop({red_file()});
  const ObjectId id = picture().id;
  const double width = picture().picture()->width;
  const Vector3 a(-0.4 * width, 0, 0.1 * width), b(0.4 * width, 0, 0.1 * width);
  const std::size_t steps = editor.history.position();
  run("picture.scale");
  ASSERT_TRUE(bench.workbench().viewport().tool_active());
  click_at(a + Vector3(0, 0, 0.25 * width));
  click_at(a);
  click_at(b);
  const Similarity before = picture().transform;
  for (const char* key : {"1", "2", "0"}) bench.key(key);
  EXPECT_NE(picture().transform.scale, before.scale) << "it shows at once";
  bench.key("Enter");
  EXPECT_FALSE(bench.workbench().viewport().tool_active());
  EXPECT_EQ(editor.history.position(), steps + 1);
  const Similarity& now = editor.document().find(id)->transform;
  const double pixel = editor.camera().pixel_length(editor.viewport) / before.scale;
  // Pixels are what a hand hits: the distance is right to one of them.
  EXPECT_NEAR((now.apply(before.inverse().apply(b)) - now.apply(before.inverse().apply(a))).norm(), 120,
              3 * pixel * 120 / (0.8 * width));
  EXPECT_LT((now.apply(before.inverse().apply(a)) - a).norm(), 3 * pixel * now.scale)
      << "the first point stays";
  run("edit.undo");
  EXPECT_EQ(editor.document().find(id)->transform, before);
  // Esc at any time changes nothing.
  run("picture.scale");
  click_at(a);
  click_at(b);
  bench.key("5");
  EXPECT_TRUE(bench.workbench().viewport().tool_active());
  bench.key("Esc");
  EXPECT_FALSE(bench.workbench().viewport().tool_active());
  EXPECT_EQ(editor.document().find(id)->transform, before);
  EXPECT_EQ(editor.history.position(), steps);
}

TEST_F(ReferencePicturesByHand, ALockedOneLetsClicksThroughAndIsNotScaled) {
  look_at_front();
  drop({red_file()});
  const double width = picture().picture()->width;
  const Vector3 beside(0.45 * width, 0, 0.1 * width);
  const Vector2 at = on_window(beside);
  const PanelRect rect = bench.workbench().viewport().rect();
  const Vector2 pixel(at.x() - double(rect.min.x), at.y() - double(rect.min.y));
  const Projector projector(editor.camera(), editor.viewport);
  EXPECT_EQ(pictures_under(editor, projector, pixel).size(), 1U);
  run("object.lock");
  EXPECT_TRUE(pictures_under(editor, projector, pixel).empty());
  EXPECT_NE(why_not("picture.scale").find("locked"), std::string::npos);
  // Its look is no shape.
  bench.click("combo.picture_layer");
  frames(2);
  bench.click("choice.picture_layer.2");
  frames(2);
  EXPECT_EQ(picture().picture()->look.layer, PictureLayer::front);
}

TEST_F(ReferencePicturesByHand, ADragOverOneThatIsNotChosenDrawsABoxAndMovesOneThatIs) {
  look_at_front();
  drop({red_file()});
  const double width = picture().picture()->width;
  const Similarity before = picture().transform;
  const Vector2 from = on_window({0.4 * width, 0, 0.15 * width}),
                to = on_window({-0.4 * width, 0, -0.15 * width});
  const auto drag = [&] {
    bench.move(from.x(), from.y());
    bench.press();
    bench.move((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
    bench.move(to.x(), to.y());
    bench.release();
    frames(2);
  };
  editor.selection.clear_objects();
  drag();
  EXPECT_EQ(picture().transform, before);
  EXPECT_TRUE(editor.selection.objects().contains(editor.document().objects[0]->id))
      << "the cube is in the box";
  editor.selection.clear_objects();
  editor.selection.select({picture().id, element_of(picture().id)}, Selection::How::replace);
  frames(1);
  drag();
  EXPECT_GT((picture().transform.translation - before.translation).norm(), 0.3 * width) << "it went along";
}

TEST_F(ReferencePicturesByHand, ThePanelSaysWhereItLiesAndWhatShows) {
  drop({red_file()});
  frames(2);
  const auto& marks = bench.workbench().marks().all();
  for (const char* mark :
       {"picture.file", "picture.state", "slider.picture_opacity", "combo.picture_layer",
        "combo.picture_plane", "check.picture_only", "button.picture.scale", "button.picture.pack"})
    EXPECT_TRUE(marks.contains(mark)) << mark;
  EXPECT_FALSE(marks.contains("picture.error"));
  bench.click("combo.picture_plane");
  frames(2);
  bench.click("choice.picture_plane.4");
  frames(2);
  EXPECT_EQ(faced_side(picture().transform.rotation), PictureSide::top);
  bench.click("check.picture_only");
  frames(2);
  EXPECT_EQ(picture().picture()->look.only_from, PictureSide::top);
  run("edit.undo");
  EXPECT_FALSE(picture().picture()->look.only_from);
}

TEST_F(ReferencePicturesByHand, HiddenItCostsNoMemory) {
  drop({red_file()});
  const ObjectId id = picture().id;
  ASSERT_TRUE(editor.references.of(id)->image);
  const std::weak_ptr<const ReferenceImage> image = editor.references.of(id)->image;
  run("object.hide");
  EXPECT_FALSE(editor.references.of(id)->image);
  frames(3);
  EXPECT_TRUE(image.expired()) << "neither the scene nor the renderer keeps it";
  run("object.show_all");
  EXPECT_TRUE(editor.references.of(id)->image);
}

TEST_F(ReferencePicturesByHand, PackedItNeedsNoFile) {
  const fs::path file = red_file();
  const std::string bytes = test::slurp(file);
  drop({file});
  const ObjectId id = picture().id;
  run("picture.pack");
  ASSERT_TRUE(picture().picture()->packed());
  EXPECT_EQ(*picture().picture()->bytes, bytes) << "the original bytes";
  EXPECT_EQ(picture().picture()->path, "red.png");
  EXPECT_NE(why_not("picture.pack").find("already"), std::string::npos);
  fs::remove(file);
  ASSERT_TRUE(save_document(editor.document(), folder.path() / "model.hariko"));
  const Document again = load_document(folder.path() / "model.hariko").value();
  editor.open(again, folder.path() / "model.hariko");
  settle();
  EXPECT_TRUE(editor.references.of(id)->image) << "without its file";
  EXPECT_EQ(notices("cannot be shown"), 0U);
  // And out again.
  editor.selection.active = id;
  jobs.unpack(id, folder.path() / "out.png");
  settle();
  EXPECT_FALSE(picture().picture()->packed());
  EXPECT_EQ(picture().picture()->path, (folder.path() / "out.png").generic_string());
  EXPECT_EQ(test::slurp(folder.path() / "out.png"), bytes);
}

TEST_F(ReferencePicturesByHand, MissingOnesAreToldOnceAndFoundTogether) {
  fs::create_directory(folder.path() / "old");
  fs::create_directory(folder.path() / "new");
  drop({red_file("old/a.png"), red_file("old/b.png")});
  const ObjectId first = editor.document().objects[1]->id, second = editor.document().objects[2]->id;
  EXPECT_NE(why_not("picture.find"), "") << "none is missing";
  run("object.hide");  // both: whether they are there is found out all the same
  const fs::path file = folder.path() / "model.hariko";
  ASSERT_TRUE(save_document(editor.document(), file));
  for (const char* name : {"a.png", "b.png"})
    fs::rename(folder.path() / "old" / name, folder.path() / "new" / name);
  editor.open(load_document(file).value(), file);
  settle();
  EXPECT_EQ(notices("cannot be shown: 2 (a.png, b.png)"), 1U);
  settle();
  EXPECT_EQ(notices("cannot be shown"), 1U) << "once";
  EXPECT_EQ(why_not("picture.find"), "");
  run("object.show_all");
  editor.selection.active = first;
  editor.mode = ElementMode::object;
  settle();
  EXPECT_TRUE(bench.workbench().marks().all().contains("picture.error"));
  const std::size_t steps = editor.history.position();
  jobs.find(folder.path() / "new" / "a.png");
  settle();
  EXPECT_EQ(editor.history.position(), steps + 1) << "one step for both";
  for (const ObjectId id : {first, second}) {
    EXPECT_TRUE(editor.references.of(id)->image);
    EXPECT_FALSE(editor.references.of(id)->error);
  }
  EXPECT_NE(why_not("picture.find"), "");
}

TEST_F(ReferencePicturesByHand, AFileThatChangedIsReadAgainWhenAsked) {
  const fs::path file = red_file();
  look_at_front();
  drop({file});
  const double width = picture().picture()->width;
  const Vector3 beside(0.45 * width, 0, 0.07 * width);
  EXPECT_TRUE(red_at(beside));
  Image grey(40, 20);
  for (auto& byte : grey.rgba) byte = 128;
  ASSERT_TRUE(write_png(file, grey).ok());
  settle();
  EXPECT_TRUE(red_at(beside));
  run("picture.read_again");
  EXPECT_FALSE(red_at(beside));
}

TEST_F(ReferencePicturesByHand, TheStartPageTakesAPictureToo) {
  editor.has_document = false;
  drop({red_file()});
  EXPECT_TRUE(editor.has_document);
  ASSERT_EQ(editor.document().objects.size(), 1U);
  EXPECT_TRUE(picture().picture());
}

}  // namespace
}  // namespace hariko
