#pragma once

// OffscreenContext: OpenGL without a window or display.

#include <memory>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_no_egl{"E_NO_EGL"};

/// GL 3.3 core context by EGL: on the surfaceless platform, else on a device. It is current on the thread
/// that made it during its life, and has no default framebuffer.
class OffscreenContext {
 public:
  /// Creates a context. Errors: E_NO_EGL, listing what was tried.
  static Result<OffscreenContext> create();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;
  ~OffscreenContext();

 private:
  struct State;
  explicit OffscreenContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hariko
