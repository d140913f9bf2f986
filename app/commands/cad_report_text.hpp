#pragma once

// What was written as STEP or IGES, for people.

#include <string>

#include "app/files/export_cad.hpp"

namespace hariko {

/// The report in lines for people, lengths in the document's unit.
std::string text_of(const CadExportReport& report, Unit unit);

}  // namespace hariko
