#pragma once

// How meshes of other programs are read, and what is said of it.

#include <string>

#include "core/exchange/clean_part.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

inline constexpr Code w_repaired{"W_REPAIRED"};
inline constexpr Code w_can_be_opened{"W_CAN_BE_OPENED"};

struct Reading {
  JoinChoice join = {};
  bool repair = false;     ///< those that make no polyhedron are changed until they do
  bool reference = false;  ///< or kept as facets, where they cannot be repaired or need not be
  friend bool operator==(const Reading&, const Reading&) = default;
};

/// Adds the counts of another mesh of the same file.
void add_counts(RepairReport& sum, const RepairReport& report);

/// "vertices merged: 12, faces turned: 3".
std::string repair_text(const RepairReport& report);

/// W_REPAIRED.
Message repaired_message(const RepairReport& report);

}  // namespace hariko
