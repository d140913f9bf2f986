#include "app/commands/run_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/file_options.hpp"
#include "app/commands/outline_command_line.hpp"
#include "app/commands/render_command_line.hpp"
#include "app/commands/unfold_command_line.hpp"
#include "core/base/file_ending.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

namespace {

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
    render_.add_to(app_);
    add_construction(render_.command());
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
    const std::initializer_list<const CLI::App*> commands = {info_,     export_, render_.command(),
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
    if (*render_.command()) return render_.run(construction());
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
    mesh_->add_option("--start", start_, "Whole patches, or cells as long as their curvature lets them be")
        ->check(CLI::IsMember({"patches", "cells"}))
        ->capture_default_str();
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
    if (*render_.command()) render_.check();
    if (*export_) check_export();
    if (*export_ && export_arguments_.control && lower_ending(export_arguments_.out) != ".obj")
      throw CLI::ValidationError("--control", "the name must end in .obj");
    if (*mesh_) {
      check_mesh_output(input_, output_);
      if (!errors_.empty() && std::filesystem::path(errors_).extension() != ".csv")
        throw CLI::ValidationError("--errors", "the name must end in .csv");
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
    out.options.start = start_ == "cells" ? MeshStart::cells : MeshStart::patches;
    out.options.split = split_ == "halving"     ? SplitRule::halving
                        : split_ == "gauss"     ? SplitRule::gauss
                        : split_ == "curvature" ? SplitRule::curvature
                                                : SplitRule::midpoint;
    out.options.optimise = optimise_;
    out.options.balanced = balanced_;
    out.options.report = MeshReport::all;
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
  CLI::App *info_ = nullptr, *export_ = nullptr, *evaluate_ = nullptr, *mesh_ = nullptr;
  std::vector<std::string> files_;
  InfoArguments info_arguments_;
  ExportArguments export_arguments_;
  FileOptions file_options_;
  CLI::Option* density_ = nullptr;
  std::vector<CLI::Option*> cad_options_;
  RenderCommandLine render_;
  UnfoldCommandLine unfold_;
  OutlineCommandLine outlines_;
  std::string input_, output_, mode_, tension_;
  std::string start_ = "patches", split_ = "mid", errors_;
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
