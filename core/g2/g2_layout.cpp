#include "core/g2/g2_layout.hpp"

#include <Eigen/LU>

#include "core/g2/faces/corner_shapes.hpp"

namespace hariko {

namespace {

std::shared_ptr<const G2Atlas> atlas_of(const HalfEdgeMesh& mesh, const ChartChoice& charts) {
  auto atlas = std::make_shared<G2Atlas>();
  for (const auto& placed : charts.placed) atlas->chart.emplace_back(placed, &placed->chart);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    atlas->face.push_back(mesh.face(h));
    atlas->side.push_back(charts.side[h]);
  }
  return atlas;
}

}  // namespace

G2Layout::G2Layout(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
                   const TensionWeights& weights, const std::vector<PrescribedRibbon>& ribbons)
    : mesh_(std::move(mesh)),
      frames_(frames),
      unknowns_(g2_unknowns(*mesh_, frames_)),
      corners_(corner_shapes(*mesh_, frames_)),
      charts_(choose_charts(*mesh_, frames_.charts, corners_, weights, ribbons)),
      atlas_(atlas_of(*mesh_, charts_)) {
  for (const CornerUnknowns& corner : unknowns_.corner) {
    inverse_turn_.push_back(corner.turn.inverse());
    inverse_tangent_turn_.push_back(corner.tangent_turn.inverse());
  }
  incidence_.assign(unknowns_.count, 0);
  for (Index f = 0; f < mesh_->face_count(); ++f)
    for (int i = 0; i < slot_count(f); ++i) ++incidence_[slot_unknown(f, i)];
}

Index G2Layout::slot_unknown(Index face, int slot) const {
  const int n = static_cast<int>(mesh_->side_count(face));
  if (slot < 3 * n) return unknowns_.corner[half_edge(face, slot / 3)].unknown[std::size_t(slot % 3)];
  if (slot < 8 * n)
    return unknowns_.side[half_edge(face, (slot - 3 * n) / 5)].unknown[std::size_t((slot - 3 * n) % 5)];
  return unknowns_.corner[half_edge(face, (slot - 8 * n) / 2)].tangent[std::size_t((slot - 8 * n) % 2)];
}

int G2Layout::turn_column(Index face, int slot, std::array<std::pair<int, double>, 3>& entry) const {
  const int n = static_cast<int>(mesh_->side_count(face));
  if (slot < 3 * n) {
    const Matrix3& turn = unknowns_.corner[half_edge(face, slot / 3)].turn;
    for (int i = 0; i < 3; ++i) entry[std::size_t(i)] = {slot - slot % 3 + i, turn(i, slot % 3)};
    return 3;
  }
  if (slot < 8 * n) {
    const int k = slot - 3 * n;
    entry[0] = {slot, unknowns_.side[half_edge(face, k / 5)].sign[std::size_t(k % 5)]};
    return 1;
  }
  const int k = slot - 8 * n;
  const Eigen::Matrix2d& turn = unknowns_.corner[half_edge(face, k / 2)].tangent_turn;
  for (int i = 0; i < 2; ++i) entry[std::size_t(i)] = {slot - k % 2 + i, turn(i, k % 2)};
  return 2;
}

}  // namespace hariko
