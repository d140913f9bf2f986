#pragma once

// Target curvature of a face: that of a reference surface, smoothed over the face's width (g2.md section 8).

#include <array>
#include <vector>

#include "core/g2/faces/face_reference.hpp"

namespace hariko {

/// Symmetric 2x2 matrix: 11, 12, 22.
using SymmetricMatrix2 = std::array<double, 3>;

/// Second fundamental form of the reference and its metric, at one point. The orthonormal frame is that of
/// the metric's symmetric root L, g = L L: it turns with the chart, so that nothing depends on the corner
/// that the chart begins with.
struct FramedPoint {
  Vector3 normal;         ///< unit; zero where the reference has none
  SymmetricMatrix2 root;  ///< L in the chart's coordinates
  double area;            ///< area element, det L
  SymmetricMatrix2 t;     ///< the form in the orthonormal frame
  /// Inverse of L.
  SymmetricMatrix2 inverse_root() const { return {root[2] / area, -root[1] / area, root[0] / area}; }
};
using FramedFace = std::vector<std::vector<FramedPoint>>;

/// Forms and metrics of a reference at the points of the quadrature. Metrics are kept above 1e-6 of their
/// mean over the face, so that folds stay finite. Empty where the reference has shrunk to a point.
FramedFace framed(const ChartSamples& samples, const FaceReference& reference);

/// Smooths the forms: replaces t by polynomials of degree four in the chart's coordinates, with a smoothing
/// length of `width` times the face's narrowest chart width.
void smooth_forms(const ChartSamples& samples, double width, FramedFace& face);

/// Load of the target over the chart, one vector per control: the integral of the target's second derivatives
/// times the control's function. The target has the tangential part of the reference's second derivatives and
/// the forms of `smooth`, times `share`.
std::vector<Vector3> chart_load(const ChartSamples& samples, const FaceReference& reference,
                                const FramedFace& own, const FramedFace& smooth, double share,
                                const ChartMeasure& measure);

/// Load of the target's third derivatives, in the same form. Along the surface they are the reference's:
/// without them, faces would be drawn to charts without any distortion, which thin faces beside wide ones
/// cannot have. Across it, the forms of `smooth` do not change.
std::vector<Vector3> third_load(const ChartSamples& samples, const FaceReference& reference,
                                const FramedFace& own, const FramedFace& smooth, double third,
                                const ChartMeasure& measure);

/// Bending matrix over the reference itself, the integral of squared second covariant derivatives;
/// `metric_load` is the corresponding load of the forms of `smooth`.
Eigen::MatrixXd metric_plate(const ChartSamples& samples, const FaceReference& reference,
                             const FramedFace& frames);
std::vector<Vector3> metric_load(const ChartSamples& samples, const FaceReference& reference,
                                 const FramedFace& smooth);

}  // namespace hariko
