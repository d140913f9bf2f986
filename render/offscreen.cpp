#include "render/offscreen.hpp"

#include <epoxy/egl.h>

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace hariko {

namespace {

bool client_has(const char* extension) {
  const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return all && std::strstr(all, extension);
}

/// Candidate displays in order: the surfaceless platform, then each device (software devices come last
/// there).
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> out;
  if (client_has("EGL_MESA_platform_surfaceless"))
    out.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  if (client_has("EGL_EXT_platform_device") && client_has("EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count))
      for (EGLint i = 0; i < count; ++i)
        out.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
  }
  return out;
}

EGLContext make_context(EGLDisplay display) {
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
  const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         3,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE,
                                         EGL_TRUE,
                                         EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

struct OffscreenContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  ~State() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    // The display is shared by all contexts of the process without a reference count, so it is not
    // terminated.
  }
};

OffscreenContext::OffscreenContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;
OffscreenContext::~OffscreenContext() = default;

Result<OffscreenContext> OffscreenContext::create() {
  std::string tried;
  const auto note = [&](const std::string& what) { tried += (tried.empty() ? "" : "; ") + what; };
  for (const EGLDisplay display : candidate_displays()) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) {
      note("a display could not be opened");
      continue;
    }
    const EGLContext context = make_context(display);
    if (context == EGL_NO_CONTEXT) {
      note("a display without OpenGL 3.3");
      continue;
    }
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      eglDestroyContext(display, context);
      note("a display that needs a window");
      continue;
    }
    auto state = std::make_unique<State>();
    state->display = display;
    state->context = context;
    return OffscreenContext(std::move(state));
  }
  if (tried.empty()) tried = "the EGL library offers neither the surfaceless nor the device platform";
  return make_error(e_no_egl, "Pictures cannot be drawn without a window on this machine: " + tried + ".",
                    "Install Mesa's software driver (packages libegl1 and libgl1-mesa-dri).");
}

}  // namespace hariko
