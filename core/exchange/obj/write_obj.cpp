#include "core/exchange/mesh_name.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {
namespace {

void append_position(std::string& out, const Vector3& p) {
  out += 'v';
  for (int axis = 0; axis < 3; ++axis) {
    out += ' ';
    append_real(out, p[axis]);
  }
  out += '\n';
}

void append_normal(std::string& out, const Vector3& n) {
  out += "vn";
  for (int axis = 0; axis < 3; ++axis) {
    out += ' ';
    append_real(out, static_cast<float>(n[axis]));
  }
  out += '\n';
}

}  // namespace

std::string write_obj(std::span<const NamedTriangles> meshes) {
  std::string out;
  std::size_t first_vertex = 1, first_normal = 1;  // OBJ counts from 1, over all objects
  for (const NamedTriangles& named : meshes) {
    const TriangleMesh* mesh = named.mesh;
    const bool has_normals = !mesh->normal_triangles.empty();
    out += "o " + name_for_file(named.name) + '\n';
    for (const Vector3& p : mesh->positions) append_position(out, mesh->origin + p);
    if (has_normals)
      for (const Vector3& n : mesh->normals) append_normal(out, n);
    for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
      out += 'f';
      for (std::size_t corner = 0; corner < 3; ++corner) {
        out += ' ';
        append_integer(out, first_vertex + mesh->triangles[t][corner]);
        if (!has_normals) continue;
        out += "//";
        append_integer(out, first_normal + mesh->normal_triangles[t][corner]);
      }
      out += '\n';
    }
    first_vertex += mesh->positions.size();
    if (has_normals) first_normal += mesh->normals.size();
  }
  return out;
}

std::string write_obj(std::span<const NamedPolygons> meshes) {
  std::string out;
  std::size_t first_vertex = 1;
  for (const NamedPolygons& named : meshes) {
    const PolygonMesh* mesh = named.mesh;
    out += "o " + name_for_file(named.name) + '\n';
    for (const Vector3& p : mesh->positions) append_position(out, p);
    for (std::size_t f = 0; f < mesh->face_count(); ++f) {
      out += 'f';
      for (const Index v : mesh->face(f)) {
        out += ' ';
        append_integer(out, first_vertex + v);
      }
      out += '\n';
    }
    first_vertex += mesh->positions.size();
  }
  return out;
}

}  // namespace hariko
