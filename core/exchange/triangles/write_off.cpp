#include "core/exchange/number_text.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {
namespace {

/// Gathers vertices and faces separately, as the counts come first.
class OffWriter {
 public:
  void add_vertex(const Vector3& position) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) vertices_ += ' ';
      append_real(vertices_, position[axis]);
    }
    vertices_ += '\n';
    ++vertex_count_;
  }
  template <class Face>
  void add_face(const Face& face, std::size_t base) {
    append_integer(faces_, face.size());
    for (const Index v : face) {
      faces_ += ' ';
      append_integer(faces_, base + v);
    }
    faces_ += '\n';
    ++face_count_;
  }
  std::size_t vertex_count() const { return vertex_count_; }
  std::string take() {
    return "OFF\n" + std::to_string(vertex_count_) + ' ' + std::to_string(face_count_) + " 0\n" + vertices_ +
           faces_;
  }

 private:
  std::string vertices_, faces_;
  std::size_t vertex_count_ = 0, face_count_ = 0;
};

}  // namespace

std::string write_off(std::span<const NamedTriangles> meshes) {
  OffWriter out;
  for (const NamedTriangles& named : meshes) {
    const std::size_t base = out.vertex_count();
    for (const Vector3& position : named.mesh->positions) out.add_vertex(named.mesh->origin + position);
    for (const auto& triangle : named.mesh->triangles) out.add_face(triangle, base);
  }
  return out.take();
}

std::string write_off(std::span<const NamedPolygons> meshes) {
  OffWriter out;
  for (const NamedPolygons& named : meshes) {
    const std::size_t base = out.vertex_count();
    for (const Vector3& position : named.mesh->positions) out.add_vertex(position);
    for (std::size_t f = 0; f < named.mesh->face_count(); ++f) out.add_face(named.mesh->face(f), base);
  }
  return out.take();
}

}  // namespace hariko
