#include "core/patching/quartic/patch_constants.hpp"

#include <cmath>

namespace hariko {

namespace {

/// Component s . t / (t . t) of the split vector s of corner h along the vector t of one of the corner's
/// edges: half-edge h, or the one before it.
double split_along(const HalfEdgeMesh& mesh, const VertexFrames& frames, Index h, bool own_edge) {
  if (frames.half_turn[h]) return 0;  // the contributions of both sides of the edge cancel
  const auto [first, second] = frames.split_factors(mesh, h);
  const double a = frames.length[2 * h], b = frames.length[2 * mesh.previous(h) + 1];
  const double cosine = std::cos(frames.step[h]);
  return own_edge ? first + second * b / a * cosine : second + first * a / b * cosine;
}

}  // namespace

PatchConstants patch_constants(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  const Index count = mesh.half_edge_count();
  const FaceCharts& charts = frames.charts;
  PatchConstants out;
  out.x = charts.area;
  out.c_centre.resize(count);
  out.c_split.resize(count);
  out.own_split.resize(count);
  out.free_split = frames.half_turn;
  out.smooth.resize(count);
  out.c_origin.assign(count, 0.0);
  out.c_target.assign(count, 0.0);
  out.own.assign(count, 0.0);
  for (Index h = 0; h < count; ++h) {
    const Index before = mesh.previous(h);
    const double x = out.x[h], x_before = out.x[before];
    out.own_split[h] = x_before / (x_before + x);
    out.c_centre[h] =
        0.75 * (x_before * charts.dot[h] + x * charts.dot[before]) / ((x_before + x) * charts.square[h]);
    out.c_split[h] = out.free_split[h] ? 0.0 : 0.75 / (frames.split_gain[h] * (x_before + x));
    out.smooth[h] = !frames.sharp[mesh.edge(h)];
    if (!out.smooth[h]) continue;
    const Index twin = mesh.twin(h);
    const double own = out.x[twin] / (x + out.x[twin]), other = x / (x + out.x[twin]);
    // Corners beside the edge, at its origin and at its target: one opens with it, the other closes with it.
    out.c_origin[h] = 0.75 * (own * split_along(mesh, frames, h, true) +
                              other * split_along(mesh, frames, mesh.next(twin), false));
    out.c_target[h] = 0.75 * (own * split_along(mesh, frames, mesh.next(h), false) +
                              other * split_along(mesh, frames, twin, true));
    out.own[h] = own;
  }
  return out;
}

}  // namespace hariko
