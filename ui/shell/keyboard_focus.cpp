#include "ui/shell/keyboard_focus.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <vector>

#include "ui/widgets/panels.hpp"

namespace hariko {

namespace {

/// Presses the item that the keyboard is on; a number's field opens for typing.
void activate_item() {
  ImGuiContext& g = *GImGui;
  g.NavActivateId = g.NavActivateDownId = g.NavActivatePressedId = g.NavId;
#if IMGUI_VERSION_NUM < 18900
  g.NavActivateInputId = g.NavId;
#endif
  g.NavActivateFlags = ImGuiActivateFlags_PreferInput;
}

/// Tab goes on from the item that the keyboard is on, also after Enter took it out of a field, and begins
/// with the first one where there is none. Left alone, versions of Dear ImGui differ: some begin anew after a
/// field, some go nowhere in a panel that has just been chosen. `everywhere`: it goes to buttons and lists,
/// too, as it does by itself in newer versions.
void tab_goes_on(bool from_item, bool everywhere) {
#if IMGUI_VERSION_NUM < 18900
  constexpr int tabbing = ImGuiNavMoveFlags_Tabbing;
#else
  constexpr int tabbing = ImGuiNavMoveFlags_IsTabbing;
#endif
  ImGuiContext& g = *GImGui;
  if (!g.NavMoveSubmitted || (g.NavMoveFlags & tabbing) == 0) return;
  if (g.NavTabbingDir >= 0) g.NavTabbingDir = from_item ? 1 : 0;
#if IMGUI_VERSION_NUM < 18900
  if (everywhere) g.NavMoveFlags |= ImGuiNavMoveFlags_FocusApi;
#else
  static_cast<void>(everywhere);
#endif
}

}  // namespace

bool text_field_active() {
  return GImGui->ActiveId != 0 && GImGui->ActiveId == GImGui->InputTextState.ID;
}

void close_popups(bool restore_focus) {
  if (!GImGui->OpenPopupStack.empty()) ImGui::ClosePopupToLevel(0, restore_focus);
}

void KeyboardFocus::begin_frame(bool preferences) {
  if (activates_) activate_item();
  activates_ = false;
  tab_goes_on(GImGui->NavId != 0 && item_drawn_, navigates(preferences));
}

void KeyboardFocus::end_frame(bool preferences) {
  // Flags of the next frame: arrows and Enter belong to the items only where the keyboard was given to them.
  ImGuiIO& io = ImGui::GetIO();
  item_drawn_ = GImGui->NavIdIsAlive;
  const ImGuiWindow* window = panel_.empty() ? nullptr : ImGui::FindWindowByName(panel_.c_str());
  if (ImGui::IsMouseClicked(0) || (window && !window->Active)) leave_panel();
  if (navigates(preferences))
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
}

bool KeyboardFocus::navigates(bool preferences) const {
  const ImGuiWindow* window = GImGui->NavWindow;
  return !panel_.empty() || !GImGui->OpenPopupStack.empty() ||
         (preferences && window && window->RootWindow == ImGui::FindWindowByName("###preferences"));
}

void KeyboardFocus::leave_panel() {
  if (panel_.empty()) return;
  panel_.clear();
  GImGui->NavDisableHighlight = true;
}

void KeyboardFocus::next_panel(bool back) {
  // From above, as they stand.
  std::vector<std::string> shown;
  for (const ImGuiWindow* window :
       {ImGui::FindWindowByName("Objects"), ImGui::FindWindowByName("Properties"),
        ImGui::FindWindowByName("History"), ImGui::FindWindowByName("Meshing"),
        ImGui::FindWindowByName("Guide"), ImGui::FindWindowByName("Paper"),
        ImGui::FindWindowByName("Folding"), ImGui::FindWindowByName("Gauss sphere"),
        ImGui::FindWindowByName("Steps"), ImGui::FindWindowByName("Tools")})
    if (window && window->WasActive) shown.emplace_back(window->Name);
  const auto at = std::find(shown.begin(), shown.end(), panel_);
  const auto count = static_cast<std::ptrdiff_t>(shown.size());
  std::ptrdiff_t next = at == shown.end() ? (back ? count - 1 : 0) : (at - shown.begin()) + (back ? -1 : 1);
  if (next < 0 || next >= count) return leave_panel();
  panel_ = shown[static_cast<std::size_t>(next)];
  ImGuiWindow* window = ImGui::FindWindowByName(panel_.c_str());
  ImGui::FocusWindow(window);
  ImGui::NavInitWindow(window, true);
  show_keyboard_focus();
}

bool KeyboardFocus::item_key(const KeyChord& chord) {
  if (chord.control || chord.alt) return false;
  switch (chord.key) {
    case Key::enter:
    case Key::keypad_enter:
      activates_ = true;
      return true;
    case Key::up:
    case Key::down:
    case Key::left:
    case Key::right:
    case Key::tab:
    case Key::space:
    case Key::home:
    case Key::end:
    case Key::page_up:
    case Key::page_down:
      return true;
    default:
      return false;
  }
}

}  // namespace hariko
