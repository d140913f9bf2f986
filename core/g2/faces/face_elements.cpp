#include "core/g2/faces/face_elements.hpp"

#include <numeric>
#include <set>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/g2/curvature_target.hpp"
#include "core/g2/faces/face_measure.hpp"

namespace hariko {

namespace {

FaceWeights face_weights(const G2Layout& layout, const TensionWeights& weights, Index face) {
  const HalfEdgeMesh& mesh = layout.mesh();
  FaceWeights out;
  out.tau = weights.membrane[face];
  for (int j = 0; j < int(mesh.side_count(face)); ++j) {
    const Index h = layout.half_edge(face, j);
    out.curve.push_back(weights.curve[h]);
    out.tangent_out.push_back(weights.tangent[2 * h]);
    out.tangent_in.push_back(weights.tangent[2 * mesh.previous(h) + 1]);
  }
  const Index first = layout.half_edge(face, 0) - mesh.face_begin(face);
  out.measure = face_measure(mesh, layout.frames().charts, face, first, layout.chart(face).vertices());
  return out;
}

}  // namespace

FaceElements::FaceElements(const G2Layout& layout, const TensionWeights& weights, double third)
    : third_(third), over_reference_(weights.over_reference), element_(layout.mesh().face_count()) {
  const Index faces = layout.mesh().face_count();
  std::vector<Index> fresh, same_as(faces);
  std::map<std::pair<const PlacedChart*, FaceWeights>, Index> known;
  for (Index f = 0; f < faces; ++f) {
    weights_.push_back(face_weights(layout, weights, f));
    same_as[f] = known.try_emplace({layout.placed(f).get(), weights_[f]}, f).first->second;
    if (same_as[f] == f) fresh.push_back(f);
  }
  for_faces_by_chart(layout, fresh, [&](Index f, const ChartSamples& samples) {
    element_[f] =
        std::make_shared<const CondensedFace>(condense(layout.places(f), chart_energy(layout, f, samples)));
  });
  for (Index f = 0; f < faces; ++f) element_[f] = element_[same_as[f]];
}

Eigen::MatrixXd FaceElements::chart_energy(const G2Layout& layout, Index face,
                                           const ChartSamples& samples) const {
  const FaceWeights& weights = weights_[face];
  Eigen::MatrixXd energy = plate_matrix(samples, third_, weights.measure);
  if (weights.plate != 1) energy *= weights.plate;
  if (weights.tau != 0) energy += weights.tau * membrane_matrix(samples, weights.measure);
  add_network_terms(layout.chart(face), weights, energy);
  return energy;
}

bool FaceElements::bend_over(const G2Layout& layout, const FaceReferences& references) {
  const Index faces = layout.mesh().face_count();
  std::vector<Index> tense;
  for (Index f = 0; f < faces; ++f)
    if (over_reference_[f] > 0) tense.push_back(f);
  if (tense.empty()) return false;
  std::vector<double> area(faces);
  for_faces_by_chart(layout, ascending_indices(faces), [&](Index f, const ChartSamples& samples) {
    area[f] = area_of(samples, references(f, samples));
  });
  const double surface = std::accumulate(area.begin(), area.end(), 0.0);
  double charts = 0;
  for (Index f = 0; f < faces; ++f) charts += layout.chart(f).area();
  reference_scale_ = surface > 0 ? surface / charts : 1;
  for_faces_by_chart(layout, std::move(tense), [&](Index f, const ChartSamples& samples) {
    const FaceReference reference = references(f, samples);
    const FramedFace frames = framed(samples, reference);
    weights_[f].plate = frames.empty() ? 1 : 1 - over_reference_[f];
    Eigen::MatrixXd energy = chart_energy(layout, f, samples);
    if (!frames.empty())
      energy += over_reference_[f] * reference_scale_ * metric_plate(samples, reference, frames);
    element_[f] = std::make_shared<const CondensedFace>(condense(layout.places(f), energy));
  });
  return true;
}

std::size_t FaceElements::bytes() const {
  std::set<std::shared_ptr<const CondensedFace>> all(element_.begin(), element_.end());
  std::size_t bytes = 0;
  for (const auto& element : all)
    for (const PaddedMatrix* matrix : {&element->matrix, &element->load, &element->centre, &element->inverse})
      bytes += matrix->value.size() * sizeof(double);
  return bytes;
}

}  // namespace hariko
