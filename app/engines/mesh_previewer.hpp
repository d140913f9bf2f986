#pragma once

// MeshPreviewer: computes the mesh of the meshing panel, off the main thread; the latest request wins.

#include "app/engines/work_lane.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/meshing.hpp"

namespace hariko {

/// Keeps the meshing panel up to date. For the main thread.
class MeshPreviewer {
 public:
  /// `published`: called when a mesh is ready to be shown.
  MeshPreviewer(Editor& editor, std::function<void()> wake, std::function<void()> published);

  /// Requests a mesh where the panel's settings or the object have changed. Rests during gestures.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle() && !editor_.meshing.job; }

 private:
  void forget();

  Editor& editor_;
  std::function<void()> published_;
  std::shared_ptr<const Object> object_;  ///< object of the last request
  MeshingSettings settings_;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

/// Meshes an object of the document with the given settings and maps the errors. Errors are part of the
/// result; cancelled work returns one without meshes.
MeshingResult preview_mesh(const Document& document, const std::shared_ptr<const Object>& object,
                           const MeshingSettings& settings, const CancelToken& cancel = {},
                           const Progress& progress = {});

}  // namespace hariko
