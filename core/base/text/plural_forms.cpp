#include "core/base/text/plural_forms.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

constexpr std::string_view rule_blanks = " \t\r\n";

std::string_view without_rule_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(rule_blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(rule_blanks) - begin + 1);
}

/// Value behind "name =" in one of the parts between semicolons.
std::optional<std::string_view> assigned(std::string_view rule, std::string_view name) {
  while (!rule.empty()) {
    const std::size_t end = std::min(rule.find(';'), rule.size());
    const std::string_view part = without_rule_blanks(rule.substr(0, end));
    rule.remove_prefix(std::min(end + 1, rule.size()));
    if (!part.starts_with(name)) continue;
    const std::string_view rest = without_rule_blanks(part.substr(name.size()));
    if (rest.starts_with('=')) return without_rule_blanks(rest.substr(1));
  }
  return {};
}

Message refused_rule(const std::string& sentence) {
  return make_error(e_plural_forms, sentence, "Take the line Plural-Forms that is common for the language.");
}

}  // namespace

/// Recursive descent over one expression; levels of binary operators by a table.
class PluralRuleParser {
 public:
  explicit PluralRuleParser(std::string_view text) : text_(text) {}

  /// Nodes of the whole text; nothing where it is no expression.
  std::optional<std::vector<PluralForms::Node>> parse() {
    if (!choice() || !skip_blanks().empty()) return {};
    return std::move(nodes_);
  }

 private:
  using Operation = PluralForms::Operation;
  using Place = std::optional<std::size_t>;
  struct Operator {
    std::string_view sign;
    Operation operation;
    int level;  ///< those of higher ones bind first
  };
  /// Longer signs stand before those that they begin with.
  static constexpr std::array<Operator, 13> operators{{{"||", Operation::either, 0},
                                                       {"&&", Operation::both, 1},
                                                       {"==", Operation::equal, 2},
                                                       {"!=", Operation::unequal, 2},
                                                       {"<=", Operation::at_most, 3},
                                                       {">=", Operation::at_least, 3},
                                                       {"<", Operation::less, 3},
                                                       {">", Operation::greater, 3},
                                                       {"+", Operation::add, 4},
                                                       {"-", Operation::subtract, 4},
                                                       {"*", Operation::multiply, 5},
                                                       {"/", Operation::divide, 5},
                                                       {"%", Operation::remainder, 5}}};
  static constexpr int levels = 6, deepest = 50;

  std::string_view skip_blanks() {
    at_ = std::min(text_.find_first_not_of(rule_blanks, at_), text_.size());
    return text_.substr(at_);
  }
  bool take(std::string_view sign) {
    if (!skip_blanks().starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }
  std::size_t put(PluralForms::Node node) {
    nodes_.push_back(node);
    return nodes_.size() - 1;
  }

  Place choice() {
    if (++depth_ > deepest) return {};
    const Place condition = binary(0);
    if (condition && take("?")) {
      const Place yes = choice();
      if (!yes || !take(":")) return {};
      const Place no = choice();
      if (!no) return {};
      --depth_;
      return put({Operation::choose, 0, *condition, *yes, *no});
    }
    --depth_;
    return condition;
  }

  Place binary(int level) {
    if (level == levels) return unary();
    Place left = binary(level + 1);
    while (left) {
      const Operator* found = nullptr;
      const std::string_view rest = skip_blanks();
      for (const Operator& each : operators)
        if (!found && rest.starts_with(each.sign)) found = &each;
      if (!found || found->level != level) return left;
      at_ += found->sign.size();
      const Place right = binary(level + 1);
      if (!right) return {};
      left = put({found->operation, 0, *left, *right, 0});
    }
    return left;
  }

  Place unary() {
    const std::string_view rest = skip_blanks();
    if (rest.empty()) return {};
    if (is_digit(rest.front())) return number();
    if (take("n")) return put({Operation::n, 0, 0, 0, 0});
    if (++depth_ > deepest) return {};
    Place inner;
    if (take("!")) {
      inner = unary();
      if (inner) inner = put({Operation::negate, 0, *inner, 0, 0});
    } else if (take("(")) {
      inner = choice();
      if (!take(")")) return {};
    }
    --depth_;
    return inner;
  }

  Place number() {
    std::uint64_t value = 0;
    for (; at_ < text_.size() && is_digit(text_[at_]); ++at_) {
      value = value * 10 + std::uint64_t(text_[at_] - '0');
      if (value > 1'000'000'000) return {};
    }
    return put({Operation::number, value, 0, 0, 0});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<PluralForms::Node> nodes_;
};

PluralForms::Value PluralForms::applied(Operation operation, std::uint64_t a, std::uint64_t b) {
  switch (operation) {
    case Operation::equal:
      return a == b ? 1 : 0;
    case Operation::unequal:
      return a != b ? 1 : 0;
    case Operation::less:
      return a < b ? 1 : 0;
    case Operation::greater:
      return a > b ? 1 : 0;
    case Operation::at_most:
      return a <= b ? 1 : 0;
    case Operation::at_least:
      return a >= b ? 1 : 0;
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return b == 0 ? Value() : Value(a / b);
    case Operation::remainder:
      return b == 0 ? Value() : Value(a % b);
    default:
      HARIKO_ASSERT(false, "the operation has not two operands");
      return {};
  }
}

PluralForms::Value PluralForms::value(std::size_t node, std::uint64_t n) const {
  const auto& [operation, number, first, second, third] = nodes_[node];
  if (operation == Operation::number) return number;
  if (operation == Operation::n) return n;
  const Value a = value(first, n);
  if (!a) return {};
  switch (operation) {
    case Operation::negate:
      return *a == 0 ? 1 : 0;
    case Operation::choose:
      return value(*a != 0 ? second : third, n);
    case Operation::either:
      if (*a != 0) return 1;
      break;
    case Operation::both:
      if (*a == 0) return 0;
      break;
    default:
      break;
  }
  const Value b = value(second, n);
  if (!b) return {};
  if (operation == Operation::either || operation == Operation::both) return *b != 0 ? 1 : 0;
  return applied(operation, *a, *b);
}

Result<PluralForms> PluralForms::parse(std::string_view rule) {
  if (rule.size() > longest_rule) return refused_rule("The rule of the plural is too long.");
  const auto number = assigned(rule, "nplurals"), plural = assigned(rule, "plural");
  if (!number || !plural) return refused_rule("The rule of the plural does not give nplurals and plural.");
  PluralForms forms;
  forms.count_ = number->size() == 1 && is_digit(number->front()) ? std::size_t(number->front() - '0') : 0;
  if (forms.count_ < 1 || forms.count_ > most_forms)
    return refused_rule("The number of plural forms (nplurals) is none from 1 to 8.");
  auto nodes = PluralRuleParser(*plural).parse();
  if (!nodes)
    return refused_rule("The rule of the plural is no expression of n: " + sanitized_utf8(*plural, 100) +
                        ".");
  forms.nodes_ = std::move(*nodes);
  constexpr std::uint64_t tried = 1000;  // as the checker of gettext does
  for (std::uint64_t n = 0; n <= tried; ++n) {
    const Value chosen = forms.value(forms.nodes_.size() - 1, n);
    if (!chosen)
      return refused_rule("The rule of the plural divides by zero for the count " + std::to_string(n) + ".");
    if (*chosen >= forms.count_)
      return refused_rule("The rule of the plural gives the count " + std::to_string(n) +
                          " a form that does not exist.");
  }
  return forms;
}

std::size_t PluralForms::form(std::uint64_t n) const {
  if (nodes_.empty()) return 0;
  const Value chosen = value(nodes_.size() - 1, n);
  return chosen && *chosen < count_ ? std::size_t(*chosen) : count_ - 1;
}

}  // namespace hariko
