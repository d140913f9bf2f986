#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/text/base64.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/exchange/coordinate_system.hpp"
#include "core/exchange/gltf/gltf_container.hpp"
#include "core/exchange/repair/single_normals.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/exchange/write_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {
namespace {

// Constants of the glTF 2.0 specification.
constexpr std::uint32_t magic_number = 0x46546C67, version = 2;
constexpr int float_component = 5126, index_component = 5125;
constexpr int vertex_buffer = 34962, index_buffer = 34963;

void append_word(std::string& out, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>((word >> (8 * i)) & 0xffU);
}

/// Linear value of an sRGB channel; the format stores linear colours, documents sRGB.
double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Range of the binary chunk: buffer view and accessor of the file, with the same number.
struct Accessor {
  std::size_t begin = 0, size = 0;  ///< bytes
  std::size_t count = 0;            ///< elements
  int component = 0, target = 0;
  const char* type = "";
  std::optional<std::array<Vector3, 2>> bounds;
};

/// Node, with its mesh and material of the same number.
struct Part {
  std::string name;
  Vector3 place;
  std::array<double, 3> colour{};  ///< linear
  std::size_t positions = 0, indices = 0;
  std::optional<std::size_t> normals;
};

void write_mesh(JsonWriter& json, const Part& part, std::size_t material) {
  json.object([&] {
    json.member("name", part.name);
    json.array("primitives", [&] {
      json.object([&] {
        json.object("attributes", [&] {
          json.member("POSITION", part.positions);
          if (part.normals) json.member("NORMAL", *part.normals);
        });
        json.member("indices", part.indices);
        json.member("material", material);
      });
    });
  });
}

void write_material(JsonWriter& json, const Part& part) {
  json.object([&] {
    json.object("pbrMetallicRoughness", [&] {
      json.member("baseColorFactor", {part.colour[0], part.colour[1], part.colour[2], 1.0});
      json.member("metallicFactor", 0.0);
      json.member("roughnessFactor", 0.6);
    });
    json.member("doubleSided", true);
  });
}

void write_accessor(JsonWriter& json, const Accessor& accessor, std::size_t view) {
  json.object([&] {
    json.member("bufferView", view);
    json.member("componentType", accessor.component);
    json.member("count", accessor.count);
    json.member("type", accessor.type);
    if (!accessor.bounds) return;
    json.member("min", (*accessor.bounds)[0]);
    json.member("max", (*accessor.bounds)[1]);
  });
}

void write_view(JsonWriter& json, const Accessor& accessor) {
  json.object([&] {
    json.member("buffer", 0);
    json.member("byteOffset", accessor.begin);
    json.member("byteLength", accessor.size);
    json.member("target", accessor.target);
  });
}

class GltfWriter {
 public:
  explicit GltfWriter(double metres_per_unit) : space_{metres_per_unit, UpAxis::y} {}

  Result<Done> add(const std::string& name, const std::array<std::uint8_t, 3>& colour, const Vector3& origin,
                   const VertexTriangles& mesh) {
    if (mesh.triangles.empty()) return Done{};
    const auto positions = add_vectors(mesh.positions, space_.factor, true);
    if (!positions) return positions.error();
    Part part;
    part.name = name;
    // Floats are precise enough relative to the object's own origin, which is a double.
    part.place = space_.placed(origin);
    if (!part.place.allFinite()) return too_large();
    part.colour = {linear(colour[0]), linear(colour[1]), linear(colour[2])};
    part.positions = *positions;
    if (!mesh.normals.empty()) part.normals = *add_vectors(mesh.normals, 1, false);
    part.indices = add_indices(mesh.triangles);
    parts_.push_back(std::move(part));
    return Done{};
  }

  Result<std::string> take(GltfForm form) {
    if (form == GltfForm::text)
      return root_text(1, "data:application/octet-stream;base64," + to_base64(binary_)) + '\n';
    std::string text = root_text(-1, {});
    while (text.size() % 4 != 0) text += ' ';
    const std::size_t binary = parts_.empty() ? 0 : glb_chunk_header_size + binary_.size();
    const std::size_t total = glb_header_size + glb_chunk_header_size + text.size() + binary;
    if (total > 0xffffffffU)
      return make_error(e_limit, "A glTF file has at most 4 GB.", "Choose a larger tolerance.");
    std::string out;
    out.reserve(total);
    for (const std::uint32_t word :
         {magic_number, version, std::uint32_t(total), std::uint32_t(text.size()), json_chunk})
      append_word(out, word);
    out += text;
    if (parts_.empty()) return out;
    append_word(out, std::uint32_t(binary_.size()));
    append_word(out, binary_chunk);
    return out + binary_;
  }

 private:
  /// JSON text of the file. `uri`: of the buffer; empty for the file's own binary chunk.
  std::string root_text(int indent, const std::string& uri) const {
    JsonWriter json(indent);
    json.object([&] {
      json.object("asset", [&] {
        json.member("version", "2.0");
        json.member("generator", "Hariko");
      });
      json.member("scene", 0);
      json.array("scenes", [&] {
        json.object([&] {
          if (parts_.empty()) return;
          json.array("nodes", [&] {
            for (std::size_t i = 0; i < parts_.size(); ++i) json.value(i);
          });
        });
      });
      if (!parts_.empty()) write_parts(json, uri);
    });
    return json.take();
  }
  void write_parts(JsonWriter& json, const std::string& uri) const {
    const auto each = [&](const char* name, const auto& entries, const auto& write) {
      json.array(name, [&] {
        for (std::size_t i = 0; i < entries.size(); ++i) write(entries[i], i);
      });
    };
    each("nodes", parts_, [&](const Part& part, std::size_t i) {
      json.object([&] {
        json.member("name", part.name);
        json.member("mesh", i);
        json.member("translation", part.place);
      });
    });
    each("meshes", parts_, [&](const Part& part, std::size_t i) { write_mesh(json, part, i); });
    each("materials", parts_, [&](const Part& part, std::size_t) { write_material(json, part); });
    each("accessors", accessors_,
         [&](const Accessor& accessor, std::size_t i) { write_accessor(json, accessor, i); });
    each("bufferViews", accessors_,
         [&](const Accessor& accessor, std::size_t) { write_view(json, accessor); });
    json.array("buffers", [&] {
      json.object([&] {
        json.member("byteLength", binary_.size());
        if (!uri.empty()) json.member("uri", uri);
      });
    });
  }

  static Message too_large() {
    return make_error(e_limit, "The mesh is too large for the numbers of a glTF file.",
                      "Scale it down, or export it as OBJ.");
  }

  /// Adds an accessor for the range of the binary chunk from `begin` to its end.
  std::size_t add_accessor(std::size_t begin, std::size_t count, int component, const char* type,
                           int target) {
    accessors_.push_back({begin, binary_.size() - begin, count, component, target, type, {}});
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
    if (bounded) accessors_[accessor].bounds = {{low.cast<double>(), high.cast<double>()}};
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
  std::vector<Part> parts_;
  std::vector<Accessor> accessors_;
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
