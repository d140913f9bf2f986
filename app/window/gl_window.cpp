#include "app/window/gl_window.hpp"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <optional>
#include <utility>

namespace hariko {

struct GlWindow::State {
  GLFWwindow* window = nullptr;
  Metrics metrics;
  std::optional<FontRequest> fonts;  ///< request of the present atlas; none before the first frame
  ThemeId theme = ThemeId::dark;
  Palette palette{};
  float monitor_scale = 0;  // 0: unknown
  std::string title;
  std::vector<KeyPress> keys;
  std::vector<std::filesystem::path> drops;
  std::u32string typed;
  std::vector<InputEvent> caps;
  bool close = false, redraw = false;

  InputQueue queue;
  std::vector<InputEvent> batch;  // input of the next frame
  ImVec2 pointer{-FLT_MAX, -FLT_MAX};
  std::array<bool, 5> buttons{};
  std::optional<double> replayed_now;
  FrameClock clock;

  /// Queues an event of the user, unless a replay runs.
  void from_user(InputEvent event) {
    redraw = true;
    event.came_at = glfwGetTime();
    if (!replayed_now || event.kind == InputEvent::Kind::close) queue.push(std::move(event));
  }

  ~State() {
    if (ImGui::GetCurrentContext()) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    if (window) glfwDestroyWindow(window);
    glfwTerminate();
  }
};

namespace {

/// Last GLFW error, reported through a callback without user data; written by the main thread only.
std::string& last_glfw_error() {
  static std::string text;
  return text;
}

static_assert(GLFW_KEY_LEFT_BRACKET == int(Key::left_bracket) && GLFW_KEY_Z == int(Key::z) &&
              GLFW_KEY_ESCAPE == int(Key::escape) && GLFW_KEY_DELETE == int(Key::delete_forward) &&
              GLFW_KEY_UP == int(Key::up) && GLFW_KEY_END == int(Key::end) &&
              GLFW_KEY_PAUSE == int(Key::pause) && GLFW_KEY_F12 == int(Key::f12) &&
              GLFW_KEY_F25 == int(Key::f25) && GLFW_KEY_KP_9 == int(Key::keypad_9) &&
              GLFW_KEY_KP_ENTER == int(Key::keypad_enter) && GLFW_KEY_MENU == int(Key::menu));

/// Key code by the printed letter. GLFW names keys by their places on an American keyboard, but shortcuts
/// mean the layout's letters: Ctrl+Z is where the layout has its Z.
int letter_of(int key, int scancode) {
  const bool printed = key >= GLFW_KEY_APOSTROPHE && key <= GLFW_KEY_GRAVE_ACCENT;
  if (!printed || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9)) return key;  // digits may need Shift: by place
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == 0 || name[1] != 0 || (name[0] >= '0' && name[0] <= '9')) return key;
  const int upper = name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
  return KeyChord{Key{upper}}.is_known() ? upper : key;
}

/// OpenGL version of a context without requirements, "OpenGL 2.1 (NVIDIA ...)", for messages; empty for none.
std::string version_at_hand() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(64, 64, "Hariko", nullptr, nullptr);
  if (!window) return {};
  glfwMakeContextCurrent(window);
  const std::string text = "OpenGL " + std::to_string(epoxy_gl_version() / 10) + "." +
                           std::to_string(epoxy_gl_version() % 10) + " (" +
                           reinterpret_cast<const char*>(glGetString(GL_RENDERER)) + ")";
  glfwDestroyWindow(window);
  return text;
}

/// Sets the name by which desktops match the window with its menu entry: StartupWMClass and the file name of
/// hariko.desktop.
void name_for_desktop() {
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "hariko");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "hariko");
#ifdef GLFW_WAYLAND_APP_ID
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "hariko");
#endif
}

/// Sets the icons. On Wayland, desktops take the icon from the menu entry, and GLFW reports that as an error.
void set_icons(GLFWwindow* window, std::vector<Image> icons) {
  std::vector<GLFWimage> images;
  for (Image& icon : icons) images.push_back({icon.width, icon.height, icon.rgba.data()});
  if (!images.empty()) glfwSetWindowIcon(window, static_cast<int>(images.size()), images.data());
}

}  // namespace

GlWindow::GlWindow(std::unique_ptr<State> state) : state_(std::move(state)) {
  GLFWwindow* window = state_->window;
  glfwSetWindowUserPointer(window, state_.get());
  // ImGui's backend gets its events from `deliver`, one batch for each frame.
  static constexpr auto state_of =
      +[](GLFWwindow* w) -> State& { return *static_cast<State*>(glfwGetWindowUserPointer(w)); };
  using Kind = InputEvent::Kind;
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    InputEvent event{.kind = Kind::key, .code = key};
    event.meant = key == GLFW_KEY_KP_ENTER ? GLFW_KEY_ENTER : letter_of(key, scancode);
    event.down = action != GLFW_RELEASE;
    event.repeated = action == GLFW_REPEAT;
    event.modifiers = mods;
    state_of(w).from_user(std::move(event));
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    state_of(w).from_user({.kind = Kind::text, .code = static_cast<int>(character)});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
    InputEvent event{.kind = Kind::button, .code = button};
    event.down = action == GLFW_PRESS;
    event.modifiers = mods;
    state_of(w).from_user(std::move(event));
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    state_of(w).from_user({.kind = Kind::move, .x = x, .y = y});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    state_of(w).from_user({.kind = Kind::wheel, .x = x, .y = y});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered) state_of(w).from_user({.kind = Kind::leave});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    InputEvent event{.kind = Kind::focus};
    event.down = focused != 0;
    state_of(w).from_user(std::move(event));
  });
  glfwSetWindowSizeCallback(window, [](GLFWwindow* w, int width, int height) {
    state_of(w).from_user({.kind = Kind::size, .x = double(width), .y = double(height)});
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { state_of(w).redraw = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    state_of(w).from_user({.kind = Kind::close});
    glfwSetWindowShouldClose(w, GLFW_FALSE);
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    InputEvent event{.kind = Kind::drop};
    for (int i = 0; i < count; ++i) event.paths.emplace_back(paths[i]);
    state_of(w).from_user(std::move(event));
  });

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
#if IMGUI_VERSION_NUM >= 18700
  // The input queue decides what a frame gets; a second queue after it would make the pointer lag.
  ImGui::GetIO().ConfigInputTrickleEventQueue = false;
#endif
  float scale_x = 1, scale_y = 1;
  glfwGetWindowContentScale(window, &scale_x, &scale_y);
  if (state_->monitor_scale <= 0) {
    state_->monitor_scale = std::clamp(scale_x, 1.0F, 4.0F);
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float x, float) {
      state_of(w).monitor_scale = std::clamp(x, 1.0F, 4.0F);
      state_of(w).redraw = true;
    });
  }
  state_->metrics.scale = state_->monitor_scale;
  apply_theme(state_->theme, state_->metrics.scale, state_->palette);
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

GlWindow::~GlWindow() = default;

Result<std::unique_ptr<GlWindow>> GlWindow::open(const Options& options) {
  glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text; });
  if (!glfwInit())
    return make_error(e_no_display, "No window can be opened: " + last_glfw_error() + ".",
                      "Start Hariko in a graphical session, or use it from the command line: hariko --help.");
  auto state = std::make_unique<State>();  // its destructor terminates GLFW
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);  // the renderer has its own multisampled framebuffer
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  name_for_desktop();
  int width = options.width, height = options.height;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    int x = 0, y = 0, available_width = 0, available_height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &available_width, &available_height);
    if (available_width > 0) width = std::min(width, available_width);
    if (available_height > 0) height = std::min(height, available_height);
  }
  state->window = glfwCreateWindow(width, height, options.title.c_str(), nullptr, nullptr);
  if (!state->window) {
    const std::string why = last_glfw_error();
    const std::string found = version_at_hand();
    return make_error(
        e_no_window,
        "Hariko needs OpenGL 3.3, which is not available: " + (found.empty() ? why : "found " + found) + ".",
        "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1 to draw without it.");
  }
  set_icons(state->window, options.icons);
  state->title = options.title;
  state->monitor_scale = static_cast<float>(options.scale);
  glfwSetWindowSizeLimits(state->window, 800, 560, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(state->window);
  glfwSwapInterval(1);
  return std::unique_ptr<GlWindow>(new GlWindow(std::move(state)));
}

bool GlWindow::wait(double seconds, bool keys_wait) {
  State& s = *state_;
  s.redraw = false;
  if (seconds > 0 && s.queue.empty())
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  s.batch = s.queue.take(keys_wait);
  for (const InputEvent& event : s.batch) deliver(event);
  return s.redraw || !s.batch.empty();
}

const std::vector<InputEvent>& GlWindow::input() const {
  return state_->batch;
}

void GlWindow::queue(std::vector<InputEvent> events) {
  if (glfwGetWindowAttrib(state_->window, GLFW_FOCUSED) == GLFW_FALSE) return;
  for (InputEvent& event : events) state_->from_user(std::move(event));
}

void GlWindow::drop(const std::vector<std::filesystem::path>& files) {
  InputEvent event{.kind = InputEvent::Kind::drop};
  event.paths = files;
  state_->from_user(std::move(event));
}

void GlWindow::replay(double now, const std::vector<InputEvent>& batch) {
  state_->replayed_now = now;
  for (const InputEvent& event : batch) state_->queue.push(event);
}

/// Single entry point for events of the user and of replays.
void GlWindow::deliver(const InputEvent& event) {
  State& s = *state_;
  using Kind = InputEvent::Kind;
  switch (event.kind) {
    case Kind::move:
      s.pointer = {static_cast<float>(event.x), static_cast<float>(event.y)};
      break;
    case Kind::leave:
      // A drag continues outside the window.
      if (std::ranges::none_of(s.buttons, [](bool down) { return down; })) s.pointer = {-FLT_MAX, -FLT_MAX};
      break;
    case Kind::button:
      if (event.code >= 0 && std::size_t(event.code) < s.buttons.size())
        s.buttons[std::size_t(event.code)] = event.down;
      break;
    case Kind::wheel:
      ImGui_ImplGlfw_ScrollCallback(s.window, event.x, event.y);
      break;
    case Kind::key:
      ImGui_ImplGlfw_KeyCallback(s.window, event.code, 0,
                                 event.repeated ? GLFW_REPEAT
                                 : event.down   ? GLFW_PRESS
                                                : GLFW_RELEASE,
                                 event.modifiers);
      // The desktop's key (Super) forms no shortcuts of this program.
      if (event.down && (event.modifiers & GLFW_MOD_SUPER) == 0)
        s.keys.push_back({{Key{event.meant}, (event.modifiers & GLFW_MOD_CONTROL) != 0,
                           (event.modifiers & GLFW_MOD_SHIFT) != 0, (event.modifiers & GLFW_MOD_ALT) != 0}});
      break;
    case Kind::text:
      ImGui_ImplGlfw_CharCallback(s.window, static_cast<unsigned>(event.code));
      // The character of a key follows the key directly.
      if (!s.keys.empty() && s.keys.back().text == 0) s.keys.back().text = static_cast<char32_t>(event.code);
      s.typed += static_cast<char32_t>(event.code);
      break;
    case Kind::cap:
    case Kind::cap_button:
      s.caps.push_back(event);
      break;
    case Kind::focus:
      ImGui_ImplGlfw_WindowFocusCallback(s.window, event.down ? 1 : 0);
      break;
    case Kind::size:
      if (s.replayed_now) glfwSetWindowSize(s.window, int(event.x), int(event.y));
      break;
    case Kind::drop:
      s.drops.insert(s.drops.end(), event.paths.begin(), event.paths.end());
      break;
    case Kind::close:
      s.close = true;
      break;
  }
}

void GlWindow::wake() {
  glfwPostEmptyEvent();
}

bool GlWindow::set_appearance(ThemeId theme, float interface_scale) {
  const float scale = state_->monitor_scale * interface_scale;
  if (theme == state_->theme && scale == state_->metrics.scale) return false;
  state_->theme = theme;
  state_->metrics.scale = scale;
  if (state_->fonts) set_fonts(*state_->fonts);
  apply_theme(theme, scale, state_->palette);
  return true;
}

void GlWindow::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // The backend queries the present pointer position; the frame must get that of its batch.
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18700  // this version has a queue of its own
  io.AddMousePosEvent(state_->pointer.x, state_->pointer.y);
  for (std::size_t i = 0; i < state_->buttons.size(); ++i)
    io.AddMouseButtonEvent(static_cast<int>(i), state_->buttons[i]);
#else
  io.MousePos = state_->pointer;
  for (std::size_t i = 0; i < state_->buttons.size(); ++i) io.MouseDown[i] = state_->buttons[i];
#endif
  io.DeltaTime = std::max(1e-4F, static_cast<float>(state_->clock.tick(input_time())));
  ImGui::NewFrame();
}

GlWindow::FrameEnd GlWindow::end_frame(bool measure) {
  ImGui::Render();
  const double start = glfwGetTime();
  int width = 0, height = 0;
  glfwGetFramebufferSize(state_->window, &width, &height);
  glViewport(0, 0, width, height);
  const ImVec4 clear = ImGui::ColorConvertU32ToFloat4(palette().window);
  glClearColor(clear.x, clear.y, clear.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (measure) glFinish();
  const double drawn = glfwGetTime();
  glfwSwapBuffers(state_->window);
  return {1000 * (drawn - start), 1000 * (glfwGetTime() - drawn)};
}

std::vector<KeyPress> GlWindow::take_keys() {
  return std::exchange(state_->keys, {});
}
std::vector<std::filesystem::path> GlWindow::take_drops() {
  return std::exchange(state_->drops, {});
}
std::u32string GlWindow::take_typed() {
  return std::exchange(state_->typed, {});
}
std::vector<InputEvent> GlWindow::take_caps() {
  return std::exchange(state_->caps, {});
}
void GlWindow::set_fonts(FontRequest request) {
  request.scale = state_->metrics.scale;
  if (state_->fonts == request) return;
  const bool first = !state_->fonts;
  state_->fonts = std::move(request);
  load_fonts(*state_->fonts);
  if (first) return;  // the backend uploads the atlas when the first frame begins
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}
bool GlWindow::take_close() {
  return std::exchange(state_->close, false);
}

void GlWindow::set_title(const std::string& title) {
  if (title == state_->title) return;
  state_->title = title;
  glfwSetWindowTitle(state_->window, title.c_str());
}

const Metrics& GlWindow::metrics() const {
  return state_->metrics;
}
double GlWindow::input_time() const {
  return state_->replayed_now ? *state_->replayed_now : state_->clock.at(state_->batch, now());
}

double GlWindow::now() const {
  return state_->replayed_now ? *state_->replayed_now : glfwGetTime();
}
int GlWindow::width() const {
  int width = 0, height = 0;
  glfwGetWindowSize(state_->window, &width, &height);
  return width;
}
int GlWindow::height() const {
  int width = 0, height = 0;
  glfwGetWindowSize(state_->window, &width, &height);
  return height;
}
double GlWindow::monitor_scale() const {
  return static_cast<double>(state_->monitor_scale);
}

std::vector<Image> window_icons(const std::filesystem::path& icons) {
  std::vector<Image> out;
  for (const int size : {16, 24, 32, 48, 64, 128}) {
    const std::string side = std::to_string(size);
    auto icon = read_png(icons / "hicolor" / (side + "x" + side) / "apps" / "hariko.png");
    if (icon.ok()) out.push_back(std::move(icon).value());
  }
  return out;
}

}  // namespace hariko
