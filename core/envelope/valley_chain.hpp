#pragma once

// The vertices that an edge of the hull gets on its way through the notches between two solids (spec 3.1b.1 -
// 3.1b.5).

#include <map>

#include "core/envelope/valley_cage.hpp"

namespace hariko {

/// Equal labels belong to one valley, or to corners of one solid above one valley.
struct ValleyLabel {
  Index low = no_index, high = no_index;  ///< authored solids; for corners their own solid and the other one
  bool corner = false;
  friend auto operator<=>(const ValleyLabel&, const ValleyLabel&) = default;
};

struct ChainVertex {
  CageVertex vertex;
  ValleyLabel label;
};

/// Of edges low - high of the hull, from low to high.
using ValleyChains = std::map<std::pair<Index, Index>, std::vector<ChainVertex>>;

ValleyChains valley_chains(const NetworkCage& hull, const ValleyCageInput& input);

}  // namespace hariko
