#pragma once

// Plural forms of a language: which form of a sentence a count takes, by the rule that catalogues of gettext
// give.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_plural_forms{"E_PLURAL_FORMS"};

/// Rule of a language, such as "nplurals=2; plural=(n != 1);": an expression of C over the count n, with
/// ?: || && == != < > <= >= + - * / % ! and parentheses.
class PluralForms {
 public:
  static constexpr std::size_t most_forms = 8;
  static constexpr std::size_t longest_rule = 1000;  ///< bytes

  /// One form for every count, as Japanese has.
  PluralForms() = default;
  /// Reads a rule, and tries it on the counts up to 1000. Errors: E_PLURAL_FORMS where it is not well-formed,
  /// longer than `longest_rule`, has more than `most_forms` forms, divides by zero, or names a form that does
  /// not exist. O(length).
  static Result<PluralForms> parse(std::string_view rule);

  std::size_t count() const { return count_; }
  /// Form of a count, below `count()`; the last one where the rule says nothing that can be used. O(length).
  std::size_t form(std::uint64_t n) const;

 private:
  friend class PluralRuleParser;
  enum class Operation {
    number,
    n,
    negate,
    choose,
    either,
    both,
    equal,
    unequal,
    less,
    greater,
    at_most,
    at_least,
    add,
    subtract,
    multiply,
    divide,
    remainder
  };
  /// Operands stand before the operation, and the whole rule is the last node.
  struct Node {
    Operation operation = Operation::number;
    std::uint64_t number = 0;
    std::size_t a = 0, b = 0, c = 0;
  };
  using Value = std::optional<std::uint64_t>;
  /// Value of a node for a count; nothing where it divides by zero.
  Value value(std::size_t node, std::uint64_t n) const;
  /// Value of an operation on both of its operands.
  static Value applied(Operation operation, std::uint64_t a, std::uint64_t b);

  std::size_t count_ = 1;
  std::vector<Node> nodes_;  ///< empty for one form
};

}  // namespace hariko
