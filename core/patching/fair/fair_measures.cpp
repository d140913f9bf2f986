#include "core/patching/fair/fair_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

namespace {

/// Exponent of areas: bending of patches is weighted by area^((3 - p)/2), and jumps across edges likewise,
/// with p = 1/2 between p = 0, where long edges dominate, and p = 3, true bending, where short ones do.
constexpr double area_power = 1.25;
/// Least height of a patch relative to that of the one across its side: lower patches are measured as if they
/// were higher.
constexpr double least_ratio = 0.05;

/// Measure of the jump across an edge of this length between triangles of these areas: (L / h^3) (h L)^(5/4),
/// with 1/h the sum of the reciprocal heights.
double jump_measure(double length, double x_left, double x_right) {
  const double height_times_length = 2 * x_left * x_right / (x_left + x_right);
  return std::pow(length, 4.0) * std::pow(height_times_length, area_power - 3);
}

/// Factor of the height with which a patch is measured. The condition across its side hardly moves the points
/// of a patch far lower than the other one, so a small gain in its own bending would move the other's points
/// far.
double stretch(const HalfEdgeMesh& mesh, const PatchConstants& constants, Index h) {
  if (!constants.smooth[h]) return 1;
  const double ratio = constants.x[h] / constants.x[mesh.twin(h)];
  if (ratio >= least_ratio) return 1;
  const double share = ratio / least_ratio;
  return least_ratio * (1 + share * share) / (2 * ratio);
}

/// Triangle with its height above the side p q multiplied by a factor.
ChartTriangle stretched(const ChartTriangle& t, double factor) {
  if (factor == 1) return t;
  const double side = t.pp - 2 * t.pq + t.qq;  // squared length
  // Increase of the squared height: determinant = height x side.
  const double gain = (factor * factor - 1) * t.determinant * t.determinant / side;
  return {t.pp + gain, t.pq + gain, t.qq + gain, factor * t.determinant};
}

/// Mean of the squared lengths of a face's edges, kept above zero.
double mean_square(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face) {
  double sum = 0;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    const double length = charts.edge_length[mesh.edge(h)];
    sum += length * length / double(mesh.side_count(face));
  }
  const double least = 1e-6 * charts.mean_length;
  return sum + least * least;
}

/// Factor of the membrane energy, from the tensions of a face.
double membrane_factor(const HalfEdgeMesh& mesh, const NetworkSystem& network, Index face, double tension) {
  double excess = 0, alpha = 0;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    excess += std::max(network.beta()[mesh.edge(h)] - 1, 0.0);
    alpha += network.alpha()[mesh.origin(h)];
  }
  return tension * (excess + alpha) / double(mesh.side_count(face));
}

}  // namespace

FairWeights fair_weights(Frames frames) {
  return frames == Frames::equal ? FairWeights{} : FairWeights{0.5, 2.5, 2};
}

ChartTriangle regular_triangle(Index sides) {
  const double square = split_factor(sides), angle = 2 * std::numbers::pi / double(sides);
  return {square, square * std::cos(angle), square, square * std::sin(angle)};
}

FairMeasures fair_measures(const HalfEdgeMesh& mesh, const NetworkSystem& network,
                           const PatchConstants& constants, const FairWeights& weights) {
  const FaceCharts& charts = network.frames().charts;
  const bool metric = charts.frames == Frames::metric;
  FairMeasures out;
  out.patch.resize(mesh.half_edge_count());
  out.edge.resize(mesh.edge_count());
  std::vector<double> measured = charts.area;
  std::vector<double> factor(mesh.half_edge_count(), 1.0);
  const std::vector<double>& kept_area = network.frames().kept_area;
  if (metric)
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      factor[h] = stretch(mesh, constants, h);
      measured[h] *= factor[h];
      if (!kept_area.empty()) measured[h] *= kept_area[mesh.face(h)];
    }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const double membrane = membrane_factor(mesh, network, f, weights.tension);
    const double square = metric ? mean_square(mesh, charts, f) : 1;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      const Index before = mesh.previous(h);
      PatchMeasure& patch = out.patch[h];
      const double x = measured[h];
      const double scale = metric ? std::pow(x, area_power) : 1;
      patch.triangle = metric ? ChartTriangle{charts.square[h], charts.dot[h], charts.square[mesh.next(h)],
                                              2 * charts.area[h]}
                              : regular_triangle(mesh.side_count(f));
      patch.triangle = stretched(patch.triangle, factor[h]);
      patch.plate = scale;
      patch.membrane = scale * membrane / square;
      patch.pair = weights.pair_distance * (metric ? scale / x : 1);
      patch.split_jump = weights.curvature_jump *
                         (metric ? jump_measure(std::sqrt(charts.square[h]), x, measured[before]) : 1);
      patch.c_centre = constants.c_centre[h];
      patch.c_split = constants.c_split[h];
      patch.own_split = constants.own_split[h];
      patch.corner = charts.corner[h];
    }
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    if (!constants.smooth[h]) continue;
    const Index twin = mesh.twin(h);
    const double measure = metric ? jump_measure(charts.edge_length[e], measured[h], measured[twin]) : 1;
    out.edge[e] = {weights.curvature_jump * measure, constants.c_origin[h], constants.c_target[h],
                   constants.own[h]};
  }
  return out;
}

}  // namespace hariko
