#include "app/commands/command_line/construction_command_line.hpp"

#include <CLI/CLI.hpp>

namespace hariko {

namespace {

Mode mode_of(const std::string& word) {
  return word == "paper"    ? Mode::paper
         : word == "target" ? Mode::target
         : word == "g2"     ? Mode::g2
                            : Mode::fair;
}

}  // namespace

void ConstructionCommandLine::add_to(CLI::App& command) {
  command.add_option("--mode", mode_, "Construction of the surfaces, instead of the document's")
      ->check(CLI::IsMember({"paper", "target", "fair", "g2"}));
  command
      .add_option("--frames", frames_,
                  "Whether angles and lengths of the polyhedra count in modes target and fair")
      ->check(CLI::IsMember({"equal", "metric"}));
  command
      .add_option("--merge-coplanar", merge_coplanar_,
                  "Whether triangles of polyhedra that lie in one plane are merged on the way to the surface")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--round", round_, "Mode g2 measures bending over the surface of mode fair");
  outlines_.add_to(command);
  reading_.add_to(command);
}

Construction ConstructionCommandLine::construction() const {
  Construction out;
  if (!mode_.empty()) out.mode = mode_of(mode_);
  out.round = round_;
  if (!frames_.empty()) out.frames = frames_ == "metric" ? Frames::metric : Frames::equal;
  if (!merge_coplanar_.empty()) out.merge_coplanar = merge_coplanar_ == "on";
  out.outlines = outlines_.construction();
  out.reading = reading_.reading();
  return out;
}

}  // namespace hariko
