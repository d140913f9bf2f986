#pragma once

// Reports on written files, as text. Internal to app/commands.

#include <string>

#include "app/files/export_cad.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Report in lines for people, lengths in the document's unit.
std::string text_of(const CadExportReport& report, Unit unit);

/// Line "moved to zero by -x -y -z" in the file's numbers; empty where nothing moved.
std::string moved_text(const Vector3& moved);

}  // namespace hariko
