#include "app/commands/command_line/solids_command_line.hpp"

#include <CLI/CLI.hpp>
#include <limits>

#include "app/commands/command_line/positive_number.hpp"
#include "core/document/words.hpp"

namespace hariko {

void SolidsCommandLine::add_to(CLI::App& command) {
  const std::string group = "Surfaces round solids, instead of what the document says";
  command.add_option("--surround", method_, "Method: ball, or network of curves")
      ->check(CLI::IsMember(enum_word_list<EnvelopeMethod>()))
      ->group(group);
  command
      .add_option("--ball-radius", ball_radius_,
                  "Of the ball that rolls over the solids, in the document's unit, or hull")
      ->check(CLI::IsMember({"hull"}) | positive_number())
      ->group(group);
  command.add_option("--rounding", rounding_, "Length; edges get a radius of 1.5 times this")
      ->check(positive_number())
      ->group(group);
  command
      .add_option("--on-faces", on_faces_,
                  "Flat faces lie on those of the solids, whose edges then stick out")
      ->check(CLI::IsMember({"on", "off"}))
      ->group(group);
  command.add_option("--finer-patches", finer_, "About twice as many patches, nearer to the shape")
      ->check(CLI::IsMember({"on", "off"}))
      ->group(group);
  command.add_option("--bridge-radius", bridge_radius_, "Of the ball between solids that a bridge joins")
      ->check(positive_number())
      ->group(group);
}

SolidsConstruction SolidsCommandLine::construction() const {
  SolidsConstruction out;
  out.method = enum_value<EnvelopeMethod>(method_);
  if (ball_radius_ == "hull")
    out.ball_radius = std::numeric_limits<double>::infinity();
  else if (!ball_radius_.empty())
    out.ball_radius = std::stod(ball_radius_);
  out.rounding = rounding_;
  if (!on_faces_.empty()) out.on_faces = on_faces_ == "on";
  if (!finer_.empty()) out.finer_patches = finer_ == "on";
  out.bridge_radius = bridge_radius_;
  return out;
}

}  // namespace hariko
