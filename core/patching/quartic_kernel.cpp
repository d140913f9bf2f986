#include "core/patching/quartic_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Four doubles; the compiler maps them to one AVX or two SSE registers.
typedef double Lane4 __attribute__((vector_size(32)));
typedef long long Mask4 __attribute__((vector_size(32)));
#define HARIKO_INLINE inline __attribute__((always_inline))

struct Triple {
  Lane4 x, y, z;
};

/// Sums 18 control points times three tables: out[0..2] are the three vectors for four points.
HARIKO_INLINE void accumulate(const QuarticPatch& patch, const double* table, Triple out[3]) {
  Lane4 ax{}, ay{}, az{}, bx{}, by{}, bz{}, cx{}, cy{}, cz{};
  for (std::size_t k = 0; k < quartic_control_count; ++k, table += 12) {
    const double* d = patch.control[k].data();
    Lane4 t0, t1, t2;
    __builtin_memcpy(&t0, table, sizeof t0);
    __builtin_memcpy(&t1, table + 4, sizeof t1);
    __builtin_memcpy(&t2, table + 8, sizeof t2);
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

HARIKO_INLINE bool position_normal_body(const QuarticPatch& patch, const QuarticGridTable& table,
                                        std::size_t points, Vector3* positions, Vector3* normals) {
  bool degenerate = false;
  constexpr std::size_t stride = quartic_control_count * 3 * QuarticGridTable::width;
  for (std::size_t block = 0; block < table.blocks; ++block) {
    Triple v[3];
    accumulate(patch, table.first.data() + block * stride, v);
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

HARIKO_INLINE void second_order_body(const QuarticPatch& patch, const QuarticGridTable& table,
                                     std::size_t points, PatchPoint* out) {
  constexpr std::size_t stride = quartic_control_count * 3 * QuarticGridTable::width;
  for (std::size_t block = 0; block < table.blocks; ++block) {
    Triple a[3], b[3];
    accumulate(patch, table.first.data() + block * stride, a);
    accumulate(patch, table.second.data() + block * stride, b);
    const std::size_t count = std::min(points - block * 4, std::size_t(4));
    for (std::size_t i = 0; i < count; ++i) {
      PatchPoint& point = out[block * 4 + i];
      point.position = Vector3(a[0].x[i], a[0].y[i], a[0].z[i]);
      point.ds = Vector3(a[1].x[i], a[1].y[i], a[1].z[i]);
      point.dt = Vector3(a[2].x[i], a[2].y[i], a[2].z[i]);
      point.dss = Vector3(b[0].x[i], b[0].y[i], b[0].z[i]);
      point.dst = Vector3(b[1].x[i], b[1].y[i], b[1].z[i]);
      point.dtt = Vector3(b[2].x[i], b[2].y[i], b[2].z[i]);
    }
  }
}

bool position_normal_base(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                          Vector3* positions, Vector3* normals) {
  return position_normal_body(patch, table, points, positions, normals);
}
void second_order_base(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                       PatchPoint* out) {
  second_order_body(patch, table, points, out);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) bool position_normal_avx2(const QuarticPatch& patch,
                                                          const QuarticGridTable& table, std::size_t points,
                                                          Vector3* positions, Vector3* normals) {
  return position_normal_body(patch, table, points, positions, normals);
}
__attribute__((target("avx2"))) void second_order_avx2(const QuarticPatch& patch,
                                                       const QuarticGridTable& table, std::size_t points,
                                                       PatchPoint* out) {
  second_order_body(patch, table, points, out);
}
#endif

}  // namespace

QuarticKernel quartic_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return {position_normal_avx2, second_order_avx2};
#endif
  return {position_normal_base, second_order_base};
}

}  // namespace hariko
