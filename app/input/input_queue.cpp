#include "app/input/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace hariko {

namespace {

using Kind = InputEvent::Kind;

bool is_move(const InputEvent& event) {
  return event.kind == Kind::move || event.kind == Kind::leave;
}

/// Whether an event is Shift, Ctrl, Alt or Super of either side. Their own events carry the modifiers from
/// before.
bool is_modifier(const InputEvent& event) {
  return event.kind == Kind::key && event.code >= GLFW_KEY_LEFT_SHIFT && event.code <= GLFW_KEY_RIGHT_SUPER;
}

/// Whether a frame that gets `batch` may also get `next`.
bool fits(const std::vector<InputEvent>& batch, const InputEvent& next) {
  const bool only_moves = std::ranges::all_of(batch, is_move);
  switch (next.kind) {
    case Kind::move:
    case Kind::leave:
      return only_moves;
    case Kind::button:
      // A slider is released in the frame that sees the button up: its last drag must come in an earlier
      // frame.
      return next.down ? only_moves : batch.empty();
    case Kind::wheel:
      return std::ranges::all_of(
          batch, [](const InputEvent& event) { return is_move(event) || event.kind == Kind::wheel; });
    case Kind::key:
    case Kind::text:
      return std::ranges::all_of(batch, [&](const InputEvent& event) {
        if (event.kind == Kind::text || is_move(event)) return true;
        if (event.kind != Kind::key) return false;
        // A frame would miss a key that goes down and up, and modifiers that hold for some keys only: a
        // shortcut whose modifier is released in the same frame would be a bare letter.
        if (is_modifier(event) || is_modifier(next)) return false;
        const bool same = next.kind == Kind::key && next.code == event.code && next.down != event.down;
        return !same && (next.kind == Kind::text || next.modifiers == event.modifiers);
      });
    case Kind::cap:
      return std::ranges::all_of(batch, [](const InputEvent& event) { return event.kind == Kind::cap; });
    default:
      return batch.empty();
  }
}

}  // namespace

std::vector<InputEvent> InputQueue::take(bool keys_wait) {
  std::vector<InputEvent> batch;
  while (!waiting_.empty() && fits(batch, waiting_.front())) {
    const Kind next = waiting_.front().kind;
    if (keys_wait && (next == Kind::key || next == Kind::text)) break;
    if (is_move(waiting_.front()) && !batch.empty()) {
      waiting_.front().came_at = batch.back().came_at;
      batch.pop_back();
    }
    batch.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
    if (batch.back().kind >= Kind::cap_button) break;
  }
  return batch;
}

}  // namespace hariko
