#pragma once

// Tools that cut faces: along a path of points on vertices and edges, and along a ring of quads; and the key
// with which they change between the surface and straight edges.

#include <string>

#include "ui/base/language.hpp"
#include "ui/editor/command_table.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: a click puts a point on the vertex or edge under the pointer (Ctrl: on the edge's middle), and the
/// line from the last one is carried over the faces between them as it is seen. Backspace takes the last
/// point away, Enter or Space makes one step of the whole cut. A point to which no cut can lead is refused
/// where it is clicked.
std::unique_ptr<Tool> make_knife_tool();

/// Modal, in two parts: the edge under the pointer shows where the cuts would run, the wheel or a typed
/// number sets how many; after a click the pointer slides them along the edges, and a second click or Enter
/// makes the step.
std::unique_ptr<Tool> make_loop_cut_tool();

/// Whether it is the key that changes where new points lie.
inline bool is_position_key(const KeyPress& press) {
  return !press.chord.control && !press.chord.alt && (press.text == U'e' || press.text == U'E');
}

/// For the hint line: where new points lie, and the key for the other way.
inline std::string position_hint(const Language& tr, bool on_surface) {
  return on_surface ? tr("On the surface, E: on straight edges") : tr("On straight edges, E: on the surface");
}

}  // namespace hariko
