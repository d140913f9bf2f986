#include "app/commands/command_line/construction_command_line.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/console.hpp"
#include "core/document/words.hpp"

namespace hariko {

namespace {

constexpr Code w_option_ignored{"W_OPTION_IGNORED"};

}  // namespace

void ConstructionCommandLine::add_to(CLI::App& command) {
  command.add_option("--mode", mode_, "Construction of the surfaces, instead of the document's")
      ->check(CLI::IsMember(enum_word_list<Mode>()));
  command
      .add_option("--frames", frames_,
                  "Whether angles and lengths of polyhedra and outlines count in modes target, fair and g2")
      ->check(CLI::IsMember(enum_word_list<Frames>()));
  command
      .add_option("--merge-coplanar", merge_coplanar_,
                  "Whether triangles of polyhedra that lie in one plane are merged on the way to the surface")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--round", round_, "Does nothing: mode g2 is round by itself");
  outlines_.add_to(command);
  solids_.add_to(command);
  reading_.add_to(command);
}

Construction ConstructionCommandLine::construction() const {
  Construction out;
  out.mode = enum_value<Mode>(mode_);
  if (round_)
    report("", make_warning(w_option_ignored, "--round has no meaning any more: mode g2 is round by itself.",
                            "Leave the option out."));
  out.frames = enum_value<Frames>(frames_);
  if (!merge_coplanar_.empty()) out.merge_coplanar = merge_coplanar_ == "on";
  out.outlines = outlines_.construction();
  out.solids = solids_.construction();
  out.reading = reading_.reading();
  return out;
}

}  // namespace hariko
