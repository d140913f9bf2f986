#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>

#include "app/commands/command_line/checks.hpp"
#include "core/base/files/file_ending.hpp"

namespace hariko {

namespace {

/// Parses a direction: "x", "y", "z", or "1,0,2"; nothing for others and for zero.
std::optional<Vector3> parse_across(std::string_view text) {
  if (text == "x" || text == "y" || text == "z") return Vector3(Vector3::Unit(text[0] - 'x'));
  return direction_in(text);
}

}  // namespace

void SectionsCommandLine::add_to(CLI::App& app) {
  command_ = app.add_subcommand(
      "sections", "Writes the curves in which parallel planes cut the visible objects, with curvature combs");
  command_->add_option("FILE", arguments_.file, "Document or mesh")->required();
  command_->add_option("OUT", arguments_.out, "File to write: *.svg or *.dxf")->required();
  command_->add_option("--across", across_, "Direction of the planes: x, y, z, or X,Y,Z")
      ->capture_default_str();
  command_->add_option("--planes", arguments_.count, "Number of planes")
      ->check(CLI::Range(1, SectionPlanes::most))
      ->capture_default_str();
  command_->add_option("--first", arguments_.first,
                       "Place of the first plane along the direction, in the document's unit");
  command_
      ->add_option("--step", arguments_.spacing,
                   "From plane to plane, in the document's unit; without it they are spread over the model")
      ->check(positive_number());
  command_->add_option("--combs", combs_, "Whether combs are written")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  command_->add_option("--comb-scale", arguments_.combs.scale, "Factor of the length of all teeth")
      ->check(CLI::Range(SectionCombs::least_scale, SectionCombs::most_scale))
      ->capture_default_str();
  command_->add_option("--only", arguments_.only, "Name of an object to cut, instead of all visible ones")
      ->type_name("NAME");
  command_->add_flag("--json", arguments_.json, "Print JSON");
}

void SectionsCommandLine::check() const {
  const std::string ending = lower_ending(arguments_.out);
  if (ending != ".svg" && ending != ".dxf")
    throw CLI::ValidationError("OUT", "the name must end in .svg or .dxf");
  if (!parse_across(across_))
    throw CLI::ValidationError("--across", "must be x, y, z, or three numbers as 1,0,2");
  check_distinct(arguments_.file, arguments_.out);
}

SectionsArguments SectionsCommandLine::arguments(const Construction& construction) const {
  SectionsArguments out = arguments_;
  out.direction = *parse_across(across_);
  out.combs.shown = combs_ == "on";
  out.construction = construction;
  return out;
}

}  // namespace hariko
