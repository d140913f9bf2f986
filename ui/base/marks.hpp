#pragma once

// Marks: where named parts of the interface are on the screen, for tests that drive the real window.

#include <imgui.h>
#include <imgui_internal.h>

#include <map>
#include <string>

namespace hariko {

class Marks {
 public:
  struct Rect {
    int x = 0, y = 0, width = 0, height = 0;  ///< window pixels
    friend bool operator==(const Rect&, const Rect&) = default;
  };
  void clear() { rects_.clear(); }
  /// Names the last item, if it can be seen: a window that has just appeared is measured for a frame, and is
  /// elsewhere then.
  void item(const std::string& name) {
    if (!GImGui->CurrentWindow->Hidden) rect(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  /// Names a place that is no item.
  void rect(const std::string& name, ImVec2 low, ImVec2 high) {
    rects_[name] = {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x),
                    static_cast<int>(high.y - low.y)};
  }
  /// Names the window that is being drawn.
  void window(const std::string& name) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    rects_[name] = {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(size.x),
                    static_cast<int>(size.y)};
  }
  const std::map<std::string, Rect>& all() const { return rects_; }

 private:
  std::map<std::string, Rect> rects_;
};

}  // namespace hariko
