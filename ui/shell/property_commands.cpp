// Commands for what stands in the properties: the palette finds them by name. A number is asked for, a list
// or a check box brought into sight, and a choice of a list made at once.

#include <algorithm>
#include <functional>
#include <utility>

#include "core/document/edits/edit_skin.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/shell/preference_rows.hpp"
#include "ui/shell/property_tables.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

namespace {

using Has = std::function<bool(const Object&)>;

/// Reason why nothing of the active object can be set.
Reason no_free_object(const Editor& editor) {
  const Object* object = editor.has_document ? editor.active_object() : nullptr;
  if (!object) return translatable("No object is active. Click one in the list of objects.");
  if (object->locked) return translatable("The object is locked. Unlock it in the list of objects.");
  return {};
}

/// One of the chosen objects is enough: rows and scripts are about those that have the property.
WhyNot needs(const Editor& editor, Has has) {
  return [&editor, has = std::move(has)]() -> Reason {
    if (Reason reason = no_free_object(editor)) return reason;
    if (std::ranges::any_of(chosen_objects(editor), [&](const auto& object) { return has(*object); }))
      return {};
    return translatable("The active object does not have this property.");
  };
}

WhyNot needs_row(const Editor& editor, const PanelRow& row) {
  return [&editor, row]() -> Reason {
    if (Reason reason = row.of_object ? no_free_object(editor) : needs_document(editor)()) return reason;
    if (row.there(editor)) return {};
    return row.otherwise;
  };
}

Command property(std::string id, std::string menu, const char* label, const char* help,
                 std::function<void()> run, WhyNot why_not) {
  return {.id = "property." + std::move(id),
          .menu = std::move(menu),
          .label = label,
          .help = help,
          .needs_window = true,
          .run = std::move(run),
          .why_not = std::move(why_not),
          .in_menu = false};
}

constexpr const char* properties = translatable("Properties");

std::string menu_of(const std::string& kind) {
  return kind.empty() ? properties : std::string(properties) + "/" + kind;
}

constexpr const char* in_preferences = translatable("A choice for the program, in the preferences.");

/// Choices of the first rows of skins, made without a look for their list.
void add_skin_choices(CommandHost& host) {
  Editor& editor = host.editor;
  for (const SkinChoice& choice : skin_choices()) {
    Command command = property(
        choice.id, menu_of(translatable("Skin")) + "/" + choice.list, choice.label, choice.help,
        [&editor, choose = choice.choose] { choose(editor, *shown_skin(editor)); },
        only_if(
            needs(editor, skin_properties().part.of), [&editor] { return shown_skin(editor) != nullptr; },
            translatable("No skin is active. Click one in the list of objects.")));
    command.changes_document = true;
    command.needs_window = false;
    host.table.add(std::move(command));
  }
}

}  // namespace

void add_property_commands(CommandHost& host, Workbench& workbench) {
  const auto add = [&](const char* id, const char* label, const char* help, const char* kind, Has has) {
    host.table.add(property(
        id, menu_of(kind), label, help, [&workbench, id] { workbench.show_property(id); },
        needs(host.editor, std::move(has))));
  };
  for (const PanelRow& row : panel_rows())
    host.table.add(property(
        row.id, menu_of(row.kind), row.label, row.help,
        [&workbench, id = row.id] { workbench.show_property(id); }, needs_row(host.editor, row)));
  visit_properties([&](const char* kind, const auto& known) {
    for (const auto& each : known.all)
      add(each.row.id, each.row.label, each.row.help, kind, [of = known.part.of, each](const Object& object) {
        const auto* value = of(object);
        return value && each.held_by(*value);
      });
  });
  add_skin_choices(host);
  for (const PreferenceRow& row : preference_rows())
    host.table.add(property(std::string("preferences.") + row.member, translatable("Preferences"), row.label,
                            *row.note ? row.note : in_preferences,
                            [&workbench, page = row.page] { workbench.show_preferences(page); }, {}));
  use_properties_in_scripts(host);
}

}  // namespace hariko
