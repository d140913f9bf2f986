#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/exchange/file_space.hpp"
#include "core/exchange/gltf_container.hpp"
#include "core/exchange/single_normals.hpp"
#include "core/exchange/triangulate.hpp"
#include "core/exchange/write_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr int float_component = 5126, index_component = 5125;
constexpr int vertex_buffer = 34962, index_buffer = 34963;

void append_word(std::string& out, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>((word >> (8 * i)) & 0xffU);
}

/// The alphabet and padding of RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8) | (k < taken ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= taken ? alphabet[(word >> (18 - 6 * k)) & 63U] : '=';
  }
  return out;
}

/// The format stores colours by their light, documents as screens show them (sRGB).
double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

class GltfWriter {
 public:
  explicit GltfWriter(double metres_per_unit) : space_{metres_per_unit, UpAxis::y} {}

  Result<Done> add(const std::string& name, const std::array<std::uint8_t, 3>& colour, const Vector3& origin,
                   const VertexTriangles& mesh) {
    if (mesh.triangles.empty()) return Done{};
    Json primitive = {{"attributes", Json::object()}};
    const auto positions = add_vectors(mesh.positions, space_.factor, true);
    if (!positions) return positions.error();
    primitive["attributes"]["POSITION"] = *positions;
    if (!mesh.normals.empty()) primitive["attributes"]["NORMAL"] = *add_vectors(mesh.normals, 1, false);
    primitive["indices"] = add_indices(mesh.triangles);
    primitive["material"] = materials_.size();
    materials_.push_back(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1.0}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 0.6}}},
         {"doubleSided", true}});
    // Floats are fine enough beside the object's own origin, which is a double.
    const Vector3 place = space_.placed(origin);
    if (!place.allFinite()) return too_large();
    nodes_.push_back(
        {{"name", name}, {"mesh", meshes_.size()}, {"translation", {place.x(), place.y(), place.z()}}});
    meshes_.push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    return Done{};
  }

  Result<std::string> take(GltfForm form) {
    if (form == GltfForm::text) {
      Json root = root_object();
      if (!nodes_.empty())
        root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(binary_);
      return root.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
    }
    std::string text = root_object().dump(-1, ' ', false, Json::error_handler_t::replace);
    while (text.size() % 4 != 0) text += ' ';
    const std::size_t binary = nodes_.empty() ? 0 : glb_chunk_header_size + binary_.size();
    const std::size_t total = glb_header_size + glb_chunk_header_size + text.size() + binary;
    if (total > 0xffffffffU)
      return make_error(e_limit, "A glTF file has at most 4 GB.", "Choose a larger tolerance.");
    std::string out;
    out.reserve(total);
    for (const std::uint32_t word :
         {magic, version, std::uint32_t(total), std::uint32_t(text.size()), json_chunk})
      append_word(out, word);
    out += text;
    if (nodes_.empty()) return out;
    append_word(out, std::uint32_t(binary_.size()));
    append_word(out, binary_chunk);
    return out + binary_;
  }

 private:
  Json root_object() const {
    Json scene = Json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) scene.push_back(i);
    Json root = {{"asset", {{"version", "2.0"}, {"generator", "Hariko"}}}, {"scene", 0}};
    root["scenes"] = Json::array({Json{{"nodes", scene}}});
    if (!nodes_.empty()) {
      root["nodes"] = nodes_;
      root["meshes"] = meshes_;
      root["materials"] = materials_;
      root["accessors"] = accessors_;
      root["bufferViews"] = views_;
      root["buffers"] = Json::array({Json{{"byteLength", binary_.size()}}});
    } else {
      root["scenes"][0].erase("nodes");
    }
    return root;
  }

  static Message too_large() {
    return make_error(e_limit, "The mesh is too large for the numbers of a glTF file.",
                      "Scale it down, or export it as OBJ.");
  }

  /// Adds an accessor of a part of the binary chunk that begins at `begin`.
  std::size_t add_accessor(std::size_t begin, std::size_t count, int component, const char* type,
                           int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
  }

  Result<std::size_t> add_vectors(const std::vector<Vector3>& vectors, double scale, bool bounded) {
    const std::size_t begin = binary_.size();
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const Vector3& v : vectors) {
      const Eigen::Vector3f f = (scale * space_.turned(v)).cast<float>();
      if (!f.allFinite()) return too_large();
      low = low.cwiseMin(f);
      high = high.cwiseMax(f);
      for (int axis = 0; axis < 3; ++axis) append_word(binary_, std::bit_cast<std::uint32_t>(f[axis]));
    }
    const std::size_t accessor = add_accessor(begin, vectors.size(), float_component, "VEC3", vertex_buffer);
    if (bounded) {
      accessors_[accessor]["min"] = {low.x(), low.y(), low.z()};
      accessors_[accessor]["max"] = {high.x(), high.y(), high.z()};
    }
    return accessor;
  }

  std::size_t add_indices(const std::vector<std::array<Index, 3>>& triangles) {
    const std::size_t begin = binary_.size();
    for (const auto& triangle : triangles)
      for (const Index v : triangle) append_word(binary_, v);
    return add_accessor(begin, 3 * triangles.size(), index_component, "SCALAR", index_buffer);
  }

  FileSpace space_;
  std::string binary_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array();
  Json accessors_ = Json::array(), views_ = Json::array();
};

}  // namespace

Result<std::string> write_gltf(std::span<const NamedTriangles> meshes, double metres_per_unit,
                               GltfForm form) {
  GltfWriter writer(metres_per_unit);
  for (const NamedTriangles& named : meshes)
    if (const auto added =
            writer.add(named.name, named.colour, named.mesh->origin, with_single_normals(*named.mesh));
        !added)
      return added.error();
  return writer.take(form);
}

Result<std::string> write_gltf(std::span<const NamedPolygons> meshes, double metres_per_unit, GltfForm form) {
  GltfWriter writer(metres_per_unit);
  for (const NamedPolygons& named : meshes) {
    TriangleMesh mesh;
    mesh.origin = origin_for(named.mesh->positions);
    for (const Vector3& position : named.mesh->positions) mesh.positions.push_back(position - mesh.origin);
    mesh.triangles = triangulate(*named.mesh).triangles;
    if (const auto added = writer.add(named.name, named.colour, mesh.origin, with_single_normals(mesh));
        !added)
      return added.error();
  }
  return writer.take(form);
}

}  // namespace hariko
