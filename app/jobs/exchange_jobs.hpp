#pragma once

// ExchangeJobs: imports and exports of the window, off the main thread.

#include <filesystem>
#include <functional>
#include <vector>

#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/drawing_export.hpp"
#include "app/jobs/picture_export.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Imports and exports for the main thread. Notices tell about errors and written files.
class ExchangeJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: receives "imported", "broken" (a mesh that needs a repair), "export_counted", "exported" or
  /// "export_failed" when something is done.
  ExchangeJobs(Editor& editor, Workbench& workbench, BackgroundWork& work, Log log)
      : editor_(editor), workbench_(workbench), work_(work), log_(std::move(log)) {}
  ~ExchangeJobs() { counting_.cancel(); }
  ExchangeJobs(const ExchangeJobs&) = delete;
  ExchangeJobs& operator=(const ExchangeJobs&) = delete;

  /// Adds the objects of a file to the document, as one step. Asks first whether a broken mesh is repaired,
  /// or corners that are nearly at the same place are joined, unless `join` decides it.
  void import_file(const std::filesystem::path& path, const JoinChoice& join = {});
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
  /// Writes pictures.
  void export_pictures(PictureOrder order);
  /// Writes a line drawing.
  void export_drawing(DrawingOrder order);
  /// Writes section curves.
  void export_sections(SectionOrder order);
  /// Writes the pages of the paper model as laid out.
  void export_pages(const std::filesystem::path& path);

 private:
  /// Adds imported objects. Where the file gives its unit they keep their size, otherwise their numbers.
  void add_imported(const std::filesystem::path& path, const Document& document, bool says_unit,
                    const std::vector<Message>& warnings);
  void warn(const std::vector<Message>& warnings);
  /// Shows a notice about a file that was written, or not.
  void tell(const std::filesystem::path& path, const Result<Done>& written);
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
