#pragma once

// Edits of the active skin as steps of the history, with what they have to say.

#include <string>
#include <vector>

#include "core/skinning/edit/edit_correspondence.hpp"
#include "core/skinning/edit/skin_edit.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// The document with another skin in an object, or the error of either.
Result<Document> with_skin(const Document& document, ObjectId object, const Result<SkinEdit>& edit);

/// One step; notes of the edit and how much the curve gave are shown. True when the document changed.
bool commit_skin(Editor& editor, ObjectId object, const Result<SkinEdit>& edit, const std::string& label);
/// The same for correspondences: tells how many gave way.
bool commit_skin(Editor& editor, ObjectId object, const Result<CorrespondenceEdit>& edit,
                 const std::string& label);

/// Selects the points that an edit made in the active skin.
void select_new_points(Editor& editor, const SkinEdit& edit);

/// The points, with their partners where the skin has a mirror.
std::vector<std::uint32_t> with_mirrored(const Skin& skin, const std::vector<std::uint32_t>& points);

/// Deletes the selected points of sections with those that they have in the skin's mirror, or the one of the
/// path, as one step.
void delete_selected_points(Editor& editor);

/// Ids of the selected points of sections, in the order of the sections.
std::vector<std::uint32_t> selected_section_points(const Editor& editor);
/// Numbers of the selected points of the path.
std::vector<int> selected_path_points(const Editor& editor);
/// The section that holds the selected points; null when none or several do.
const SkinSection* selected_section(const Editor& editor);

}  // namespace hariko
