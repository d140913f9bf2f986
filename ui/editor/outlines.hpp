#pragma once

// Outlines in the editor: which points are selected, and steps that change them. Points are
// selected as vertices whose ids are their numbers.

#include <functional>
#include <set>
#include <string>

#include "core/document/edits/edit_outlines.hpp"
#include "core/gaussmap/outlines/edit_outline.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// The active object, where it is an outline; else null.
const Object* active_outline(const Editor& editor);

/// Numbers of the selected points of an outline object, in vertex mode.
std::set<Index> selected_points(const Editor& editor, const Object& object);

/// Makes one step of the active outline, or says why not. True when the document changed.
bool change_outline(Editor& editor, const std::function<Result<Outline>(const Outline&)>& change,
                    const std::string& label);

/// World place of a point, and its unit normal in world axes.
struct OutlinePlace {
  Vector3 point, normal, tangent;  ///< tangent: along the loop, unit
};
OutlinePlace place_of_point(const Object& object, Index number);

/// Number of points inserted in an outline whose surface is known; 0 when it is not. From the number of its
/// faces by Euler's formula: a sphere's part with as many borders as loops.
Index inserted_points(const Editor& editor, const Object& object);

}  // namespace hariko
