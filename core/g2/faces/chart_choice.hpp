#pragma once

// ChartChoice: the chart of each face, equal ones shared, and the side that it begins with (g2.md section 3).

#include <memory>
#include <vector>

#include "core/g2/faces/face_energy.hpp"
#include "core/g2/faces/tension_weights.hpp"
#include "core/g2/prescribed_ribbons.hpp"
#include "core/network/face_charts.hpp"

namespace hariko {

/// Charts of all faces, and the numbering of their sides.
struct ChartChoice {
  std::vector<std::shared_ptr<const PlacedChart>> placed;  ///< per face
  std::vector<Index> half_edge;  ///< per corner of the face list: the half-edge of that chart side
  std::vector<int> side;         ///< per half-edge: number of its side within its face's chart
};

/// Chooses a chart for each face, beginning with the corner that makes its corners, weights and joins
/// lexicographically least, so that equal faces get equal charts. `corners`: per half-edge. `ribbons`: per
/// half-edge, or empty.
ChartChoice choose_charts(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                          const std::vector<CornerShape>& corners, const TensionWeights& weights,
                          const std::vector<PrescribedRibbon>& ribbons);

}  // namespace hariko
