#include "core/g2/g2_kernel.hpp"

#include "core/surface/grid_kernel.hpp"

namespace hariko {

namespace {

/// Active controls of a face, in order.
struct ActiveControls {
  const Vector3* controls;
  std::span<const int> active;
  std::size_t size() const { return active.size(); }
  HARIKO_INLINE const Vector3& operator[](std::size_t k) const { return controls[active[k]]; }
};

HARIKO_INLINE void accumulate_body(const Vector3* controls, std::span<const int> active,
                                   const G2GridTable& table, std::size_t points, Vector3* out) {
  grid_kernel::for_blocks(
      ActiveControls{controls, active}, table.value.data(), table.blocks, points,
      [&](std::size_t first, std::size_t count, const grid_kernel::Triple* v) __attribute__((always_inline)) {
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t k = 0; k < 3; ++k) out[3 * (first + i) + k] = grid_kernel::lane(v[k], i);
      });
}

HARIKO_INLINE bool position_normal_body(const Vector3* controls, std::span<const int> active,
                                        const G2GridTable& table, std::size_t points, Vector3* positions,
                                        Vector3* normals) {
  return grid_kernel::position_normal(ActiveControls{controls, active}, table.value.data(), table.blocks,
                                      points, positions, normals);
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
