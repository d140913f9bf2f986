#include "app/commands/command_line/solids_command_line.hpp"

#include <CLI/CLI.hpp>
#include <limits>

namespace hariko {

void SolidsCommandLine::add_to(CLI::App& command) {
  const std::string group = "Surfaces round solids, instead of what the document says";
  command.add_option("--surround", method_, "Method: ball, or network of curves")
      ->check(CLI::IsMember({"ball", "network"}))
      ->group(group);
  command
      .add_option("--ball-radius", ball_radius_,
                  "Of the ball that rolls over the solids, in the document's unit, or hull")
      ->check(CLI::IsMember({"hull"}) | CLI::PositiveNumber)
      ->group(group);
  command.add_option("--rounding", rounding_, "Length; edges get a radius of 1.5 times this")
      ->check(CLI::PositiveNumber)
      ->group(group);
}

SolidsConstruction SolidsCommandLine::construction() const {
  SolidsConstruction out;
  if (!method_.empty()) out.method = method_ == "ball" ? EnvelopeMethod::ball : EnvelopeMethod::network;
  if (ball_radius_ == "hull")
    out.ball_radius = std::numeric_limits<double>::infinity();
  else if (!ball_radius_.empty())
    out.ball_radius = std::stod(ball_radius_);
  out.rounding = rounding_;
  return out;
}

}  // namespace hariko
