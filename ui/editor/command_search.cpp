#include "ui/editor/command_search.hpp"

#include <algorithm>

#include "ui/base/fuzzy.hpp"
#include "ui/editor/menu_tree.hpp"

namespace hariko {

namespace {

constexpr double of_menu = 0.6, of_english = 0.95;
/// Below all that a label gives.
constexpr double in_help = 2;

double score_in(const Command& command, std::string_view query, const std::string& label,
                const std::string& path, const std::string& help) {
  // "view top": words of menu and label together.
  const double both = fuzzy_score(query, path + " " + label);
  // A sentence has many letters: only whole words of it mean something.
  return std::max({fuzzy_score(query, label), both * of_menu, holds_words(query, help) ? in_help : 0,
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
    double score =
        std::max(score_in(command, query, language(command.label), translated_path, language(command.help)),
                 of_english * score_in(command, query, command.label, path, command.help));
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
