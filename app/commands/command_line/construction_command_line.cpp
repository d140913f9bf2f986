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
  command.add_flag("--round", round_, "Mode g2 measures bending over the surface of mode fair");
  outlines_.add_to(command);
  solids_.add_to(command);
  reading_.add_to(command);
}

Construction ConstructionCommandLine::construction() const {
  Construction out;
  if (!mode_.empty()) out.mode = mode_of(mode_);
  out.round = round_;
  if (!frames_.empty()) out.frames = frames_ == "metric" ? Frames::metric : Frames::equal;
  out.outlines = outlines_.construction();
  out.solids = solids_.construction();
  out.reading = reading_.reading();
  return out;
}

}  // namespace hariko
