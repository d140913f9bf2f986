#pragma once

// Operations on the active polyhedron: running them, and what is selected afterwards.

#include <functional>
#include <string>

#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/surfacing/surface_form.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

using Operation = std::function<Result<EditResult>(const PolyhedronSource&)>;

/// Selects what an operation left: its elements of the kind that the mode selects, else the elements of that
/// kind that they are made of or touch. Where there are none the mode changes to what there is.
void select_result(Editor& editor, ObjectId object, const ElementSet& result);

/// Makes one step of an operation on the active object, which must be a polyhedron, and selects the result;
/// or says why not. True when the document changed.
bool run_operation(Editor& editor, const Operation& operation, const std::string& label);

/// Form that a refinement of `source` keeps, as the settings and the polyhedron have it.
std::optional<SurfaceForm> form_for_refinement(const Editor& editor, const PolyhedronSource& source);

/// `run_operation` for refinements, which get the form that they keep, if any.
using Refinement = std::function<Result<EditResult>(const PolyhedronSource&, const SurfaceForm*)>;
bool run_refinement(Editor& editor, const Refinement& refinement, const std::string& label);

/// Says so if something that is selected is locked.
void say_locked(Editor& editor);

}  // namespace hariko
