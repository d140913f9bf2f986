#include "core/g2/g2_system.hpp"

#include <set>

#include "core/g2/faces/face_blocks.hpp"
#include "core/g2/g2_controls.hpp"

namespace hariko {

G2System::G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
                   const G2Weights& weights, const std::vector<PrescribedRibbon>& ribbons)
    : G2System(mesh, network.frames(), tension_weights(*mesh, network, weights), weights.third, ribbons) {}

G2System::G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
                   const TensionWeights& weights, double third, const std::vector<PrescribedRibbon>& ribbons)
    : layout_(std::move(mesh), frames, weights, ribbons),
      elements_(layout_, weights, third),
      blocks_(face_blocks(layout_, elements_)),
      joined_(given_unknowns(layout_.mesh(), layout_.frames(), layout_.unknowns(), ribbons)) {
  const HalfEdgeMesh& topology = layout_.mesh();
  for (Index h = 0; h < ribbons.size(); ++h) {
    if (ribbons[h] == PrescribedRibbon::none) continue;
    joined_vertex_.resize(topology.vertex_count());
    joined_vertex_[topology.origin(h)] = joined_vertex_[topology.target(h)] = true;
  }
  fix_tangents({});
}

void G2System::fix_tangents(const std::vector<bool>& vertices) {
  fixed_ = vertices;
  if (fixed_.empty()) fixed_ = joined_vertex_;
  for (Index v = 0; v < joined_vertex_.size(); ++v)
    if (joined_vertex_[v]) fixed_[v] = true;
  given_ = joined_;
  for (Index h = 0; !fixed_.empty() && h < mesh().half_edge_count(); ++h) {
    if (!fixed_[mesh().origin(h)]) continue;
    const CornerUnknowns& corner = layout_.unknowns().corner[h];
    given_[corner.tangent[0]] = true;
    if (!is_straight(layout_.frames().step[h])) given_[corner.tangent[1]] = true;
  }
  whole_ = std::make_shared<const FaceRegion>(region_of_all(layout_, given_));
}

G2System::References G2System::over(ReferencePatches patches) const {
  return [this, patches = std::move(patches)](Index face, const ChartSamples& samples) {
    return reference_of_patches(samples, patches, [&](int side) { return layout_.half_edge(face, side); });
  };
}

G2System::References G2System::over(std::shared_ptr<const G2PatchSet> surface) const {
  return [surface = std::move(surface)](Index face, const ChartSamples& samples) {
    return reference_of_controls(samples, surface->face(face));
  };
}

void G2System::bend_over(const References& references) {
  if (elements_.bend_over(layout_, references)) blocks_ = face_blocks(layout_, elements_);
}

G2Face G2System::controls(Index face, const Given& given, const Field& unknowns) const {
  return face_controls(layout_, elements_[face], face, given, unknowns);
}

Network G2System::network_of(const Given& given, const Field& unknowns) const {
  return surface_network(layout_, given, unknowns);
}

std::size_t G2System::matrix_bytes() const {
  std::size_t bytes = elements_.bytes();
  for (const auto& block : std::set<std::shared_ptr<const PaddedMatrix>>(blocks_.begin(), blocks_.end()))
    bytes += block->value.size() * sizeof(double);
  return bytes;
}

}  // namespace hariko
