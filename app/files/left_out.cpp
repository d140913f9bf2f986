#include "app/files/left_out.hpp"

#include "core/document/object_shape.hpp"

#include <string>

namespace hariko {

namespace {

bool lacks_control_mesh(const Object& object) {
  return has_shape(object) && !has_control_mesh(object);
}

using Test = bool (*)(const Object&);

/// Number of visible objects that pass a test, and the names of the first.
struct Named {
  std::size_t count = 0;
  std::string names;
};
Named visible(const Document& document, Test test) {
  constexpr std::size_t most_names = 3;
  Named out;
  for (const auto& object : document.objects) {
    if (!object->visible || !test(*object)) continue;
    ++out.count;
    if (out.count <= most_names) out.names += (out.count > 1 ? ", \"" : "\"") + object->name + "\"";
    if (out.count == most_names + 1) out.names += ", ...";
  }
  return out;
}

}  // namespace

std::vector<Message> left_out_of_triangles(const Document& document) {
  const Named left = visible(document, is_unknown);
  if (left.count == 0) return {};
  return {make_warning(w_not_written,
                       "Objects left out: " + std::to_string(left.count) + " (" + left.names +
                           "). This version does not know their kinds.",
                       "Open the document with a newer version.")};
}

std::vector<Message> left_out_of_cad(const Document& document) {
  std::vector<Message> out = left_out_of_triangles(document);
  if (const Named left = visible(document, is_faceted); left.count > 0)
    out.push_back(
        make_warning(w_not_written,
                     "Objects left out: " + std::to_string(left.count) + " (" + left.names +
                         "). STEP and IGES hold smooth faces and no reference facets.",
                     "Write STL, OBJ, PLY, 3MF or glTF, which hold facets and surfaces in one file."));
  return out;
}

std::vector<Message> left_out_of_control_meshes(const Document& document) {
  std::vector<Message> out = left_out_of_triangles(document);
  if (const Named left = visible(document, lacks_control_mesh); left.count > 0)
    out.push_back(make_warning(w_not_written,
                               "Objects left out: " + std::to_string(left.count) + " (" + left.names +
                                   "). Only skins have control meshes.",
                               "Write their surfaces to another file, without --control."));
  return out;
}

std::optional<Message> left_out_of_import(const Document& document) {
  if (!document.paper) return std::nullopt;
  return make_warning(w_not_imported, "The paper model of the file was not imported.",
                      "Open the file itself to go on with its paper model.");
}

std::size_t visible_reference_objects(const Document& document) {
  return visible(document, is_faceted).count;
}

}  // namespace hariko
