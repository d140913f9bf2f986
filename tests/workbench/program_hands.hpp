#pragma once

// ProgramHands: the program but for its window, driven by hand, with a count of what the hands do: a click, a
// double click, a drag, a turn of the wheel, a chord and a number or name that is typed are one action each.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/document_session.hpp"
#include "app/engines/paper_engine.hpp"
#include "app/jobs/conversion_jobs.hpp"
#include "app/jobs/edit_jobs.hpp"
#include "app/jobs/exchange_jobs.hpp"
#include "render/shown_edges.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {

class ProgramHands : private NoServices {
 public:
  enum class Begin { empty, start_page };
  using Folder = std::shared_ptr<const TemporaryFolder>;
  /// In `folder` lie settings, recovery copies and the files of the user. CAD files are not written.
  explicit ProgramHands(Begin begin = Begin::empty, Folder folder = std::make_shared<TemporaryFolder>())
      : user_(std::move(folder)), bench_(Document(), {1440, 900}, this) {
    editor().on_long_edit = [this](const LongEdit& edit) { long_edits_.make(edit); };
    if (begin == Begin::start_page) bench_.workbench().close_document();
    frames(2);
  }

  Editor& editor() { return bench_.editor(); }
  HeadlessWorkbench& bench() { return bench_; }
  DocumentSession& session() { return session_; }
  const std::map<std::string, Marks::Rect>& marks() { return bench_.workbench().marks().all(); }
  const std::filesystem::path& folder() const { return user_->path(); }
  /// CAD files that would be written.
  const std::filesystem::path& exported() const { return exported_; }

  // Gestures.
  void click(const std::string& mark) {
    ++actions_;
    ASSERT_TRUE(marks().contains(mark)) << mark;
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
      chord.key = c;
      bench_.workbench().key({chord, static_cast<char32_t>(c)});
      bench_.frame();
    }
  }
  /// Into a dialog that asks for a file.
  void name_file(const std::string& name) {
    frames(4);
    ASSERT_TRUE(marks().contains("dialog.name"));
    type((folder() / name).string());
    press({"Enter"});
  }

  // Waiting for the program.
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      long_.publish();
      edits_.publish();
      if (!ImGui::IsAnyMouseDown()) long_edits_.settle();
      session_.publish();
      paper_.publish();
      bench_.frame();
      session_.update();
      paper_.sync();
    }
  }
  /// Until work is done, surfaces are there and the view rests.
  void wait() {
    do {
      frames(1);
      std::this_thread::yield();
    } while (!long_.idle() || !edits_.idle() || !session_.idle() || !paper_.idle() || !editor().jobs.empty());
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
  Vector2 middle_of(const std::string& mark) {
    const Marks::Rect rect = marks().at(mark);
    return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
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
  std::string hint() { return bench_.workbench().viewport().hint(); }
  std::string notice() { return editor().notices().empty() ? std::string() : editor().notices().back().text; }

  int actions() const { return actions_; }
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
  void export_pages(const std::filesystem::path& path) override { exchange_.export_pages(path); }
  void export_sections(SectionOrder order) override { exchange_.export_sections(std::move(order)); }
  void export_cad(const std::filesystem::path& path, const CadSettings&) override { exported_ = path; }
  void convert(ObjectId object) override { conversions_.convert(object); }

  Folder user_;
  std::filesystem::path exported_;
  int actions_ = 0;
  HeadlessWorkbench bench_;
  BackgroundWork long_{bench_.editor(), [] {}}, edits_{bench_.editor(), [] {}};
  EditJobs long_edits_{bench_.editor(), edits_};
  PaperEngine paper_{bench_.editor(), long_, [] {}};
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
