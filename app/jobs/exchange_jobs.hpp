#pragma once

// ExchangeJobs: imports and exports of the window, off the main thread.

#include <filesystem>
#include <functional>
#include <vector>

#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/mesh_questions.hpp"
#include "app/jobs/picture_export.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Imports and exports for the main thread. Notices tell about errors and written files.
class ExchangeJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: receives "imported", "broken" (a mesh that needs a repair), "near_corners" and "repairable"
  /// (faults that are asked about), "export_counted", "exported", "control_exported" or "export_failed" when
  /// something is done.
  ExchangeJobs(Editor& editor, Workbench& workbench, BackgroundWork& work, Log log)
      : editor_(editor), workbench_(workbench), work_(work), log_(std::move(log)) {}
  ~ExchangeJobs() { counting_.cancel(); }
  ExchangeJobs(const ExchangeJobs&) = delete;
  ExchangeJobs& operator=(const ExchangeJobs&) = delete;

  /// Adds the objects of a file to the document, as one step. Asks first whether a broken mesh is repaired,
  /// and whether faults of a mesh are mended, unless `answers` decides about these.
  void import_file(const std::filesystem::path& path, const MeshAnswers& answers = {});
  /// Counts the triangles that an export would write, for the dialogs. A running count is cancelled without a
  /// result.
  void count_export(const std::filesystem::path& path, const ExportSettings& settings);
  /// Counts the faces that a CAD export would write; otherwise as `count_export`.
  void count_cad(const CadSettings& settings);
  /// Cancels a running count.
  void cancel_count() { counting_.cancel(); }
  /// Writes the document's triangles.
  void export_file(const std::filesystem::path& path, const ExportSettings& settings);
  /// Writes the document's surfaces as STEP or IGES.
  void export_cad(const std::filesystem::path& path, const CadSettings& settings);
  /// Writes the control meshes of the visible skins.
  void export_control(const std::filesystem::path& path);
  /// Writes pictures.
  void export_pictures(PictureOrder order);
  /// Writes a line drawing.
  void export_drawing(DrawingOrder order);
  /// Writes section curves.
  void export_sections(SectionOrder order);
  /// Writes the pages of the paper model as laid out.
  void export_pages(const std::filesystem::path& path);

 private:
  void import_opened(const std::filesystem::path& path, const std::shared_ptr<const OpenedFile>& opened,
                     const MeshAnswers& answers);
  /// Adds imported objects. Where the file gives its unit they keep their size, otherwise their numbers.
  void add_imported(const std::filesystem::path& path, const Document& document, bool says_unit,
                    const std::vector<Message>& warnings);
  void warn(const std::vector<Message>& warnings);
  /// Handler of a finished export to `path`: an error is shown, else `tell` gets what was written. `event`:
  /// for the log.
  template <class Tell>
  auto when_written(const std::filesystem::path& path, Tell tell, const char* event = "exported");
  /// Shows a notice about a file that was written.
  void tell(const std::filesystem::path& path);
  Document document_to_export(bool only_selected) const;
  /// Runs `count(cancel)` on the worker; `take` gets its result unless it was cancelled.
  template <class Count, class Take>
  void count(Count count, Take take);

  Editor& editor_;
  Workbench& workbench_;
  BackgroundWork& work_;
  Log log_;
  CancelToken counting_;  ///< cancels the last count for a dialog
};

}  // namespace hariko
