#include "app/scripts/script_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/text/json_writer.hpp"
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
                                    std::string_view("steps"), std::string_view("left_out"),
                                    std::string_view("notes")};
constexpr std::array step_members{std::string_view("command"), std::string_view("arguments")};
constexpr std::string_view format_word = "hariko-script";
constexpr std::size_t shown_bytes = 120;

Message bad_script(const std::string& text) {
  return make_error(e_script, text, "The page on the command line describes scripts.");
}

const JsonValue* member_of(const JsonObject& object, std::string_view name) {
  const auto found =
      std::ranges::find_if(object, [&](const JsonMember& member) { return member.name == name; });
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

constexpr double most_left_out = 1e9;

/// Reads what recording left out; says what is wrong with it.
std::optional<Message> read_notes(const JsonObject& script, Script& out) {
  if (const JsonValue* count = member_of(script, "left_out")) {
    const double* number = count->number();
    if (!number || !(*number >= 0) || *number > most_left_out || *number != std::floor(*number))
      return bad_script("\"left_out\" is no number of edits.");
    out.left_out = static_cast<std::size_t>(*number);
  }
  const JsonValue* notes = member_of(script, "notes");
  if (!notes) return {};
  if (!notes->array()) return bad_script("\"notes\" is no list of texts.");
  for (const JsonValue& note : *notes->array()) {
    if (!note.string()) return bad_script("\"notes\" is no list of texts.");
    out.notes.push_back(*note.string());
  }
  return {};
}

void write_scalar(JsonWriter& writer, const WrittenScalar& scalar) {
  std::visit([&](const auto& one) { writer.value(one); }, scalar);
}

void write_argument(JsonWriter& writer, const WrittenValue& value) {
  if (const auto* list = std::get_if<std::vector<WrittenScalar>>(&value))
    return writer.list(*list, [&](const WrittenScalar& scalar) { write_scalar(writer, scalar); });
  if (const bool* on = std::get_if<bool>(&value)) return writer.value(*on);
  if (const double* number = std::get_if<double>(&value)) return writer.value(*number);
  writer.value(std::get<std::string>(value));
}

void write_step(JsonWriter& writer, const ScriptStep& step) {
  writer.object([&] {
    writer.member("command", step.command);
    if (step.arguments.empty()) return;
    writer.object("arguments", [&] {
      for (const WrittenArgument& argument : step.arguments) {
        writer.key(argument.name);
        write_argument(writer, argument.value);
      }
    });
  });
}

/// A list with an entry a line.
template <class Entry, class Write>
std::string lines_of(const std::vector<Entry>& entries, Write&& write) {
  std::string out = "[";
  for (const Entry& entry : entries) {
    JsonWriter writer;
    write(writer, entry);
    out += (out.size() == 1 ? "\n    " : ",\n    ") + writer.take();
  }
  return out + (entries.empty() ? "]" : "\n  ]");
}

std::string place_in_script(std::size_t steps) {
  return steps == 0 ? "At the beginning" : "After step " + std::to_string(steps);
}

}  // namespace

std::string note_of_beginning(const std::string& document) {
  return "Begins with the document \"" + document + "\": name one like it with --in.";
}

std::string note_of_missing(std::size_t steps, const std::string& edit) {
  return place_in_script(steps) + " an edit is missing: " + edit;
}

std::string note_of_file(std::size_t steps, const std::string& command) {
  return place_in_script(steps) + " a file was written, which no step does: " + command;
}

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
    auto step = step_from(value, out.steps.size());
    if (!step) return step.error();
    out.steps.push_back(std::move(step).value());
  }
  if (const auto wrong = read_notes(*object, out)) return *wrong;
  return out;
}

std::string write_script(const Script& script) {
  std::string out = "{\n  \"format\": \"" + std::string(format_word) +
                    "\",\n  \"version\": " + std::to_string(script_version) + ",\n";
  if (script.left_out > 0) out += "  \"left_out\": " + std::to_string(script.left_out) + ",\n";
  if (!script.notes.empty())
    out += "  \"notes\": " +
           lines_of(script.notes, [](JsonWriter& writer, const std::string& note) { writer.value(note); }) +
           ",\n";
  return out + "  \"steps\": " + lines_of(script.steps, write_step) + "\n}\n";
}

}  // namespace hariko
