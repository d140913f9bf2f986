#pragma once

// The key with which cutting tools change between the surface and straight edges.

#include <string>

#include "ui/base/language.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

inline bool is_position_key(const KeyPress& press) {
  return !press.chord.control && !press.chord.alt && (press.text == U'e' || press.text == U'E');
}

/// For the hint line: where new points lie, and the key for the other way.
inline std::string position_hint(const Language& tr, bool on_surface) {
  return on_surface ? tr("On the surface, E: on straight edges") : tr("On straight edges, E: on the surface");
}

}  // namespace hariko
