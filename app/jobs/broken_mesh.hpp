#pragma once

// A mesh file that makes no polyhedron: what is wrong with it, and what can be done.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/files/open_file.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// "vertices merged: 12, faces turned: 3": what a repair did, in the language of the interface.
std::string repair_text(const Language& language, const RepairReport& report);

/// Asks whether a mesh of many faces is to be reference facets, which is the default, or a cage. `accept`
/// gets the document. Where it need not be asked it is the document at once.
void ask_about_dense_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                          const std::shared_ptr<const OpenedFile>& opened,
                          std::function<void(const Document&)> accept);

/// Asks whether the mesh is to be repaired or kept as reference facets; the answers are offered as far as the
/// file allows them. `accept` gets the document and what is to be told about it then. Where nothing can be
/// done the error is a notice.
void ask_about_broken_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                           const std::shared_ptr<const OpenedFile>& opened,
                           std::function<void(const Document&, const std::string& note)> accept);

}  // namespace hariko
