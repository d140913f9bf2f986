#pragma once

// Choices for reading meshes of other programs, and messages about them.

#include <optional>
#include <string>

#include "app/files/open_file.hpp"
#include "core/exchange/repair/clean_part.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

inline constexpr Code w_repaired{"W_REPAIRED"};
inline constexpr Code w_can_be_opened{"W_CAN_BE_OPENED"};
inline constexpr Code w_turned_outwards{"W_TURNED_OUTWARDS"};  ///< closed parts were inside out

/// Choices for broken meshes.
struct Reading {
  JoinChoice join = {};
  bool repair = false;     ///< repairs meshes that make no polyhedron, or are inside out, and T-joints
  bool reference = false;  ///< keeps them as facets where they are not repaired
  friend bool operator==(const Reading&, const Reading&) = default;
};

/// Corners to join while a file is opened, and edges to split.
JoinChoice join_choice(const Reading& reading);

/// Number of closed parts of a document's polyhedra that are inside out. O(faces), and O(n log n) where some
/// look inwards and some outwards.
std::size_t parts_inside_out(const Document& document);
/// W_INSIDE_OUT with the number of such parts in a mesh file; nothing where there are none.
std::optional<Message> inside_out_message(const OpenedFile& opened);
/// Turns closed parts of a document's polyhedra outwards that are inside out; returns the number of their
/// faces.
std::size_t turn_closed_parts_outwards(Document& document);
/// The same for a mesh file's document; W_TURNED_OUTWARDS counts the faces.
void turn_outwards(OpenedFile& opened);
/// W_TURNED_OUTWARDS.
Message turned_outwards_message(std::size_t faces);

/// Adds the counts of another mesh of the same file.
void add_counts(RepairReport& sum, const RepairReport& report);

/// Summary of a repair: "vertices merged: 12, faces turned: 3".
std::string repair_text(const RepairReport& report);

/// W_REPAIRED with the summary of a repair.
Message repaired_message(const RepairReport& report);

}  // namespace hariko
