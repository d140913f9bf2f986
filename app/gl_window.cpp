#include "app/gl_window.hpp"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace hariko {

struct GlWindow::State {
  GLFWwindow* window = nullptr;
  Metrics metrics;
  FontRequest fonts;
  ThemeId theme = ThemeId::dark;
  Palette palette{};
  float monitor_scale = 1;
  const char* missing_fonts = nullptr;
  std::string title;
  std::vector<KeyPress> keys;
  std::vector<std::filesystem::path> drops;
  std::u32string typed;
  bool close = false, input = false;

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

/// GLFW reports errors through a callback without user data; this is written by the main thread only.
std::string& last_glfw_error() {
  static std::string text;
  return text;
}

/// GLFW names keys by their places on an American keyboard. Letters are meant by what is printed on them:
/// Ctrl+Z is where the layout has its Z.
int letter_of(int key, int scancode) {
  const bool printed = key >= GLFW_KEY_APOSTROPHE && key <= GLFW_KEY_GRAVE_ACCENT;
  if (!printed || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9)) return key;  // digits may need Shift: by place
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == 0 || name[1] != 0 || (name[0] >= '0' && name[0] <= '9')) return key;
  const int upper = name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
  return KeyChord{upper}.is_known() ? upper : key;
}

}  // namespace

GlWindow::GlWindow(std::unique_ptr<State> state) : state_(std::move(state)) {
  GLFWwindow* window = state_->window;
  glfwSetWindowUserPointer(window, state_.get());
  static constexpr auto noted =
      +[](GLFWwindow* w) { static_cast<State*>(glfwGetWindowUserPointer(w))->input = true; };
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    noted(w);
    // The key of the desktop makes no chords of ours.
    if (action == GLFW_RELEASE || (mods & GLFW_MOD_SUPER) != 0) return;
    KeyChord chord;
    chord.key = key == GLFW_KEY_KP_ENTER ? GLFW_KEY_ENTER : letter_of(key, scancode);
    chord.control = (mods & GLFW_MOD_CONTROL) != 0;
    chord.shift = (mods & GLFW_MOD_SHIFT) != 0;
    chord.alt = (mods & GLFW_MOD_ALT) != 0;
    static_cast<State*>(glfwGetWindowUserPointer(w))->keys.push_back({chord});
  });
  // ImGui's backend chains to these, so they must be set before it is initialised.
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    noted(w);
    // GLFW reports the character of a key right after the key.
    auto& keys = static_cast<State*>(glfwGetWindowUserPointer(w))->keys;
    if (!keys.empty() && keys.back().text == 0) keys.back().text = character;
    static_cast<State*>(glfwGetWindowUserPointer(w))->typed += static_cast<char32_t>(character);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { noted(w); });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { noted(w); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { noted(w); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { noted(w); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { noted(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { noted(w); });
  glfwSetWindowRefreshCallback(window, noted);
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    noted(w);
    static_cast<State*>(glfwGetWindowUserPointer(w))->close = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    noted(w);
    for (int i = 0; i < count; ++i)
      static_cast<State*>(glfwGetWindowUserPointer(w))->drops.emplace_back(paths[i]);
  });

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  float scale_x = 1, scale_y = 1;
  glfwGetWindowContentScale(window, &scale_x, &scale_y);
  state_->monitor_scale = std::clamp(scale_x, 1.0F, 4.0F);
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float x, float) {
    noted(w);
    static_cast<State*>(glfwGetWindowUserPointer(w))->monitor_scale = std::clamp(x, 1.0F, 4.0F);
  });
  state_->fonts.scale = state_->metrics.scale = state_->monitor_scale;
  state_->missing_fonts = load_fonts(state_->fonts);
  apply_theme(state_->theme, state_->metrics.scale, state_->palette);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

GlWindow::~GlWindow() = default;

Result<std::unique_ptr<GlWindow>> GlWindow::open(const Options& options) {
  glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text; });
  if (!glfwInit())
    return make_error(e_no_display, "No window can be opened: " + last_glfw_error() + ".",
                      "Start Hariko in a graphical session, or use it from the command line: hariko --help.");
  auto state = std::make_unique<State>();  // ends GLFW again
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);  // the renderer has its own multisampled picture
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "hariko");
  int width = options.width, height = options.height;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    int x = 0, y = 0, available_width = 0, available_height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &available_width, &available_height);
    if (available_width > 0) width = std::min(width, available_width);
    if (available_height > 0) height = std::min(height, available_height);
  }
  state->window = glfwCreateWindow(width, height, options.title.c_str(), nullptr, nullptr);
  if (!state->window)
    return make_error(
        e_no_window, "OpenGL 3.3 is not available: " + last_glfw_error() + ".",
        "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1 to draw without it.");
  state->title = options.title;
  glfwSetWindowSizeLimits(state->window, 800, 560, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(state->window);
  glfwSwapInterval(1);
  return std::unique_ptr<GlWindow>(new GlWindow(std::move(state)));
}

bool GlWindow::wait(double seconds) {
  state_->input = false;
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  return state_->input;
}

void GlWindow::wake() {
  glfwPostEmptyEvent();
}

bool GlWindow::set_appearance(ThemeId theme, float interface_scale) {
  const float scale = state_->monitor_scale * interface_scale;
  if (theme == state_->theme && scale == state_->metrics.scale) return false;
  state_->theme = theme;
  state_->metrics.scale = scale;
  set_fonts(state_->fonts);
  apply_theme(theme, scale, state_->palette);
  return true;
}

void GlWindow::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void GlWindow::end_frame() {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(state_->window, &width, &height);
  glViewport(0, 0, width, height);
  const ImVec4 clear = ImGui::ColorConvertU32ToFloat4(palette().window);
  glClearColor(clear.x, clear.y, clear.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(state_->window);
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
void GlWindow::set_fonts(FontRequest request) {
  request.scale = state_->metrics.scale;
  if (request == state_->fonts) return;
  state_->fonts = std::move(request);
  state_->missing_fonts = load_fonts(state_->fonts);
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
double GlWindow::now() const {
  return glfwGetTime();
}
const char* GlWindow::missing_fonts() const {
  return state_->missing_fonts;
}

}  // namespace hariko
