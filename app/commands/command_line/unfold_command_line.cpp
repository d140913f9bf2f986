#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands/command_line/checks.hpp"
#include "app/files/sheet_file.hpp"
#include "core/document/words.hpp"
#include "ui/base/text_number.hpp"

namespace hariko {

namespace {

/// Parses a paper size: "A4", "A3", "Letter", or "WxH" in mm.
std::optional<PaperSize> parse_paper(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (text == "a4") return a4_paper;
  if (text == "a3") return a3_paper;
  if (text == "letter") return letter_paper;
  const auto size = numbers_in<double, 2>(text, 'x');
  if (!size || !((*size)[0] > 0 && (*size)[1] > 0)) return {};
  return PaperSize{(*size)[0], (*size)[1]};
}

}  // namespace

void UnfoldCommandLine::add_to(CLI::App& app) {
  PaperSettings& settings = arguments_.settings;
  command_ = app.add_subcommand("unfold", "Makes a paper model: pages to print, cut out and glue");
  command_->add_option("FILE", file_, "Mesh or document")->required();
  command_->add_option("OUT", outs_, "Files to write: *.pdf, *.svg, *.dxf, *.png, *.json")->required();
  command_->add_option("--page", page_, "A4, A3, Letter, or WxH in mm")->capture_default_str();
  command_->add_option("--margin", settings.margin, "Round each page, mm")->capture_default_str();
  auto* height = command_->add_option("--height", height_, "Of the model (z), mm")->check(positive_number());
  auto* width = command_->add_option("--width", width_, "Of the model (x), mm")->check(positive_number());
  auto* depth = command_->add_option("--depth", depth_, "Of the model (y), mm")->check(positive_number());
  height->excludes(width)->excludes(depth);
  width->excludes(depth);
  command_
      ->add_flag("--fit", arguments_.fit,
                 "The largest model of which no facet is larger than the page (otherwise such are cut)")
      ->excludes(height)
      ->excludes(width)
      ->excludes(depth);
  command_->add_option("--goal", goal_, "What matters most")
      ->check(CLI::IsMember(enum_word_list<CutGoal>()))
      ->capture_default_str();
  command_->add_option("--method", method_, "search, or paper: the published method, which leaves overlaps")
      ->check(CLI::IsMember({"search", "paper"}))
      ->capture_default_str();
  command_->add_option("--steps", arguments_.options.steps, "Budget of the search")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000'000}))
      ->capture_default_str();
  command_->add_flag("--inside", settings.inside, "The print comes to lie inside the model");
  command_->add_option("--flat-fold", flat_degrees_, "Folds below this angle have no line, degrees")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
  command_->add_option("--merge", merge_degrees_, "Facets that fold less than this are one polygon, degrees")
      ->check(CLI::Range(0.0, 180.0));
  command_->add_option("--tab", settings.tab_height, "Height of glue tabs, mm")->capture_default_str();
  command_
      ->add_option("--least-tab", settings.least_tab,
                   "Where there is no room for a tab of this height there is a strip, mm")
      ->capture_default_str();
  command_->add_flag("--fold-angles", settings.fold_angles, "Write the angle beside each fold");
  command_
      ->add_option("--distance", distance_,
                   "Largest distance between a document's surfaces and the facets (1 % of the size)")
      ->check(positive_number());
  command_->add_option("--normal", normal_degrees_, "Largest angle between their normals, degrees")
      ->check(CLI::Range(0.0, 90.0));
  command_->add_flag("--optimise", arguments_.facets.optimise, "As few facets as can be found: takes long");
  command_->add_flag("--polyhedra", arguments_.facets.of_polyhedra,
                     "The faces of a document's polyhedra as they are, not their surfaces");
  command_->add_flag("--json", arguments_.json, "Print the counts as JSON");
  reading_.add_to(*command_);
}

void UnfoldCommandLine::check() const {
  if (!parse_paper(page_)) throw CLI::ValidationError("--page", "must be A4, A3, Letter, or like 210x297");
  for (const std::string& out : outs_) {
    if (!sheet_format_of(out))
      throw CLI::ValidationError("OUT", "the name must end in .pdf, .svg, .dxf, .png or .json");
    std::error_code ignored;
    if (out == file_ || std::filesystem::equivalent(out, file_, ignored))
      throw CLI::ValidationError("OUT", "must be another file than FILE");
  }
}

UnfoldArguments UnfoldCommandLine::arguments() const {
  constexpr double radians = std::numbers::pi / 180;
  UnfoldArguments out = arguments_;
  out.reading = reading_.reading();
  out.file = file_;
  out.outs.assign(outs_.begin(), outs_.end());
  out.settings.page = *parse_paper(page_);
  out.settings.flat_fold = flat_degrees_ * radians;
  if (merge_degrees_ >= 0) out.settings.merge_angle = merge_degrees_ * radians;
  if (distance_ > 0) out.facets.distance = distance_;
  out.facets.normal_angle = normal_degrees_ * radians;
  if (width_ > 0) out.size = PaperModelSize{0, width_};
  if (depth_ > 0) out.size = PaperModelSize{1, depth_};
  if (height_ > 0) out.size = PaperModelSize{2, height_};
  out.options.goal = enum_value<CutGoal>(goal_).value_or(CutGoal::fewest);
  out.options.method = method_ == "paper" ? CutMethod::reference : CutMethod::search;
  return out;
}

}  // namespace hariko
