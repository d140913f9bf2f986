#pragma once

// HeadlessWorkbench: the interface of one window without a window. Pointer and keys are given by the test,
// pictures are drawn off the screen, surfaces are computed by the real engine.

#include <gtest/gtest.h>
#include <imgui.h>

#include <memory>
#include <optional>

#include "app/engines/rebuild_engine.hpp"
#include "app/engines/surface_builder.hpp"
#include "render/offscreen.hpp"
#include "tests/support/places.hpp"
#include "tests/workbench/no_services.hpp"
#include "ui/base/fonts.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko::test {

class HeadlessWorkbench {
 public:
  /// Asserts that OpenGL is there: where the tests run it must be.
  /// `services`: the application, which is borrowed; null for one that does nothing.
  explicit HeadlessWorkbench(Document document, ImVec2 size = {800, 560},
                             ApplicationServices* services = nullptr)
      : context_(OffscreenContext::create().value()), renderer_(Renderer::create().value()) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = size;
#if IMGUI_VERSION_NUM < 18700
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
#endif
    metrics_.scale = 1;
    set_fonts({});
    apply_theme(ThemeId::dark, 1, palette_);
    editor_.views = &engine_.views();
    editor_.open(std::move(document), {});
    editor_.languages = find_languages(source_folder() + "/assets/languages").files;
    workbench_ = std::make_unique<Workbench>(editor_, renderer_, 1, metrics_, services ? *services : none_);
    frame();
    frame();
  }
  ~HeadlessWorkbench() {
    engine_.wait();
    workbench_.reset();
    ImGui::DestroyContext();
  }
  HeadlessWorkbench(const HeadlessWorkbench&) = delete;
  HeadlessWorkbench& operator=(const HeadlessWorkbench&) = delete;

  Editor& editor() {
    return editor_;
  }
  Workbench& workbench() {
    return *workbench_;
  }
  Renderer& renderer() {
    return renderer_;
  }

  /// Between frames.
  void set_fonts(const FontRequest& request) {
    load_fonts(request);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }

  /// As the application does when the scale of the interface changes; between frames.
  void set_scale(float scale) {
    metrics_.scale = scale;
    set_fonts({scale, false, {}});
    apply_theme(ThemeId::dark, scale, palette_);
  }

  void frame() {
    editor_.now += 0.05;
    engine_.publish();
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 0.05F;
    ImGui::NewFrame();
    workbench_->frame();
    ImGui::Render();
    engine_.sync(editor_.document(), editor_.history.in_gesture(), editor_.now, RecomputePolicy::live,
                 editor_.view.map);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  void key(const KeyChord& chord) {
    const bool plain = !chord.control && !chord.alt && static_cast<int>(chord.key) < 128;
    workbench_->key({chord, plain ? static_cast<char32_t>(chord.key) : char32_t(0)});
    frame();
  }
  void key(std::string_view chord) {
    key(KeyChord::parse(chord).value());
  }

  /// A key as the window gives it, to ImGui and to the workbench: down for a frame, then up.
  void tap(std::string_view text) {
    const KeyChord chord = KeyChord::parse(text).value();
    hold(chord.shift, chord.control, chord.alt);
    const ImGuiKey key = imgui_key(chord.key);
    if (key != ImGuiKey_COUNT) put(key, true);
    this->key(chord);
    if (key != ImGuiKey_COUNT) put(key, false);
    hold(false, false, false);
    frame();
  }
  /// Characters into the field that has the keyboard.
  void type(std::string_view text) {
    for (const char c : text) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
      frame();
    }
  }
  /// The same, and Enter.
  void enter(std::string_view text) {
    type(text);
    tap("Enter");
  }

  void move(double x, double y) {
    ImGui::GetIO().MousePos = {static_cast<float>(x), static_cast<float>(y)};
    frame();
  }
  void press(int button = 0) {
    ImGui::GetIO().MouseDown[button] = true;
    frame();
  }
  void release(int button = 0) {
    ImGui::GetIO().MouseDown[button] = false;
    frame();
  }
  void wheel(double steps) {
    ImGui::GetIO().MouseWheel = static_cast<float>(steps);
    frame();
    ImGui::GetIO().MouseWheel = 0;
  }
  void hold(bool shift, bool control, bool alt) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(ImGuiMod_Ctrl, control);
    io.AddKeyEvent(ImGuiMod_Alt, alt);
#else
    io.KeyShift = shift;
    io.KeyCtrl = control;
    io.KeyAlt = alt;
#endif
  }

  /// Runs what the palette finds for these words, which has to be this command.
  void from_palette(const char* words, const std::string& id) {
    key("F3");
    frames(3);
    type(words);
    frames(2);
    ASSERT_TRUE(workbench_->marks().all().contains("palette.selected." + id)) << words;
    key("Enter");
    frames(2);
  }

  /// Until surfaces are ready and shown.
  void settle() {
    frame();
    engine_.wait();
    frame();
  }
  /// Until surfaces that depend on others are ready, too, and nothing is said to be stale.
  void wait_for_surfaces() {
    for (int i = 0; i < 5; ++i) settle();
    editor_.stale_since.clear();
  }
  /// Presses what bears this mark.
  void click(const std::string& mark) {
    const auto found = workbench_->marks().all().find(mark);
    ASSERT_NE(found, workbench_->marks().all().end()) << mark;
    const Marks::Rect rect = found->second;
    move(rect.x + rect.width / 2.0, rect.y + rect.height / 2.0);
    press();
    release();
  }

 private:
  static ImGuiKey imgui_key(Key key) {
    switch (key) {
      case Key::tab:
        return ImGuiKey_Tab;
      case Key::enter:
        return ImGuiKey_Enter;
      case Key::escape:
        return ImGuiKey_Escape;
      case Key::space:
        return ImGuiKey_Space;
      case Key::backspace:
        return ImGuiKey_Backspace;
      case Key::up:
        return ImGuiKey_UpArrow;
      case Key::down:
        return ImGuiKey_DownArrow;
      case Key::left:
        return ImGuiKey_LeftArrow;
      case Key::right:
        return ImGuiKey_RightArrow;
      default:
        return ImGuiKey_COUNT;
    }
  }
  static void put(ImGuiKey key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
    ImGui::GetIO().AddKeyEvent(key, down);
#else
    ImGui::GetIO().KeysDown[key] = down;
#endif
  }

  OffscreenContext context_;
  Renderer renderer_;
  Metrics metrics_;
  Palette palette_{};
  Editor editor_;
  RebuildEngine engine_{[] { return std::make_unique<SurfaceBuilder>(); }, [] {}};
  NoServices none_;
  std::unique_ptr<Workbench> workbench_;
};

}  // namespace hariko::test
