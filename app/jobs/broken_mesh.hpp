#pragma once

// Dialogs about mesh files that make no polyhedron: their faults, and what can be done.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/files/open_file.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Summary of a repair in the language of the interface: "vertices merged: 12, faces turned: 3".
std::string repair_text(const Language& language, const RepairReport& report);

/// Asks whether a mesh with many faces becomes reference facets, which is the default, or a cage. `accept`
/// gets the document, immediately where no question is needed.
void ask_about_dense_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                          const std::shared_ptr<const OpenedFile>& opened,
                          std::function<void(const Document&)> accept);

/// Asks whether a broken mesh is repaired or kept as reference facets; offers the answers that the file
/// allows. `accept` gets the document and the note to show with it. Where neither is possible the error
/// becomes a notice.
void ask_about_broken_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                           const std::shared_ptr<const OpenedFile>& opened,
                           std::function<void(const Document&, const std::string& note)> accept);

}  // namespace hariko
