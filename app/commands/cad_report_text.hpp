#pragma once

// Report on a STEP or IGES export, as text.

#include <string>

#include "app/files/export_cad.hpp"

namespace hariko {

/// Report in lines for people, lengths in the document's unit.
std::string text_of(const CadExportReport& report, Unit unit);

}  // namespace hariko
