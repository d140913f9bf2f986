#pragma once

// FaceElements: the energies of faces as dense matrices with their centres eliminated, equal ones shared
// (g2.md section 5).

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/g2/faces/face_reference.hpp"
#include "core/g2/g2_layout.hpp"

namespace hariko {

/// Supplier of a reference surface at the points of a face's quadrature.
using FaceReferences = std::function<FaceReference(Index face, const ChartSamples& samples)>;

/// Calls body(face, samples) for faces in the order of their charts, so that a chart's functions are computed
/// once per task.
template <class Body>
void for_faces_by_chart(const G2Layout& layout, std::vector<Index> faces, const Body& body) {
  constexpr std::size_t grain = 16;
  std::map<const PlacedChart*, Index> first;
  for (const Index f : faces) first.try_emplace(layout.placed(f).get(), f);
  std::stable_sort(faces.begin(), faces.end(), [&](Index a, Index b) {
    return first.at(layout.placed(a).get()) < first.at(layout.placed(b).get());
  });
  parallel_for(faces.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::optional<ChartSamples> samples;
    for (std::size_t k = begin; k < end; ++k) {
      const FaceChart& chart = layout.chart(faces[k]);
      if (!samples || &samples->chart() != &chart) samples.emplace(chart);
      body(faces[k], *samples);
    }
  });
}

/// Condensed energies of all faces.
class FaceElements {
 public:
  FaceElements(const G2Layout& layout, const TensionWeights& weights, double third);

  const CondensedFace& operator[](Index face) const { return *element_[face]; }
  const FaceWeights& weights(Index face) const { return weights_[face]; }
  /// Share of a face's bending that is measured over the reference, and the scale from there to the charts.
  double over_reference(Index face) const { return over_reference_[face]; }
  double reference_scale() const { return reference_scale_; }
  double third() const { return third_; }  ///< weight of third derivatives

  /// Measures part of the bending over this surface in faces whose vertices have tension. False where there
  /// are no such faces.
  bool bend_over(const G2Layout& layout, const FaceReferences& references);

  /// Bytes of matrices; shared ones are counted once.
  std::size_t bytes() const;

 private:
  Eigen::MatrixXd chart_energy(const G2Layout& layout, Index face, const ChartSamples& samples) const;

  double third_;
  std::vector<FaceWeights> weights_;    ///< per face
  std::vector<double> over_reference_;  ///< per face
  double reference_scale_ = 1;
  std::vector<std::shared_ptr<const CondensedFace>> element_;  ///< per face
};

}  // namespace hariko
