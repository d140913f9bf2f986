#include "ui/shell/navigation_rows.hpp"

#include <array>

#include "ui/view/navigation.hpp"

namespace hariko {

namespace {

constexpr std::array motions{std::pair{NavigationAction::orbit, translatable("Orbit")},
                             std::pair{NavigationAction::pan, translatable("Pan")},
                             std::pair{NavigationAction::zoom, translatable("Zoom")}};
constexpr std::array buttons{std::pair{PointerButton::left, translatable("left drag")},
                             std::pair{PointerButton::middle, translatable("middle drag")},
                             std::pair{PointerButton::right, translatable("right drag")}};

}  // namespace

std::vector<std::pair<std::string, std::string>> navigation_rows(const Language& tr,
                                                                 NavigationPreset preset) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [motion, name] : motions) {
    std::string drags;
    const auto add = [&](const std::string& text) { drags += (drags.empty() ? "" : ",  ") + text; };
    for (const auto& [button, drag] : buttons)
      for (int modifiers = 0; modifiers < 8; ++modifiers) {
        PointerEvent press;
        press.kind = PointerEvent::Kind::press;
        press.button = button;
        press.alt = (modifiers & 4) != 0;
        press.control = (modifiers & 2) != 0;
        press.shift = (modifiers & 1) != 0;
        // Where Alt makes no difference it need not be pressed.
        PointerEvent plain = press;
        plain.alt = false;
        const auto moves = [&, wanted = motion](bool parallel) {
          const auto action = navigation_action(preset, press, parallel);
          return action == wanted && !(press.alt && navigation_action(preset, plain, parallel) == action);
        };
        const bool perspective = moves(false), parallel = moves(true);
        if (!perspective && !parallel) continue;
        const std::string keys = std::string(press.control ? "Ctrl + " : "") + (press.alt ? "Alt + " : "") +
                                 (press.shift ? "Shift + " : "") + tr(drag);
        add(perspective == parallel
                ? keys
                : fill(tr(perspective ? "{0} (perspective)" : "{0} (parallel views)"), {keys}));
      }
    for (const bool control : {false, true})
      for (const bool shift : {false, true}) {
        const bool plain = wheel_action(preset, false, false) == motion && (control || shift);
        if (wheel_action(preset, shift, control) != motion || plain || (control && shift)) continue;
        add(std::string(control ? "Ctrl + " : "") + (shift ? "Shift + " : "") +
            tr(preset == NavigationPreset::trackpad ? "two fingers" : "wheel"));
      }
    rows.emplace_back(tr(name), drags);
  }
  return rows;
}

}  // namespace hariko
