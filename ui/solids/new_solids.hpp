#pragma once

// The solids that can be added, with the numbers that make them.

#include <functional>
#include <span>
#include <vector>

#include "core/envelope/solid.hpp"
#include "ui/editor/editor.hpp"

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
/// What that makes of a document, without a step.
Result<Document> with_new_solid(const Editor& editor, const Solid& solid);

}  // namespace hariko
