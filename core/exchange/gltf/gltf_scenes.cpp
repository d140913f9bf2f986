#include "core/exchange/gltf/gltf_scenes.hpp"

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

/// Nodes of a scene with all that are below them.
void reach_nodes(const Json& root, std::size_t scene, std::set<std::uint64_t>& reached) {
  std::vector<std::uint64_t> waiting;
  append_nodes(root, root["scenes"][scene], "nodes", waiting);
  while (!waiting.empty()) {
    const std::uint64_t number = waiting.back();
    waiting.pop_back();
    if (reached.insert(number).second) append_nodes(root, root["nodes"][number], "children", waiting);
  }
}

}  // namespace

std::uint64_t gltf_default_scene(const Json& root, GltfFields& fields) {
  return fields.whole(root, "scene", "The description").value_or(0);
}

std::vector<std::uint64_t> gltf_roots(const Json& root, GltfFields& fields) {
  if (size_of(root, "scenes") > 0) {
    const std::uint64_t number = gltf_default_scene(root, fields);
    const Json* scene = fields.entry(root, "scenes", number);
    return scene ? fields.wholes(*scene, "nodes", numbered("scenes", number)) : std::vector<std::uint64_t>();
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

std::size_t objects_of_other_scenes(const Json& root, std::uint64_t default_scene) {
  std::set<std::uint64_t> shown, others;
  for (std::size_t scene = 0; scene < size_of(root, "scenes"); ++scene)
    reach_nodes(root, scene, scene == default_scene ? shown : others);
  std::size_t out = 0;
  for (const std::uint64_t number : others)
    if (!shown.contains(number) && find(root["nodes"][number], "mesh")) ++out;
  return out;
}

}  // namespace hariko
