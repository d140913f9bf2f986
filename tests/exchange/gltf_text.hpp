#pragma once

// glTF files as other programs write them: layouts of buffers that our writer does not use.

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/exchange/mesh_text.hpp"

namespace hariko::test {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? alphabet[(word >> (18 - 6 * k)) & 63U] : '=';
  }
  return out;
}

/// Puts numbers, little-endian.
inline void put(std::string& out, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out += static_cast<char>((value >> (8 * i)) & 0xffU);
}

inline std::string glb(std::string json, const std::string& binary) {
  while (json.size() % 4 != 0) json += ' ';
  std::string out = "glTF";
  put(out, 2, 4);
  put(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()), 4);
  put(out, static_cast<std::uint32_t>(json.size()), 4);
  put(out, 0x4E4F534A, 4);
  out += json;
  put(out, static_cast<std::uint32_t>(binary.size()), 4);
  put(out, 0x004E4942, 4);
  return out + binary;
}

/// One mesh in a layout. `nodes` is the text of the list of nodes; mesh 0 is the only one.
struct GltfLayout {
  std::vector<Vector3> positions;  ///< rounded to floats, or in units of 1 / 32767 where they are quantized
  std::vector<Index> corners;      ///< none: the positions in their order
  int index_component = 5125;      ///< 5121, 5123, 5125
  bool quantized = false;          ///< 16-bit whole numbers for -1 .. 1
  std::size_t lead = 0, gap = 0;   ///< bytes before the first position and after each one
  int mode = 4;
  std::string nodes = R"([{"mesh": 0, "name": "part"}])";
  std::string scene = R"("scene": 0, "scenes": [{"nodes": [0]}],)";
  std::string extra;  ///< more members of the whole, each with a comma behind it

  std::string binary() const {
    std::string out(lead, '\x7f');
    for (const Vector3& p : positions) {
      for (int axis = 0; axis < 3; ++axis) {
        if (quantized)
          put(out, static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(p[axis] * 32767))), 2);
        else
          put(out, std::bit_cast<std::uint32_t>(static_cast<float>(p[axis])), 4);
      }
      out += std::string(gap, '\x7f');
    }
    for (const Index corner : corners) put(out, corner, index_size());
    return out;
  }
  std::string json(const std::string& uri) const {
    const auto text = [](std::size_t value) { return std::to_string(value); };
    const std::size_t row = quantized ? 6 : 12, points = positions.size() * (row + gap);
    const std::string stride = gap > 0 ? ", \"byteStride\": " + text(row + gap) : "";
    std::string out = R"({"asset": {"version": "2.0"}, )" + extra + scene + R"("nodes": )" + nodes +
                      R"(, "meshes": [{"name": "mesh", "primitives": [{"attributes": {"POSITION": 0})" +
                      (corners.empty() ? "" : R"(, "indices": 1)") +
                      (mode == 4 ? "" : ", \"mode\": " + std::to_string(mode)) + "}]}], \"accessors\": [" +
                      R"({"bufferView": 0, "type": "VEC3", "count": )" + text(positions.size()) +
                      R"(, "componentType": )" + (quantized ? "5122, \"normalized\": true" : "5126") +
                      R"(, "byteOffset": )" + text(lead) + "}";
    if (!corners.empty())
      out += R"(, {"bufferView": 1, "type": "SCALAR", "count": )" + text(corners.size()) +
             R"(, "componentType": )" + std::to_string(index_component) + "}";
    out += R"(], "bufferViews": [{"buffer": 0, "byteLength": )" + text(lead + points) + stride + "}";
    if (!corners.empty())
      out += R"(, {"buffer": 0, "byteOffset": )" + text(lead + points) + R"(, "byteLength": )" +
             text(corners.size() * index_size()) + "}";
    out += R"(], "buffers": [{"byteLength": )" + text(binary().size());
    if (!uri.empty()) out += ", \"uri\": \"" + uri + "\"";
    return out + "}]}";
  }
  std::string text() const { return json("data:application/octet-stream;base64," + base64(binary())); }
  std::string binary_file() const { return glb(json(""), binary()); }
  std::size_t index_size() const { return index_component == 5121 ? 1 : index_component == 5123 ? 2 : 4; }
};

/// A tetrahedron with its outside outside, a corner at the origin and volume 1/6.
inline GltfLayout gltf_tetrahedron() {
  GltfLayout out;
  out.positions = {Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  out.corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return out;
}

/// Triangles over the polygons, with a normal a facet; positions are relative to `origin`.
inline TriangleMesh faceted(const PolygonMesh& polygons, const Vector3& origin) {
  TriangleMesh mesh;
  mesh.origin = origin;
  mesh.positions = polygons.positions;
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    const auto face = polygons.face(f);
    const Vector3 a = mesh.positions[face[0]], b = mesh.positions[face[1]], c = mesh.positions[face[2]];
    mesh.normals.push_back((b - a).cross(c - a).normalized());
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      mesh.triangles.push_back({face[0], face[k], face[k + 1]});
      mesh.normal_triangles.push_back({Index(f), Index(f), Index(f)});
    }
  }
  return mesh;
}

/// By the divergence theorem; positive where faces look outward.
inline double volume_of(const PolygonMesh& mesh) {
  double volume = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      volume += mesh.positions[face[0]].dot(mesh.positions[face[k]].cross(mesh.positions[face[k + 1]])) / 6;
  }
  return volume;
}

}  // namespace hariko::test
