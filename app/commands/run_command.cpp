#include "app/commands/run_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "core/exchange/mesh_file.hpp"
#include "render/color_map.hpp"
#include "render/picture.hpp"

namespace hariko {

namespace {

std::optional<int> parse_int(std::string_view text) {
  int value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "1280x960"
std::optional<PixelSize> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto width = parse_int(std::string_view(text).substr(0, cross));
  const auto height = parse_int(std::string_view(text).substr(cross + 1));
  const auto fits = [](const std::optional<int>& side) {
    return side && *side >= 1 && *side <= max_picture_side;
  };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return PixelSize{*width, *height};
}

bool is_png(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension == ".png";
}

Mode mode_of(const std::string& word) {
  return word == "paper" ? Mode::paper : word == "target" ? Mode::target : Mode::fair;
}

/// The arguments as strings, and the subcommand that they are for.
class CommandLine {
 public:
  CommandLine()
      : app_("Hariko turns polyhedra into smooth surfaces. Without a command it opens the window.",
             "hariko") {
    app_.set_version_flag("--version", "hariko " HARIKO_VERSION);
    app_.require_subcommand(0, 1);
    app_.add_option("FILE", files_, "Documents or meshes to open in the window");
    add_info();
    add_export();
    add_render();
    add_evaluate();
    app_.footer(
        "Files are Hariko documents (*.hariko) or meshes (*.obj, *.off, *.ply, *.stl).\n"
        "Exit codes: 0 fine, 1 the input or the job failed, 2 wrong usage.");
  }

  /// True when the first word is one that this class answers to; all else is for the window.
  bool answers(std::string_view word) const {
    if (word == "--help" || word == "-h" || word == "--version") return true;
    const auto commands = {info_, export_, render_, evaluate_};
    return std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* command) { return command->get_name() == word; });
  }

  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
      check_combinations();
    } catch (const CLI::ParseError& error) {
      return app_.exit(error) == 0 ? exit_fine : exit_usage;
    }
    if (*info_) return run_info(info_arguments_);
    if (*export_) return run_export(export_arguments_);
    if (*render_) return run_render(render_arguments());
    return run_evaluate(evaluate_arguments());
  }

 private:
  void add_info() {
    info_ = app_.add_subcommand("info", "Describes every object: counts, measures, continuity, messages");
    info_->add_option("FILE", info_arguments_.file, "Document or mesh")->required();
    info_->add_flag("--json", info_arguments_.json, "Print JSON");
  }
  void add_export() {
    export_ = app_.add_subcommand("export", "Writes the surfaces of the visible objects as triangles");
    export_->add_option("FILE", export_arguments_.file, "Document or mesh")->required();
    export_->add_option("OUT", export_arguments_.out, "File to write: *.obj, *.ply or *.stl")->required();
    export_->add_option("--density", export_arguments_.density, "Intervals a patch side, 1 to 256")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
  }
  void add_render() {
    render_ =
        app_.add_subcommand("render", "Draws the visible objects into a PNG picture, without a display");
    render_->add_option("FILE", input_, "Document or mesh")->required();
    render_->add_option("OUT", output_, "Picture to write: *.png")->required();
    render_->add_option("--size", size_, "Width and height in pixels, as 1280x960")->capture_default_str();
    render_->add_option("--view", view_, "Direction of view")
        ->check(CLI::IsMember({"iso", "front", "back", "left", "right", "top", "bottom"}))
        ->capture_default_str();
    render_->add_option("--map", map_, "What colours the surface")
        ->check(CLI::IsMember({"shaded", "patches", "zebra", "gauss", "mean", "k1", "k2", "continuity"}))
        ->capture_default_str();
    render_->add_option("--show", show_, "Drawn as well: polyhedron, network, or both with a comma between")
        ->delimiter(',')
        ->check(CLI::IsMember({"polyhedron", "network"}));
  }
  void add_evaluate() {
    evaluate_ =
        app_.add_subcommand("evaluate", "Prints the network, all control points and sampled points as JSON");
    evaluate_->add_option("FILE", input_, "Document with one polyhedron, or mesh")->required();
    evaluate_->add_option("--mode", mode_, "Construction, instead of the document's")
        ->check(CLI::IsMember({"paper", "target", "fair"}));
    evaluate_->add_option("--tension", tension_, "JSON file with tensions, creases and corners");
  }

  void check_combinations() const {
    if (*export_) {
      const auto format = format_of_extension(export_arguments_.out);
      if (!format || *format == MeshFormat::off)
        throw CLI::ValidationError("OUT", "the name must end in .obj, .ply or .stl");
      check_distinct(export_arguments_.file, export_arguments_.out);
    }
    if (*render_) {
      if (!parse_size(size_))
        throw CLI::ValidationError("--size", "must be like 1280x960, each side from 1 to " +
                                                 std::to_string(max_picture_side) + " pixels");
      if (!is_png(output_)) throw CLI::ValidationError("OUT", "the name must end in .png");
    }
  }
  static void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out) {
    std::error_code ignored;
    if (in == out || std::filesystem::equivalent(in, out, ignored))
      throw CLI::ValidationError("OUT", "must be another file than FILE");
  }

  RenderArguments render_arguments() const {
    RenderArguments out;
    out.file = input_;
    out.out = output_;
    const PixelSize size = *parse_size(size_);
    out.width = size.width;
    out.height = size.height;
    out.view = *standard_view_from(view_);
    out.map = *surface_map_from(map_);
    for (const std::string& item : show_) (item == "network" ? out.network : out.polyhedron) = true;
    return out;
  }
  EvaluateArguments evaluate_arguments() const {
    EvaluateArguments out;
    out.file = input_;
    if (!mode_.empty()) out.mode = mode_of(mode_);
    if (!tension_.empty()) out.tension = tension_;
    return out;
  }

  CLI::App app_;
  CLI::App *info_ = nullptr, *export_ = nullptr, *render_ = nullptr, *evaluate_ = nullptr;
  std::vector<std::string> files_, show_;
  InfoArguments info_arguments_;
  ExportArguments export_arguments_;
  std::string input_, output_, size_ = "1280x960", view_ = "iso", map_ = "shaded", mode_, tension_;
};

}  // namespace

std::optional<int> run_command(int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  CommandLine line;
  if (!line.answers(argv[1])) return std::nullopt;
  return line.run(argc, argv);
}

}  // namespace hariko
