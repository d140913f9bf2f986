#pragma once

// ProgramHands: the program but for its window, driven by hand, with a count of what the hands do: a click, a
// double click, a drag, a turn of the wheel, a chord and a number or name that is typed are one action each.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/document_session.hpp"
#include "app/engines/gauss_engine.hpp"
#include "app/engines/mesh_previewer.hpp"
#include "app/engines/paper_engine.hpp"
#include "app/jobs/conversion_jobs.hpp"
#include "app/jobs/edit_jobs.hpp"
#include "app/jobs/exchange_jobs.hpp"
#include "app/jobs/skin_jobs.hpp"
#include "render/scene.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko::test {

class ProgramHands : private NoServices {
 public:
  enum class Begin { empty, start_page };
  using Folder = std::shared_ptr<const TemporaryFolder>;
  /// In `folder` lie settings, recovery copies and the files of the user. CAD files are not written.
  explicit ProgramHands(Begin begin = Begin::empty, Folder folder = std::make_shared<TemporaryFolder>(),
                        ImVec2 size = {1440, 900})
      : user_(std::move(folder)), bench_(Document(), size, this) {
    editor().on_long_edit = [this](const LongEdit& edit) { long_edits_.make(edit); };
    if (begin == Begin::start_page) bench_.workbench().close_document();
    frames(2);
  }

  Editor& editor() { return bench_.editor(); }
  HeadlessWorkbench& bench() { return bench_; }
  DocumentSession& session() { return session_; }
  const std::map<std::string, Marks::Rect>& marks() { return bench_.workbench().marks().all(); }
  const std::filesystem::path& folder() const { return user_->path(); }
  ExchangeJobs& exchange() { return exchange_; }
  /// CAD files that would be written.
  const std::filesystem::path& exported() const { return exported_; }

  // Gestures.
  void click(const std::string& mark) {
    ++actions_;
    bench_.click(mark);
    frames(3);
  }
  void click(const Vector2& at, int times = 1) {
    ++actions_;
    bench_.move(at.x(), at.y());
    for (int i = 0; i < times; ++i) {
      bench_.press();
      bench_.release();
    }
    frames(2);
  }
  void drag(const Vector2& from, const Vector2& to, int button = 0) {
    begin_drag(from, to, button);
    bench_.release(button);
    frames(2);
  }
  /// Drags a handle, with Ctrl held after the press.
  void drag_in_steps(const Vector2& from, const Vector2& to) {
    ++actions_;
    bench_.move(from.x(), from.y());
    bench_.press();
    bench_.hold(false, true, false);
    bench_.move((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
    bench_.move(to.x(), to.y());
    bench_.release();
    bench_.hold(false, false, false);
    frames(2);
  }
  /// One stroke of the left button through all these places.
  void stroke(const std::vector<Vector2>& places) {
    ++actions_;
    bench_.move(places.front().x(), places.front().y());
    bench_.press();
    for (const Vector2& place : places) bench_.move(place.x(), place.y());
    bench_.release();
    frames(2);
  }
  /// Leaves the button pressed.
  void begin_drag(const Vector2& from, const Vector2& to, int button = 0) {
    ++actions_;
    bench_.move(from.x(), from.y());
    bench_.press(button);
    bench_.move((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
    bench_.move(to.x(), to.y());
  }
  void wheel(double steps) {
    ++actions_;
    bench_.wheel(steps);
    frames(1);
  }
  void press(std::initializer_list<const char*> chords) {
    for (const char* chord : chords) {
      ++actions_;
      bench_.tap(chord);
    }
    frames(2);
  }
  /// A number or a name: into the field that has the keyboard, else for the running tool.
  void type(std::string_view text) {
    ++actions_;
    if (ImGui::GetIO().WantTextInput) return bench_.type(text);
    for (const char c : text) {
      KeyChord chord;
      chord.key = Key{c};
      bench_.workbench().key({chord, static_cast<char32_t>(c)});
      bench_.frame();
    }
  }
  /// An entry of a menu.
  void menu(const char* name, const char* command) {
    click(std::string("menu.") + name);
    click(std::string("command.") + command);
  }
  /// An item of a list in the properties.
  void choose(const std::string& list, int number) {
    click("combo." + list);
    click("choice." + list + "." + std::to_string(number));
  }
  /// A number into a field of the properties.
  void enter(const std::string& field, std::string_view text) {
    click("field." + field);
    type(text);
    press({"Enter"});
  }
  /// Into a dialog that asks for a file.
  void name_file(const std::string& name) {
    frames(4);
    ASSERT_TRUE(marks().contains("dialog.name"));
    type((folder() / name).string());
    press({"Enter"});
  }

  /// Opens a file of the checkout as one of the user's, without the dialog.
  void open_copy(const std::string& file) {
    const std::filesystem::path original = std::filesystem::path(source_folder()) / file;
    std::filesystem::copy_file(original, folder() / original.filename());
    session_.open(folder() / original.filename());
    wait();
  }
  void open_sample(const std::string& name) { open_copy("assets/samples/" + name + ".hariko"); }

  // Waiting for the program.
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      long_.publish();
      edits_.publish();
      if (!ImGui::IsAnyMouseDown()) {
        skins_.settle();
        long_edits_.settle();
      }
      session_.publish();
      paper_.publish();
      gauss_.publish();
      meshes_.publish();
      bench_.frame();
      session_.update();
      paper_.sync();
      gauss_.sync();
      meshes_.sync();
    }
  }
  /// Until work is done, surfaces are there and the view rests.
  void wait() {
    do {
      frames(1);
      std::this_thread::yield();
    } while (!long_.idle() || !edits_.idle() || !session_.idle() || !paper_.idle() || !gauss_.idle() ||
             !meshes_.idle() || !editor().jobs.empty());
    bench_.wait_for_surfaces();
    constexpr int flight = 8;
    frames(flight);
  }

  // Queries of the screen.
  Vector2 pixel(const Vector3& world) {
    const ImVec2 corner = bench_.workbench().viewport().rect().min;
    return Projector(editor().camera(), editor().viewport).project(world)->head<2>() +
           Vector2(double(corner.x), double(corner.y));
  }
  double depth(const Vector3& world) {
    return Projector(editor().camera(), editor().viewport).project(world)->z();
  }
  /// The corner of the first object that is nearest to the eye.
  Vector2 nearest_corner() {
    const PolyhedronSource& source = *editor().document().objects[0]->polyhedron();
    Vector3 best = source.origin + source.polyhedron.position(0);
    for (Index v = 1; v < source.polyhedron.vertex_count(); ++v)
      if (const Vector3 at = source.origin + source.polyhedron.position(v); depth(at) < depth(best))
        best = at;
    return pixel(best);
  }
  Vector2 middle_of(const std::string& mark) {
    const Marks::Rect rect = marks().at(mark);
    return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
  }
  /// Marks that begin so.
  std::vector<std::string> marks_of(std::string_view beginning) {
    std::vector<std::string> out;
    for (const auto& [mark, rect] : marks())
      if (mark.starts_with(beginning)) out.push_back(mark);
    return out;
  }
  /// A place in the first view, as shares of its size.
  Vector2 in_view(double x, double y) {
    const Marks::Rect view = marks().at("view.0");
    return {view.x + x * view.width, view.y + y * view.height};
  }
  /// Reason that the active object has no newer surface; empty where it has one.
  std::string surface_error() {
    const SurfaceView* view = editor().view_of(editor().selection.active);
    if (!view || !view->mesh) return "no surface";
    return view->error ? to_string(*view->error) : std::string();
  }
  /// The middle of the curve of the edge whose straight line has its middle nearest to a place.
  Vector2 curve_near(const Vector3& place) {
    const SceneObject& object = bench_.workbench().viewport().scene().scene().objects[0];
    const DisplayPolyhedron& lines = *object.polyhedron;
    const auto end = [&](Index v) { return object.to_world(lines.origin, lines.positions[v]); };
    Index best = 0;
    double least = 1e300;
    for (Index e = 0; e < lines.edges.size(); ++e) {
      const double far = ((end(lines.edges[e][0]) + end(lines.edges[e][1])) / 2 - place).norm();
      if (far < least) least = far, best = e;
    }
    const std::vector<Vector3> curve = shown_curve(object, best);
    return pixel(curve[curve.size() / 2]);
  }
  /// Selection in the active object, in words.
  std::string selected() {
    return describe_in(editor().active_object(), editor().selection.of_active(), Language());
  }
  /// Whether so many steps lead here, the last one with this name.
  void expect_step(std::size_t position, std::string_view label) {
    EXPECT_EQ(editor().history.position(), position);
    EXPECT_EQ(editor().history.undo_label(), label);
  }
  /// The same, once everything has followed it.
  void wait_for_step(std::size_t position, std::string_view label) {
    wait();
    expect_step(position, label);
  }
  std::string hint() { return bench_.workbench().viewport().hint(); }
  std::string notice() { return editor().notices().empty() ? std::string() : editor().notices().back().text; }

  int actions() const { return actions_; }
  /// Meshes that the panel of triangles has got.
  int meshed() const { return meshed_; }
  /// Clicks and keys before another start of the program.
  void count_from(int actions) { actions_ += actions; }
  void expect_at_most(int most, const char* job) const {
    std::printf("%s: %d actions\n", job, actions_);
    ::testing::Test::RecordProperty("actions", actions_);
    EXPECT_LE(actions_, most) << job;
  }

 private:
  void open(const std::filesystem::path& path) override { session_.open(path); }
  void save(const std::filesystem::path& path, std::function<void()> then) override {
    session_.save(path, std::move(then));
  }
  void recover(const std::string& id) override { session_.recover(id); }
  void import_file(const std::filesystem::path& path) override { exchange_.import_file(path); }
  void export_file(const std::filesystem::path& path, const ExportSettings& settings) override {
    exchange_.export_file(path, settings);
  }
  void count_export(const std::filesystem::path& path, const ExportSettings& settings) override {
    exchange_.count_export(path, settings);
  }
  void cancel_count() override { exchange_.cancel_count(); }
  void export_control(const std::filesystem::path& path) override { exchange_.export_control(path); }
  void export_pages(const std::filesystem::path& path) override { exchange_.export_pages(path); }
  void export_pictures(PictureOrder order) override { exchange_.export_pictures(std::move(order)); }
  void export_drawing(DrawingOrder order) override { exchange_.export_drawing(std::move(order)); }
  void export_sections(SectionOrder order) override { exchange_.export_sections(std::move(order)); }
  void export_cad(const std::filesystem::path& path, const CadSettings&) override { exported_ = path; }
  void convert(ObjectId object) override { conversions_.convert(object); }
  void add_section(ObjectId skin, double place) override { skins_.add_section(skin, place); }

  Folder user_;
  std::filesystem::path exported_;
  int actions_ = 0, meshed_ = 0;
  HeadlessWorkbench bench_;
  BackgroundWork long_{bench_.editor(), [] {}}, edits_{bench_.editor(), [] {}};
  EditJobs long_edits_{bench_.editor(), edits_};
  SkinJobs skins_{bench_.editor(), edits_, [](const char*, const auto&) {}};
  GaussEngine gauss_{bench_.editor(), bench_.editor().gauss, [] {}};
  PaperEngine paper_{bench_.editor(), long_, [] {}};
  MeshPreviewer meshes_{bench_.editor(), [] {}, [this] { ++meshed_; }};
  ConversionJobs conversions_{bench_.editor(), long_, [](const char*, const auto&) {}};
  ExchangeJobs exchange_{bench_.editor(), bench_.workbench(), long_, [](const char*, const auto&) {}};
  Pictures pictures_{bench_.renderer(), long_, folder() / "cache"};
  DocumentSession session_{bench_.editor(),
                           bench_.workbench(),
                           {folder() / "config", folder() / "state", folder() / "cache"},
                           folder() / "samples",
                           {[] {}, [] {}, [](const char*, const auto&) {}}};

 public:
  /// Looks for what earlier sessions left, as the program does when it starts.
  void find_offers() {
    session_.find_offers(pictures_);
    wait();
  }
};

}  // namespace hariko::test
