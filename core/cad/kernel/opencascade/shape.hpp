#pragma once

// OpenCASCADE boundary representation of a CAD model. Private to this folder.

#include <TopoDS_Shape.hxx>

#include "core/cad/kernel/cad_file.hpp"

namespace hariko {

/// Solids of the closed shells, looking outward, with their voids (see `cad_shells`), and open shells; a
/// compound where there are several. Faces share edges and vertices by construction; nothing is sewn. Adds to
/// the counts of the report.
TopoDS_Shape shape_of(const CadModel& model, CadFileReport& report);

}  // namespace hariko
