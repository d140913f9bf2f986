#pragma once

// ExportMemory: what was chosen last in the dialogs of files, for the next session.

#include <map>
#include <string>

#include "ui/files/export_settings.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

struct ExportMemory {
  std::map<std::string, ExportSettings> formats;  ///< by ending, as ".stl"
  CadChoices cad;                                 ///< tolerance 0: nothing was chosen yet
  PictureSettings picture;
  DrawingSettings drawing;
  std::map<std::string, std::string> folders;  ///< folder of the last file, by kind: "import", "cad"

  friend bool operator==(const ExportMemory&, const ExportMemory&) = default;
};

}  // namespace hariko
