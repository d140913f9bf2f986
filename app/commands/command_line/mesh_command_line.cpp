#include "app/commands/command_line/mesh_command_line.hpp"

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands/command_line/distinct_files.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

void MeshCommandLine::add_to(CLI::App& app) {
  command_ =
      app.add_subcommand("mesh", "Writes the surfaces of the visible objects as triangles under tolerances");
  command_->add_option("FILE", file_, "Document, mesh, or file of Bezier patches (*.bpt, *.json)")
      ->required();
  command_->add_option("OUT", out_, "File to write: *.obj, *.off, *.ply, *.stl, *.3mf, *.glb or *.gltf")
      ->required();
  command_->add_option("--distance", distance_, "Between surface and facets, in the document's unit");
  command_->add_option("--normal", normal_, "Between the normals of surface and facet, degrees");
  command_->add_option("--fold", fold_, "Between neighbouring facets, degrees");
  command_->add_option("--luminance", luminance_, "Difference of brightness, 0 to 1");
  command_->add_option("--max-edge", max_edge_, "Length of edges");
  command_->add_option("--min-angle", min_angle_, "Smallest angle of a facet, degrees");
  command_->add_option("--start", start_, "Whole patches, or cells as long as their curvature lets them be")
      ->check(CLI::IsMember(enum_word_list<MeshStart>()))
      ->capture_default_str();
  command_->add_option("--split", split_, "Which edge is split, and where")
      ->check(CLI::IsMember(enum_word_list<SplitRule>()))
      ->capture_default_str();
  command_->add_flag("--optimise", optimise_, "Fewer facets, in more time");
  command_->add_flag(
      "--balanced", balanced_,
      "Vertices may leave surfaces that bend one way: fewer facets still, by a distance alone");
  command_->add_option("--errors", errors_, "File to write the error of every facet and sample to: *.csv");
  command_->add_flag("--json", json_, "Print JSON");
  file_options_.add_to(command_);
}

void MeshCommandLine::check() const {
  if (!written_format(out_))
    throw CLI::ValidationError("OUT", "the name must end in " + std::string(written_mesh_endings));
  file_options_.check(out_);
  check_distinct(file_, out_);
  if (!errors_.empty() && std::filesystem::path(errors_).extension() != ".csv")
    throw CLI::ValidationError("--errors", "the name must end in .csv");
}

MeshArguments MeshCommandLine::arguments(const Construction& construction) const {
  MeshArguments out;
  out.file = file_;
  out.out = out_;
  out.errors = errors_;
  out.json = json_;
  out.file_arguments = file_options_.arguments();
  out.construction = construction;
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
  out.options.start = enum_value<MeshStart>(start_).value_or(MeshStart::patches);
  out.options.split = enum_value<SplitRule>(split_).value_or(SplitRule::midpoint);
  out.options.optimise = optimise_;
  out.options.balanced = balanced_;
  out.options.report = MeshReport::all;
  return out;
}

}  // namespace hariko
