#pragma once

// Questions about an imported mesh: whether corners that are nearly at the same place are joined, and whether
// faults, which it opens with, are repaired.

#include <cstddef>
#include <functional>
#include <string>

#include "core/document/document.hpp"
#include "core/exchange/repair/clean_part.hpp"
#include "ui/widgets/prompt.hpp"

namespace hariko {

/// `file`: its name. `unit`: of the lengths in the report. The tolerance is shown and can be changed. One of
/// the two is called, unless the designer closes the question.
Prompt::Request join_request(const Language& language, const std::string& file, const CleanReport& report,
                             Unit unit, std::function<void(const JoinChoice&)> join,
                             std::function<void()> keep);

/// Numbers of faults that are repaired where the designer wants it.
struct RepairableFaults {
  std::size_t on_edges = 0;    ///< corners that lie on edges of other faces (T-joints)
  std::size_t inside_out = 0;  ///< closed parts that are inside out
};

/// Faults to be repaired.
struct RepairChoice {
  bool split_edges = true;
  bool turn_parts = true;
};

/// `file`: its name. Where there are faults of both kinds each can be left out; marks: "import.split_edges",
/// "import.turn_parts". One of the two is called, unless the designer closes the question.
Prompt::Request repair_request(const Language& language, const std::string& file,
                               const RepairableFaults& faults,
                               std::function<void(const RepairChoice&)> repair, std::function<void()> keep);

}  // namespace hariko
