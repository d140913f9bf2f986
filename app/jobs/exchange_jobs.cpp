#include "app/jobs/exchange_jobs.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "app/files/sheet_file.hpp"
#include "app/jobs/export_triangles.hpp"
#include "app/jobs/mesh_questions.hpp"
#include "core/document/convert_unit.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/files/export_text.hpp"

namespace hariko {

namespace {

Phrase exporting(const std::filesystem::path& path) {
  return Phrase(translatable("Exporting {0}"), {path.filename().string()});
}

}  // namespace

template <class Tell>
auto ExchangeJobs::when_written(const std::filesystem::path& path, Tell tell, const char* event) {
  return [this, path, tell = std::move(tell), event](const auto& written) {
    if (!written.ok()) {
      log_("export_failed", path);
      return editor_.notify(written.error());
    }
    tell(*written);
    log_(event, path);
  };
}

void ExchangeJobs::warn(const std::vector<Message>& warnings) {
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, warnings.size()); ++i) editor_.notify(warnings[i]);
}

void ExchangeJobs::import_file(const std::filesystem::path& path, const MeshAnswers& answers) {
  work_.run_cancellable(
      Phrase(translatable("Importing {0}"), {path.filename().string()}),
      [path, answers, choice = editor_.mesh_import](const CancelToken& cancel, const Progress& progress) {
        return open_as_answered(path, answers, choice, cancel, progress);
      },
      [this, path, answers, begun = editor_.has_document,
       documents = editor_.documents](const OpenedFile& opened) {
        if (begun && documents != editor_.documents && (opened.document || opened.broken_mesh))
          return editor_.warn({"{0} was not imported, as another document was opened meanwhile.",
                               {path.filename().string()}});
        import_opened(path, std::make_shared<const OpenedFile>(opened), answers);
      });
}

void ExchangeJobs::import_opened(const std::filesystem::path& path,
                                 const std::shared_ptr<const OpenedFile>& opened,
                                 const MeshAnswers& answers) {
  if (opened->document) {
    MeshReactions reactions;
    reactions.read_again = [this, path](const MeshAnswers& decided) { import_file(path, decided); };
    reactions.accept = [this, path, opened] {
      ask_about_dense_mesh(editor_, workbench_, path, opened, [this, path, opened](const Document& document) {
        add_imported(path, document, opened->says_unit, opened->messages);
      });
    };
    reactions.asked = [this, path](const char* what) { log_(what, path); };
    return ask_about_faults(editor_, workbench_, path, opened, answers, reactions);
  }
  if (!opened->broken_mesh) return editor_.notify(*opened->error());
  const auto accept = [this, path, opened](const Document& document, const std::string& note) {
    OpenedFile mended = *opened;
    forget_errors(mended);
    add_imported(path, document, mended.says_unit, mended.messages);
    editor_.notify(Notice::Kind::info, note);
  };
  if (answers.repair && opened->repaired)
    return accept(*opened->repaired, repair_note(editor_.language, path, opened->repair));
  log_("broken", path);
  ask_about_broken_mesh(editor_, workbench_, path, opened, accept,
                        [this, path, answers] { import_file(path, with_repair(answers)); });
}

void ExchangeJobs::add_imported(const std::filesystem::path& path, const Document& document, bool says_unit,
                                const std::vector<Message>& warnings) {
  if (!editor_.has_document) editor_.open({}, {});
  if (editor_.history.in_gesture()) editor_.cancel_preview();
  const Document& before = editor_.history.current();
  const auto fitting = says_unit ? convert_unit(document, before.unit) : document;
  if (!fitting.ok()) return editor_.notify(fitting.error());
  if (!editor_.commit(append_document(before, *fitting),
                      Phrase(translatable("Import {0}"), {path.filename().string()})))
    return;
  editor_.tell_script({WrittenCommand{"file.import", {written("path", path.string())}}});
  editor_.selection.clear_elements();
  editor_.selection.clear_objects();
  // A document may bring saved views alone.
  if (!fitting->objects.empty()) editor_.selection.active = editor_.document().objects.back()->id;
  editor_.frame_all();
  warn(warnings);
  if (const auto left = left_out_of_import(document)) editor_.notify(*left);
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
  count(
      [settings, document = document_to_export(settings.only_selected)](const CancelToken& cancel) {
        return hariko::count_cad(document, settings.choices, cancel, settings.wall);
      },
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
      exporting(path),
      [path, settings, document = document_to_export(settings.only_selected)](const CancelToken& cancel,
                                                                              const Progress& progress) {
        return export_triangles(document, path, settings, cancel, progress);
      },
      when_written(path, [this, path, choices = settings.choices,
                          unit = editor_.history.current().unit](const ExportReport& exported) {
        warn(exported.warnings);
        editor_.notify(Notice::Kind::info, export_text(editor_.language, path, exported, unit, choices));
        ++editor_.exports;
      }));
}

void ExchangeJobs::export_cad(const std::filesystem::path& path, const CadSettings& settings) {
  counting_.cancel();
  const Unit unit = editor_.document().unit;
  Document document = document_to_export(settings.only_selected);
  std::vector<Message> left_out = left_out_of_cad(document);
  work_.run_cancellable(
      exporting(path),
      [path, settings, document = std::move(document)](const CancelToken& cancel, const Progress& progress) {
        return hariko::export_cad(document, path, settings.choices, header_time(), cancel, progress,
                                  settings.wall);
      },
      when_written(path, [this, path, unit, left_out = std::move(left_out)](const CadExportReport& exported) {
        warn(left_out);
        for (const Message& warning : warnings_of(exported)) editor_.notify(warning);
        editor_.notify(Notice::Kind::info, cad_export_text(editor_.language, path, totals(exported.objects),
                                                           exported.bytes, unit));
        ++editor_.exports;
      }));
}

void ExchangeJobs::export_control(const std::filesystem::path& path) {
  const Document& document = editor_.history.current();
  work_.run(
      exporting(path), [path, document](const CancelToken&) { return export_control_meshes(document, path); },
      when_written(
          path,
          [this, path, left_out = left_out_of_control_meshes(document)](const Done&) {
            for (const Message& warning : left_out) editor_.notify(warning);
            tell(path);
          },
          "control_exported"));
}

void ExchangeJobs::export_pictures(PictureOrder order) {
  const std::size_t count = order.files.size();
  const auto first = order.files.front();
  work_.run_cancellable(
      exporting(first),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_pictures(order, cancel, progress);
      },
      when_written(first, [this, first, count](const Done&) {
        const std::string name = first.filename().string();
        editor_.inform(count == 1
                           ? Phrase("Exported {0}.", {name})
                           : Phrase("Exported {0} pictures, {1} first.", {std::to_string(count), name}));
      }));
}

void ExchangeJobs::export_drawing(DrawingOrder order) {
  const auto path = order.file;
  work_.run_cancellable(
      exporting(path),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_drawing(order, cancel, progress);
      },
      when_written(path, [this, path](const Done&) { tell(path); }));
}

void ExchangeJobs::export_sections(SectionOrder order) {
  const auto path = order.file;
  work_.run_cancellable(
      exporting(path),
      [order = std::move(order)](const CancelToken& cancel, const Progress& progress) {
        return write_sections(order, cancel, progress);
      },
      when_written(path, [this, path](const Done&) { tell(path); }));
}

void ExchangeJobs::tell(const std::filesystem::path& path) {
  editor_.inform({"Exported {0}.", {path.filename().string()}});
  ++editor_.exports;
}

void ExchangeJobs::export_pages(const std::filesystem::path& path) {
  const auto layout = editor_.paper.layout;
  if (!layout) return;
  work_.run(
      exporting(path), [path, layout](const CancelToken&) { return write_sheet_file(path, layout->drawing); },
      when_written(path, [this, path](const Done&) { tell(path); }));
}

}  // namespace hariko
