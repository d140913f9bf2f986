// Line drawings of the view: what they show, the file they become, and what keeps them from it.

#include "ui/files/picture_order.hpp"

#include <set>
#include <thread>

#include "app/jobs/picture_export.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "render/picture.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

Document prism() {
  return document_from_mesh(test::prism(5), "Prism").value();
}

Result<DrawingOrder> ordered(HeadlessWorkbench& bench, const DrawingSettings& settings = {},
                             const std::filesystem::path& file = "a.svg") {
  return order_drawing(bench.editor(), bench.workbench().viewport().scene(), settings, file);
}

/// As the window does it, on another thread.
Result<Done> write(const DrawingOrder& order, const CancelToken& cancel = {}, const Progress& progress = {}) {
  Result<Done> result = Done{};
  std::thread([&] { result = write_drawing(order, cancel, progress); }).join();
  return result;
}

TEST(DrawingOrder, IsSeenAsTheViewIs) {
  HeadlessWorkbench bench(prism());
  bench.wait_for_surfaces();
  for (const bool orthographic : {false, true}) {
    Camera camera = bench.editor().camera().orbit(0.4, 0.2);
    camera.orthographic = orthographic;
    bench.editor().set_camera(camera);
    bench.frame();
    const auto order = test::must(ordered(bench));
    const PixelSize viewport = bench.editor().viewport;
    EXPECT_NEAR(order->view.width / order->view.height, viewport.aspect(), 1e-12);
    const Projector projector(camera, viewport);
    const double scale = order->view.width / viewport.width;
    ASSERT_EQ(order->surfaces.size(), 1U);
    const DrawnSurface& drawn = order->surfaces[0];
    for (Index patch = 0; patch < drawn.surface.patch_count(); ++patch) {
      const PatchPoint local = drawn.surface.patches().evaluate(patch, Vector2(0.3, 0.3), Order::first);
      const Vector3 point = drawn.transform * Vector3(drawn.surface.origin() + local.position);
      EXPECT_LT((order->view.project(point).head<2>() - scale * projector.project(point)->head<2>()).norm(),
                1e-6);
    }
  }
}

/// Every line lies on the model or at its end, and where the model ends there is a line.
void expect_lines_where_the_picture_ends(Document document) {
  HeadlessWorkbench bench(std::move(document));
  bench.wait_for_surfaces();
  // A picture of the surface alone, of the size of the view, and the outline in pixels of it.
  PictureSettings picture;
  picture.transparent = true;
  picture.grid = false;
  const auto pixels = order_picture(bench.editor(), bench.workbench().viewport().scene(), picture, "a.png");
  ASSERT_TRUE(pixels.ok());
  Scene shown = pixels->scene;
  for (SceneObject& object : shown.objects) object.show_polyhedron = object.show_network = false;
  const auto image = render_picture(shown, pixels->cameras[0], pixels->size.width, pixels->size.height);
  ASSERT_TRUE(image.ok());
  DrawingSettings settings{.network = false};
  const auto order = test::must(ordered(bench, settings));
  const auto drawing = test::must(draw_lines(order->surfaces, order->view, order->lines));
  const double scale = pixels->size.width / order->view.width;
  const auto covered = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < image->width && y < image->height && image->pixel(x, y)[3] > 127;
  };
  std::set<std::pair<int, int>> near_lines;
  for (const PageLine& stroke : drawing->lines)
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
      for (int k = 0; k <= 200; ++k) {
        const Vector2 p =
            scale * (stroke.points[i - 1] + k / 200.0 * (stroke.points[i] - stroke.points[i - 1]));
        const int x = int(std::floor(p.x())), y = int(std::floor(p.y()));
        bool any = false;
        for (int dy = -2; dy <= 2; ++dy)
          for (int dx = -2; dx <= 2; ++dx) {
            any = any || covered(x + dx, y + dy);
            near_lines.insert({x + dx, y + dy});
          }
        EXPECT_TRUE(any) << "a line beside the model at " << p.transpose();
      }
  int edge = 0;
  for (int y = 1; y + 1 < image->height; ++y)
    for (int x = 1; x + 1 < image->width; ++x) {
      if (!covered(x, y) ||
          (covered(x - 1, y) && covered(x + 1, y) && covered(x, y - 1) && covered(x, y + 1)))
        continue;
      ++edge;
      EXPECT_TRUE(near_lines.contains({x, y})) << "no line at the end of the model at " << x << ", " << y;
    }
  EXPECT_GT(edge, 200);
}

TEST(DrawingOrder, LinesLieWhereThePictureEnds) {
  expect_lines_where_the_picture_ends(prism());
  expect_lines_where_the_picture_ends(
      load_document(test::source_folder() + "/assets/samples/fig2.hariko").value());
}

TEST(DrawingOrder, IsWrittenWhole) {
  const test::TemporaryFolder folder;
  HeadlessWorkbench bench(prism());
  bench.wait_for_surfaces();
  DrawingSettings settings{.width = 120};
  const auto order = test::must(ordered(bench, settings, folder.path() / "a.svg"));
  const Progress progress = Progress::make();
  ASSERT_TRUE(write(*order, {}, progress).ok());
  EXPECT_EQ(progress.fraction(), 1);
  const std::string svg = test::slurp(folder.path() / "a.svg");
  EXPECT_NE(svg.find("width=\"120mm\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"network\""), std::string::npos);
  EXPECT_EQ(svg.find("-hidden"), std::string::npos);

  settings.hidden = true;
  ASSERT_TRUE(write(*ordered(bench, settings, folder.path() / "b.svg")).ok());
  EXPECT_NE(test::slurp(folder.path() / "b.svg").find("id=\"network-hidden\""), std::string::npos);
  settings.network = false;
  ASSERT_TRUE(write(*ordered(bench, settings, folder.path() / "b.svg")).ok());
  const std::string outline = test::slurp(folder.path() / "b.svg");
  EXPECT_EQ(outline.find("id=\"network"), std::string::npos);
  EXPECT_NE(outline.find("id=\"silhouette\""), std::string::npos);

  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  test::must_fail(write(*ordered(bench, settings, folder.path() / "c.svg"), cancel), e_cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "c.svg"));
  test::must_fail(write(*ordered(bench, settings, folder.path() / "missing" / "c.svg")), e_file_write);
}

TEST(DrawingOrder, TheSectionOfTheViewCuts) {
  HeadlessWorkbench bench(prism());
  bench.wait_for_surfaces();
  bench.editor().view.section.shown = true;
  bench.editor().view.section.axis = 2;
  bench.editor().view.section.offset = bench.workbench().viewport().scene().scene().world_box().center().z();
  bench.frame();
  const auto order = test::must(ordered(bench));
  const auto drawing = test::must(draw_lines(order->surfaces, order->view, order->lines));
  const auto& strokes = drawing->lines;
  EXPECT_TRUE(std::any_of(strokes.begin(), strokes.end(),
                          [](const PageLine& stroke) { return stroke.kind == LineKind::section; }));
}

TEST(DrawingOrder, RefusalsSayWhy) {
  HeadlessWorkbench bench(prism());
  bench.wait_for_surfaces();
  const ObjectId id = bench.editor().active_object()->id;
  bench.editor().stale_since[id] = 0;
  EXPECT_EQ(ordered(bench).error().code, e_surface_pending);
  bench.editor().stale_since.clear();
  ASSERT_TRUE(ordered(bench).ok());
  const Document& document = bench.editor().history.current();
  DisplaySettings display = document.objects[0]->display;
  display.surface = false;
  ASSERT_TRUE(bench.editor().commit(set_display(document, id, display), "Hide surface"));
  bench.frame();
  EXPECT_EQ(ordered(bench).error().code, e_nothing_to_show);
}

TEST(DrawingOrder, TheDialogChoosesTheFormat) {
  struct Orders final : test::NoServices {
    void export_drawing(DrawingOrder order) override { lines = std::move(order); }
    void export_pictures(PictureOrder order) override { picture = std::move(order); }
    std::optional<DrawingOrder> lines;
    std::optional<PictureOrder> picture;
  };
  Orders orders;
  const std::optional<DrawingOrder>& lines = orders.lines;
  const std::optional<PictureOrder>& picture = orders.picture;
  HeadlessWorkbench bench(prism(), {800, 560}, &orders);
  bench.wait_for_surfaces();
  const auto frames = [&] { bench.frame(), bench.frame(), bench.frame(); };
  const auto shows = [&](const char* mark) { return bench.workbench().marks().all().contains(mark); };
  ASSERT_TRUE(bench.workbench().commands().run("file.export_picture").ran);
  frames();
  EXPECT_TRUE(shows("picture.size"));
  EXPECT_FALSE(shows("picture.page_width"));
  bench.click("dialog.format");
  frames();
  bench.click("dialog.format.svg");
  frames();
  EXPECT_FALSE(shows("picture.size"));
  ASSERT_TRUE(shows("picture.page_width"));
  bench.click("picture.hidden");
  bench.click("picture.network");
  bench.click("dialog.accept");
  frames();
  ASSERT_TRUE(lines.has_value());
  EXPECT_FALSE(picture.has_value());
  EXPECT_EQ(lines->file.filename(), "Untitled.svg");
  EXPECT_TRUE(lines->lines.hidden);
  EXPECT_FALSE(lines->lines.kinds.contains(LineKind::network));
  EXPECT_TRUE(lines->lines.kinds.contains(LineKind::silhouette));

  // The format of the last time is offered again, and can be changed back.
  ASSERT_TRUE(bench.workbench().commands().run("file.export_picture").ran);
  frames();
  EXPECT_TRUE(shows("picture.page_width"));
  bench.click("dialog.format");
  frames();
  bench.click("dialog.format.png");
  frames();
  bench.click("dialog.accept");
  frames();
  ASSERT_TRUE(picture.has_value());
  EXPECT_EQ(picture->files[0].filename(), "Untitled.png");
  // A turntable has one format only.
  ASSERT_TRUE(bench.workbench().commands().run("file.export_turntable").ran);
  frames();
  EXPECT_FALSE(shows("dialog.format"));
}

/// The vase, which bends outwards everywhere: nothing hides its outline.
class DrawingWork : public ::testing::Test, protected test::ProgramHands {
 protected:
  void SetUp() override { open_sample("fig2"); }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  void open_dialog() {
    bench().from_palette("export picture", "file.export_picture");
    frames(4);
  }
  void set_width(const char* text) {
    click("picture.page_width");
    type(text);
    click("dialog.name");
  }
  /// The written drawing.
  std::string accept_as(const std::string& name) {
    click("dialog.name");
    type((folder() / name).string());
    click("dialog.accept");
    wait();
    return test::slurp(folder() / name);
  }
  /// Names of the layers of a drawing.
  static std::set<std::string> layers(const std::string& svg) {
    const std::string begin = "<g id=\"";
    std::set<std::string> out;
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
      const std::size_t name = at + begin.size();
      out.insert(svg.substr(name, svg.find('"', name) - name));
    }
    return out;
  }
};

TEST_F(DrawingWork, ThePageAndTheLayersAreThoseOfTheDialog) {
  open_dialog();
  click("dialog.format");
  click("dialog.format.svg");
  ASSERT_TRUE(shows("picture.page_width"));
  click("picture.hidden");
  const std::string whole = accept_as("a.svg");
  EXPECT_NE(whole.find("width=\"180mm\""), std::string::npos) << notice();
  EXPECT_EQ(layers(whole), (std::set<std::string>{"silhouette", "network", "network-hidden"}));

  // The format and what was chosen for it are there again.
  open_dialog();
  ASSERT_TRUE(shows("picture.page_width"));
  set_width("9 cm");
  click("picture.hidden");
  click("picture.network");
  const std::string part = accept_as("b.svg");
  EXPECT_NE(part.find("width=\"90mm\""), std::string::npos) << notice();
  EXPECT_EQ(layers(part), std::set<std::string>{"silhouette"});
}

}  // namespace
}  // namespace hariko
