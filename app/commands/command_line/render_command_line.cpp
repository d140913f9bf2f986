#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/commands/command_line/checks.hpp"
#include "core/base/files/file_ending.hpp"
#include "core/document/words.hpp"
#include "render/color_map.hpp"
#include "render/picture.hpp"
#include "ui/base/text_number.hpp"

namespace hariko {

namespace {

/// Parses a size in pixels, "1280x960".
std::optional<PixelSize> parse_size(const std::string& text) {
  const auto size = numbers_in<int, 2>(text, 'x');
  const auto fits = [](int side) { return side >= 1 && side <= max_picture_side; };
  if (!size || !std::ranges::all_of(*size, fits)) return std::nullopt;
  return PixelSize{(*size)[0], (*size)[1]};
}

/// Parses a page, "180x120mm", to pixels of 1/96 inch.
std::optional<Vector2> parse_page(std::string_view text) {
  if (!text.ends_with("mm")) return std::nullopt;
  text.remove_suffix(2);
  const auto page = numbers_in<double, 2>(text, 'x');
  const auto fits = [](double side) { return side >= least_page_side && side <= most_page_side; };
  if (!page || !std::ranges::all_of(*page, fits)) return std::nullopt;
  return Vector2(pixels_per_millimetre * Vector2((*page)[0], (*page)[1]));
}

/// Parses a range of map values: "symmetric", "percentile", "full", or "-1,1".
std::optional<MapRange> parse_range(std::string_view text) {
  if (const auto mode = enum_value<RangeMode>(text); mode && mode != RangeMode::manual)
    return MapRange{*mode};
  const auto ends = numbers_in<double, 2>(text, ',');
  if (!ends || !((*ends)[0] < (*ends)[1])) return std::nullopt;
  return MapRange{RangeMode::manual, (*ends)[0], (*ends)[1]};
}

/// Parses a colour, "#b9b4ac".
std::optional<Colour> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t value = 0;
  const auto [stop, status] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  if (status != std::errc() || stop != text.data() + 7) return std::nullopt;
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift); };
  return Colour{byte(16), byte(8), byte(0)};
}

/// Parses a section plane: "x=10", or "-x=10" for the other half.
std::optional<SectionPlane> parse_section(std::string_view text) {
  const bool flipped = !text.empty() && text[0] == '-';
  if (flipped) text.remove_prefix(1);
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=') return std::nullopt;
  const auto offset = number_in<double>(text.substr(2));
  if (!offset) return std::nullopt;
  SectionPlane plane;
  plane.normal = (flipped ? -1.0 : 1.0) * Vector3::Unit(text[0] - 'x');
  plane.offset = flipped ? -*offset : *offset;
  return plane;
}

/// Parses a pull: "x", "-z", "view" (towards the eye), or a direction as "1,0,2".
std::optional<Vector3> parse_pull(std::string_view text, StandardView view) {
  if (text == "view") return Camera::standard(view).towards_eye();
  const double side = text.starts_with('-') ? -1 : 1;
  const std::string_view axis = text.substr(side < 0 ? 1 : 0);
  if (axis == "x" || axis == "y" || axis == "z") return Vector3(side * Vector3::Unit(axis[0] - 'x'));
  return direction_in(text);
}

bool is_png(const std::string& path) {
  return lower_ending(path) == ".png";
}
bool is_svg(const std::string& path) {
  return lower_ending(path) == ".svg";
}

}  // namespace

void RenderCommandLine::add_to(CLI::App& app) {
  command_ = app.add_subcommand(
      "render", "Draws the visible objects, as a PNG picture or as an SVG line drawing, without a display");
  command_->add_option("FILE", file_, "Document or mesh")->required();
  command_->add_option("OUT", out_, "File to write: *.png, or *.svg for lines")->required();
  command_->add_option("--size", size_, "Width and height in pixels, as 1280x960; of *.svg also as 180x120mm")
      ->capture_default_str();
  command_->add_option("--format", format_, "Kind of the picture, where the name of OUT has no such ending")
      ->check(CLI::IsMember({"png", "svg"}));
  CLI::Option* side = command_->add_option("--view", view_, "Direction of view")
                          ->check(CLI::IsMember(enum_word_list<StandardView>()))
                          ->capture_default_str();
  command_
      ->add_option("--saved-view", saved_view_,
                   "Name of a view that was saved in the document, instead of --view")
      ->excludes(side);
  command_->add_option("--section", section_,
                       "Cuts away what is beyond: x=10, y=-2.5, or -z=3 for the other half");
  add_looks();
  add_lines();
}

void RenderCommandLine::add_looks() {
  picture_options_ = {
      command_->add_option("--map", map_, "What colours the surface")
          ->check(CLI::IsMember(surface_map_words()))
          ->capture_default_str(),
      command_->add_option("--pull", pull_,
                           "Of the map draft, where the part leaves its mould: x, -z, view, or X,Y,Z"),
      command_->add_option(
          "--limit", limit_,
          "Of the maps draft, radius and thickness: degrees, or a length in the file's unit"),
      command_->add_option("--deviation-from", arguments_.reference,
                           "Of the map deviation: the object that the others are compared with"),
      command_
          ->add_option(
              "--show", show_,
              "Drawn as well, with commas between: polyhedron, network, tensions, marks (G0, G1, G2), combs")
          ->delimiter(',')
          ->check(CLI::IsMember({"polyhedron", "network", "tensions", "marks", "combs"})),
      command_->add_option("--range", range_, "Of the map: symmetric, percentile, full, or LOW,HIGH")
          ->capture_default_str(),
      command_->add_option("--material", material_, "Instead of each object's own")
          ->check(CLI::IsMember(enum_word_list<Material>())),
      command_->add_option("--colour", colour_, "As #b9b4ac, instead of each object's own"),
      command_
          ->add_option("--wire", wire_,
                       "Lines over the surface: none, borders of patches, or the display mesh")
          ->check(CLI::IsMember(enum_word_list<PatchWire>()))
          ->capture_default_str(),
      command_->add_option("--stripes", arguments_.stripes, "Of zebra and isophotes, 2 to 64")
          ->check(CLI::Range(2, 64))
          ->capture_default_str(),
      command_->add_option(
          "--environment", arguments_.environment,
          "What shaded surfaces reflect: studio, tubes, horizon, overcast, or a panorama as a "
          "Radiance, PNG or JPEG file"),
      command_
          ->add_option("--environment-turn", arguments_.environment_turn,
                       "Degrees about z, anticlockwise from above")
          ->check(CLI::Range(-360.0, 360.0))
          ->capture_default_str(),
      command_->add_option("--exposure", arguments_.exposure, "Of the environment, in stops")
          ->check(CLI::Range(-Environment::most_exposure, Environment::most_exposure))
          ->capture_default_str(),
      command_->add_option("--background", background_, "Of the picture")
          ->check(CLI::IsMember(enum_word_list<Background>()))
          ->capture_default_str(),
      command_->add_flag("--colour-blind-safe", arguments_.colour_blind_safe,
                         "Colours of maps that differ for all kinds of colour vision")};
}

void RenderCommandLine::add_lines() {
  std::vector<std::string> kinds;
  for (const LineKind kind : line_kinds) kinds.emplace_back(to_string(kind));
  drawing_options_ = {
      command_
          ->add_option("--lines", lines_,
                       "Of *.svg, with commas between: silhouette, border, crease, section, network; all "
                       "where nothing is said")
          ->delimiter(',')
          ->check(CLI::IsMember(kinds)),
      command_->add_flag("--hidden", hidden_, "Of *.svg: hidden lines as well, dashed")};
}

void RenderCommandLine::check() const {
  if (!section_.empty() && !parse_section(section_))
    throw CLI::ValidationError("--section", "must be like x=10, y=-2.5 or -z=3");
  if ((is_png(out_) && format_ == "svg") || (is_svg(out_) && format_ == "png"))
    throw CLI::ValidationError("--format", "is another one than that of the name's ending");
  if (is_picture()) return check_picture();
  if (is_drawing()) return check_drawing();
  throw CLI::ValidationError("OUT", "the name must end in .png or .svg, or --format say which it is");
}

bool RenderCommandLine::is_picture() const {
  return format_.empty() ? is_png(out_) : format_ == "png";
}
bool RenderCommandLine::is_drawing() const {
  return format_.empty() ? is_svg(out_) : format_ == "svg";
}

void RenderCommandLine::check_picture() const {
  for (const CLI::Option* option : drawing_options_)
    if (*option) throw CLI::ValidationError(option->get_name(), "is for line drawings, *.svg");
  if (!parse_size(size_))
    throw CLI::ValidationError("--size", "must be like 1280x960, each side from 1 to " +
                                             std::to_string(max_picture_side) + " pixels");
  if (!parse_range(range_))
    throw CLI::ValidationError("--range", "must be symmetric, percentile, full, or two numbers as -1,1");
  if (!colour_.empty() && !parse_colour(colour_))
    throw CLI::ValidationError("--colour", "must be like #b9b4ac");
  check_environment();
  check_making();
}

void RenderCommandLine::check_environment() const {
  const bool named = !arguments_.environment.empty();
  if (named && *surface_map_from(map_) != SurfaceMap::shaded)
    throw CLI::ValidationError("--environment", "is for the map shaded");
  for (const char* option : {"--environment-turn", "--exposure"})
    if (!named && *command_->get_option(option)) throw CLI::ValidationError(option, "needs --environment");
}

void RenderCommandLine::check_making() const {
  if (pull_ == "view" && !saved_view_.empty())
    throw CLI::ValidationError("--pull", "view needs --view; give a direction as 1,0,2 with --saved-view");
  if (!pull_.empty() && !parse_pull(pull_, *standard_view_from(view_)))
    throw CLI::ValidationError("--pull", "must be an axis as x or -z, view, or a direction as 1,0,2");
  if (!limit_) return;
  const SurfaceMap map = *surface_map_from(map_);
  if (!has_limit(map)) throw CLI::ValidationError("--limit", "is for the maps draft, radius and thickness");
  if (map == SurfaceMap::draft && !(*limit_ >= 0 && *limit_ <= MakingSettings::max_draft))
    throw CLI::ValidationError("--limit", "must be 0 to 89 degrees");
  if (map != SurfaceMap::draft && !(*limit_ > 0 && std::isfinite(*limit_)))
    throw CLI::ValidationError("--limit", "must be a length above 0");
}

void RenderCommandLine::check_drawing() const {
  for (const CLI::Option* option : picture_options_)
    if (*option) throw CLI::ValidationError(option->get_name(), "is for pictures, *.png");
  if (!parse_size(size_) && !parse_page(size_))
    throw CLI::ValidationError("--size", "must be like 1280x960, each side from 1 to " +
                                             std::to_string(max_picture_side) +
                                             " pixels, or like 180x120mm, from 10 to 2000 mm");
}

int RenderCommandLine::run(const Construction& construction) const {
  if (is_drawing()) {
    DrawingArguments arguments = drawing();
    arguments.construction = construction;
    return run_drawing(arguments);
  }
  RenderArguments arguments = picture();
  arguments.construction = construction;
  return run_render(arguments);
}

RenderArguments RenderCommandLine::picture() const {
  RenderArguments out = arguments_;
  out.file = file_;
  out.out = out_;
  const PixelSize size = *parse_size(size_);
  out.width = size.width;
  out.height = size.height;
  out.view = *standard_view_from(view_);
  out.saved_view = saved_view_;
  out.map = *surface_map_from(map_);
  const auto shows = [&](const char* item) {
    return std::find(show_.begin(), show_.end(), item) != show_.end();
  };
  out.tensions = shows("tensions");
  out.polyhedron = shows("polyhedron") || out.tensions;
  out.network = shows("network");
  out.marks = shows("marks");
  out.combs = shows("combs");
  out.range = *parse_range(range_);
  if (!pull_.empty()) out.pull = parse_pull(pull_, out.view);
  out.limit = limit_;
  out.wire = enum_value<PatchWire>(wire_).value_or(PatchWire::none);
  out.material = enum_value<Material>(material_);
  if (!colour_.empty()) out.colour = parse_colour(colour_);
  if (!section_.empty()) out.section = parse_section(section_);
  out.background = enum_value<Background>(background_).value_or(Background::dark);
  return out;
}

DrawingArguments RenderCommandLine::drawing() const {
  DrawingArguments out;
  out.file = file_;
  out.out = out_;
  if (const auto page = parse_page(size_)) {
    out.unit = PageUnit::millimetre;
    out.width = page->x();
    out.height = page->y();
  } else {
    const PixelSize size = *parse_size(size_);
    out.width = size.width;
    out.height = size.height;
  }
  out.view = *standard_view_from(view_);
  out.saved_view = saved_view_;
  if (!section_.empty()) out.section = parse_section(section_);
  if (!lines_.empty()) out.lines.kinds.clear();
  for (const std::string& name : lines_) out.lines.kinds.insert(*line_kind_from(name));
  out.lines.hidden = hidden_;
  return out;
}

}  // namespace hariko
