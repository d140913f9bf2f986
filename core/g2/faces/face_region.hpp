#pragma once

// FaceRegion: the unknowns of some faces, either all or those in which a drag's response is solved, numbered
// without gaps (g2.md sections 6 and 10).

#include <vector>

#include "core/g2/g2_layout.hpp"

namespace hariko {

/// Faces of a region and the numbering of their unknowns.
struct FaceRegion {
  std::vector<Index> faces;
  std::vector<std::size_t> first_slot;  ///< per face of the region, plus one
  std::vector<Index> slot;         ///< Own number of each slot's unknown; no_index where it is held at zero.
  std::vector<Index> global;       ///< unknown of each own number
  std::vector<double> share;       ///< per own number: 1 / sqrt(number of faces that have it)
  std::vector<std::size_t> begin;  ///< per own number, plus one: its range in `slots`
  std::vector<std::size_t> slots;

  std::size_t size() const { return global.size(); }
};

/// Numbers the unknowns of a region. `given`, per unknown: it has a value already. Unknowns that are given,
/// or shared with faces outside, are held at zero. `faces`: ascending.
FaceRegion face_region(const G2Layout& layout, const std::vector<bool>& given, std::vector<Index> faces);
/// Region of all faces of the mesh.
FaceRegion region_of_all(const G2Layout& layout, const std::vector<bool>& given);

}  // namespace hariko
