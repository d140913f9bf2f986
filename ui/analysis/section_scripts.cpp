// Use of section curves in scripts.

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/files/file_ending.hpp"
#include "ui/analysis/section_curve_edits.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

constexpr const char* across_words[] = {"x", "y", "z"};

/// Planes and combs as a script gives them; those that it leaves out stay or are spread over the model.
void set_sections(Editor& editor, const Arguments& given) {
  SectionCurves& curves = editor.sections;
  curves.planes.direction =
      Vector3::Unit(std::find(std::begin(across_words), std::end(across_words), given.text("across")) -
                    std::begin(across_words));
  curves.planes.count = given.whole("planes");
  spread_sections(editor);
  if (given.has("spacing")) {
    // Without a first place the set stays in the middle.
    curves.planes.first +=
        0.5 * (curves.planes.spacing - given.number("spacing")) * (curves.planes.count - 1);
    curves.planes.spacing = given.number("spacing");
  }
  if (given.has("first")) curves.planes.first = given.number("first");
  curves.combs.shown = given.on("combs");
  curves.combs.scale = given.number("scale");
  curves.shown = true;
}

void export_by_script(CommandHost& host, const std::string& path) {
  const std::string ending = lower_ending(path);
  if (ending != ".svg" && ending != ".dxf")
    return host.editor.notify(make_error(e_argument,
                                         "The name of the section curves must end in .svg or .dxf.",
                                         "`hariko run --list` says what each command takes."));
  auto order = order_sections(host.editor, path);
  if (!order) return host.editor.notify(order.error());
  host.application.export_sections(std::move(order).value());
}

}  // namespace

void use_sections_in_scripts(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.use_in_scripts(
      "analyse.section_curves",
      {.arguments = {word_argument("across", "the direction of the planes",
                                   {std::begin(across_words), std::end(across_words)}, "x"),
                     whole_argument("planes", "how many", 7, 1, SectionPlanes::most),
                     optional(length_argument("first", "place of the first plane; else they are spread", {})),
                     optional(length_argument("spacing", "from plane to plane; else they are spread", {},
                                              least_section_spacing)),
                     on_off_argument("combs", "teeth as long as the curvature", true),
                     number_argument("scale", "factor of the teeth", 1, SectionCombs::least_scale,
                                     SectionCombs::most_scale)},
       .run = [&editor](const Arguments& given) { set_sections(editor, given); }});
  host.table.use_in_scripts(
      "analyse.section_export",
      {.arguments = {path_argument("path", "*.svg or *.dxf")},
       .run = [&host](const Arguments& given) { export_by_script(host, given.text("path")); },
       .looks_at_surfaces = true});
}

}  // namespace hariko
