#pragma once

// The solids that can be added, with the numbers that make them.

#include <functional>
#include <span>
#include <vector>

#include "core/envelope/solid.hpp"
#include "ui/editor/editor.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

struct NewSolid {
  const char* name;  ///< "box": commands are solid.box and solid.place_box
  const char *label, *step, *help;
  std::function<std::vector<OperationNumber>(double radius)> numbers;  ///< to begin with
  std::function<Solid(std::span<const OperationNumber>)> make;

  /// With its usual proportions.
  Solid of_radius(double radius) const { return make(numbers(radius)); }
};

std::vector<NewSolid> new_solids();

/// The active object where it is made of solids and not locked, else null.
const Object* active_solids(const Editor& editor);

/// Selects solids of an object, which shows where they can be seen.
void select_solids(Editor& editor, ObjectId object, std::span<const std::uint32_t> ids);

/// Adds a solid to the active object where that is made of solids, else as a new object at `place`; its
/// numbers can be adjusted afterwards. `put` gives it its place in the object's axes. False, with a notice,
/// when it is refused.
bool add_new_solid(Editor& editor, const NewSolid& shape, std::vector<OperationNumber> numbers,
                   std::function<Solid(Solid)> put, const Similarity& place);
/// Document with that solid added, without a step.
Result<Document> with_new_solid(const Editor& editor, const Solid& solid);

/// Modal: a drag from the surface of the active solids pulls it to the pointer, a drag from a place that was
/// pulled before moves that place; the wheel changes how far about it the surface follows, Del removes it.
/// One step for each.
std::unique_ptr<Tool> make_pull_tool();

/// Modal: a click puts the solid on another solid of the active object, or on the working plane; a drag gives
/// its radius. Ctrl snaps both. One step.
std::unique_ptr<Tool> make_place_solid_tool(NewSolid shape);

}  // namespace hariko
