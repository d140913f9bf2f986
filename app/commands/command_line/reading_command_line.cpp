#include "app/commands/command_line/reading_command_line.hpp"

#include <CLI/CLI.hpp>

#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

constexpr const char* usual = "usual";

std::string wrong_tolerance(const std::string& text) {
  double value = 0;
  const bool good = text == usual || (parse_real(text, value) == NumberStatus::ok && value >= 0);
  return good ? std::string() : "should be a length that is not negative, but is " + text;
}

}  // namespace

void ReadingCommandLine::add_to(CLI::App& command) {
  const std::string group = "Meshes of other programs";
  command
      .add_option("--weld", weld_,
                  "Joins corners that are nearly at the same place: up to a distance in the file's numbers, "
                  "1e-6 of each mesh's size where none is given (equal ones are joined always)")
      ->type_name("[TOLERANCE]")
      ->expected(0, 1)
      ->default_str(usual)
      ->check(CLI::Validator(wrong_tolerance, "", "tolerance"))
      ->group(group);
  command.add_flag("--repair", repair_, "Changes meshes that make no polyhedron until they do")->group(group);
  command.add_flag("--reference", reference_, "Keeps meshes that make no polyhedron as facets")->group(group);
}

Reading ReadingCommandLine::reading() const {
  Reading out;
  out.repair = repair_;
  out.reference = reference_;
  out.join.near = weld_ != none;
  double distance = 0;
  if (out.join.near && weld_ != usual && parse_real(weld_, distance) == NumberStatus::ok)
    out.join.distance = distance;
  return out;
}

}  // namespace hariko
