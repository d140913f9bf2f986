#include "app/commands/cad_report_text.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/files/control_mesh_file.hpp"
#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"

namespace hariko {

int run_export(const ExportArguments& arguments) {
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_only(*read, arguments.file_arguments.only);
  if (!document.ok()) {
    report(arguments.file.string(), document.error());
    return exit_failed;
  }
  if (cad_format_of(arguments.out)) {
    CadChoices choices = arguments.cad;
    if (arguments.file_arguments.choices.unit) choices.unit = *arguments.file_arguments.choices.unit;
    choices.scale = arguments.file_arguments.choices.scale;
    const auto written = export_cad(*document, arguments.out, choices, header_time());
    if (!written.ok()) {
      report(arguments.file.string(), written.error());
      return exit_failed;
    }
    for (const Message& warning : warnings_of(*written)) report(arguments.file.string(), warning);
    return print(text_of(*written, document->unit)) ? exit_fine : exit_failed;
  }
  const auto done = arguments.control ? export_control_meshes(*document, arguments.out)
                                      : export_surfaces(*document, arguments.out, arguments.density,
                                                        arguments.file_arguments.choices);
  if (done.ok()) return exit_fine;
  report(arguments.file.string(), done.error());
  return exit_failed;
}

}  // namespace hariko
