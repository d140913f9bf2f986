#pragma once

// LastOperation: a step whose numbers can still be changed right after it was made.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

class Editor;

struct OperationNumber {
  const char* id;     ///< also the mark "last.<id>"
  const char* label;  ///< English, translated where it is shown
  double value = 0;
  double low = 0, high = 0;
  bool whole = false;  ///< a count; others are lengths in the document's unit
};

/// Result of an operation with these numbers on a document, the object that is then active, and what of it
/// is selected.
struct OperationResult {
  Document document;
  ObjectId active;
  ElementSelection selected = {};
};
using MakeOperation =
    std::function<Result<OperationResult>(const Document&, std::span<const OperationNumber>)>;

/// Can be adjusted as long as the document is the one that it made.
class LastOperation {
 public:
  /// Makes the step. False, with a notice, when it is refused.
  bool run(Editor& editor, std::string label, std::vector<OperationNumber> numbers, MakeOperation make);
  /// Makes the step anew with another number, in the place of the old one; refused numbers change nothing.
  bool adjust(Editor& editor, std::size_t number, double value);

  bool can_adjust(const Editor& editor) const;
  const std::string& label() const { return label_; }
  const std::vector<OperationNumber>& numbers() const { return numbers_; }

 private:
  bool commit(Editor& editor, const Document& before, std::span<const OperationNumber> numbers);

  std::string label_;
  std::vector<OperationNumber> numbers_;
  MakeOperation make_;
  Document before_, after_;
};

}  // namespace hariko
