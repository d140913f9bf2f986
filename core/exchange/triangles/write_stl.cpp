#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/exchange/mesh_name.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {
namespace {

constexpr std::size_t begin_size = 84, written_facet_size = 50;

/// Normal and three corners.
using Facet = std::array<Eigen::Vector3f, 4>;

void append_binary(std::string& out, const Facet& facet) {
  for (const Eigen::Vector3f& vector : facet)
    for (int axis = 0; axis < 3; ++axis) {
      const auto bits = std::bit_cast<std::uint32_t>(vector[axis]);
      for (int i = 0; i < 4; ++i) out += static_cast<char>((bits >> (8 * i)) & 0xffU);
    }
  out.append(2, '\0');
}

void append_ascii(std::string& out, const Facet& facet) {
  std::array<char, 400> text;  // 12 numbers of at most 15 characters, and 74 others
  char* end = text.data();
  const auto add_text = [&](std::string_view words) { end = std::copy(words.begin(), words.end(), end); };
  const auto add_vector = [&](const Eigen::Vector3f& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      *end++ = ' ';
      end = std::to_chars(end, text.data() + text.size(), vector[axis]).ptr;
    }
  };
  add_text("facet normal");
  add_vector(facet[0]);
  add_text("\nouter loop\n");
  for (std::size_t corner = 1; corner < facet.size(); ++corner) {
    add_text("vertex");
    add_vector(facet[corner]);
    add_text("\n");
  }
  add_text("endloop\nendfacet\n");
  out.append(text.data(), end);
}

class StlWriter {
 public:
  StlWriter(MeshEncoding encoding, std::size_t triangles) : ascii_(encoding == MeshEncoding::ascii) {
    constexpr std::size_t usual_ascii_size = 200;  // bytes of a triangle, about
    out_.reserve(begin_size + (ascii_ ? usual_ascii_size : written_facet_size) * triangles);
    if (ascii_) return;
    // Must not begin with "solid", by which readers tell text.
    out_ = "binary STL written by Hariko";
    out_.resize(begin_size, ' ');
  }

  void begin(const std::string& name) {
    if (ascii_) out_ += "solid " + (name_ = name_for_file(name)) + "\n";
  }
  void end() {
    if (ascii_) out_ += "endsolid " + name_ + "\n";
  }

  /// Adds a facet; corners are relative to `origin`, and the normal is computed from the relative ones.
  void add(const Vector3& origin, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 ab = b - a, ac = c - a;
    // Scaled first, so that neither tiny nor huge triangles overflow or underflow; a degenerate triangle has
    // the normal 0, as the format requires.
    const double scale = std::max(ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff());
    Vector3 normal = Vector3::Zero();
    if (scale > 0) normal = (ab / scale).cross(ac / scale).normalized();
    if (!normal.allFinite()) normal.setZero();
    const Facet facet{normal.cast<float>(), (origin + a).cast<float>(), (origin + b).cast<float>(),
                      (origin + c).cast<float>()};
    for (const Eigen::Vector3f& vector : facet) in_range_ = in_range_ && vector.allFinite();
    ascii_ ? append_ascii(out_, facet) : append_binary(out_, facet);
    ++count_;
  }

  Result<std::string> finish() {
    if (!in_range_)
      return make_error(e_limit, "Coordinates of the mesh are too large for an STL file.",
                        "Scale the model down, or export OBJ or PLY.");
    if (ascii_) return std::move(out_);
    if (count_ > std::numeric_limits<std::uint32_t>::max())
      return make_error(e_limit, "The mesh has more triangles than an STL file can hold.",
                        "Lower the density, or export PLY.");
    for (std::size_t i = 0; i < 4; ++i) out_[80 + i] = static_cast<char>((count_ >> (8 * i)) & 0xffU);
    return std::move(out_);
  }

 private:
  const bool ascii_;
  std::string out_, name_;
  std::uint64_t count_ = 0;
  bool in_range_ = true;
};

}  // namespace

Result<std::string> write_stl(std::span<const NamedTriangles> meshes, MeshEncoding encoding) {
  std::size_t count = 0;
  for (const NamedTriangles& named : meshes) count += named.mesh->triangles.size();
  StlWriter writer(encoding, count);
  for (const NamedTriangles& named : meshes) {
    writer.begin(named.name);
    const std::vector<Vector3>& p = named.mesh->positions;
    for (const auto& [a, b, c] : named.mesh->triangles) writer.add(named.mesh->origin, p[a], p[b], p[c]);
    writer.end();
  }
  return writer.finish();
}

Result<std::string> write_stl(std::span<const NamedPolygons> meshes, MeshEncoding encoding) {
  std::size_t count = 0;
  for (const NamedPolygons& named : meshes)
    if (named.mesh->face_vertices.size() > 2 * named.mesh->face_count())
      count += named.mesh->face_vertices.size() - 2 * named.mesh->face_count();
  StlWriter writer(encoding, count);
  std::vector<Vector3> corners;
  for (const NamedPolygons& named : meshes) {
    writer.begin(named.name);
    for (std::size_t f = 0; f < named.mesh->face_count(); ++f) {
      corners.clear();
      for (const Index v : named.mesh->face(f)) corners.push_back(named.mesh->positions[v]);
      for (const auto& [a, b, c] : triangulate_polygon(corners))
        writer.add(Vector3::Zero(), corners[a], corners[b], corners[c]);
    }
    writer.end();
  }
  return writer.finish();
}

}  // namespace hariko
