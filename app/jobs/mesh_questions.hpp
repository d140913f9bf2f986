#pragma once

// Questions about mesh files: those that make no polyhedron, their faults, and what can be done; and
// meshes that open as they are, but have faults that can be mended while they are opened.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/files/open_file.hpp"
#include "core/exchange/repair/mesh_import.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Answers to the questions about a mesh file, for reading it again.
struct MeshAnswers {
  JoinChoice join = {};        ///< corners to join, and edges to split
  bool turn_parts = false;     ///< turns closed parts that are inside out
  bool repair = false;         ///< repairs a broken mesh
  bool about_corners = false;  ///< the designer has decided about corners nearly at the same place
  bool about_faults = false;   ///< the designer has decided about corners on edges and parts inside out
};

/// The same answers, and a repair of a broken mesh that also splits edges.
MeshAnswers with_repair(MeshAnswers answers);

/// Opens a file as the designer has answered and chosen: `open_file`, `turn_outwards`, `prepare_meshes`.
OpenedFile open_as_answered(const std::filesystem::path& path, const MeshAnswers& answers,
                            const MeshImport& choice, const CancelToken& cancel, const Progress& progress);

/// Reactions to the answers.
struct MeshReactions {
  std::function<void(const MeshAnswers&)> read_again;
  std::function<void()> accept;            ///< the file stays as it was read
  std::function<void(const char*)> asked;  ///< a question is shown: "near_corners", "repairable"
};

/// Asks about corners nearly at the same place, then about corners on edges of other faces and closed parts
/// that are inside out, where a file with a document has some and `answers` does not decide about them.
/// Accepts at once where nothing is to be asked.
void ask_about_faults(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                      const std::shared_ptr<const OpenedFile>& opened, const MeshAnswers& answers,
                      const MeshReactions& reactions);

/// Summary of a repair in the language of the interface: "vertices merged: 12, faces turned: 3".
std::string repair_text(const Language& language, const RepairReport& report);

/// Removes the errors of a mesh that is repaired or kept as facets: what its reader left out is still told.
void forget_errors(OpenedFile& opened);

/// Asks whether a mesh with many faces becomes reference facets, which is the default, or a cage. `accept`
/// gets the document, immediately where no question is needed.
void ask_about_dense_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                          const std::shared_ptr<const OpenedFile>& opened,
                          std::function<void(const Document&)> accept);

/// Note about a mesh that was repaired.
std::string repair_note(const Language& language, const std::filesystem::path& path,
                        const RepairReport& report);

/// Asks whether a broken mesh is repaired or kept as reference facets; offers the answers that the file
/// allows. `accept` gets the document and the note to show with it. Where corners lie on edges of other
/// faces, a repair calls `split_edges` instead, which reads the file again and splits them, too. Where
/// neither is possible the error becomes a notice.
void ask_about_broken_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                           const std::shared_ptr<const OpenedFile>& opened,
                           std::function<void(const Document&, const std::string& note)> accept,
                           std::function<void()> split_edges);

}  // namespace hariko
