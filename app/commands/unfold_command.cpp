#include <algorithm>
#include <memory>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/files/model_facets.hpp"
#include "app/files/sheet_file.hpp"
#include "core/exchange/number_text.hpp"
#include "core/unfolding/cut_large_faces.hpp"
#include "core/unfolding/pages/sheet_drawing.hpp"
#include "core/unfolding/unfolding.hpp"

namespace hariko {

namespace {

/// Millimetres of paper per unit of the mesh. Errors: E_PAPER_SETTING where the model has no extent along the
/// axis of the given size.
Result<double> paper_scale(const UnfoldArguments& arguments, const PolygonMesh& mesh, double millimetres) {
  // Slightly smaller: the packer rotates pieces in steps.
  if (arguments.fit) return 0.998 * largest_uncut_scale(mesh, arguments.settings);
  if (!arguments.size) return millimetres;
  double low = 1e300, high = -1e300;
  for (const Index v : mesh.face_vertices) {
    if (v >= mesh.positions.size()) continue;
    low = std::min(low, mesh.positions[v][arguments.size->axis]);
    high = std::max(high, mesh.positions[v][arguments.size->axis]);
  }
  if (!(high > low))
    return make_error(e_paper_setting, "The model has no extent in the direction whose size is given.",
                      "Give another of --height, --width and --depth.");
  return arguments.size->millimetres / (high - low);
}

std::string summary_json(const Unfolding& unfolding, std::size_t overlaps) {
  std::string out = "{\"facets\":";
  append_integer(out, unfolding.graph->face_count());
  const auto number = [&](const char* name, std::size_t value) {
    out += std::string(",\"") + name + "\":";
    append_integer(out, value);
  };
  const auto real = [&](const char* name, double value) {
    out += std::string(",\"") + name + "\":";
    append_real(out, value);
  };
  number("components", unfolding.graph->component_count());
  number("pieces", unfolding.pieces.size());
  number("pages", unfolding.page_count);
  number("joints", unfolding.joints.size());
  number("tabs", unfolding.joints.size() - strip_count(unfolding));
  number("strips", strip_count(unfolding));
  number("overlaps", overlaps);
  real("paper_use", paper_use(unfolding));
  real("scale", unfolding.settings.scale);
  return out + "}\n";
}

std::string summary_text(const Unfolding& unfolding) {
  const auto count = [](std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  std::string out = count(unfolding.pieces.size(), "piece", "pieces") + " on " +
                    count(unfolding.page_count, "page", "pages") + ", " +
                    count(unfolding.joints.size(), "joint", "joints") + " with " +
                    count(unfolding.joints.size() - strip_count(unfolding), "tab", "tabs") + " and " +
                    count(strip_count(unfolding), "strip", "strips") + ", ";
  return out + std::to_string(static_cast<int>(100 * paper_use(unfolding))) + " % of the paper\n";
}

}  // namespace

int run_unfold(const UnfoldArguments& arguments) {
  const std::string file = arguments.file.string();
  auto facets = [&] {
    const ProgressLine line(arguments.file, "reading");
    return model_facets(arguments.file, arguments.facets, arguments.reading, {}, line.progress());
  }();
  if (!facets.ok()) return failure(arguments.file, facets.error());
  report(file, facets->warnings);
  if (const auto errors = unfolding_errors(facets->mesh); !errors.empty()) {
    report(file, errors);
    return exit_failed;
  }
  PaperSettings settings = arguments.settings;
  const auto scale = paper_scale(arguments, facets->mesh, facets->millimetres_per_unit);
  if (!scale.ok()) return failure(arguments.file, scale.error());
  settings.scale = *scale;
  const auto cut = cut_large_faces(facets->mesh, settings);
  if (!cut.ok()) return failure(arguments.file, cut.error());
  if (cut->cut > 0) report(file, cut_faces_message(cut->cut));
  auto graph = FacetGraph::build(cut->mesh);
  if (!graph.ok()) return failure(arguments.file, graph.error());
  const auto unfolded = [&] {
    const ProgressLine line(arguments.file, "unfolding");
    return unfold(std::make_shared<const FacetGraph>(std::move(graph).value()), settings, arguments.options,
                  {}, line.progress());
  }();
  if (!unfolded.ok()) return failure(arguments.file, unfolded.error());
  const std::vector<Message> messages = unfolding_messages(*unfolded);
  report(file, messages);
  if (std::ranges::any_of(messages,
                          [](const Message& message) { return message.severity == Severity::error; }))
    return exit_failed;
  const SheetDrawing drawing = draw_sheets(*unfolded);
  for (const std::filesystem::path& out : arguments.outs)
    if (const auto written = write_sheet_file(out, drawing); !written.ok())
      return failure(out, written.error());
  const auto overlaps = overlapping_pairs(printed_polygons(*unfolded), paper_tolerance(*unfolded)).size();
  return print(arguments.json ? summary_json(*unfolded, overlaps) : summary_text(*unfolded)) ? exit_fine
                                                                                             : exit_failed;
}

}  // namespace hariko
