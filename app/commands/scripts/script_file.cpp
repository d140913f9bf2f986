#include "app/commands/scripts/script_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/format/json_value.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

using detail::JsonMember;
using detail::JsonObject;
using detail::JsonValue;

constexpr std::array script_members{std::string_view("format"), std::string_view("version"),
                                    std::string_view("steps")};
constexpr std::array step_members{std::string_view("command"), std::string_view("arguments")};
constexpr std::string_view format_word = "hariko-script";
constexpr std::size_t shown_bytes = 120;

Message bad_script(const std::string& text) {
  return make_error(e_script, text, "The page on the command line describes scripts.");
}

const JsonValue* member_of(const JsonObject& object, std::string_view name) {
  const auto found = std::find_if(object.begin(), object.end(),
                                  [&](const JsonMember& member) { return member.name == name; });
  return found == object.end() ? nullptr : &found->value;
}

/// Complains about a member that is none of `known`. `owner`: "The script", "Step 3".
std::optional<Message> unknown_member(const JsonObject& object, std::span<const std::string_view> known,
                                      const std::string& owner) {
  for (const JsonMember& member : object) {
    if (std::find(known.begin(), known.end(), member.name) != known.end()) continue;
    const auto near = nearest_word(member.name, {known.begin(), known.end()});
    return bad_script(owner + " has the unknown member \"" + shortened(member.name, shown_bytes) + "\"." +
                      (near ? " Did you mean \"" + *near + "\"?" : std::string()));
  }
  return {};
}

std::optional<WrittenScalar> scalar_from(const JsonValue& value) {
  if (const bool* on = value.boolean()) return WrittenScalar(*on);
  if (const double* number = value.number()) return WrittenScalar(*number);
  if (const std::string* text = value.string()) return WrittenScalar(*text);
  return {};
}

std::optional<WrittenValue> value_from_json(const JsonValue& value) {
  if (const auto scalar = scalar_from(value))
    return std::visit([](const auto& one) { return WrittenValue(one); }, *scalar);
  const detail::JsonArray* array = value.array();
  if (!array) return {};
  std::vector<WrittenScalar> list;
  for (const JsonValue& entry : *array) {
    auto scalar = scalar_from(entry);
    if (!scalar) return {};
    list.push_back(*std::move(scalar));
  }
  return WrittenValue(std::move(list));
}

Result<ScriptStep> step_from(const JsonValue& value, std::size_t index) {
  const std::string name = "S" + step_text(index, {}).substr(1);
  const JsonObject* object = value.object();
  if (!object) return bad_script(name + " is no object.");
  if (const auto wrong = unknown_member(*object, step_members, name)) return *wrong;
  const JsonValue* command = member_of(*object, "command");
  if (!command || !command->string()) return bad_script(name + " has no text \"command\".");
  ScriptStep step{*command->string(), {}};
  const JsonValue* arguments = member_of(*object, "arguments");
  if (!arguments) return step;
  if (!arguments->object())
    return bad_script("The arguments of " + step_text(index, step.command) + " are no object.");
  for (const JsonMember& member : *arguments->object()) {
    auto written = value_from_json(member.value);
    if (!written)
      return bad_script("The argument \"" + shortened(member.name, shown_bytes) + "\" of " +
                        step_text(index, step.command) + " is no number, text, switch, or list of these.");
    step.arguments.push_back({member.name, *std::move(written)});
  }
  return step;
}

std::optional<Message> wrong_header(const JsonObject& script) {
  const JsonValue *format = member_of(script, "format"), *version = member_of(script, "version");
  if (!format || !format->string() || *format->string() != format_word)
    return bad_script("The file is no script: its member \"format\" is not \"hariko-script\".");
  if (!version || !version->number()) return bad_script("The script has no number \"version\".");
  if (*version->number() == script_version) return {};
  std::string number;
  append_real(number, *version->number());
  return bad_script("Version " + number + " of scripts is unknown: this program reads version 1.");
}

}  // namespace

std::string step_text(std::size_t index, const std::string& command) {
  const std::string name = "step " + std::to_string(index + 1);
  return command.empty() ? name : name + " \"" + shortened(command, shown_bytes) + "\"";
}

Result<Script> read_script(std::string_view text) {
  const auto parsed = detail::parse_json(text);
  if (!parsed) return parsed.error();
  const JsonObject* object = parsed->object();
  if (!object) return bad_script("The script is no JSON object.");
  if (const auto wrong = wrong_header(*object)) return *wrong;
  if (const auto wrong = unknown_member(*object, script_members, "The script")) return *wrong;
  const JsonValue* steps = member_of(*object, "steps");
  if (!steps || !steps->array()) return bad_script("The script has no list \"steps\".");
  Script out;
  for (const JsonValue& value : *steps->array()) {
    auto step = step_from(value, out.size());
    if (!step) return step.error();
    out.push_back(std::move(step).value());
  }
  return out;
}

}  // namespace hariko
