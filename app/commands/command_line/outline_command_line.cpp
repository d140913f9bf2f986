#include "app/commands/command_line/outline_command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/document/format/format_names.hpp"

namespace hariko {

namespace {

template <std::size_t N>
std::vector<std::string> words(const std::array<std::string_view, N>& names) {
  return {names.begin(), names.end()};
}

/// Number of a word that the parser accepted; nothing for the empty word.
template <class Enum, std::size_t N>
std::optional<Enum> value_of(const std::string& word, const std::array<std::string_view, N>& names) {
  const auto found = std::find(names.begin(), names.end(), word);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

}  // namespace

void OutlineCommandLine::add_to(CLI::App& command) {
  const std::string group = "Outlines, instead of what the document says";
  command.add_option("--method", method_, "How the points inside are found")
      ->check(CLI::IsMember(words(detail::gauss_names)))
      ->group(group);
  command.add_option("--sign", sign_, "Of the curvature where it is not given: positive bends to one side")
      ->check(CLI::IsMember(words(detail::sign_names)))
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
      ->check(CLI::PositiveNumber)
      ->group(group);
}

OutlineConstruction OutlineCommandLine::construction() const {
  OutlineConstruction out;
  out.method = value_of<GaussMode>(method_, detail::gauss_names);
  out.sign = value_of<CurvatureSign>(sign_, detail::sign_names);
  out.radius = spacing_;
  if (count_) out.most_points = Index(*count_);
  out.gap = gap_;
  return out;
}

}  // namespace hariko
