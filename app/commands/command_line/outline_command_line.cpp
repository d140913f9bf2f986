#include "app/commands/command_line/outline_command_line.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/command_line/positive_number.hpp"
#include "core/document/words.hpp"

namespace hariko {

void OutlineCommandLine::add_to(CLI::App& command) {
  const std::string group = "Outlines, instead of what the document says";
  command.add_option("--method", method_, "How the points inside are found")
      ->check(CLI::IsMember(enum_word_list<GaussMode>()))
      ->group(group);
  command.add_option("--sign", sign_, "Of the curvature where it is not given: positive bends to one side")
      ->check(CLI::IsMember(enum_word_list<CurvatureSign>()))
      ->group(group);
  command.add_option("--spacing", spacing_, "Of the points inside, in steps of the outline, 0.01 to 100")
      ->check(CLI::Range(OutlineSettings::smallest_radius, OutlineSettings::largest_radius))
      ->group(group);
  command.add_option("--count", count_, "At most so many points inside, 0 to 20000")
      ->check(CLI::Range(0U, unsigned{OutlineSettings::point_limit}))
      ->group(group);
  command
      .add_option("--gap", gap_,
                  "Largest distance between control points and tangent planes, in the document's unit")
      ->check(positive_number())
      ->group(group);
}

OutlineConstruction OutlineCommandLine::construction() const {
  OutlineConstruction out;
  out.method = enum_value<GaussMode>(method_);
  out.sign = enum_value<CurvatureSign>(sign_);
  out.radius = spacing_;
  if (count_) out.most_points = Index(*count_);
  out.gap = gap_;
  return out;
}

}  // namespace hariko
