// Pictures and turntables of the view: what they show, the files they become, and what keeps them from it.

#include "ui/files/picture_order.hpp"

#include <set>
#include <thread>

#include "app/jobs/picture_export.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/edits/edits.hpp"
#include "render/picture.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

using test::files_in;
using test::HeadlessWorkbench;

Document box_document() {
  return document_from_mesh(test::prism(4), "Box").value();
}

PictureSettings small(int width, int height) {
  PictureSettings settings;
  settings.size = PictureSettings::Size::custom;
  settings.custom = {width, height};
  return settings;
}

/// As the window does it: on a thread without a context.
Result<Done> write(const PictureOrder& order, const CancelToken& cancel = {}, const Progress& progress = {}) {
  Result<Done> result = Done{};
  std::thread([&] { result = write_pictures(order, cancel, progress); }).join();
  return result;
}

TEST(PictureOrder, APictureHasTheSizeAndTheBackgroundThatWereAskedFor) {
  const test::TemporaryFolder folder;
  HeadlessWorkbench bench(box_document());
  bench.wait_for_surfaces();
  for (const bool transparent : {false, true}) {
    PictureSettings settings = small(320, 200);
    settings.transparent = transparent;
    settings.grid = false;
    const auto order = order_picture(bench.editor(), bench.workbench().viewport().scene(), settings,
                                     folder.path() / "box.png");
    ASSERT_TRUE(order.ok()) << to_string(order.error());
    const auto written = write(*order);
    ASSERT_TRUE(written.ok()) << to_string(written.error());
    const auto image = test::must(read_png(folder.path() / "box.png"));
    EXPECT_EQ(image->width, 320);
    EXPECT_EQ(image->height, 200);
    EXPECT_EQ(image->pixel(2, 2)[3], transparent ? 0 : 255);
    EXPECT_EQ(image->pixel(160, 100)[3], 255) << "the model is in the middle";
    std::set<int> reds;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 320; ++x) reds.insert(image->pixel(x, y)[0]);
    EXPECT_GT(reds.size(), 40U) << "hardly anything is drawn";
  }
}

TEST(PictureOrder, WhatIsSelectedShowsOnlyWhenAskedFor) {
  HeadlessWorkbench bench(box_document());
  bench.wait_for_surfaces();
  bench.editor().selection.select_all(*bench.editor().active_object(), ElementMode::vertex);
  bench.frame();
  const auto& scene = bench.workbench().viewport().scene();
  ASSERT_FALSE(scene.scene().objects[0].selected.vertices.empty());
  PictureSettings settings = small(64, 64);
  EXPECT_TRUE(
      order_picture(bench.editor(), scene, settings, "a.png")->scene.objects[0].selected.vertices.empty());
  settings.selection = true;
  EXPECT_FALSE(
      order_picture(bench.editor(), scene, settings, "a.png")->scene.objects[0].selected.vertices.empty());
}

TEST(PictureOrder, ANarrowPictureShowsAllThatTheViewShows) {
  HeadlessWorkbench bench(box_document());
  bench.wait_for_surfaces();
  const Editor& editor = bench.editor();
  const Projector view(editor.camera(), editor.viewport);
  // Points at the middles of the view's left and right borders.
  const double middle = editor.viewport.height / 2.0;
  const Vector3 left = view.on_facing_plane({1, middle}, editor.camera().target);
  const Vector3 right = view.on_facing_plane({editor.viewport.width - 1.0, middle}, editor.camera().target);
  const auto order = order_picture(editor, bench.workbench().viewport().scene(), small(100, 400), "a.png");
  ASSERT_TRUE(order.ok());
  const Projector picture(order->cameras[0], order->size);
  EXPECT_GE(picture.project(left)->x(), 0);
  EXPECT_LE(picture.project(right)->x(), 100);
  EXPECT_LT(picture.project(left)->x(), 2) << "the model is smaller than it need be";
}

TEST(PictureOrder, ATurntableGoesOnceRoundAndShowsTheWholeModelEverywhere) {
  // Far from the middle of the world, longer than wide.
  Document document = box_document();
  const Similarity place{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vector3::UnitX())), 3, {40, -7, 2}};
  document = set_transform(document, document.objects[0]->id, place).value();
  HeadlessWorkbench bench(document);
  bench.wait_for_surfaces();
  PictureSettings settings = small(300, 200);
  settings.turntable_pictures = 8;
  const auto order =
      order_turntable(bench.editor(), bench.workbench().viewport().scene(), settings, "/tmp/turn.png");
  ASSERT_TRUE(order.ok()) << to_string(order.error());
  ASSERT_EQ(order->cameras.size(), 8U);
  ASSERT_EQ(order->files.size(), 8U);
  EXPECT_EQ(order->files.front(), "/tmp/turn_0001.png");
  EXPECT_EQ(order->files.back(), "/tmp/turn_0008.png");
  std::vector<Vector3> outline;
  for (const SceneObject& object : order->scene.objects) object.add_outline(outline);
  ASSERT_FALSE(outline.empty());
  const Vector3 centre = order->scene.world_box().center();
  const auto radius = [&](const Camera& camera) { return (camera.eye() - centre).head<2>().norm(); };
  double turned = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Camera &now = order->cameras[i], &next = order->cameras[(i + 1) % 8];
    EXPECT_NEAR(radius(now), radius(order->cameras[0]), 1e-9 * radius(now));
    EXPECT_NEAR(now.eye().z(), order->cameras[0].eye().z(), 1e-9 * radius(now));
    const double step = std::acos(std::clamp(
        (now.eye() - centre).head<2>().normalized().dot((next.eye() - centre).head<2>().normalized()), -1.0,
        1.0));
    turned += step;
    const Projector projector(now, order->size);
    for (const Vector3& point : outline) {
      const auto pixel = projector.project(point);
      ASSERT_TRUE(pixel.has_value());
      ASSERT_TRUE(pixel->x() >= 0 && pixel->x() <= 300 && pixel->y() >= 0 && pixel->y() <= 200)
          << "picture " << i << " cuts the model off at " << pixel->transpose();
    }
  }
  EXPECT_NEAR(turned, 2 * 3.14159265358979, 1e-6);
}

TEST(PictureOrder, ASeriesIsWrittenWholeOrRemoved) {
  const test::TemporaryFolder folder;
  HeadlessWorkbench bench(box_document());
  bench.wait_for_surfaces();
  PictureSettings settings = small(64, 48);
  settings.turntable_pictures = 3;
  const auto& scene = bench.workbench().viewport().scene();
  auto order = test::must(order_turntable(bench.editor(), scene, settings, folder.path() / "turn.png"));
  const Progress progress = Progress::make();
  ASSERT_TRUE(write(*order, {}, progress).ok());
  EXPECT_EQ(progress.fraction(), 1);
  EXPECT_EQ(files_in(folder.path()), 3U);
  EXPECT_NE(test::slurp(order->files[0]), test::slurp(order->files[1])) << "nothing turns";

  // Cancelled as soon as something was written.
  settings.turntable_pictures = 400;
  const auto cancelled_folder = folder.path() / "cancelled";
  std::filesystem::create_directory(cancelled_folder);
  order = order_turntable(bench.editor(), scene, settings, cancelled_folder / "turn.png");
  const CancelToken cancel = CancelToken::make();
  const Progress how_far = Progress::make();
  Result<Done> result = Done{};
  std::thread worker([&] { result = write_pictures(*order, cancel, how_far); });
  while (how_far.fraction() <= 0) std::this_thread::yield();
  cancel.cancel();
  worker.join();
  test::must_fail(result, e_cancelled);
  EXPECT_EQ(files_in(cancelled_folder), 0U);
}

TEST(PictureOrder, RefusalsSayWhy) {
  const test::TemporaryFolder folder;
  HeadlessWorkbench bench(box_document());
  bench.wait_for_surfaces();
  const auto& scene = bench.workbench().viewport().scene();
  const auto code = [](const auto& result) { return result.ok() ? Code{"none"} : result.error().code; };
  const auto ordered = [&](const PictureSettings& settings) {
    return order_picture(bench.editor(), scene, settings, folder.path() / "missing" / "a.png");
  };
  EXPECT_EQ(code(ordered(small(0, 10))), e_picture_size);
  EXPECT_EQ(code(ordered(small(10, 9000))), e_picture_size);
  PictureSettings many = small(10, 10);
  many.turntable_pictures = 100'000;
  EXPECT_EQ(code(order_turntable(bench.editor(), scene, many, "a.png")), e_picture_count);

  const auto order = test::must(ordered(small(10, 10)));
  const auto written = write(*order);
  test::must_fail(written, e_file_write);
  EXPECT_NE(written.error().text.find("missing"), std::string::npos) << written.error().text;

  bench.editor().stale_since[bench.editor().active_object()->id] = 0;
  EXPECT_EQ(code(ordered(small(10, 10))), e_surface_pending);
  bench.editor().stale_since.clear();

  const Document& document = bench.editor().history.current();
  ASSERT_TRUE(bench.editor().commit(set_visible(document, document.objects[0]->id, false), "Hide"));
  bench.frame();
  EXPECT_EQ(code(ordered(small(10, 10))), e_nothing_to_show);
  const auto outcome = bench.workbench().commands().run("file.export_picture");
  EXPECT_FALSE(outcome.ran);
  EXPECT_EQ(outcome.reason, "No object is visible. Show one or add one.");
}

TEST(PictureOrder, TheDialogGivesTheOrder) {
  struct Orders final : test::NoServices {
    void export_pictures(PictureOrder order) override { last = std::move(order); }
    std::optional<PictureOrder> last;
  };
  Orders orders;
  const std::optional<PictureOrder>& given = orders.last;
  HeadlessWorkbench bench(box_document(), {800, 560}, &orders);
  bench.wait_for_surfaces();
  ASSERT_TRUE(bench.workbench().commands().run("file.export_turntable").ran);
  for (int i = 0; i < 5; ++i) bench.frame();  // rows of options find their places
  for (const char* mark :
       {"picture.size", "picture.count", "picture.transparent", "picture.grid", "dialog.name"})
    EXPECT_TRUE(bench.workbench().marks().all().contains(mark)) << mark;
  bench.click("picture.transparent");
  bench.click("picture.grid");
  for (int i = 0; i < 3; ++i) bench.frame();
  bench.click("dialog.accept");
  bench.frame();
  ASSERT_TRUE(given.has_value());
  EXPECT_EQ(given->files.size(), 72U);
  EXPECT_EQ(given->files[0].filename(), "Untitled_0001.png");
  EXPECT_EQ(given->scene.background, Background::transparent);
  ASSERT_TRUE(bench.workbench().viewport().scene().scene().grid.visible);
  EXPECT_FALSE(given->scene.grid.visible);
  EXPECT_EQ(given->size, bench.editor().viewport);
}

TEST(PictureOrder, LeavingAsksAboutWorkThatIsNotFinished) {
  struct Leaving final : test::NoServices {
    void quit() override { left = true; }
    bool left = false;
  };
  Leaving leaving;
  const bool& left = leaving.left;
  HeadlessWorkbench bench(box_document(), {800, 560}, &leaving);
  bench.wait_for_surfaces();  // text about them in the status line moves its button
  bench.editor().jobs.push_back(
      std::make_shared<const Job>(Job{"Exporting turn.png", true, CancelToken::make(), Progress::make()}));
  bench.editor().jobs.back()->progress.report(0.42);
  bench.frame();
  EXPECT_TRUE(bench.workbench().marks().all().contains("status.cancel_job"));
  bench.workbench().quit();
  bench.frame();
  bench.frame();
  EXPECT_FALSE(left);
  ASSERT_NE(bench.workbench().question(), nullptr);
  EXPECT_NE(bench.workbench().question()->text.find("turn.png"), std::string::npos);
  bench.click("prompt.wait");
  bench.frame();
  EXPECT_FALSE(left);
  // The button in the status line stops it; then nothing is asked.
  bench.click("status.cancel_job");
  EXPECT_TRUE(bench.editor().jobs.back()->cancel.cancelled());
  bench.workbench().quit();
  EXPECT_TRUE(left);
}

}  // namespace
}  // namespace hariko
