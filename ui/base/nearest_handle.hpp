#pragma once

// Which of the handles that lie over the picture is under the pointer.

#include <imgui.h>

#include <optional>

#include "core/base/vector.hpp"

namespace hariko {

/// Number of the handle nearest to a pixel, if it is within the radius (design pixels). Handles have their
/// place as `at`.
template <class Handles>
std::optional<std::size_t> nearest_handle(const Handles& handles, const Vector2& pixel, double radius) {
  std::optional<std::size_t> best;
  double least = radius * double(ImGui::GetIO().DisplayFramebufferScale.x);
  for (std::size_t i = 0; i < handles.size(); ++i)
    if (const double distance = (handles[i].at - pixel).norm(); distance <= least) {
      least = distance;
      best = i;
    }
  return best;
}

}  // namespace hariko
