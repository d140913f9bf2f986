#include "app/commands/command_line/run_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

#include "app/commands/command_line/checks.hpp"
#include "app/commands/command_line/construction_command_line.hpp"
#include "app/commands/command_line/standard_streams.hpp"
#include "app/commands/command_line/subcommand_lines.hpp"
#include "app/commands/command_line/suggestions.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

/// Parser of all arguments, and the command that they select.
class CommandLine {
 public:
  CommandLine()
      : app_("Hariko turns polyhedra into smooth surfaces. Without a command it opens the window.",
             "hariko") {
    app_.set_version_flag("--version", "hariko " HARIKO_VERSION);
    app_.require_subcommand(0, 1);
    window_.add_to(app_);
    add_info();
    export_.add_to(app_);
    render_.add_to(app_);
    mesh_.add_to(app_);
    sections_.add_to(app_);
    add_evaluate();
    unfold_.add_to(app_);
    script_.add_to(app_, streams_);
    add_sample_pictures();
    for (CLI::App* command :
         {info_, export_.command(), render_.command(), mesh_.command(), sections_.command(), evaluate_})
      construction_.add_to(*command);
    for (CLI::App* command : {info_, export_.command(), render_.command(), mesh_.command(),
                              sections_.command(), evaluate_, unfold_.command()})
      streams_.add_to(*command);
    for (CLI::App* command : app_.get_subcommands({}))
      for (CLI::Option* option : command->get_options())
        if (option->get_type_name().starts_with("FLOAT")) option->check(finite_number());
    app_.footer(
        "Files are Hariko documents (*.hariko), meshes (*.obj, *.off, *.ply, *.stl, *.glb, *.gltf, *.3mf), "
        "Bezier patches (*.bpt, *.json) or CAD files (*.step, *.stp, *.iges, *.igs).\n"
        "- as FILE or OUT is the standard input or output.\n"
        "`hariko COMMAND --help` describes the options of a command.\n"
        "Exit codes: 0 fine, 1 the input or the job failed, 2 wrong usage.");
  }

  /// See `run_command`.
  std::variant<int, WindowOptions> run(int argc, char** argv) {
    try {
      // Checks the command before errors in its own arguments are reported.
      if (argc > 1) check_first_word(argv[1]);
      parse(argc, argv);
      check_combinations();
    } catch (const CLI::ParseError& error) {
      return app_.exit(error) == 0 ? exit_fine : exit_usage;
    }
    const Construction construction = construction_.construction();
    info_arguments_.construction = evaluate_arguments_.construction = construction;
    if (*info_) return run_info(info_arguments_);
    if (*export_.command()) return streams_.finish(run_export(export_.arguments(construction)));
    if (*render_.command()) return streams_.finish(render_.run(construction));
    if (*unfold_.command()) return streams_.finish(run_unfold(unfold_.arguments()));
    if (*mesh_.command()) return streams_.finish(run_mesh(mesh_.arguments(construction)));
    if (*sections_.command()) return streams_.finish(run_sections(sections_.arguments(construction)));
    if (*evaluate_) return run_evaluate(evaluate_arguments_);
    if (*script_.command()) return streams_.finish(script_.run());
    if (*pictures_) return run_sample_pictures(assets_, pictures_folder_);
    report_missing(window_.options());
    return window_.options();
  }

 private:
  void add_info() {
    info_ = app_.add_subcommand("info", "Describes every object: counts, measures, continuity, messages");
    info_->add_option("FILE", info_arguments_.file, "Document or mesh")->required();
    info_->add_flag("--json", info_arguments_.json, "Print JSON");
    info_->add_option("--against", info_arguments_.against,
                      "Another state of the document: how many patches of each surface are the same there");
  }
  void add_evaluate() {
    evaluate_ =
        app_.add_subcommand("evaluate", "Prints the network, all control points and sampled points as JSON");
    evaluate_->add_option("FILE", evaluate_arguments_.file, "Document with one polyhedron, or mesh")
        ->required();
    evaluate_->add_option("--tension", evaluate_arguments_.tension,
                          "JSON file with tensions, creases and corners");
  }

  /// Adds the command that only the build uses.
  void add_sample_pictures() {
    pictures_ = app_.add_subcommand("sample-pictures", "Draws the pictures of the start page")->group("");
    pictures_->add_option("ASSETS", assets_, "The program's data")->required();
    pictures_->add_option("OUT", pictures_folder_, "Folder of the pictures")->required();
  }

  void parse(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ExtrasError& error) {
      throw CLI::ParseError(error.what() + suggested_option(app_), exit_usage);
    }
  }

  void check_first_word(const std::string& word) const {
    if (word.starts_with('-')) return;
    if (const auto why = unknown_command(app_, word)) throw CLI::ParseError(*why, exit_usage);
  }
  void check_combinations() const {
    for (const CLI::App* command : app_.get_subcommands()) window_.check_nothing_said(*command);
    streams_.check();
    if (*export_.command()) export_.check();
    if (*unfold_.command()) unfold_.check();
    if (*render_.command()) render_.check();
    if (*mesh_.command()) mesh_.check();
    if (*sections_.command()) sections_.check();
    if (*script_.command()) script_.check();
    // A mistyped command may also follow the window's options.
    if (const auto& files = window_.options().files; !files.empty()) check_first_word(files.front().string());
  }

  /// Reports missing files in the terminal, where names are typed; the window reports them too, as it may
  /// have been started from a menu.
  static void report_missing(const WindowOptions& options) {
    for (const std::filesystem::path& file : options.files) {
      std::error_code unknown;
      if (!std::filesystem::exists(file, unknown))
        report(sanitized_utf8(file.string()), make_error(e_file_open, "There is no such file.",
                                                         "Check its name and the folder that it lies in."));
    }
  }

  CLI::App app_;
  CLI::App *info_ = nullptr, *evaluate_ = nullptr, *pictures_ = nullptr;
  InfoArguments info_arguments_;
  EvaluateArguments evaluate_arguments_;
  std::filesystem::path assets_, pictures_folder_;
  WindowCommandLine window_;
  ExportCommandLine export_;
  MeshCommandLine mesh_;
  SectionsCommandLine sections_;
  RenderCommandLine render_;
  UnfoldCommandLine unfold_;
  ScriptCommandLine script_;
  ConstructionCommandLine construction_;
  StandardStreams streams_;
};

}  // namespace

std::variant<int, WindowOptions> run_command(int argc, char** argv) {
  return CommandLine().run(argc, argv);
}

}  // namespace hariko
