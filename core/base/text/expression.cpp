#include "core/base/text/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

constexpr double per_degree = std::numbers::pi / 180;
constexpr std::array names{"pi",  "e",     "sqrt",  "abs",  "min", "max",
                           "cos", "round", "floor", "ceil", "sin", "tan"};

Message failed(std::string text) {
  return make_error(e_expression, std::move(text), "Type a number such as 12.5, 12mm+3 or 2*pi.");
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Translates typed text into the parser's syntax: units become factors, and syntax that these expressions
/// do not have (assignments, comparisons, strings) is refused.
class Translator {
 public:
  Translator(std::string_view text, std::span<const UnitFactor> units) : rest_(text), units_(units) {}

  Result<std::string> translate() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == ' ')
        rest_.remove_prefix(1);
      else if (is_digit(c) || c == '.') {
        if (operand_) return failed("Two numbers follow each other.");
        number();
      } else if (take_unit())
        continue;
      else if (is_letter(c)) {
        if (const auto unknown = name()) return failed("\"" + *unknown + "\" is not known.");
      } else if (std::string_view("+-*/^(),").find(c) != std::string_view::npos) {
        if (c == '(') times();
        operand_ = c == ')';
        out_ += c;
        rest_.remove_prefix(1);
      } else {
        return failed("The expression has a sign that means nothing here.");
      }
    }
    return out_;
  }

 private:
  void number() {
    std::size_t length = digits(0);
    if (length < rest_.size() && rest_[length] == '.') length += 1 + digits(length + 1);
    // An e without an exponent behind it begins a name.
    if (length < rest_.size() && (rest_[length] == 'e' || rest_[length] == 'E')) {
      std::size_t sign = length + 1;
      if (sign < rest_.size() && (rest_[sign] == '+' || rest_[sign] == '-')) ++sign;
      if (const std::size_t exponent = digits(sign)) length = sign + exponent;
    }
    take(length);
  }
  std::size_t digits(std::size_t from) const {
    std::size_t end = from;
    while (end < rest_.size() && is_digit(rest_[end])) ++end;
    return end - from;
  }
  /// Inserts the sign of an implied product: "2pi", "3(1+2)".
  void times() {
    if (operand_) out_ += '*';
  }
  void take(std::size_t length) {
    times();
    out_ += rest_.substr(0, length);
    rest_.remove_prefix(length);
    operand_ = true;
  }

  bool take_unit() {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    for (const UnitFactor& unit : units_) {
      const bool here =
          is_letter(unit.name.front()) ? rest_.substr(0, length) == unit.name : rest_.starts_with(unit.name);
      if (!here || !operand_) continue;
      std::array<char, 32> digits{};
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), unit.factor).ptr;
      out_.append("*(").append(digits.data(), end).append(")");
      rest_.remove_prefix(unit.name.size());
      return true;
    }
    return false;
  }

  std::optional<std::string> name() {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view word = rest_.substr(0, length);
    if (std::find(names.begin(), names.end(), word) == names.end()) return std::string(word);
    take(length);
    operand_ = word == "pi" || word == "e";
    return std::nullopt;
  }

  std::string_view rest_;
  std::span<const UnitFactor> units_;
  std::string out_;
  bool operand_ = false;  ///< a value ends here, so a unit or another factor may follow
};

double calculate(const std::string& expression) {
  mu::Parser parser;
  parser.ClearConst();
  parser.ClearFun();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("e", std::numbers::e);
  const auto function = [&](const char* name, mu::fun_type1 value) { parser.DefineFun(name, value); };
  function("sqrt", [](double x) { return std::sqrt(x); });
  function("abs", [](double x) { return std::abs(x); });
  function("round", [](double x) { return std::round(x); });
  function("floor", [](double x) { return std::floor(x); });
  function("ceil", [](double x) { return std::ceil(x); });
  function("sin", [](double x) { return std::sin(x * per_degree); });
  function("cos", [](double x) { return std::cos(x * per_degree); });
  function("tan", [](double x) { return std::tan(x * per_degree); });
  parser.DefineFun("min", static_cast<mu::fun_type2>([](double a, double b) { return std::min(a, b); }));
  parser.DefineFun("max", static_cast<mu::fun_type2>([](double a, double b) { return std::max(a, b); }));
  parser.SetExpr(expression);
  int count = 0;
  const double* values = parser.Eval(count);
  if (count != 1) throw mu::ParserError("several values");
  return values[0];
}

}  // namespace

Result<double> evaluate(std::string_view text, std::span<const UnitFactor> units) {
  if (text.size() > max_expression_length) return failed("The expression is too long.");
  const auto translated = Translator(text, units).translate();
  if (!translated) return translated.error();
  if (translated->empty()) return failed("There is no number.");
  try {
    const double value = calculate(*translated);
    if (std::isfinite(value)) return value;
    return failed("The expression has no finite value.");
  } catch (const mu::ParserError&) {
    return failed("The expression is not complete.");
  }
}

}  // namespace hariko
