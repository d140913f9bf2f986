#include "core/g2/g2_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Four doubles; the compiler maps them to one AVX or two SSE registers.
typedef double Lane4 __attribute__((vector_size(32)));
#define HARIKO_INLINE inline __attribute__((always_inline))

struct Triple {
  Lane4 x, y, z;
};

HARIKO_INLINE void sum_block(const Vector3* controls, std::span<const int> active, const double* table,
                             Triple out[3]) {
  Lane4 ax{}, ay{}, az{}, bx{}, by{}, bz{}, cx{}, cy{}, cz{};
  for (const int k : active) {
    const double* d = controls[k].data();
    Lane4 t0, t1, t2;
    __builtin_memcpy(&t0, table, sizeof t0);
    __builtin_memcpy(&t1, table + 4, sizeof t1);
    __builtin_memcpy(&t2, table + 8, sizeof t2);
    table += 12;
    const double x = d[0], y = d[1], z = d[2];
    ax += t0 * x;
    ay += t0 * y;
    az += t0 * z;
    bx += t1 * x;
    by += t1 * y;
    bz += t1 * z;
    cx += t2 * x;
    cy += t2 * y;
    cz += t2 * z;
  }
  out[0] = {ax, ay, az};
  out[1] = {bx, by, bz};
  out[2] = {cx, cy, cz};
}

HARIKO_INLINE void accumulate_body(const Vector3* controls, std::span<const int> active,
                                   const G2GridTable& table, std::size_t points, Vector3* out) {
  const std::size_t stride = active.size() * 3 * G2GridTable::width;
  for (std::size_t block = 0; block < table.blocks; ++block) {
    Triple v[3];
    sum_block(controls, active, table.value.data() + block * stride, v);
    const std::size_t count = std::min(points - block * 4, std::size_t(4));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        out[3 * (block * 4 + i) + k] = Vector3(v[k].x[i], v[k].y[i], v[k].z[i]);
  }
}

HARIKO_INLINE bool position_normal_body(const Vector3* controls, std::span<const int> active,
                                        const G2GridTable& table, std::size_t points, Vector3* positions,
                                        Vector3* normals) {
  bool degenerate = false;
  const std::size_t stride = active.size() * 3 * G2GridTable::width;
  for (std::size_t block = 0; block < table.blocks; ++block) {
    Triple v[3];
    sum_block(controls, active, table.value.data() + block * stride, v);
    const Triple &p = v[0], &s = v[1], &t = v[2];
    const Lane4 nx = s.y * t.z - s.z * t.y, ny = s.z * t.x - s.x * t.z, nz = s.x * t.y - s.y * t.x;
    const Lane4 square = nx * nx + ny * ny + nz * nz;
    const Lane4 limit = (s.x * s.x + s.y * s.y + s.z * s.z) * (t.x * t.x + t.y * t.y + t.z * t.z) * 1e-24;
    const std::size_t count = std::min(points - block * 4, std::size_t(4));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = block * 4 + i;
      positions[at] = Vector3(p.x[i], p.y[i], p.z[i]);
      const double scale = square[i] > limit[i] ? 1 / std::sqrt(square[i]) : 0;
      degenerate = degenerate || scale == 0;
      normals[at] = Vector3(nx[i] * scale, ny[i] * scale, nz[i] * scale);
    }
  }
  return degenerate;
}

void accumulate_base(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                     std::size_t points, Vector3* out) {
  accumulate_body(controls, active, table, points, out);
}
bool position_normal_base(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                          std::size_t points, Vector3* positions, Vector3* normals) {
  return position_normal_body(controls, active, table, points, positions, normals);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void accumulate_avx2(const Vector3* controls, std::span<const int> active,
                                                     const G2GridTable& table, std::size_t points,
                                                     Vector3* out) {
  accumulate_body(controls, active, table, points, out);
}
__attribute__((target("avx2"))) bool position_normal_avx2(const Vector3* controls,
                                                          std::span<const int> active,
                                                          const G2GridTable& table, std::size_t points,
                                                          Vector3* positions, Vector3* normals) {
  return position_normal_body(controls, active, table, points, positions, normals);
}
#endif

}  // namespace

G2Kernel g2_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return {accumulate_avx2, position_normal_avx2};
#endif
  return {accumulate_base, position_normal_base};
}

}  // namespace hariko
