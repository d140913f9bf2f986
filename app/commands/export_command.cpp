#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/export_report.hpp"
#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"

namespace hariko {

namespace {

Result<WrittenMeshes> control_meshes(const Document& document, const std::filesystem::path& out) {
  const auto done = export_control_meshes(document, out);
  if (!done.ok()) return done.error();
  return WrittenMeshes{{}, Vector3::Zero(), left_out_of_control_meshes(document)};
}

}  // namespace

int run_export(const ExportArguments& arguments) {
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_only(*read, arguments.file_arguments.only);
  if (!document.ok()) return failure(arguments.file, document.error());
  if (cad_format_of(arguments.out)) {
    CadChoices choices = arguments.cad;
    if (arguments.file_arguments.choices.unit) choices.unit = *arguments.file_arguments.choices.unit;
    choices.scale = arguments.file_arguments.choices.scale;
    choices.to_zero = arguments.file_arguments.choices.to_zero;
    const auto written = [&] {
      const ProgressLine line(arguments.out, "writing");
      return export_cad(*document, arguments.out, choices, header_time(), {}, line.progress(),
                        arguments.file_arguments.wall);
    }();
    if (!written.ok()) return failure(arguments.file, written.error());
    for (const Message& warning : left_out_of_cad(*document)) report(arguments.file.string(), warning);
    for (const Message& warning : warnings_of(*written)) report(arguments.file.string(), warning);
    return print(text_of(*written, document->unit) + moved_text(written->moved)) ? exit_fine : exit_failed;
  }
  const auto written = [&] {
    const ProgressLine line(arguments.out, "writing");
    return arguments.control ? control_meshes(*document, arguments.out)
                             : export_surfaces(*document, arguments.out, arguments.density,
                                               arguments.file_arguments.choices, {}, line.progress(),
                                               arguments.file_arguments.wall);
  }();
  if (!written.ok()) return failure(arguments.file, written.error());
  for (const Message& warning : written->warnings) report(arguments.file.string(), warning);
  const std::string moved = moved_text(written->moved);
  return moved.empty() || print(moved) ? exit_fine : exit_failed;
}

}  // namespace hariko
