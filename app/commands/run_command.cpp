#include "app/commands/run_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/file_options.hpp"
#include "app/commands/outline_command_line.hpp"
#include "app/commands/unfold_command_line.hpp"
#include "core/cad/kernel/cad_file.hpp"
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

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || stop != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// "symmetric", "percentile", "full", or "-1,1"
std::optional<MapRange> parse_range(std::string_view text) {
  if (text == "symmetric") return MapRange{RangeMode::symmetric};
  if (text == "percentile") return MapRange{RangeMode::percentile};
  if (text == "full") return MapRange{RangeMode::full};
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto low = parse_number(text.substr(0, comma)), high = parse_number(text.substr(comma + 1));
  if (!low || !high || !(*low < *high)) return std::nullopt;
  return MapRange{RangeMode::manual, *low, *high};
}

/// "#b9b4ac"
std::optional<Colour> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t value = 0;
  const auto [stop, status] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  if (status != std::errc() || stop != text.data() + 7) return std::nullopt;
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift); };
  return Colour{byte(16), byte(8), byte(0)};
}

/// "x=10", or "-x=10" for the other half
std::optional<SectionPlane> parse_section(std::string_view text) {
  const bool flipped = !text.empty() && text[0] == '-';
  if (flipped) text.remove_prefix(1);
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=') return std::nullopt;
  const auto offset = parse_number(text.substr(2));
  if (!offset) return std::nullopt;
  SectionPlane plane;
  plane.normal = (flipped ? -1.0 : 1.0) * Vector3::Unit(text[0] - 'x');
  plane.offset = flipped ? -*offset : *offset;
  return plane;
}

Material material_from(std::string_view word) {
  constexpr std::array<std::string_view, material_count> words{"clay", "porcelain", "metal",
                                                               "wax",  "rubber",    "plastic"};
  return static_cast<Material>(std::find(words.begin(), words.end(), word) - words.begin());
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

bool is_png(const std::string& path) {
  return lower_extension(path) == ".png";
}

Mode mode_of(const std::string& word) {
  return word == "paper"    ? Mode::paper
         : word == "target" ? Mode::target
         : word == "g2"     ? Mode::g2
                            : Mode::fair;
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
    unfold_.add_to(app_);
    add_mesh();
    app_.footer(
        "Files are Hariko documents (*.hariko), meshes (*.obj, *.off, *.ply, *.stl, *.glb, *.gltf, *.3mf), "
        "Bezier patches (*.bpt, *.json) or CAD files (*.step, *.stp, *.iges, *.igs).\n"
        "Exit codes: 0 fine, 1 the input or the job failed, 2 wrong usage.");
  }

  /// True when the first word is one that this class answers to; all else is for the window.
  bool answers(std::string_view word) const {
    if (word == "--help" || word == "-h" || word == "--version") return true;
    const std::initializer_list<const CLI::App*> commands = {info_,     export_, render_,
                                                             evaluate_, mesh_,   unfold_.command()};
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
    info_arguments_.construction = construction();
    if (*info_) return run_info(info_arguments_);
    if (*export_) return run_export(export_arguments());
    if (*render_) return run_render(render_arguments());
    if (*unfold_.command()) return run_unfold(unfold_.arguments());
    if (*mesh_) return run_mesh(mesh_arguments());
    return run_evaluate(evaluate_arguments());
  }

 private:
  void add_info() {
    info_ = app_.add_subcommand("info", "Describes every object: counts, measures, continuity, messages");
    info_->add_option("FILE", info_arguments_.file, "Document or mesh")->required();
    info_->add_flag("--json", info_arguments_.json, "Print JSON");
    info_->add_option("--against", info_arguments_.against,
                      "Another state of the document: how many patches of each surface are the same there");
    add_construction(info_);
  }
  void add_export() {
    export_ =
        app_.add_subcommand("export", "Writes the surfaces of the visible objects, as triangles or for CAD");
    export_->add_option("FILE", export_arguments_.file, "Document or mesh")->required();
    export_
        ->add_option(
            "OUT", export_arguments_.out,
            "File to write: *.obj, *.off, *.ply, *.stl, *.3mf, *.glb, *.gltf, *.step, *.stp, *.iges or *.igs")
        ->required();
    density_ = export_
                   ->add_option("--density", export_arguments_.density,
                                "Of triangles: intervals a patch side, 1 to 256")
                   ->check(CLI::Range(1, 256))
                   ->capture_default_str();
    add_cad();
    export_->add_flag("--control", export_arguments_.control,
                      "Writes the control meshes of skins, with creases, as OBJ instead");
    file_options_.add_to(export_);
    add_construction(export_);
  }
  /// STEP and IGES.
  void add_cad() {
    cad_options_ = {
        export_
            ->add_option("--tolerance", export_arguments_.cad.tolerance,
                         "Of STEP and IGES: between the surface and faces that cannot be exact, in the "
                         "document's unit; 1e-5 of each object's diagonal otherwise")
            ->check(CLI::PositiveNumber),
        export_->add_flag("--ap242", export_arguments_.cad.ap242,
                          "STEP in the newer schema AP242, not AP214")};
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
        ->check(CLI::IsMember(
            {"shaded", "patches", "zebra", "isophotes", "gauss", "mean", "k1", "k2", "continuity"}))
        ->capture_default_str();
    render_
        ->add_option(
            "--show", show_,
            "Drawn as well, with commas between: polyhedron, network, tensions, marks (G0, G1, G2), combs")
        ->delimiter(',')
        ->check(CLI::IsMember({"polyhedron", "network", "tensions", "marks", "combs"}));
    add_render_looks();
    add_construction(render_);
  }
  void add_render_looks() {
    render_->add_option("--range", range_, "Of the map: symmetric, percentile, full, or LOW,HIGH")
        ->capture_default_str();
    render_->add_option("--material", material_, "Instead of each object's own")
        ->check(CLI::IsMember({"clay", "porcelain", "metal", "wax", "rubber", "plastic"}));
    render_->add_option("--colour", colour_, "As #b9b4ac, instead of each object's own");
    render_
        ->add_option("--wire", wire_, "Lines over the surface: none, borders of patches, or the display mesh")
        ->check(CLI::IsMember({"none", "borders", "mesh"}))
        ->capture_default_str();
    render_->add_option("--section", section_,
                        "Cuts away what is beyond: x=10, y=-2.5, or -z=3 for the other half");
    render_->add_option("--stripes", render_arguments_.stripes, "Of zebra and isophotes, 2 to 64")
        ->check(CLI::Range(2, 64))
        ->capture_default_str();
    render_->add_option("--background", background_, "")
        ->check(CLI::IsMember({"dark", "light", "transparent"}))
        ->capture_default_str();
    render_->add_flag("--colour-blind-safe", render_arguments_.colour_blind_safe,
                      "Colours of maps that differ for all kinds of colour vision");
  }
  void add_evaluate() {
    evaluate_ =
        app_.add_subcommand("evaluate", "Prints the network, all control points and sampled points as JSON");
    evaluate_->add_option("FILE", input_, "Document with one polyhedron, or mesh")->required();
    add_construction(evaluate_);
    evaluate_->add_option("--tension", tension_, "JSON file with tensions, creases and corners");
  }

  void add_mesh() {
    mesh_ = app_.add_subcommand("mesh",
                                "Writes the surfaces of the visible objects as triangles under tolerances");
    mesh_->add_option("FILE", input_, "Document, mesh, or file of Bezier patches (*.bpt, *.json)")
        ->required();
    mesh_->add_option("OUT", output_, "File to write: *.obj, *.off, *.ply, *.stl, *.3mf, *.glb or *.gltf")
        ->required();
    mesh_->add_option("--distance", distance_, "Between surface and facets, in the document's unit");
    mesh_->add_option("--normal", normal_, "Between the normals of surface and facet, degrees");
    mesh_->add_option("--fold", fold_, "Between neighbouring facets, degrees");
    mesh_->add_option("--luminance", luminance_, "Difference of brightness, 0 to 1");
    mesh_->add_option("--max-edge", max_edge_, "Length of edges");
    mesh_->add_option("--min-angle", min_angle_, "Smallest angle of a facet, degrees");
    mesh_->add_option("--split", split_, "Which edge is split, and where")
        ->check(CLI::IsMember({"mid", "halving", "gauss", "curvature"}))
        ->capture_default_str();
    mesh_->add_flag("--optimise", optimise_, "Fewer facets, in more time");
    mesh_->add_flag("--balanced", balanced_,
                    "Vertices may leave surfaces that bend one way: fewer facets still, by a distance alone");
    mesh_->add_option("--errors", errors_, "File to write the error of every facet and sample to: *.csv");
    mesh_->add_flag("--json", mesh_json_, "Print JSON");
    file_options_.add_to(mesh_);
    add_construction(mesh_);
  }

  void add_construction(CLI::App* command) {
    command->add_option("--mode", mode_, "Construction of the surfaces, instead of the document's")
        ->check(CLI::IsMember({"paper", "target", "fair", "g2"}));
    command->add_flag("--round", round_, "Mode g2 measures bending over the surface of mode fair");
    outlines_.add_to(*command);
  }
  Construction construction() const {
    Construction out;
    if (!mode_.empty()) out.mode = mode_of(mode_);
    out.round = round_;
    out.outlines = outlines_.construction();
    return out;
  }

  void check_combinations() const {
    if (*unfold_.command()) unfold_.check();
    if (*export_) check_export();
    if (*export_ && export_arguments_.control && lower_extension(export_arguments_.out) != ".obj")
      throw CLI::ValidationError("--control", "the name must end in .obj");
    if (*mesh_) {
      check_mesh_output(input_, output_);
      if (!errors_.empty() && std::filesystem::path(errors_).extension() != ".csv")
        throw CLI::ValidationError("--errors", "the name must end in .csv");
    }
    if (*render_) {
      if (!parse_size(size_))
        throw CLI::ValidationError("--size", "must be like 1280x960, each side from 1 to " +
                                                 std::to_string(max_picture_side) + " pixels");
      if (!parse_range(range_))
        throw CLI::ValidationError("--range", "must be symmetric, percentile, full, or two numbers as -1,1");
      if (!colour_.empty() && !parse_colour(colour_))
        throw CLI::ValidationError("--colour", "must be like #b9b4ac");
      if (!section_.empty() && !parse_section(section_))
        throw CLI::ValidationError("--section", "must be like x=10, y=-2.5 or -z=3");
      if (!is_png(output_)) throw CLI::ValidationError("OUT", "the name must end in .png");
    }
  }
  void check_export() const {
    const bool cad = cad_format_of(export_arguments_.out).has_value();
    if (!cad && !written_format(export_arguments_.out))
      throw CLI::ValidationError("OUT", "the name must end in " + std::string(written_mesh_endings) +
                                            ", or in " + std::string(cad_endings));
    check_distinct(export_arguments_.file, export_arguments_.out);
    file_options_.check(export_arguments_.out);
    if (cad && *density_)
      throw CLI::ValidationError("--density", "is for triangles; STEP and IGES have a --tolerance");
    if (cad && file_options_.arguments().choices.y_up)
      throw CLI::ValidationError("--up", "z is up in STEP and IGES");
    for (const CLI::Option* option : cad_options_)
      if (!cad && *option) throw CLI::ValidationError(option->get_name(), "is for STEP and IGES");
  }
  void check_mesh_output(const std::filesystem::path& in, const std::filesystem::path& out) const {
    if (!written_format(out))
      throw CLI::ValidationError("OUT", "the name must end in " + std::string(written_mesh_endings));
    file_options_.check(out);
    check_distinct(in, out);
  }
  static void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out) {
    std::error_code ignored;
    if (in == out || std::filesystem::equivalent(in, out, ignored))
      throw CLI::ValidationError("OUT", "must be another file than FILE");
  }

  ExportArguments export_arguments() const {
    ExportArguments out = export_arguments_;
    out.file_arguments = file_options_.arguments();
    out.construction = construction();
    return out;
  }
  RenderArguments render_arguments() const {
    RenderArguments out = render_arguments_;
    out.file = input_;
    out.out = output_;
    out.construction = construction();
    const PixelSize size = *parse_size(size_);
    out.width = size.width;
    out.height = size.height;
    out.view = *standard_view_from(view_);
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
    out.wire =
        wire_ == "mesh" ? PatchWire::mesh : (wire_ == "borders" ? PatchWire::borders : PatchWire::none);
    if (!material_.empty()) out.material = material_from(material_);
    if (!colour_.empty()) out.colour = parse_colour(colour_);
    if (!section_.empty()) out.section = parse_section(section_);
    out.background = background_ == "light"         ? Background::light
                     : background_ == "transparent" ? Background::transparent
                                                    : Background::dark;
    return out;
  }
  MeshArguments mesh_arguments() const {
    MeshArguments out;
    out.file = input_;
    out.out = output_;
    out.errors = errors_;
    out.json = mesh_json_;
    out.file_arguments = file_options_.arguments();
    out.construction = construction();
    const auto radians = [](const std::optional<double>& degrees) {
      return degrees ? std::optional(*degrees * std::numbers::pi / 180) : std::nullopt;
    };
    MeshCriteria& criteria = out.options.criteria;
    criteria.distance = distance_;
    criteria.normal_angle = radians(normal_);
    criteria.fold_angle = radians(fold_);
    criteria.luminance = luminance_;
    criteria.max_edge = max_edge_;
    criteria.min_angle = radians(min_angle_);
    out.options.split = split_ == "halving"     ? SplitRule::halving
                        : split_ == "gauss"     ? SplitRule::gauss
                        : split_ == "curvature" ? SplitRule::curvature
                                                : SplitRule::midpoint;
    out.options.optimise = optimise_;
    out.options.balanced = balanced_;
    out.options.measure_all = true;
    return out;
  }
  EvaluateArguments evaluate_arguments() const {
    EvaluateArguments out;
    out.file = input_;
    out.construction = construction();
    if (!tension_.empty()) out.tension = tension_;
    return out;
  }

  CLI::App app_;
  CLI::App *info_ = nullptr, *export_ = nullptr, *render_ = nullptr, *evaluate_ = nullptr, *mesh_ = nullptr;
  std::vector<std::string> files_, show_;
  InfoArguments info_arguments_;
  ExportArguments export_arguments_;
  FileOptions file_options_;
  CLI::Option* density_ = nullptr;
  std::vector<CLI::Option*> cad_options_;
  RenderArguments render_arguments_;
  UnfoldCommandLine unfold_;
  OutlineCommandLine outlines_;
  std::string range_ = "symmetric", material_, colour_, wire_ = "none", section_, background_ = "dark";
  std::string input_, output_, size_ = "1280x960", view_ = "iso", map_ = "shaded", mode_, tension_;
  std::string split_ = "mid", errors_;
  std::optional<double> distance_, normal_, fold_, luminance_, max_edge_, min_angle_;
  bool round_ = false, mesh_json_ = false, optimise_ = false, balanced_ = false;
};

}  // namespace

std::optional<int> run_command(int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  CommandLine line;
  if (!line.answers(argv[1])) return std::nullopt;
  return line.run(argc, argv);
}

}  // namespace hariko
