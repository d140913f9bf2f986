#include "app/files/control_mesh_file.hpp"

#include <deque>

#include "core/base/files/file_io.hpp"
#include "core/exchange/obj/write_control_mesh.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/local_skin.hpp"

namespace hariko {

Result<Done> export_control_meshes(const Document& document, const std::filesystem::path& path) {
  std::deque<ControlMesh> meshes;
  std::vector<NamedControlMesh> named;
  for (const auto& object : document.objects) {
    if (!object->visible || !object->skin()) continue;
    const LocalSkin local = local_skin(*object->skin()->skin);
    auto made = evaluate_skin(local.skin);
    if (!made) {
      Message error = made.error();
      error.text = object->name + ": " + error.text;
      return error;
    }
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 0; k < places.size(); ++k) {
      meshes.push_back(made->mesh.control);
      for (Vector3& p : meshes.back().mesh.positions) p = places[k].apply(local.origin + p);
      named.push_back({name_of_place(*object, k), &meshes.back()});
    }
  }
  if (named.empty())
    return make_error(e_no_skin, "There is no visible skin whose control mesh could be written.",
                      "Show a skin, or draw one.");
  return write_file_atomic(path, write_control_obj(named));
}

}  // namespace hariko
