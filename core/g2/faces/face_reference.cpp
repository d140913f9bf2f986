#include "core/g2/faces/face_reference.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace hariko {

namespace {

ReferencePoint changed(const CoordinateChange& change, const ReferencePoint& at) {
  Eigen::Matrix<double, 5, 3> from;
  from << at.x.transpose(), at.y.transpose(), at.xx.transpose(), at.xy.transpose(), at.yy.transpose();
  const Eigen::Matrix<double, 5, 3> to = change.matrix.topLeftCorner<5, 5>() * from;
  return {to.row(0), to.row(1), to.row(2), to.row(3), to.row(4)};
}

}  // namespace

FaceReference reference_of_patches(const ChartSamples& samples, const ReferencePatches& patches,
                                   const std::function<Index(int side)>& patch) {
  const FaceChart& chart = samples.chart();
  FaceReference out;
  std::vector<PatchPoint> room;
  for (int side = 0; side < chart.sides(); ++side) {
    room.resize(samples.points(side).size());
    patches(patch(side), samples.points(side), room);
    // Change from derivatives by the patch's parameters.
    Eigen::Matrix2d edges;
    edges << chart.vertex(side), chart.vertex((side + 1) % chart.sides());
    const Eigen::Matrix2d inverse = edges.inverse();
    const double a = inverse(0, 0), b = inverse(0, 1), c = inverse(1, 0), d = inverse(1, 1);
    auto& own = out.emplace_back();
    for (const PatchPoint& p : room)
      own.push_back({a * p.ds + c * p.dt, b * p.ds + d * p.dt,
                     a * a * p.dss + 2 * a * c * p.dst + c * c * p.dtt,
                     a * b * p.dss + (a * d + b * c) * p.dst + c * d * p.dtt,
                     b * b * p.dss + 2 * b * d * p.dst + d * d * p.dtt});
    for (std::size_t i = 0; i < samples.changes(side).size(); ++i)
      own[i] = changed(samples.changes(side)[i], own[i]);
  }
  return out;
}

FaceReference reference_of_controls(const ChartSamples& samples, std::span<const Vector3> controls) {
  const FaceChart& chart = samples.chart();
  FaceReference out;
  for (int side = 0; side < chart.sides(); ++side) {
    const std::span<const int> active = chart.active_controls(side);
    auto& own = out.emplace_back();
    samples.with_basis(side, [&](const ChartSamples::Basis& basis) {
      for (std::size_t i = 0; i < samples.points(side).size(); ++i) {
        const std::span<const Jet3> functions = basis.at(i);
        ReferencePoint sum{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                           Vector3::Zero()};
        for (std::size_t k = 0; k < active.size(); ++k) {
          const Vector3& c = controls[std::size_t(active[k])];
          const Jet3& f = functions[k];
          sum.x += f.x * c;
          sum.y += f.y * c;
          sum.xx += f.xx * c;
          sum.xy += f.xy * c;
          sum.yy += f.yy * c;
        }
        own.push_back(sum);
      }
    });
  }
  return out;
}

double area_of(const ChartSamples& samples, const FaceReference& reference) {
  double sum = 0;
  for (int side = 0; side < samples.sides(); ++side)
    for (std::size_t i = 0; i < samples.points(side).size(); ++i) {
      const ReferencePoint& s = reference[std::size_t(side)][i];
      sum += samples.points(side)[i].weight * s.x.cross(s.y).norm();
    }
  return sum;
}

}  // namespace hariko
