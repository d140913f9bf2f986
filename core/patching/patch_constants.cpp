#include "core/patching/patch_constants.hpp"

#include <cmath>
#include <numbers>

namespace hariko {

double split_factor(Index sides) {
  const double s = std::sin(std::numbers::pi / double(sides));
  return 1 / (4 * s * s);
}

PatchConstants patch_constants(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  constexpr double pi = std::numbers::pi;
  PatchConstants out;
  out.f.resize(mesh.face_count());
  out.c_centre.resize(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    out.f[f] = split_factor(mesh.side_count(f));
    out.c_centre[f] = 0.75 * std::cos(2 * pi / double(mesh.side_count(f)));
  }
  const Index count = mesh.half_edge_count();
  out.c_split.resize(count);
  out.free_split.resize(count);
  out.smooth.resize(count);
  out.c_origin.assign(count, 0.0);
  out.c_target.assign(count, 0.0);
  out.own.assign(count, 0.0);
  for (Index h = 0; h < count; ++h) {
    // A step of pi is only ever set as pi / 1 or 2 pi / 2, so the comparison is exact.
    out.free_split[h] = frames.step[h] == pi;
    out.c_split[h] = out.free_split[h] ? 0.0 : 3 / (8 * out.f[mesh.face(h)]);
    out.smooth[h] = !frames.sharp[mesh.edge(h)];
    if (!out.smooth[h]) continue;
    const Index twin = mesh.twin(h);
    const double own = out.f[mesh.face(h)], other = out.f[mesh.face(twin)];
    const double factor = 1.5 * own * other / (own + other);
    // Both corners beside a smooth edge lie in one sector, hence share its step.
    out.c_origin[h] = factor * (1 + std::cos(frames.step[h]));
    out.c_target[h] = factor * (1 + std::cos(frames.step[twin]));
    out.own[h] = other / (own + other);
  }
  return out;
}

}  // namespace hariko
