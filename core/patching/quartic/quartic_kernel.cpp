#include "core/patching/quartic/quartic_kernel.hpp"

#include "core/surface/grid_kernel.hpp"

namespace hariko {

namespace {

struct PatchControls {
  const QuarticPatch& patch;
  static constexpr std::size_t size() { return quartic_control_count; }
  HARIKO_INLINE const Vector3& operator[](std::size_t k) const { return patch.control[k]; }
};

HARIKO_INLINE bool position_normal_body(const QuarticPatch& patch, const QuarticGridTable& table,
                                        std::size_t points, Vector3* positions, Vector3* normals) {
  return grid_kernel::position_normal(PatchControls{patch}, table.first.data(), table.blocks, points,
                                      positions, normals);
}

HARIKO_INLINE void first_order_body(const QuarticPatch& patch, const QuarticGridTable& table,
                                    std::size_t points, PatchPoint* out) {
  using grid_kernel::lane;
  grid_kernel::for_blocks(
      PatchControls{patch}, table.first.data(), table.blocks, points,
      [&](std::size_t first, std::size_t count, const grid_kernel::Triple* a) __attribute__((always_inline)) {
        for (std::size_t i = 0; i < count; ++i)
          out[first + i] = {lane(a[0], i), lane(a[1], i), lane(a[2], i)};
      });
}

HARIKO_INLINE void second_order_body(const QuarticPatch& patch, const QuarticGridTable& table,
                                     std::size_t points, PatchPoint* out) {
  using grid_kernel::lane, grid_kernel::lanes, grid_kernel::sum_block;
  constexpr std::size_t stride = quartic_control_count * 3 * lanes;
  for (std::size_t block = 0; block < table.blocks; ++block) {
    grid_kernel::Triple a[3], b[3];
    sum_block(PatchControls{patch}, table.first.data() + block * stride, a);
    sum_block(PatchControls{patch}, table.second.data() + block * stride, b);
    const std::size_t count = std::min(points - block * lanes, lanes);
    for (std::size_t i = 0; i < count; ++i)
      out[block * lanes + i] = {lane(a[0], i), lane(a[1], i), lane(a[2], i),
                                lane(b[0], i), lane(b[1], i), lane(b[2], i)};
  }
}

bool position_normal_base(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                          Vector3* positions, Vector3* normals) {
  return position_normal_body(patch, table, points, positions, normals);
}
void first_order_base(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                      PatchPoint* out) {
  first_order_body(patch, table, points, out);
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
__attribute__((target("avx2"))) void first_order_avx2(const QuarticPatch& patch,
                                                      const QuarticGridTable& table, std::size_t points,
                                                      PatchPoint* out) {
  first_order_body(patch, table, points, out);
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
  if (__builtin_cpu_supports("avx2")) return {position_normal_avx2, first_order_avx2, second_order_avx2};
#endif
  return {position_normal_base, first_order_base, second_order_base};
}

}  // namespace hariko
