#include "app/scripts/edit_guesses.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "app/scripts/polyhedron_guesses.hpp"

namespace hariko {

namespace {

std::vector<ObjectPair> changed_objects(const Document& before, const Document& after) {
  std::vector<ObjectPair> out;
  for (const auto& object : after.objects) {
    const Object* old = before.find(object->id);
    if (old && old != object.get() && !(*old == *object)) out.emplace_back(old, object.get());
  }
  return out;
}

WrittenCommand choosing(const std::vector<std::string>& names) {
  return {"select.objects", {written("names", names)}};
}

/// Sets each property to what it is afterwards: objects with the same value at once.
std::vector<WrittenCommand> property_steps(const std::vector<ObjectPair>& objects,
                                           const CommandTable& table) {
  std::vector<WrittenCommand> out;
  for (const Command& command : table.all()) {
    if (!command.script.read) continue;
    std::vector<std::pair<std::vector<WrittenArgument>, std::vector<std::string>>> groups;
    for (const auto& [old, now] : objects) {
      const auto value = command.script.read(*now);
      if (value.empty() || value == command.script.read(*old)) continue;
      const auto same = std::ranges::find_if(groups, [&](const auto& group) { return group.first == value; });
      if (same != groups.end())
        same->second.push_back(old->name);
      else
        groups.push_back({value, {old->name}});
    }
    for (const auto& [value, names] : groups) {
      out.push_back(choosing(names));
      out.push_back({command.id, value});
    }
  }
  return out;
}

std::vector<WrittenCommand> visibility_steps(const std::vector<ObjectPair>& objects) {
  std::vector<std::string> hidden, shown;
  for (const auto& [old, now] : objects)
    if (old->visible_itself() != now->visible_itself())
      (now->visible_itself() ? shown : hidden).push_back(now->name);
  std::vector<WrittenCommand> out;
  if (!shown.empty()) out.push_back({"object.show_all", {written("names", shown)}});
  if (hidden.empty()) return out;
  out.push_back(choosing(hidden));
  out.push_back({"object.hide"});
  return out;
}

}  // namespace

std::vector<std::vector<WrittenCommand>> edit_guesses(const Document& before, const Document& after,
                                                      const CommandTable& table) {
  const auto objects = changed_objects(before, after);
  std::vector<std::vector<WrittenCommand>> out;
  for (const auto& guess : {property_steps(objects, table), visibility_steps(objects), tension_steps(objects),
                            move_steps(objects)})
    if (!guess.empty()) out.push_back(guess);
  return out;
}

}  // namespace hariko
