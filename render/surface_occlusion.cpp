#include "render/surface_occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hariko {

namespace {

constexpr float nothing = -std::numeric_limits<float>::infinity();
constexpr std::size_t many_triangles = 50'000;

/// Triangles of a patch to be drawn: those of the pattern, or for large meshes two (one) between its corners.
std::vector<std::array<std::size_t, 3>> drawn_triangles(const DisplayMesh& mesh) {
  std::vector<std::array<std::size_t, 3>> out;
  if (mesh.triangle_count() <= many_triangles) {
    for (const auto& t : mesh.pattern().triangles())
      out.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
    return out;
  }
  const std::vector<Vector2> parameters = mesh.pattern().parameters();
  const auto at = [&](double x, double y) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < parameters.size(); ++i)
      if ((parameters[i] - Vector2(x, y)).norm() < (parameters[best] - Vector2(x, y)).norm()) best = i;
    return best;
  };
  out.push_back({at(0, 0), at(1, 0), at(0, 1)});
  if (mesh.pattern().domain == Domain::square) out.push_back({at(1, 0), at(1, 1), at(0, 1)});
  return out;
}

}  // namespace

SurfaceOcclusion::SurfaceOcclusion(const std::vector<SceneObject>& objects,
                                   const std::optional<SectionPlane>& section, const Projector& projector,
                                   double cell)
    : projector_(projector),
      cell_(cell),
      width_(int(std::ceil(projector.size().width / cell))),
      height_(int(std::ceil(projector.size().height / cell))),
      nearest_(std::size_t(std::max(width_, 0)) * std::size_t(std::max(height_, 0)), nothing) {
  for (const SceneObject& object : objects)
    if (object.mesh && object.show_surface) add(object, section);
}

double SurfaceOcclusion::nearness(double depth) const {
  return projector_.camera().orthographic ? -depth : 1 / depth;
}

void SurfaceOcclusion::add(const SceneObject& object, const std::optional<SectionPlane>& section) {
  const DisplayMesh& mesh = *object.mesh;
  const auto triangles = drawn_triangles(mesh);
  const std::size_t n = mesh.vertices_per_patch();
  const Matrix3 turn = object.transform.topLeftCorner<3, 3>();
  const Vector3 move = object.transform.topRightCorner<3, 1>() + turn * mesh.origin();
  std::vector<Vector3> points(n);
  std::vector<std::optional<Vector3>> pixels(n);
  std::vector<char> used(n, 0);
  for (const auto& t : triangles)
    for (const std::size_t i : t) used[i] = 1;
  for (const auto& chunk : mesh.chunks())
    for (std::size_t base = 0; base + n <= chunk->vertices.size(); base += n) {
      for (std::size_t i = 0; i < n; ++i) {
        if (!used[i]) continue;
        const auto& p = chunk->vertices[base + i].position;
        points[i] = turn * Vector3(double(p[0]), double(p[1]), double(p[2])) + move;
        pixels[i] = projector_.project(points[i]);
      }
      for (const auto& [a, b, c] : triangles) {
        if (!pixels[a] || !pixels[b] || !pixels[c]) continue;
        if (section && section->cuts((points[a] + points[b] + points[c]) / 3)) continue;
        draw(*pixels[a], *pixels[b], *pixels[c]);
      }
    }
}

void SurfaceOcclusion::draw(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector2 p = a.head<2>() / cell_, u = b.head<2>() / cell_ - p, v = c.head<2>() / cell_ - p;
  const double area = u.x() * v.y() - u.y() * v.x();
  if (std::abs(area) < 1e-12) return;
  const double na = nearness(a.z()), nb = nearness(b.z()), nc = nearness(c.z());
  // Range of cells whose centres may lie in the triangle.
  const auto range = [](double low, double high, int most) {
    return std::pair(int(std::clamp(std::ceil(low - 0.5), 0.0, double(most))),
                     int(std::clamp(std::floor(high - 0.5) + 1, 0.0, double(most))));
  };
  const auto [left, right] =
      range(p.x() + std::min({0.0, u.x(), v.x()}), p.x() + std::max({0.0, u.x(), v.x()}), width_);
  const auto [top, bottom] =
      range(p.y() + std::min({0.0, u.y(), v.y()}), p.y() + std::max({0.0, u.y(), v.y()}), height_);
  constexpr double seam = 1e-9;  // avoids gaps between neighbours
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const Vector2 d = Vector2(x + 0.5, y + 0.5) - p;
      const double s = (d.x() * v.y() - d.y() * v.x()) / area, t = (u.x() * d.y() - u.y() * d.x()) / area;
      if (s < -seam || t < -seam || s + t > 1 + seam) continue;
      float& nearest = nearest_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
      nearest = std::max(nearest, float(na + s * (nb - na) + t * (nc - na)));
    }
}

bool SurfaceOcclusion::hides(const Vector3& world) const {
  const auto at = projector_.project(world);
  if (!at) return false;
  const double slack = 2 * cell_ * projector_.pixel_length_at(world);
  const double own = nearness(std::max(at->z() - slack, 0.5 * at->z()));
  const int x = int(std::floor(std::clamp(at->x() / cell_, -9.0, 1e6))),
            y = int(std::floor(std::clamp(at->y() / cell_, -9.0, 1e6)));
  // Nothing is known outside the picture.
  if (x < 1 || y < 1 || x + 1 >= width_ || y + 1 >= height_) return false;
  for (int j = y - 1; j <= y + 1; ++j)
    for (int i = x - 1; i <= x + 1; ++i)
      if (double(nearest_[std::size_t(j) * std::size_t(width_) + std::size_t(i)]) <= own) return false;
  return true;
}

}  // namespace hariko
