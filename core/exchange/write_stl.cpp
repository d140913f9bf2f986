#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/exchange/triangulate.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {
namespace {

constexpr std::size_t facet_size = 50;

void append_float(std::string& out, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i) out += static_cast<char>((bits >> (8 * i)) & 0xffU);
}

class StlWriter {
 public:
  explicit StlWriter(std::size_t triangles) {
    out_.reserve(84 + facet_size * triangles);
    // Must not begin with "solid", by which readers tell text.
    out_ = "binary STL written by Hariko";
    out_.resize(84, ' ');
  }

  /// Corners relative to `origin`, from which the normal is computed.
  void add(const Vector3& origin, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 ab = b - a, ac = c - a;
    // Scaled first, so that neither tiny nor huge triangles leave the range of doubles; a triangle without
    // area has the normal 0, as the format asks.
    const double scale = std::max(ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff());
    Vector3 normal = Vector3::Zero();
    if (scale > 0) normal = (ab / scale).cross(ac / scale).normalized();
    if (!normal.allFinite()) normal.setZero();
    append(normal);
    for (const Vector3* corner : {&a, &b, &c}) append(origin + *corner);
    out_.append(2, '\0');
    ++count_;
  }

  Result<std::string> finish() {
    if (!in_range_)
      return make_error(e_limit, "Coordinates of the mesh are too large for an STL file.",
                        "Scale the model down, or export OBJ or PLY.");
    if (count_ > std::numeric_limits<std::uint32_t>::max())
      return make_error(e_limit, "The mesh has more triangles than an STL file can hold.",
                        "Lower the density, or export PLY.");
    for (std::size_t i = 0; i < 4; ++i) out_[80 + i] = static_cast<char>((count_ >> (8 * i)) & 0xffU);
    return std::move(out_);
  }

 private:
  void append(const Vector3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = static_cast<float>(p[axis]);
      in_range_ = in_range_ && std::isfinite(number);
      append_float(out_, number);
    }
  }
  std::string out_;
  std::uint64_t count_ = 0;
  bool in_range_ = true;
};

}  // namespace

Result<std::string> write_stl(std::span<const NamedTriangles> meshes) {
  std::size_t count = 0;
  for (const NamedTriangles& named : meshes) count += named.mesh->triangles.size();
  StlWriter writer(count);
  for (const NamedTriangles& named : meshes) {
    const std::vector<Vector3>& p = named.mesh->positions;
    for (const auto& [a, b, c] : named.mesh->triangles) writer.add(named.mesh->origin, p[a], p[b], p[c]);
  }
  return writer.finish();
}

Result<std::string> write_stl(std::span<const NamedPolygons> meshes) {
  std::size_t count = 0;
  for (const NamedPolygons& named : meshes)
    if (named.mesh->face_vertices.size() > 2 * named.mesh->face_count())
      count += named.mesh->face_vertices.size() - 2 * named.mesh->face_count();
  StlWriter writer(count);
  std::vector<Vector3> corners;
  for (const NamedPolygons& named : meshes) {
    for (std::size_t f = 0; f < named.mesh->face_count(); ++f) {
      corners.clear();
      for (const Index v : named.mesh->face(f)) corners.push_back(named.mesh->positions[v]);
      for (const auto& [a, b, c] : triangulate_polygon(corners))
        writer.add(Vector3::Zero(), corners[a], corners[b], corners[c]);
    }
  }
  return writer.finish();
}

}  // namespace hariko
