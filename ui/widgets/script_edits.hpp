#pragma once

// PropertyScripts: what stands in the properties as scripts set it, by the ids of its rows.

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/editor/command_table.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

using EditObject = std::function<Result<Document>(const Document&, const Object&, const Arguments&)>;
using WrittenArguments = std::vector<WrittenArgument>;
using ReadObject = std::function<WrittenArguments(const Object&)>;

/// An enumeration as the argument "value", and a switch as the argument "on".
template <class Enum>
ArgumentSpec one_of() {
  return word_argument("value", "", enum_word_list<Enum>(), {});
}
inline ArgumentSpec on_or_off() {
  return on_off_argument("on", "", true);
}

/// Enumerator of the word, which the table has found among those of the argument.
template <class Enum>
Enum chosen_of(const Arguments& given) {
  const auto value = enum_value<Enum>(given.text("value"));
  HARIKO_ASSERT(value.has_value(), "words of arguments are checked");
  return *value;
}

// Arguments that set a present value.
template <class Enum>
WrittenArguments word_now(Enum value) {
  return {written("value", std::string(enum_word(value)))};
}
inline WrittenArguments on_now(bool on) {
  return {written_switch("on", on)};
}

/// Edits that are told to the table, by the ids of the rows of the properties. They act on all chosen
/// objects, in one step.
class PropertyScripts {
 public:
  PropertyScripts(CommandTable& table, Editor& editor) : table_(table), editor_(editor) {}

  /// `edit` leaves objects without the property as they are, and `read` gives nothing for them.
  void add(const std::string& id, std::vector<ArgumentSpec> arguments, const char* step, EditObject edit,
           ReadObject read, bool looks_at_surfaces = false) {
    ScriptUse use;
    use.arguments = std::move(arguments);
    use.looks_at_surfaces = looks_at_surfaces;
    use.read = std::move(read);
    use.run = [&editor = editor_, step, edit = std::move(edit)](const Arguments& given) {
      Result<Document> result = editor.history.current();
      for (const ObjectId chosen : chosen_ids(editor)) {
        const auto object = result ? result->find_shared(chosen) : nullptr;
        if (object) result = edit(*result, *object, given);
      }
      editor.commit(result, step);
    };
    table_.use_in_scripts("property." + id, std::move(use));
  }

  /// Adds all of a table; objects that do not have one stay as they are.
  template <class Value>
  void add_table(const ObjectProperties<Value>& known) {
    for (const Property<Value>& each : known.all)
      add(
          each.row.id, {property_argument(each.row)}, each.row.step,
          [part = known.part, each](const Document& document, const Object& object,
                                    const Arguments& given) -> Result<Document> {
            const Value* now = part.of(object);
            if (!now || !each.held_by(*now)) return document;
            const double wanted = given_property(each.row, given);
            return part.edit(document, object.id, [&](Value& value) { each.set(value, wanted); });
          },
          [part = known.part, each](const Object& object) {
            const Value* now = part.of(object);
            const double value = now ? each.get(*now) : std::nan("");
            return std::isnan(value) ? WrittenArguments()
                                     : WrittenArguments{written_property(each.row, value)};
          });
  }

 private:
  CommandTable& table_;
  Editor& editor_;
};

}  // namespace hariko
