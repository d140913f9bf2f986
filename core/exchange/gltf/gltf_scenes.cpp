#include "core/exchange/gltf/gltf_scenes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace hariko {

using Json = nlohmann::json;

namespace {

/// Appends the numbers of a list that are nodes of the file; ignores everything else.
void append_nodes(const Json& root, const Json& owner, const char* name, std::vector<std::uint64_t>& out) {
  const Json* list = find(owner, name);
  if (!list || !list->is_array()) return;
  for (const Json& number : *list)
    if (number.is_number_unsigned() && number.get<std::uint64_t>() < size_of(root, "nodes"))
      out.push_back(number.get<std::uint64_t>());
}

/// Whether a scene's list of nodes is sound or missing.
bool has_sound_list(const Json& root, std::size_t scene) {
  const Json& owner = root["scenes"][scene];
  const Json* list = find(owner, "nodes");
  if (!list) return owner.is_object();
  std::vector<std::uint64_t> nodes;
  append_nodes(root, owner, "nodes", nodes);
  return list->is_array() && nodes.size() == list->size();
}

/// Adds the nodes of a scene with all that are below them; whether a node with a mesh is among those that are
/// new.
bool reach_nodes(const Json& root, std::size_t scene, std::set<std::uint64_t>& reached) {
  std::vector<std::uint64_t> waiting;
  append_nodes(root, root["scenes"][scene], "nodes", waiting);
  bool objects = false;
  while (!waiting.empty()) {
    const std::uint64_t number = waiting.back();
    waiting.pop_back();
    if (!reached.insert(number).second) continue;
    objects = objects || find(root["nodes"][number], "mesh") != nullptr;
    append_nodes(root, root["nodes"][number], "children", waiting);
  }
  return objects;
}

}  // namespace

GltfScene gltf_scene(const Json& root, GltfFields& fields) {
  const std::size_t count = size_of(root, "scenes");
  if (count == 0) return {};
  const std::uint64_t named = fields.whole(root, "scene", "The description").value_or(0);
  if (named >= count || !has_sound_list(root, named)) return {named, false};  // `gltf_roots` notes the error
  // Nodes that were reached in vain are not looked at again.
  std::set<std::uint64_t> reached;
  if (reach_nodes(root, named, reached)) return {named, false};
  for (std::size_t scene = 0; scene < count; ++scene)
    if (reach_nodes(root, scene, reached)) return {scene, true};
  const Json* nodes = find(root, "nodes");
  const auto has_mesh = [](const Json& node) { return find(node, "mesh") != nullptr; };
  const bool any = nodes && nodes->is_array() && std::any_of(nodes->begin(), nodes->end(), has_mesh);
  return any ? GltfScene{std::nullopt, true} : GltfScene{named, false};
}

std::vector<std::uint64_t> gltf_roots(const Json& root, const GltfScene& scene, GltfFields& fields) {
  if (scene.number) {
    const Json* found = fields.entry(root, "scenes", *scene.number);
    return found ? fields.wholes(*found, "nodes", numbered("scenes", *scene.number))
                 : std::vector<std::uint64_t>();
  }
  std::set<std::uint64_t> children;
  const std::size_t count = size_of(root, "nodes");
  for (std::size_t n = 0; n < count; ++n)
    for (const std::uint64_t child : fields.wholes(root["nodes"][n], "children", numbered("nodes", n)))
      children.insert(child);
  std::vector<std::uint64_t> out;
  for (std::size_t n = 0; n < count; ++n)
    if (!children.contains(n)) out.push_back(n);
  return out;
}

GltfLeftOut objects_left_out(const Json& root, const GltfScene& scene) {
  GltfLeftOut out;
  if (!scene.number) return out;
  std::set<std::uint64_t> shown, others;
  for (std::size_t number = 0; number < size_of(root, "scenes"); ++number)
    reach_nodes(root, number, number == *scene.number ? shown : others);
  for (std::size_t number = 0; number < size_of(root, "nodes"); ++number) {
    if (shown.contains(number) || !find(root["nodes"][number], "mesh")) continue;
    ++(others.contains(number) ? out.in_others : out.in_none);
  }
  return out;
}

}  // namespace hariko
