#pragma once

// Operations on the active polyhedron: running them, and what is selected afterwards.

#include <functional>
#include <optional>
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

/// Form that a refinement keeps, or why it keeps none although it should.
struct FormToKeep {
  std::optional<SurfaceForm> form;
  std::optional<Message> lost;  ///< error of the surface

  const SurfaceForm* pointer() const { return form ? &*form : nullptr; }
};

/// Form that a refinement of `source` keeps, as the settings and the polyhedron have it.
FormToKeep form_for_refinement(const Editor& editor, const PolyhedronSource& source);
/// Warns, after a refinement, that it did not keep the surface, with the error of the surface. Without one it
/// says nothing.
void say_form_lost(Editor& editor, const std::optional<Message>& why);

/// `run_operation` for refinements, which get the form that they keep, if any. Warns where it is lost.
using Refinement = std::function<Result<EditResult>(const PolyhedronSource&, const SurfaceForm*)>;
bool run_refinement(Editor& editor, const Refinement& refinement, const std::string& label);

/// Says so if something that is selected is locked.
void say_locked(Editor& editor);

}  // namespace hariko
