#include "app/scripts/edit_guesses.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/scripts/circumstances.hpp"

namespace hariko {

namespace {

/// An object before and after the edit.
using ObjectPair = std::pair<const Object*, const Object*>;

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
      const auto same =
          std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == value; });
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

/// Sets tensions that differ, all elements with the same one at once.
template <class Id, class Values>
void add_tension_steps(const Object& object, const Values& old, const Values& now, double neutral,
                       const char* select, const char* argument, std::vector<WrittenCommand>& out) {
  std::set<Id> ids;
  for (const auto& [id, value] : old) ids.insert(id);
  for (const auto& [id, value] : now) ids.insert(id);
  std::map<double, std::vector<std::string>> by_value;
  for (const Id id : ids)
    if (const double value = now.get_or(id, neutral); value != old.get_or(id, neutral))
      by_value[value].push_back(script_name(id));
  for (const auto& [value, names] : by_value) {
    out.push_back({select, {written("object", object.name), written("ids", names)}});
    out.push_back({"shape.tension", {written(argument, value)}});
  }
}

std::vector<WrittenCommand> tension_steps(const std::vector<ObjectPair>& objects) {
  std::vector<WrittenCommand> out;
  for (const auto& [old, now] : objects) {
    if (!old->polyhedron() || !now->polyhedron()) continue;
    const Shaping &before = *old->polyhedron()->shaping, &after = *now->polyhedron()->shaping;
    add_tension_steps<VertexId>(*now, before.alpha, after.alpha, 0, "select.vertices", "alpha", out);
    add_tension_steps<EdgeId>(*now, before.beta, after.beta, 1, "select.edges", "beta", out);
  }
  return out;
}

/// Moves the vertices that lie elsewhere; nothing where they do not all go the same way, of one object.
std::vector<WrittenCommand> move_steps(const std::vector<ObjectPair>& objects) {
  if (objects.size() != 1) return {};
  const auto& [old, now] = objects.front();
  const PolyhedronSource *before = old->polyhedron(), *after = now->polyhedron();
  if (!before || !after || before->polyhedron.vertex_count() != after->polyhedron.vertex_count()) return {};
  std::vector<std::string> ids;
  std::optional<Vector3> by;
  for (Index v = 0; v < before->polyhedron.vertex_count(); ++v) {
    const Vector3 from = before->origin + before->polyhedron.position(v),
                  to = after->origin + after->polyhedron.position(v);
    if (before->polyhedron.vertex_id(v) != after->polyhedron.vertex_id(v)) return {};
    if (from == to) continue;
    constexpr double same = 1e-9;
    const Vector3 way = now->transform.apply_to_vector(to - from);
    if (by && (way - *by).norm() > same * by->norm()) return {};
    if (!by) by = way;
    ids.push_back(script_name(before->polyhedron.vertex_id(v)));
  }
  if (!by) return {};
  return {{"select.vertices", {written("object", now->name), written("ids", ids)}},
          {"transform.move", {written("by", *by)}}};
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
