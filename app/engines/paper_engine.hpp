#pragma once

// PaperEngine: computes the layout of the document's paper model, off the main thread.

#include <functional>
#include <memory>

#include "app/engines/work_lane.hpp"
#include "app/jobs/background_work.hpp"
#include "core/base/progress.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Facets of a paper model, or the reason why it has none.
struct MadePaperMesh {
  std::shared_ptr<const PaperMesh> mesh;
  PaperFault fault;
};
/// Facets of a paper model. For a worker.
MadePaperMesh make_paper_mesh(const Document& document, const PaperModel& paper, const CancelToken& cancel,
                              const Progress& progress = {});

/// Keeps the paper model's layout up to date. All calls from the main thread.
class PaperEngine {
 public:
  /// `searches`: queue on which searches run, so that they can be cancelled.
  PaperEngine(Editor& editor, BackgroundWork& searches, std::function<void()> wake);

  /// Updates the editor's paper state to the document, and starts a requested search. To be called each
  /// frame. During a gesture the facets wait for its end, unless it changes the paper model itself.
  void sync();
  /// Takes over finished results; returns their number.
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  /// Waits for the worker, for scripts and for tests.
  void wait() { lane_.wait(); }

 private:
  /// Inputs that determine the facets.
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
  std::optional<Source> source_;  ///< inputs of the editor's mesh, or of its fault
  std::optional<Source> asked_;   ///< inputs of the mesh being made
  std::shared_ptr<const PaperModel> asked_model_, faulty_model_;
  std::uint64_t documents_ = 0;
  bool searching_ = false;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
