#include "ui/editor/command_arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/text/expression.hpp"
#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/length_units.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

constexpr std::array<std::string_view, 8> type_names{"number", "whole number", "point", "switch",
                                                     "word",   "text",         "path",  "list"};
constexpr std::size_t shown_bytes = 120;

Message wrong_argument(const ArgumentSpec& spec, const std::string& what) {
  return make_error(e_argument,
                    "The argument \"" + spec.name + "\" " + what + (what.ends_with('.') ? "" : "."),
                    "`hariko run --list` says what each command takes.");
}

/// The number, without an exponent where it is whole.
std::string plain(double value) {
  std::string out;
  if (value == std::round(value) && std::abs(value) < 1e15) {
    if (value < 0) out = "-";
    append_integer(out, static_cast<std::uint64_t>(std::abs(value)));
  } else {
    append_real(out, value);
  }
  return out;
}

/// "at least 1", "1 to 64"; empty where there are no bounds.
std::string bounds_text(const ArgumentSpec& spec) {
  const bool low = std::isfinite(spec.low), high = std::isfinite(spec.high);
  if (low && high) return plain(spec.low) + " to " + plain(spec.high);
  if (low) return "at least " + plain(spec.low);
  return high ? "at most " + plain(spec.high) : std::string();
}

std::string wanted_text(const ArgumentSpec& spec) {
  switch (spec.type) {
    case ArgumentType::number:
      return spec.unit == ArgumentUnit::length    ? "a length: a number, or a text such as \"12 mm\""
             : spec.unit == ArgumentUnit::degrees ? "an angle in degrees"
                                                  : "a number";
    case ArgumentType::whole:
      return "a whole number";
    case ArgumentType::point:
      return "a list of three numbers";
    case ArgumentType::on_off:
      return "true or false";
    case ArgumentType::list:
      return "a list of texts or whole numbers";
    default:
      return "a text";
  }
}

/// Declaration that a value is read against, and the document's unit where that is known.
struct ArgumentReading {
  const ArgumentSpec& spec;
  std::optional<Unit> unit;

  Message mistyped() const { return wrong_argument(spec, "must be " + wanted_text(spec)); }
  std::vector<UnitFactor> units() const {
    if (spec.unit == ArgumentUnit::degrees) return {std::begin(angle_units), std::end(angle_units)};
    if (spec.unit == ArgumentUnit::none) return {};
    const auto lengths = length_units(unit.value_or(Unit::millimetre));
    return {lengths.begin(), lengths.end()};
  }
  Result<double> in_range(double value) const {
    const bool checked = unit || spec.unit != ArgumentUnit::length;
    if (checked && !(value >= spec.low && value <= spec.high))
      return wrong_argument(spec, "is " + plain(value) + ", but must be " + bounds_text(spec));
    return value;
  }
};

Result<double> number_from(const ArgumentReading& reading, const WrittenScalar& written) {
  const double* plain_number = std::get_if<double>(&written);
  if (plain_number) return reading.in_range(*plain_number);
  const std::string* text = std::get_if<std::string>(&written);
  if (!text || reading.spec.type == ArgumentType::whole) return reading.mistyped();
  const auto value = evaluate(*text, reading.units());
  if (!value) return wrong_argument(reading.spec, "is no number: " + value.error().text);
  return reading.in_range(*value);
}

std::optional<WrittenScalar> scalar_of(const WrittenValue& written) {
  if (const auto* on = std::get_if<bool>(&written)) return *on;
  if (const auto* number = std::get_if<double>(&written)) return *number;
  if (const auto* text = std::get_if<std::string>(&written)) return *text;
  return {};
}

Result<ArgumentValue> number_value(const ArgumentReading& reading, const WrittenValue& written) {
  const auto scalar = scalar_of(written);
  if (!scalar) return reading.mistyped();
  const auto value = number_from(reading, *scalar);
  if (!value) return value.error();
  if (reading.spec.type == ArgumentType::whole && *value != std::floor(*value)) return reading.mistyped();
  return ArgumentValue(*value);
}

Result<ArgumentValue> point_value(const ArgumentReading& reading, const WrittenValue& written) {
  const auto* list = std::get_if<std::vector<WrittenScalar>>(&written);
  if (!list || list->size() != 3) return reading.mistyped();
  Vector3 out;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = number_from(reading, (*list)[static_cast<std::size_t>(axis)]);
    if (!value) return value.error();
    out[axis] = *value;
  }
  return ArgumentValue(out);
}

/// Text of an entry of a list: a text, or a whole number written out.
std::optional<std::string> entry_text(const WrittenScalar& written) {
  if (const auto* text = std::get_if<std::string>(&written)) return *text;
  const auto* number = std::get_if<double>(&written);
  constexpr double largest_exact = 9007199254740992;  // whole numbers below it are exact
  if (!number || *number != std::floor(*number) || std::abs(*number) >= largest_exact) return {};
  return std::to_string(static_cast<long long>(*number));
}

Result<ArgumentValue> list_value(const ArgumentReading& reading, const WrittenValue& written) {
  std::vector<WrittenScalar> entries;
  if (const auto scalar = scalar_of(written))
    entries.push_back(*scalar);
  else
    entries = std::get<std::vector<WrittenScalar>>(written);
  std::vector<std::string> out;
  for (const WrittenScalar& entry : entries) {
    auto text = entry_text(entry);
    if (!text) return reading.mistyped();
    out.push_back(*std::move(text));
  }
  return ArgumentValue(std::move(out));
}

Result<ArgumentValue> word_value(const ArgumentReading& reading, const std::string& written) {
  const std::vector<std::string>& words = reading.spec.words;
  if (std::find(words.begin(), words.end(), written) != words.end()) return ArgumentValue(written);
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return wrong_argument(reading.spec,
                        "is \"" + shortened(written, shown_bytes) + "\", but must be one of " + all);
}

Result<ArgumentValue> value_from(const ArgumentReading& reading, const WrittenValue& written) {
  switch (reading.spec.type) {
    case ArgumentType::number:
    case ArgumentType::whole:
      return number_value(reading, written);
    case ArgumentType::point:
      return point_value(reading, written);
    case ArgumentType::list:
      return list_value(reading, written);
    case ArgumentType::on_off:
      if (const bool* on = std::get_if<bool>(&written)) return ArgumentValue(*on);
      return reading.mistyped();
    default:
      break;
  }
  const std::string* text = std::get_if<std::string>(&written);
  if (!text) return reading.mistyped();
  if (reading.spec.type == ArgumentType::word) return word_value(reading, *text);
  if (text->empty()) return wrong_argument(reading.spec, "is empty");
  return ArgumentValue(*text);
}

Message unknown_argument(std::span<const ArgumentSpec> specs, const std::string& name) {
  const std::string shown = shortened(name, shown_bytes);
  if (specs.empty())
    return make_error(e_argument, "The command takes no arguments, but \"" + shown + "\" is written.",
                      "`hariko run --list` says what each command takes.");
  std::vector<std::string> known;
  for (const ArgumentSpec& spec : specs) known.push_back(spec.name);
  const auto near = nearest_word(name, known);
  return make_error(
      e_argument,
      "There is no argument \"" + shown + "\"." + (near ? " Did you mean \"" + *near + "\"?" : std::string()),
      "`hariko run --list` says what each command takes.");
}

ArgumentSpec typed(std::string name, ArgumentType type, std::string help) {
  ArgumentSpec spec{std::move(name), type};
  spec.help = std::move(help);
  return spec;
}

}  // namespace

std::string_view name_of(ArgumentType type) {
  return type_names[static_cast<std::size_t>(type)];
}

ArgumentSpec length_argument(std::string name, std::string help, std::optional<double> millimetres,
                             double low) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::number, std::move(help));
  spec.unit = ArgumentUnit::length;
  if (millimetres) spec.standard = *millimetres;
  spec.low = low;
  return spec;
}

ArgumentSpec angle_argument(std::string name, std::string help, std::optional<double> degrees) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::number, std::move(help));
  spec.unit = ArgumentUnit::degrees;
  if (degrees) spec.standard = *degrees;
  return spec;
}

ArgumentSpec number_argument(std::string name, std::string help, std::optional<double> standard, double low,
                             double high) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::number, std::move(help));
  if (standard) spec.standard = *standard;
  spec.low = low;
  spec.high = high;
  return spec;
}

ArgumentSpec whole_argument(std::string name, std::string help, std::optional<int> standard, int low,
                            int high) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::whole, std::move(help));
  if (standard) spec.standard = double(*standard);
  spec.low = low;
  spec.high = high;
  return spec;
}

ArgumentSpec point_argument(std::string name, std::string help, ArgumentUnit unit,
                            const std::optional<Vector3>& standard) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::point, std::move(help));
  spec.unit = unit;
  if (standard) spec.standard = *standard;
  return spec;
}

ArgumentSpec on_off_argument(std::string name, std::string help, std::optional<bool> standard) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::on_off, std::move(help));
  if (standard) spec.standard = *standard;
  return spec;
}

ArgumentSpec word_argument(std::string name, std::string help, std::vector<std::string> words,
                           std::optional<std::string> standard) {
  ArgumentSpec spec = typed(std::move(name), ArgumentType::word, std::move(help));
  spec.words = std::move(words);
  if (standard) spec.standard = *std::move(standard);
  return spec;
}

ArgumentSpec text_argument(std::string name, std::string help) {
  return typed(std::move(name), ArgumentType::text, std::move(help));
}

ArgumentSpec path_argument(std::string name, std::string help) {
  return typed(std::move(name), ArgumentType::path, std::move(help));
}

ArgumentSpec list_argument(std::string name, std::string help) {
  return typed(std::move(name), ArgumentType::list, std::move(help));
}

ArgumentSpec optional(ArgumentSpec spec) {
  spec.optional = true;
  return spec;
}

ArgumentValue standard_in(const ArgumentSpec& spec, Unit unit) {
  HARIKO_ASSERT(spec.standard.has_value(), "the argument has no default");
  ArgumentValue value = *spec.standard;
  if (spec.unit != ArgumentUnit::length) return value;
  if (auto* number = std::get_if<double>(&value)) *number /= millimetres_per(unit);
  if (auto* point = std::get_if<Vector3>(&value)) *point /= millimetres_per(unit);
  return value;
}

void Arguments::set(std::string name, ArgumentValue value) {
  values_.insert_or_assign(std::move(name), std::move(value));
}

Result<Arguments> read_arguments(std::span<const ArgumentSpec> specs,
                                 std::span<const WrittenArgument> written, std::optional<Unit> unit) {
  Arguments out;
  for (const WrittenArgument& argument : written) {
    const auto spec = std::ranges::find_if(specs, [&](const auto& s) { return s.name == argument.name; });
    if (spec == specs.end()) return unknown_argument(specs, argument.name);
    if (out.has(argument.name)) return wrong_argument(*spec, "is written twice");
    auto value = value_from({*spec, unit}, argument.value);
    if (!value) return value.error();
    out.set(argument.name, std::move(value).value());
  }
  for (const ArgumentSpec& spec : specs) {
    if (out.has(spec.name)) continue;
    if (spec.required()) return wrong_argument(spec, "is missing");
    if (spec.standard) out.set(spec.name, standard_in(spec, unit.value_or(Unit::millimetre)));
  }
  return out;
}

WrittenArgument written(std::string name, double value) {
  return {std::move(name), WrittenValue(value)};
}
WrittenArgument written(std::string name, const Vector3& point) {
  return {std::move(name), std::vector<WrittenScalar>{point.x(), point.y(), point.z()}};
}
WrittenArgument written(std::string name, std::string text) {
  return {std::move(name), WrittenValue(std::move(text))};
}
WrittenArgument written(std::string name, const std::vector<std::string>& texts) {
  return {std::move(name), std::vector<WrittenScalar>(texts.begin(), texts.end())};
}
WrittenArgument written_switch(std::string name, bool on) {
  return {std::move(name), WrittenValue(on)};
}

}  // namespace hariko
