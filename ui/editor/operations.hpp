#pragma once

// Operations on the active polyhedron: running them, and what is selected afterwards. Selections that follow
// from others.

#include <functional>
#include <optional>

#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/surfacing/surface_form.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

using Operation = std::function<Result<EditResult>(const PolyhedronSource&)>;

/// Selects what an operation left: its elements of the kind that the mode selects, else the elements of that
/// kind that they are made of or touch. Where there are none the mode changes to what there is.
void select_result(Editor& editor, ObjectId object, const ElementSet& result);

/// Change of what is selected of an object.
struct ElementChange {
  /// Reason why it does nothing to the elements of an object, in English; null where it does something.
  const char* (*why_not)(const Object&);
  std::function<ElementSelection(const Object&, const ElementSelection&)> change;
};
/// Change by the mesh of a polyhedron, or by the net of patches.
ElementChange by_cage(std::function<ElementSelection(const Polyhedron&, const ElementSelection&)> change);
/// Change by a polyhedron with its tensions.
ElementChange by_polyhedron(
    std::function<ElementSelection(const PolyhedronSource&, const ElementSelection&)> change);
/// Adds all that hangs together with the selected elements, as each kind of object has it.
ElementChange by_links();

/// Replaces what is selected of each object whose elements the change can do something to.
void change_elements(Editor& editor, const ElementChange& change);

/// Inverts what is selected of each object that has something selected, and of the active one in any case.
void invert_elements(Editor& editor);
/// Adds all that hangs together with an element; false where its kind has no links.
bool select_linked_to(Editor& editor, const ElementRef& element);

/// Makes one step of an operation on the active object, which must be a polyhedron, and selects the result;
/// or says why not. True when the document changed.
bool run_operation(Editor& editor, const Operation& operation, const Phrase& label);

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
bool run_refinement(Editor& editor, const Refinement& refinement, const Phrase& label);

/// Says so if something that is selected is locked.
void say_locked(Editor& editor);

}  // namespace hariko
