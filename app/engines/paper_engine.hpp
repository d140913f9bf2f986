#pragma once

// PaperEngine: keeps the layout of the document's paper model, off the main thread.

#include <functional>
#include <memory>

#include "app/engines/work_lane.hpp"
#include "app/jobs/background_work.hpp"
#include "core/base/progress.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// The facets of a paper model, or why it has none. For a worker.
struct MadePaperMesh {
  std::shared_ptr<const PaperMesh> mesh;
  PaperFault fault;
};
MadePaperMesh make_paper_mesh(const Document& document, const PaperModel& paper, const CancelToken& cancel,
                              const Progress& progress = {});

/// Everything here runs on the main thread but the work itself.
class PaperEngine {
 public:
  /// Searches run among the work on files, where they can be cancelled.
  PaperEngine(Editor& editor, BackgroundWork& searches, std::function<void()> wake);

  /// Brings the editor's paper state up to the document, and begins a search that was asked for. Call each
  /// frame. In a gesture the facets wait for its end, unless it changes the paper model itself.
  void sync();
  /// Takes over what workers finished. Returns how much.
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }

 private:
  /// What the facets were made from.
  struct Source {
    std::vector<std::shared_ptr<const Object>> objects;
    Unit unit = Unit::millimetre;
    bool of_polyhedra = false;
    double distance = 0, normal_angle = 0;
    std::vector<ObjectId> wanted;
  };
  static PaperModel choices_of_search(const Document& document);
  static Source source_of(const Document& document, const PaperModel& paper);
  static bool same_objects(const Source& a, const Source& b);
  static bool same(const Source& a, const Source& b);
  void lay_out(const Document& document, bool mesh_anew);
  void search();
  void take_mesh(const MadePaperMesh& made, const Source& source);

  Editor& editor_;
  BackgroundWork& searches_;
  std::optional<Source> source_;  ///< of the editor's mesh, or of its fault
  std::optional<Source> asked_;   ///< of the mesh being made
  std::shared_ptr<const PaperModel> asked_model_, faulty_model_;
  std::uint64_t documents_ = 0;
  bool searching_ = false;
  WorkLane lane_;  ///< last: its thread stops before the rest goes
};

}  // namespace hariko
