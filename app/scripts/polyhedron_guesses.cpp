#include "app/scripts/polyhedron_guesses.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

#include "app/scripts/circumstances.hpp"

namespace hariko {

namespace {

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

}  // namespace

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

}  // namespace hariko
