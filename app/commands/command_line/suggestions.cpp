#include "app/commands/command_line/suggestions.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

std::string did_you_mean(const std::optional<std::string>& word) {
  return word ? "\nDid you mean '" + *word + "'?" : std::string();
}

/// Long names of all options that the help shows.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options({}))
    for (const std::string& name : option->get_lnames())
      if (!option->get_group().empty()) names.push_back("--" + name);
  return names;
}

}  // namespace

std::optional<std::string> unknown_command(const CLI::App& app, const std::string& word) {
  const std::filesystem::path path(word);
  std::error_code unknown;  // an inaccessible file counts as missing
  if (path.has_extension() || path.has_parent_path() || std::filesystem::exists(path, unknown))
    return std::nullopt;
  std::vector<std::string> known{"--help", "--version"};  // also offered to people who type `hariko help`
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == word) return std::nullopt;
    known.push_back(command->get_name());
  }
  return "'" + shortened(word, 120) + "' is neither a command nor a file." +
         did_you_mean(nearest_word(word, known));
}

std::string suggested_option(const CLI::App& app) {
  std::vector<const CLI::App*> places{&app};
  for (const CLI::App* command : app.get_subcommands()) places.push_back(command);
  for (const CLI::App* place : places)
    for (const std::string& word : place->remaining())
      if (word.starts_with('-'))
        return did_you_mean(nearest_word(word.substr(0, word.find('=')), option_names(*place)));
  return {};
}

}  // namespace hariko
