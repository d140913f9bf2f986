// Orbits and drags in the whole interface, with the real worker and renderer, in a picture off the screen:
// milliseconds a frame, and frames from the pointer to the surface that it made. A screen of 60 refreshes a
// second is played by waiting for the next one where a window swaps its buffers.
//
//     hariko_drag_bench WIDTH HEIGHT FACES shaded|zebra|gauss [FRAMES]

#include <epoxy/gl.h>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "app/engines/rebuild_engine.hpp"
#include "app/engines/surface_builder.hpp"
#include "bench/models.hpp"
#include "render/frame_target.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"
#include "tests/workbench/no_services.hpp"
#include "ui/base/fonts.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// Measured values of one kind.
class Values {
 public:
  void add(double value) { values_.push_back(value); }
  void print(const char* name) {
    if (values_.empty()) return;
    std::sort(values_.begin(), values_.end());
    const auto at = [&](double fraction) {
      return values_[std::min(values_.size() - 1,
                              static_cast<std::size_t>(fraction * static_cast<double>(values_.size())))];
    };
    std::printf("    %-28s p50 %8.2f  p95 %8.2f  most %8.2f  (%zu)\n", name, at(0.5), at(0.95), at(1),
                values_.size());
  }

 private:
  std::vector<double> values_;
};

/// A window without a screen.
class Bench {
 public:
  Bench(Document document, PixelSize size)
      : context_(OffscreenContext::create().value()), renderer_(Renderer::create().value()) {
    std::printf("%s\n", describe_gl().c_str());
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
#if IMGUI_VERSION_NUM < 18700
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
#endif
    metrics_.scale = 1;
    load_fonts({});
    apply_theme(ThemeId::dark, 1, palette_);
    if (!ImGui_ImplOpenGL3_Init("#version 330 core") || !window_.resize(size, 1)) std::abort();
    editor_.views = &engine_.views();
    editor_.open(std::move(document), {});
    editor_.frame_times.visible = true;
    const bool software = describe_gl().find("llvmpipe") != std::string::npos;
    workbench_ = std::make_unique<Workbench>(editor_, renderer_, software ? 1 : 4, metrics_, none_);
    settle();
  }
  ~Bench() {
    engine_.wait();
    workbench_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// `refreshes` a second; 0: frames follow each other at once.
  void orbit(double refreshes, int frames) {
    const PanelRect rect = workbench_->viewport().rect();
    const ImVec2 middle((rect.min.x + rect.max.x) / 2, (rect.min.y + rect.max.y) / 2);
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = middle;
    frame();
    io.MouseDown[ImGuiMouseButton_Middle] = true;
    frame();
    begin("orbit", refreshes);
    for (int i = 0; i < frames; ++i) {
      io.MousePos = along(middle, 300, 120, i);
      frame();
    }
    print();
    io.MouseDown[ImGuiMouseButton_Middle] = false;
    settle();
  }

  /// Moves the vertex nearest to the eye.
  void drag(double refreshes, int frames) {
    const ImVec2 start = select_vertex();
    ImGui::GetIO().MousePos = start;
    frame();
    key("G");
    if (!workbench_->viewport().tool_active()) std::abort();
    begin("drag of a vertex", refreshes);
    std::deque<std::tuple<std::shared_ptr<const Object>, int, Clock::time_point>> edits;  // not shown yet
    std::shared_ptr<const Object> last;
    for (int i = 0; i < frames; ++i) {
      const auto event = Clock::now();
      ImGui::GetIO().MousePos = along(start, 60, 40, i);
      frame();
      const auto object = editor_.document().objects[0];
      if (std::exchange(last, object) != object) edits.emplace_back(object, i, event);
      const auto view = engine_.views().find(object->id);
      if (view == engine_.views().end()) continue;
      const auto shown = std::find_if(edits.begin(), edits.end(), [&](const auto& edit) {
        return std::get<0>(edit) == view->second.object;
      });
      if (shown == edits.end()) continue;
      latency_.add(milliseconds(shown_at_ - std::get<2>(*shown)));
      latency_frames_.add(i - std::get<1>(*shown) + 1);
      surface_.add(view->second.milliseconds);
      edits.erase(edits.begin(), shown + 1);
    }
    print();
    key("Esc");
    settle();
  }

 private:
  static ImVec2 along(const ImVec2& middle, float across, float up, int step) {
    return {middle.x + across * std::sin(static_cast<float>(step) / 15),
            middle.y + up * std::sin(static_cast<float>(step) / 11)};
  }

  /// Steps of the application's frame, in the same order.
  void frame() {
    const auto start = Clock::now();
    editor_.now = milliseconds(start - zero_) / 1000;
    engine_.publish();
    ImGui::GetIO().DeltaTime = 1.0F / 60;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    workbench_->frame();
    engine_.sync(editor_.document(), editor_.history.in_gesture(), editor_.now, RecomputePolicy::live,
                 editor_.view.map);
    const auto ours = Clock::now();
    ImGui::Render();
    window_.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glFinish();
    const auto drawn = Clock::now();
    const double picture = workbench_->viewport().picture_milliseconds();
    frame_.add(milliseconds(drawn - start));
    picture_.add(picture);
    interface_.add(milliseconds(drawn - ours));
    ours_.add(milliseconds(ours - start) - picture);
    wait_for_refresh();
    shown_at_ = Clock::now();
  }

  void wait_for_refresh() {
    if (refreshes_ <= 0) return;
    const auto step =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / refreshes_));
    for (tick_ += step; Clock::now() > tick_; tick_ += step) ++missed_;
    std::this_thread::sleep_until(tick_);
  }

  void begin(const char* what, double refreshes) {
    std::printf("  %s, %s\n", what, refreshes > 0 ? "60 refreshes a second" : "without pauses");
    frame_ = picture_ = interface_ = ours_ = surface_ = latency_ = latency_frames_ = {};
    refreshes_ = refreshes;
    missed_ = 0;
    tick_ = Clock::now();
  }
  void print() {
    frame_.print("frame");
    picture_.print("  pictures of the model");
    interface_.print("  interface");
    ours_.print("  our own work");
    surface_.print("surface, by the worker");
    latency_.print("pointer to surface");
    latency_frames_.print("pointer to surface, frames");
    if (refreshes_ > 0) std::printf("    refreshes missed: %d\n", missed_);
    refreshes_ = 0;
  }

  void settle() {
    constexpr int rounds = 12;  // until what is still is drawn with all samples
    for (int i = 0; i < rounds; ++i) {
      frame();
      engine_.wait();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  void key(const char* text) {
    const KeyChord chord = KeyChord::parse(text).value();
    workbench_->key(
        {chord, static_cast<int>(chord.key) < 128 ? static_cast<char32_t>(chord.key) : char32_t(0)});
    frame();
  }

  /// Returns where it is in the window.
  ImVec2 select_vertex() {
    const Object& object = *editor_.document().objects[0];
    const PolyhedronSource& source = *object.polyhedron();
    const Projector projector(editor_.camera(), editor_.viewport);
    const ImVec2 corner = workbench_->viewport().rect().min;
    double nearest = std::numeric_limits<double>::infinity();
    ElementSelection one;
    ImVec2 place;
    for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
      const auto at = projector.project(source.origin + source.polyhedron.position(v));
      if (!at || at->z() >= nearest) continue;
      nearest = at->z();
      one.vertices = {source.polyhedron.vertex_id(v)};
      place = {corner.x + static_cast<float>(at->x()), corner.y + static_cast<float>(at->y())};
    }
    editor_.mode = ElementMode::vertex;
    editor_.selection.set(object.id, one);
    return place;
  }

  OffscreenContext context_;
  Renderer renderer_;
  gl::FrameTarget window_;
  Metrics metrics_;
  Palette palette_{};
  Editor editor_;
  RebuildEngine engine_{[] { return std::make_unique<SurfaceBuilder>(); }, [] {}};
  test::NoServices none_;
  std::unique_ptr<Workbench> workbench_;
  const Clock::time_point zero_ = Clock::now();
  double refreshes_ = 0;
  int missed_ = 0;
  Clock::time_point tick_, shown_at_;
  Values frame_, picture_, interface_, ours_, surface_, latency_, latency_frames_;
};

int run(int argc, char** argv) {
  constexpr int least_arguments = 5;
  if (argc < least_arguments) {
    std::puts("hariko_drag_bench WIDTH HEIGHT FACES shaded|zebra|gauss [FRAMES]");
    return 2;
  }
  const PixelSize size{std::atoi(argv[1]), std::atoi(argv[2])};
  const int frames = argc > least_arguments ? std::atoi(argv[5]) : 240;
  const std::string map = argv[4];
  Document document = document_from_mesh(bench_torus_mesh(std::atoi(argv[3])), "Torus").value();
  auto object = std::make_shared<Object>(*document.objects[0]);
  object->display.map = map == "zebra"   ? SurfaceMap::zebra
                        : map == "gauss" ? SurfaceMap::gaussian
                                         : SurfaceMap::shaded;
  document.objects[0] = object;
  std::printf("%d x %d, %zu faces, %s, ", size.width, size.height,
              std::size_t(object->polyhedron()->polyhedron.face_count()), map.c_str());
  Bench bench(std::move(document), size);
  for (const double refreshes : {0.0, 60.0}) {
    bench.orbit(refreshes, frames);
    bench.drag(refreshes, frames);
  }
  return 0;
}

}  // namespace
}  // namespace hariko

int main(int argc, char** argv) {
  return hariko::run(argc, argv);
}
