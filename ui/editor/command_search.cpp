#include "ui/editor/command_search.hpp"

#include <algorithm>
#include <string>

#include "ui/base/fuzzy.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

namespace {

constexpr double of_menu = 0.6, of_english = 0.95, of_other_name = 0.8;
/// Below all that a label gives.
constexpr double in_help = 2;

/// The best of names that stand between commas.
double score_of_names(std::string_view query, std::string_view names) {
  constexpr std::string_view comma = ", ";
  double best = 0;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(comma), names.size());
    best = std::max(best, fuzzy_score(query, names.substr(0, end)));
    names.remove_prefix(std::min(end + comma.size(), names.size()));
  }
  return best;
}

/// Texts of a command in one language.
struct CommandTexts {
  std::string label, path, help, other_names;
};

double score_in(const Command& command, std::string_view query, const CommandTexts& texts) {
  const auto& [label, path, help, other_names] = texts;
  // "view top": words of menu and label together.
  const double both = fuzzy_score(query, path + " " + label);
  // A sentence has many letters: only whole words of it mean something.
  return std::max({fuzzy_score(query, label), of_other_name * score_of_names(query, other_names),
                   both * of_menu, holds_words(query, help) ? in_help : 0,
                   command.keys.empty() ? 0 : (query == command.keys ? 20.0 : 0.0)});
}

}  // namespace

std::vector<const Command*> search_commands(const CommandTable& table, const Language& language,
                                            std::string_view query, std::span<const std::string> recent) {
  std::vector<std::pair<double, const Command*>> found;
  for (const Command& command : table.all()) {
    std::string path, translated_path;
    for (const std::string& folder : menu_folders(command.menu)) {
      path += folder + " ";
      translated_path += language(folder) + " ";
    }
    const CommandTexts translated{language(command.label), translated_path, language(command.help),
                                  language(command.other_names)};
    const CommandTexts english{command.label, path, command.help, command.other_names};
    double score =
        std::max(score_in(command, query, translated), of_english * score_in(command, query, english));
    if (score <= 0) continue;
    const auto used = std::find(recent.begin(), recent.end(), command.id);
    score += 0.5 * static_cast<double>(recent.end() - used) / static_cast<double>(recent.size() + 1);
    found.emplace_back(score, &command);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Command*> out;
  out.reserve(found.size());
  for (const auto& [score, command] : found) out.push_back(command);
  return out;
}

}  // namespace hariko
