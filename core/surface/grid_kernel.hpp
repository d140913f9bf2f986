#pragma once

// Inner loop of grid evaluation, for kernels that compile it once per kind of processor: sums of control
// points times tables, four grid points at a time. For each block of four points and each control, a table
// has three groups (such as value, d/ds, d/dt) of four doubles. Include in kernels only.

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"

#define HARIKO_INLINE inline __attribute__((always_inline))

namespace hariko::grid_kernel {

/// Four doubles; the compiler maps them to one AVX or two SSE registers.
typedef double Lane4 __attribute__((vector_size(32)));

/// Vectors of four points, by coordinates.
struct Triple {
  Lane4 x, y, z;
};

inline constexpr std::size_t lanes = 4;

/// Computes three sums for four points into out[0..2]. `controls` has size() and [k], a vector.
template <class Controls>
HARIKO_INLINE void sum_block(const Controls& controls, const double* table, Triple out[3]) {
  Lane4 ax{}, ay{}, az{}, bx{}, by{}, bz{}, cx{}, cy{}, cz{};
  for (std::size_t k = 0; k < controls.size(); ++k, table += 3 * lanes) {
    const double* d = controls[k].data();
    Lane4 t0, t1, t2;
    __builtin_memcpy(&t0, table, sizeof t0);
    __builtin_memcpy(&t1, table + lanes, sizeof t1);
    __builtin_memcpy(&t2, table + 2 * lanes, sizeof t2);
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

/// Calls each(first point, points of the block, sums) for every block.
template <class Controls, class Each>
HARIKO_INLINE void for_blocks(const Controls& controls, const double* table, std::size_t blocks,
                              std::size_t points, const Each& each) {
  const std::size_t stride = controls.size() * 3 * lanes;
  for (std::size_t block = 0; block < blocks; ++block) {
    Triple v[3];
    sum_block(controls, table + block * stride, v);
    each(block * lanes, std::min(points - block * lanes, lanes), v);
  }
}

/// Positions and unit normals; a normal is zero where the derivatives are parallel to within 1e-12 of the
/// product of their lengths (then returns true).
template <class Controls>
HARIKO_INLINE bool position_normal(const Controls& controls, const double* table, std::size_t blocks,
                                   std::size_t points, Vector3* positions, Vector3* normals) {
  bool degenerate = false;
  for_blocks(
      controls, table, blocks,
      points, [&](std::size_t first, std::size_t count, const Triple* v) __attribute__((always_inline)) {
        const Triple &p = v[0], &s = v[1], &t = v[2];
        const Lane4 nx = s.y * t.z - s.z * t.y, ny = s.z * t.x - s.x * t.z, nz = s.x * t.y - s.y * t.x;
        const Lane4 square = nx * nx + ny * ny + nz * nz;
        const Lane4 limit = (s.x * s.x + s.y * s.y + s.z * s.z) * (t.x * t.x + t.y * t.y + t.z * t.z) * 1e-24;
        for (std::size_t i = 0; i < count; ++i) {
          positions[first + i] = Vector3(p.x[i], p.y[i], p.z[i]);
          const double scale = square[i] > limit[i] ? 1 / std::sqrt(square[i]) : 0;
          degenerate = degenerate || scale == 0;
          normals[first + i] = Vector3(nx[i] * scale, ny[i] * scale, nz[i] * scale);
        }
      });
  return degenerate;
}

/// Vector of point i of a block.
HARIKO_INLINE Vector3 lane(const Triple& v, std::size_t i) {
  return {v.x[i], v.y[i], v.z[i]};
}

}  // namespace hariko::grid_kernel
