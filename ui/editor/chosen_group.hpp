#pragma once

// ChosenGroup: the group whose row was clicked, as long as the selection stays as it was then.

#include <optional>
#include <vector>

#include "core/document/group.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

class Editor;

class ChosenGroup {
 public:
  /// Chooses a group with all of its objects; what can be selected of them is selected, and its first object
  /// is the active one. The group must exist.
  void choose(Editor& editor, GroupId group);
  /// The chosen group; none after another selection, or where the document has it no more.
  GroupId chosen(const Editor& editor) const;

 private:
  struct Chosen {
    GroupId group;
    Selection selection;  ///< state when it was chosen
    ElementMode mode = ElementMode::vertex;
  };
  std::optional<Chosen> chosen_;
};

/// Groups that the choice of objects stands for as a whole, the outermost ones: that of the clicked row, and
/// groups of which all objects are chosen.
std::vector<GroupId> chosen_groups(const Editor& editor);

}  // namespace hariko
