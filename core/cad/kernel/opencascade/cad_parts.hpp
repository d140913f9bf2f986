#pragma once

// Parts of a document that the kernel has read, with their names, colours, places and visibility. Private to
// this folder.

#include <TDocStd_Document.hxx>
#include <TopTools_MapOfShape.hxx>
#include <cstddef>
#include <vector>

#include "core/base/result.hpp"
#include "core/cad/kernel/opencascade/sew_faces.hpp"

namespace hariko {

/// Parts of a document, and a count of its visible shapes without faces.
struct CadParts {
  std::vector<CadLeaf> leaves;
  std::size_t curves = 0;  ///< wires, and edges alone
  std::size_t points = 0;  ///< vertices alone
};

/// Collects the parts of a document, each in its place; E_LIMIT where there are more than `max_cad_parts`.
/// `hidden`: shapes, without their places, that the file hides. Bodies of a shape with different colours or
/// visibility are parts of their own. O(size).
Result<CadParts> cad_parts(const Handle(TDocStd_Document) & document, const TopTools_MapOfShape& hidden);

}  // namespace hariko
