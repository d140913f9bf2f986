#pragma once

// What the panels are about: the chosen objects, and the selected elements of the active one.

#include <memory>
#include <span>
#include <vector>

#include "ui/editor/editor.hpp"

namespace hariko {

using Objects = std::vector<std::shared_ptr<const Object>>;

template <class Id>
struct SelectedIds {
  std::shared_ptr<const Object> object;  ///< a polyhedron; null when there are no ids
  std::vector<Id> ids;                   ///< ascending
};

/// The chosen objects, the active one first, with all of a chosen group (`ChosenGroup`); empty when there is
/// none.
Objects chosen_objects(const Editor& editor);

/// Their ids.
std::vector<ObjectId> chosen_ids(const Editor& editor);

/// Chooses whole objects instead of what was chosen and selected; hidden and locked ones are left out. The
/// first becomes the active one.
void choose_objects(Editor& editor, std::span<const ObjectId> objects);

/// Those that the shown document has.
SelectedIds<VertexId> selected_vertices(const Editor& editor);
SelectedIds<EdgeId> selected_edges(const Editor& editor);
SelectedIds<FaceId> selected_faces(const Editor& editor);

}  // namespace hariko
