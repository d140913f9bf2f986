#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands/command_line/checks.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

void MeshCommandLine::add_to(CLI::App& app) {
  MeshCriteria& criteria = arguments_.options.criteria;
  command_ =
      app.add_subcommand("mesh", "Writes the surfaces of the visible objects as triangles under tolerances");
  command_->add_option("FILE", arguments_.file, "Document, mesh, or file of Bezier patches (*.bpt, *.json)")
      ->required();
  command_
      ->add_option("OUT", arguments_.out, "File to write: *.obj, *.off, *.ply, *.stl, *.3mf, *.glb or *.gltf")
      ->required();
  command_->add_option("--distance", criteria.distance, "Between surface and facets, in the document's unit");
  command_->add_option("--normal", normal_, "Between the normals of surface and facet, degrees");
  command_->add_option("--fold", fold_, "Between neighbouring facets, degrees");
  command_->add_option("--luminance", criteria.luminance, "Difference of brightness, 0 to 1");
  command_->add_option("--max-edge", criteria.max_edge, "Length of edges");
  command_->add_option("--min-angle", min_angle_, "Smallest angle of a facet, degrees");
  command_->add_option("--start", start_, "Whole patches, or cells as long as their curvature lets them be")
      ->check(CLI::IsMember(enum_word_list<MeshStart>()))
      ->capture_default_str();
  command_->add_option("--split", split_, "Which edge is split, and where")
      ->check(CLI::IsMember(enum_word_list<SplitRule>()))
      ->capture_default_str();
  command_->add_flag("--optimise", arguments_.options.optimise, "Fewer facets, in more time");
  command_->add_flag(
      "--balanced", arguments_.options.balanced,
      "Vertices may leave surfaces that bend one way: fewer facets still, by a distance alone");
  command_->add_option("--errors", arguments_.errors,
                       "File to write the error of every facet and sample to: *.csv");
  command_->add_flag("--json", arguments_.json, "Print JSON");
  file_options_.add_to(command_);
}

void MeshCommandLine::check() const {
  if (!written_format(arguments_.out))
    throw CLI::ValidationError("OUT", "the name must end in " + std::string(written_mesh_endings));
  file_options_.check(arguments_.out);
  check_distinct(arguments_.file, arguments_.out);
  if (!arguments_.errors.empty() && arguments_.errors.extension() != ".csv")
    throw CLI::ValidationError("--errors", "the name must end in .csv");
}

MeshArguments MeshCommandLine::arguments(const Construction& construction) const {
  MeshArguments out = arguments_;
  out.file_arguments = file_options_.arguments();
  out.construction = construction;
  const auto radians = [](const std::optional<double>& degrees) {
    return degrees ? std::optional(*degrees * std::numbers::pi / 180) : std::nullopt;
  };
  MeshCriteria& criteria = out.options.criteria;
  criteria.normal_angle = radians(normal_);
  criteria.fold_angle = radians(fold_);
  criteria.min_angle = radians(min_angle_);
  out.options.start = enum_value<MeshStart>(start_).value_or(MeshStart::patches);
  out.options.split = enum_value<SplitRule>(split_).value_or(SplitRule::midpoint);
  out.options.report = MeshReport::all;
  return out;
}

}  // namespace hariko
