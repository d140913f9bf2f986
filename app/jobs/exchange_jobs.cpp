#include "app/jobs/exchange_jobs.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "app/files/export_cad.hpp"
#include "app/files/left_out.hpp"
#include "app/files/prepare_meshes.hpp"
#include "app/files/sheet_file.hpp"
#include "app/jobs/broken_mesh.hpp"
#include "app/jobs/export_triangles.hpp"
#include "core/document/convert_unit.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/files/export_text.hpp"
#include "ui/files/join_request.hpp"

namespace hariko {

void ExchangeJobs::warn(const std::vector<Message>& warnings) {
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, warnings.size()); ++i) editor_.notify(warnings[i]);
}

void ExchangeJobs::import_file(const std::filesystem::path& path, const JoinChoice& join) {
  work_.run_cancellable(
      fill(translatable("Importing {0}"), {path.filename().string()}),
      [path, join, choice = editor_.mesh_import](const CancelToken& cancel, const Progress& progress) {
        OpenedFile opened = open_file(path, cancel, progress, join);
        prepare_meshes(opened, choice);
        return opened;
      },
      [this, path, join](const OpenedFile& opened) {
        const auto take = [this, path, opened] {
          ask_about_dense_mesh(editor_, workbench_, path, std::make_shared<const OpenedFile>(opened),
                               [this, path, opened](const Document& document) {
                                 add_imported(path, document, opened.says_unit, opened.messages);
                               });
        };
        if (opened.document && opened.cleaned.near > 0 && !join.near) {
          log_("near_corners", path);
          return workbench_.ask(join_request(
              editor_.language, path.filename().string(), opened.cleaned, opened.document->unit,
              [this, path](const JoinChoice& chosen) { import_file(path, chosen); }, take));
        }
        if (opened.document) return take();
        if (!opened.broken_mesh) return editor_.notify(*opened.error());
        log_("broken", path);
        ask_about_broken_mesh(
            editor_, workbench_, path, std::make_shared<const OpenedFile>(opened),
            [this, path, says_unit = opened.says_unit](const Document& document, const std::string& note) {
              add_imported(path, document, says_unit, {});
              editor_.notify(Notice::Kind::info, note);
            });
      });
}

void ExchangeJobs::add_imported(const std::filesystem::path& path, const Document& document, bool says_unit,
                                const std::vector<Message>& warnings) {
  if (!editor_.has_document) editor_.open({}, {});
  if (editor_.history.in_gesture()) editor_.cancel_preview();
  const Document& before = editor_.history.current();
  const auto fitting = says_unit ? convert_unit(document, before.unit) : document;
  if (!fitting.ok()) return editor_.notify(fitting.error());
  if (!editor_.commit(append_document(before, *fitting),
                      fill(translatable("Import {0}"), {path.filename().string()})))
    return;
  editor_.tell_script({WrittenCommand{"file.import", {written("path", path.string())}}});
  editor_.selection.clear_elements();
  editor_.selection.active = editor_.document().objects.back()->id;
  editor_.frame_all();
  warn(warnings);
  log_("imported", path);
}

template <class Count, class Take>
void ExchangeJobs::count(Count count, Take take) {
  counting_.cancel();
  counting_ = CancelToken::make();
  work_.run(
      "", [count = std::move(count), counting = counting_](const CancelToken&) { return count(counting); },
      [this, take = std::move(take), counting = counting_](const auto& counted) {
        if (counting.cancelled()) return;
        take(counted);
        log_("export_counted", {});
      });
}

void ExchangeJobs::count_export(const std::filesystem::path& path, const ExportSettings& settings) {
  count([path, settings, document = document_to_export(settings.only_selected)](
            const CancelToken& cancel) { return count_triangles(document, path, settings, cancel); },
        [this, settings](const Result<ExportCount>& counted) {
          workbench_.files().take_export_count(settings, counted);
        });
}

void ExchangeJobs::count_cad(const CadSettings& settings) {
  count([settings, document = document_to_export(settings.only_selected)](
            const CancelToken& cancel) { return hariko::count_cad(document, settings.choices, cancel); },
        [this, settings](const Result<CadTotals>& counted) {
          workbench_.files().take_cad_count(settings, counted);
        });
}

Document ExchangeJobs::document_to_export(bool only_selected) const {
  const Document& document = editor_.history.current();
  if (!only_selected) return document;
  const auto shown = showing_only(document, chosen_ids(editor_));
  HARIKO_ASSERT(shown.ok(), "every object can be hidden");
  return *shown;
}

void ExchangeJobs::export_file(const std::filesystem::path& path, const ExportSettings& settings) {
  counting_.cancel();  // otherwise the file would wait for it
  work_.run_cancellable(
      fill(translatable("Exporting {0}"), {path.filename().string()}),
      [path, settings, document = document_to_export(settings.only_selected)](const CancelToken& cancel,
                                                                              const Progress& progress) {
        return export_triangles(document, path, settings, cancel, progress);
      },
      [this, path, choices = settings.choices,
       unit = editor_.history.current().unit](const Result<ExportReport>& exported) {
        if (!exported.ok()) {
          log_("export_failed", path);
          return editor_.notify(exported.error());
        }
        warn(exported->warnings);
        editor_.notify(Notice::Kind::info, export_text(editor_.language, path, *exported, unit, choices));
        ++editor_.exports;
        log_("exported", path);
      });
}

void ExchangeJobs::export_cad(const std::filesystem::path& path, const CadSettings& settings) {
  counting_.cancel();
  const Unit unit = editor_.document().unit;
  Document document = document_to_export(settings.only_selected);
  std::vector<Message> left_out = left_out_of_cad(document);
  work_.run_cancellable(
      fill(translatable("Exporting {0}"), {path.filename().string()}),
      [path, settings, document = std::move(document)](const CancelToken& cancel, const Progress& progress) {
        return hariko::export_cad(document, path, settings.choices, header_time(), cancel, progress);
      },
      [this, path, unit, left_out = std::move(left_out)](const Result<CadExportReport>& exported) {
        if (!exported.ok()) {
          log_("export_failed", path);
          return editor_.notify(exported.error());
        }
        warn(left_out);
        for (const Message& warning : warnings_of(*exported)) editor_.notify(warning);
        editor_.notify(Notice::Kind::info, cad_export_text(editor_.language, path, totals(exported->objects),
                                                           exported->bytes, unit));
        ++editor_.exports;
        log_("exported", path);
      });
}

void ExchangeJobs::export_pictures(PictureOrder order) {
  const std::size_t count = order.files.size();
  const auto first = order.files.front();
  work_.run_cancellable(
      fill(translatable("Exporting {0}"), {first.filename().string()}),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_pictures(order, cancel, progress);
      },
      [this, first, count](const Result<Done>& written) {
        if (!written.ok()) {
          log_("export_failed", first);
          return editor_.notify(written.error());
        }
        const std::string name = first.filename().string();
        editor_.notify(Notice::Kind::info, count == 1
                                               ? fill(editor_.language("Exported {0}."), {name})
                                               : fill(editor_.language("Exported {0} pictures, {1} first."),
                                                      {std::to_string(count), name}));
        log_("exported", first);
      });
}

void ExchangeJobs::export_drawing(DrawingOrder order) {
  const auto path = order.file;
  work_.run_cancellable(
      fill(translatable("Exporting {0}"), {path.filename().string()}),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_drawing(order, cancel, progress);
      },
      [this, path](const Result<Done>& written) { tell(path, written); });
}

void ExchangeJobs::export_sections(SectionOrder order) {
  const auto path = order.file;
  work_.run_cancellable(
      fill(translatable("Exporting {0}"), {path.filename().string()}),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_sections(order, cancel, progress);
      },
      [this, path](const Result<Done>& written) { tell(path, written); });
}

void ExchangeJobs::tell(const std::filesystem::path& path, const Result<Done>& written) {
  if (!written.ok()) {
    log_("export_failed", path);
    return editor_.notify(written.error());
  }
  editor_.notify(Notice::Kind::info, fill(editor_.language("Exported {0}."), {path.filename().string()}));
  ++editor_.exports;
  log_("exported", path);
}

void ExchangeJobs::export_pages(const std::filesystem::path& path) {
  const auto layout = editor_.paper.layout;
  if (!layout) return;
  work_.run(
      fill(translatable("Exporting {0}"), {path.filename().string()}),
      [path, layout](const CancelToken&) { return write_sheet_file(path, layout->drawing); },
      [this, path](const Result<Done>& written) { tell(path, written); });
}

}  // namespace hariko
