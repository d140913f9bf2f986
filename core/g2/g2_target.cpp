#include "core/g2/g2_target.hpp"

#include <algorithm>
#include <limits>

#include "core/base/index_list.hpp"
#include "core/g2/curvature_target.hpp"

namespace hariko {

namespace {

/// Number of sides above which faces in equal frames have no target curvature: the reference is too far from
/// the visible surface.
constexpr Index largest_equal_target_side_count = 6;
/// Smoothing length of target curvatures, in widths of a face.
constexpr double smoothing_width = 0.4;

/// Weight of the target. In equal frames it is zero where a vertex of the face has edges of very different
/// lengths, as the reference has no good curvature there.
double target_share(const G2Layout& layout, Index face, std::span<const Vector3> positions) {
  const HalfEdgeMesh& mesh = layout.mesh();
  if (layout.frames().charts.frames == Frames::metric) return 1;
  if (mesh.side_count(face) > largest_equal_target_side_count) return 0;
  double largest = 1;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    const auto add = [&](Index edge) {
      const double length = (positions[mesh.target(edge)] - positions[mesh.origin(edge)]).norm();
      low = std::min(low, length);
      high = std::max(high, length);
    };
    for (const Index g : mesh.fan_corners(mesh.origin(h))) {
      add(g);
      add(mesh.previous(g));
    }
    if (high > 0) largest = std::max(largest, high / low);
  }
  return std::clamp((8 - largest) / 3, 0.0, 1.0);
}

/// Splits the load: the centre's coefficients minimise the energy with their part of it.
void split_load(const ControlPlaces& places, const CondensedFace& element, const std::vector<Vector3>& load,
                FaceTarget& out) {
  std::vector<Vector3> centre(places.centre.size());
  for (std::size_t i = 0; i < centre.size(); ++i) centre[i] = load[std::size_t(places.centre[i])];
  const PaddedMatrix& by_unknowns = element.centre;
  for (std::size_t i = 0; i < places.unknown.size(); ++i) {
    Vector3 sum = load[std::size_t(places.unknown[i])];
    for (std::size_t k = 0; k < centre.size(); ++k)
      sum += by_unknowns.value[i * by_unknowns.stride + k] * centre[k];
    out.load[i] = sum;
  }
  multiply(element.inverse, centre.data(), out.centre.data());
}

bool touches_sharp_edge(const G2Layout& layout, Index face) {
  const HalfEdgeMesh& mesh = layout.mesh();
  bool any = false;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h)
    any = any || layout.frames().sharp[mesh.edge(h)];
  return any;
}

}  // namespace

G2Target curvature_target(const G2Layout& layout, const FaceElements& elements,
                          const FaceReferences& references, std::span<const Vector3> positions,
                          const FaceReferences* at_sharp_edges) {
  G2Target out(layout.mesh().face_count());
  std::vector<Index> faces = ascending_indices(layout.mesh().face_count());
  for_faces_by_chart(layout, std::move(faces), [&](Index f, const ChartSamples& samples) {
    const ControlPlaces& places = layout.places(f);
    out[f].load.assign(places.unknown.size(), Vector3::Zero());
    out[f].centre.assign(places.centre.size(), Vector3::Zero());
    const double share = target_share(layout, f, positions);
    if (share == 0) return;
    const bool by_sharp = at_sharp_edges && touches_sharp_edge(layout, f);
    const FaceReference reference = (by_sharp ? *at_sharp_edges : references)(f, samples);
    const FramedFace own = framed(samples, reference);
    if (own.empty()) return;
    FramedFace smooth = own;
    smooth_forms(samples, smoothing_width, smooth);
    const double over = elements.over_reference(f);
    std::vector<Vector3> load =
        chart_load(samples, reference, own, smooth, (1 - over) * share, elements.weights(f).measure);
    // In equal frames the reference's second derivatives are too rough for it.
    if (layout.frames().charts.frames == Frames::metric) {
      const std::vector<Vector3> third = third_load(
          samples, reference, own, smooth, (1 - over) * elements.third(), elements.weights(f).measure);
      for (std::size_t i = 0; i < load.size(); ++i) load[i] += third[i];
    }
    if (over > 0) {
      const std::vector<Vector3> more = metric_load(samples, reference, smooth);
      for (std::size_t i = 0; i < load.size(); ++i) load[i] += over * elements.reference_scale() * more[i];
    }
    split_load(places, elements[f], load, out[f]);
  });
  return out;
}

}  // namespace hariko
