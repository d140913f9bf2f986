#pragma once

// AmountTool: an operation on a polyhedron whose amount is dragged or typed.

#include <functional>

#include "core/modeling/edit_result.hpp"
#include "core/modeling/selection/region.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// Operation with an amount, and how the pointer drives it. Amounts are lengths in the object's space, places
/// and directions in the document's.
struct AmountOperation {
  ObjectId object;
  const char* name = "";  ///< name of the value, translatable: "Extrude"
  Phrase label;           ///< name of the step
  /// The command and its argument with which a script does the same; empty where none does.
  std::string command = {}, argument = {};
  Vector3 anchor = Vector3::Zero();      ///< place of the selection
  Vector3 axis = Vector3::Zero();        ///< along which the pointer drags; zero: to the right is more
  bool negative = false;                 ///< whether amounts may be below zero
  bool grouped = false;                  ///< whether I changes between regions and single faces
  Grouping grouping = Grouping::region;  ///< to begin with
  std::function<Result<EditResult>(const PolyhedronSource&, double amount, Grouping)> apply;
  /// The least amount that is refused as too large; infinity where there is none.
  std::function<double(const PolyhedronSource&, Grouping)> limit = {};
  /// The operation on what is selected later, for repeating it, or why there is none; empty where it cannot
  /// be repeated.
  std::function<Result<AmountOperation>(const Editor&)> again = {};
};

/// Modal: the pointer drags the amount, digits type it, a click or Enter makes one step, Esc or a right click
/// none. What the operation refuses is said beside the pointer; an amount of zero makes no step.
std::unique_ptr<Tool> make_amount_tool(AmountOperation operation);

}  // namespace hariko
