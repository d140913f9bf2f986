#include "app/commands/scripts/command_list.hpp"

#include <cmath>

#include "core/base/text/json_writer.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

const char* unit_word(ArgumentUnit unit) {
  return unit == ArgumentUnit::length ? "length" : unit == ArgumentUnit::degrees ? "degrees" : "";
}

std::string real_text(double value) {
  std::string out;
  append_real(out, value);
  return out;
}

/// Default of an argument as it may be written in a script.
std::string standard_text(const ArgumentSpec& spec) {
  const ArgumentValue& value = *spec.standard;
  const std::string unit = spec.unit == ArgumentUnit::length ? " mm" : "";
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return real_text(*number) + unit;
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  if (const Vector3* point = std::get_if<Vector3>(&value))
    return "[" + real_text(point->x()) + ", " + real_text(point->y()) + ", " + real_text(point->z()) + "]" +
           unit;
  return "[]";
}

std::string range_of_text(const ArgumentSpec& spec) {
  const bool low = std::isfinite(spec.low), high = std::isfinite(spec.high);
  if (low && high) return ", " + real_text(spec.low) + " to " + real_text(spec.high);
  if (low) return ", at least " + real_text(spec.low);
  return high ? ", at most " + real_text(spec.high) : std::string();
}

std::string argument_line(const ArgumentSpec& spec) {
  std::string out = "    " + spec.name + ": ";
  if (spec.type == ArgumentType::word) {
    std::string words;
    for (const std::string& word : spec.words) words += (words.empty() ? "" : "|") + word;
    out += words;
  } else {
    out += name_of(spec.type);
  }
  if (spec.unit != ArgumentUnit::none) out += std::string(" (") + unit_word(spec.unit) + ")";
  out += range_of_text(spec);
  if (spec.standard) out += ", default " + standard_text(spec);
  if (spec.required()) out += ", required";
  if (!spec.help.empty()) out += "; " + spec.help;
  return out + "\n";
}

void write_standard(JsonWriter& json, const ArgumentSpec& spec) {
  json.key("default");
  if (!spec.standard) return json.value(nullptr);
  std::visit([&json](const auto& value) { json.value(value); }, *spec.standard);
}

void write_argument(JsonWriter& json, const ArgumentSpec& spec) {
  const auto bound = [](double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; };
  json.object([&] {
    json.member("name", spec.name);
    json.member("type", name_of(spec.type));
    json.member("unit", unit_word(spec.unit));
    json.member("required", spec.required());
    write_standard(json, spec);
    json.member("low", bound(spec.low));
    json.member("high", bound(spec.high));
    json.member("words", spec.words);
    json.member("help", spec.help);
  });
}

}  // namespace

std::string command_list_text(const CommandTable& table) {
  std::string out;
  for (const Command& command : table.all()) {
    out += command.id + (command.scriptable() ? "" : " (needs the window)") + ": " + command.help + "\n";
    if (!command.scriptable()) continue;
    for (const ArgumentSpec& spec : command.script.arguments) out += argument_line(spec);
  }
  return out;
}

std::string command_list_json(const CommandTable& table) {
  JsonWriter json(2);
  json.object([&] {
    json.list("commands", table.all(), [&](const Command& command) {
      json.object([&] {
        json.member("id", command.id);
        json.member("menu", command.menu);
        json.member("label", command.label);
        json.member("help", command.help);
        json.member("needs_window", !command.scriptable());
        json.list("arguments", command.script.arguments,
                  [&](const ArgumentSpec& spec) { write_argument(json, spec); });
      });
    });
  });
  return json.take() + "\n";
}

}  // namespace hariko
