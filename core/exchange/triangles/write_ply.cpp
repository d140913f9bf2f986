#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/exchange/mesh_name.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/single_normals.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {
namespace {

/// Content of the file: vertices with at most one normal each, and polygons.
struct PlyContent {
  std::vector<Vector3> positions;
  std::vector<Vector3> normals;  ///< one for each position, or none at all
  std::vector<std::size_t> face_offsets{0};
  std::vector<Index> face_vertices;
};

void add(PlyContent& content, const Vector3& origin, const VertexTriangles& mesh) {
  const std::size_t base = content.positions.size();
  for (const Vector3& p : mesh.positions) content.positions.push_back(origin + p);
  content.normals.insert(content.normals.end(), mesh.normals.begin(), mesh.normals.end());
  for (const auto& triangle : mesh.triangles) {
    for (const Index v : triangle) content.face_vertices.push_back(static_cast<Index>(base + v));
    content.face_offsets.push_back(content.face_vertices.size());
  }
}

template <class Unsigned>
void append_bytes(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out += static_cast<char>((value >> (8 * i)) & 0xffU);
}

template <class Mesh>
std::string header_of(const PlyContent& content, std::span<const Mesh> meshes, MeshEncoding encoding,
                      bool long_lists) {
  std::string out = "ply\nformat ";
  out += encoding == MeshEncoding::ascii ? "ascii 1.0\n" : "binary_little_endian 1.0\n";
  for (const auto& mesh : meshes) out += "comment object " + name_for_file(mesh.name) + '\n';
  out += "element vertex " + std::to_string(content.positions.size()) + '\n';
  for (const char* axis : {"x", "y", "z"}) out += std::string("property double ") + axis + '\n';
  if (!content.normals.empty())
    for (const char* axis : {"nx", "ny", "nz"}) out += std::string("property float ") + axis + '\n';
  out += "element face " + std::to_string(content.face_offsets.size() - 1) + '\n';
  out += long_lists ? "property list int int vertex_indices\n" : "property list uchar int vertex_indices\n";
  return out + "end_header\n";
}

void append_ascii(std::string& out, const PlyContent& content) {
  for (std::size_t v = 0; v < content.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) out += ' ';
      append_real(out, content.positions[v][axis]);
    }
    for (int axis = 0; axis < 3 && !content.normals.empty(); ++axis) {
      out += ' ';
      append_real(out, static_cast<float>(content.normals[v][axis]));
    }
    out += '\n';
  }
  for (std::size_t f = 0; f + 1 < content.face_offsets.size(); ++f) {
    append_integer(out, content.face_offsets[f + 1] - content.face_offsets[f]);
    for (std::size_t c = content.face_offsets[f]; c < content.face_offsets[f + 1]; ++c) {
      out += ' ';
      append_integer(out, content.face_vertices[c]);
    }
    out += '\n';
  }
}

void append_binary(std::string& out, const PlyContent& content, bool long_lists) {
  out.reserve(out.size() + content.positions.size() * (content.normals.empty() ? 24 : 36) +
              content.face_vertices.size() * 4 + content.face_offsets.size() * 4);
  for (std::size_t v = 0; v < content.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      append_bytes(out, std::bit_cast<std::uint64_t>(content.positions[v][axis]));
    for (int axis = 0; axis < 3 && !content.normals.empty(); ++axis)
      append_bytes(out, std::bit_cast<std::uint32_t>(static_cast<float>(content.normals[v][axis])));
  }
  for (std::size_t f = 0; f + 1 < content.face_offsets.size(); ++f) {
    const auto sides = static_cast<std::uint32_t>(content.face_offsets[f + 1] - content.face_offsets[f]);
    if (long_lists)
      append_bytes(out, sides);
    else
      append_bytes(out, static_cast<std::uint8_t>(sides));
    for (std::size_t c = content.face_offsets[f]; c < content.face_offsets[f + 1]; ++c)
      append_bytes(out, content.face_vertices[c]);
  }
}

template <class Mesh>
std::string to_bytes(const PlyContent& content, std::span<const Mesh> meshes, MeshEncoding encoding) {
  bool long_lists = false;  // the usual list type counts only to 255
  for (std::size_t f = 0; f + 1 < content.face_offsets.size(); ++f)
    long_lists = long_lists || content.face_offsets[f + 1] - content.face_offsets[f] > 255;
  std::string out = header_of(content, meshes, encoding, long_lists);
  if (encoding == MeshEncoding::ascii)
    append_ascii(out, content);
  else
    append_binary(out, content, long_lists);
  return out;
}

}  // namespace

std::string write_ply(std::span<const NamedTriangles> meshes, MeshEncoding encoding) {
  const bool with_normals = std::all_of(meshes.begin(), meshes.end(), [](const NamedTriangles& named) {
    return !named.mesh->normal_triangles.empty();
  });
  PlyContent content;
  for (const NamedTriangles& named : meshes) {
    add(content, named.mesh->origin,
        with_normals ? with_single_normals(*named.mesh)
                     : VertexTriangles{named.mesh->positions, {}, named.mesh->triangles});
  }
  return to_bytes(content, meshes, encoding);
}

std::string write_ply(std::span<const NamedPolygons> meshes, MeshEncoding encoding) {
  PlyContent content;
  for (const NamedPolygons& named : meshes) {
    const std::size_t base = content.positions.size();
    content.positions.insert(content.positions.end(), named.mesh->positions.begin(),
                             named.mesh->positions.end());
    for (std::size_t f = 0; f < named.mesh->face_count(); ++f) {
      for (const Index v : named.mesh->face(f)) content.face_vertices.push_back(static_cast<Index>(base + v));
      content.face_offsets.push_back(content.face_vertices.size());
    }
  }
  return to_bytes(content, meshes, encoding);
}

}  // namespace hariko
