#include "core/exchange/obj/write_control_mesh.hpp"

#include "core/exchange/mesh_name.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

/// Appends a tag, with vertices counted from 0, unlike in faces.
void append_tag(std::string& out, std::string_view tag, std::initializer_list<std::size_t> vertices,
                double sharpness) {
  out += tag;
  for (const std::size_t v : vertices) {
    out += ' ';
    append_integer(out, v);
  }
  out += ' ';
  append_real(out, sharpness);
  out += '\n';
}

}  // namespace

std::string write_control_obj(std::span<const NamedControlMesh> meshes) {
  std::string out;
  std::size_t first = 0;
  for (const auto& [name, control] : meshes) {
    const PolygonMesh& mesh = control->mesh;
    out += "o " + name_for_file(name) + '\n';
    for (const Vector3& p : mesh.positions) {
      out += 'v';
      for (int axis = 0; axis < 3; ++axis) {
        out += ' ';
        append_real(out, p[axis]);
      }
      out += '\n';
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      out += 'f';
      for (const Index v : mesh.face(f)) {
        out += ' ';
        append_integer(out, first + v + 1);
      }
      out += '\n';
    }
    for (const ControlMesh::Crease& crease : control->creases)
      append_tag(out, "t crease 2/1/0", {first + crease.a, first + crease.b}, crease.sharpness);
    for (const ControlMesh::Corner& corner : control->corners)
      append_tag(out, "t corner 1/1/0", {first + corner.vertex}, corner.sharpness);
    first += mesh.positions.size();
  }
  return out;
}

}  // namespace hariko
