#pragma once

// NumericInput: numbers typed while a tool runs.

#include <optional>
#include <string>
#include <vector>

#include "core/base/text/expression.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

/// A few fields for expressions, of which one is being edited. Nothing is drawn and nothing is changed by
/// itself: the tool passes keys on and asks for values.
class NumericInput {
 public:
  NumericInput() : NumericInput(1, {}) {}
  NumericInput(std::size_t components, std::vector<UnitFactor> units)
      : texts_(components), units_(std::move(units)) {}

  /// Digits, signs, letters once a number is begun, Backspace, and Tab (Shift+Tab) for the next (previous)
  /// field. False for other keys, also for a Backspace that finds nothing.
  bool key(const KeyPress& press);
  /// Whether something is typed.
  bool active() const;
  std::size_t size() const { return texts_.size(); }
  std::size_t current() const { return current_; }
  const std::string& text(std::size_t component) const { return texts_[component]; }
  /// Nothing for an empty field and for one that is no expression (yet).
  std::optional<double> value(std::size_t component = 0) const;
  /// Reason why the current field has no value; nothing when it is empty or good.
  std::optional<Message> error() const;
  /// Whether the current field ends with a unit that a letter more makes another one: "8m" on the way to
  /// "8mm". Its value counts when it is confirmed, and is not to be shown before.
  bool unfinished() const;
  /// Fewer or more fields; keeps the texts of those that stay.
  void resize(std::size_t components);
  void clear();

 private:
  bool takes(char32_t character) const;

  std::vector<std::string> texts_;
  std::vector<UnitFactor> units_;
  std::size_t current_ = 0;
};

}  // namespace hariko
