#include "core/subdivision/stencil_kernel.hpp"

#include "core/surface/grid_kernel.hpp"

namespace hariko {

namespace {

using Controls = std::span<const Vector3>;

HARIKO_INLINE void accumulate_body(Controls controls, const StencilTable& table, std::size_t points,
                                   Vector3* out) {
  grid_kernel::for_blocks(
      controls, table.value.data(), table.blocks, points,
      [&](std::size_t first, std::size_t count, const grid_kernel::Triple* v) __attribute__((always_inline)) {
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t k = 0; k < 3; ++k) out[3 * (first + i) + k] = grid_kernel::lane(v[k], i);
      });
}

HARIKO_INLINE bool position_normal_body(Controls controls, const StencilTable& table, std::size_t points,
                                        Vector3* positions, Vector3* normals) {
  return grid_kernel::position_normal(controls, table.value.data(), table.blocks, points, positions, normals);
}

void accumulate_base(Controls controls, const StencilTable& table, std::size_t points, Vector3* out) {
  accumulate_body(controls, table, points, out);
}
bool position_normal_base(Controls controls, const StencilTable& table, std::size_t points,
                          Vector3* positions, Vector3* normals) {
  return position_normal_body(controls, table, points, positions, normals);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void accumulate_avx2(Controls controls, const StencilTable& table,
                                                     std::size_t points, Vector3* out) {
  accumulate_body(controls, table, points, out);
}
__attribute__((target("avx2"))) bool position_normal_avx2(Controls controls, const StencilTable& table,
                                                          std::size_t points, Vector3* positions,
                                                          Vector3* normals) {
  return position_normal_body(controls, table, points, positions, normals);
}
#endif

}  // namespace

StencilKernel stencil_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return {accumulate_avx2, position_normal_avx2};
#endif
  return {accumulate_base, position_normal_base};
}

Vector3 table_value(std::span<const Vector3> controls, const StencilTable& table, std::size_t point) {
  constexpr std::size_t lanes = grid_kernel::lanes;
  const double* weight = table.value.data() + (point / lanes) * controls.size() * 3 * lanes + point % lanes;
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < controls.size(); ++k, weight += 3 * lanes) sum += *weight * controls[k];
  return sum;
}

}  // namespace hariko
