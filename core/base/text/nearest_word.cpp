#include "core/base/text/nearest_word.hpp"

#include <algorithm>

namespace hariko {

namespace {

/// Word without leading dashes, with ASCII letters in lower case.
std::string bare(std::string_view word) {
  word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
  std::string out(word);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace

std::size_t spelling_distance(std::string_view a, std::string_view b) {
  // Rows of the distance table for the last two letters of `a` and for this one.
  std::vector<std::size_t> older(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], older[j - 2] + 1);
    }
    std::swap(older, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t least_beginning = 3, longest = 100;  // `longest`: longer inputs are not words
  const std::string given = bare(word);
  if (given.empty() || given.size() > longest) return std::nullopt;
  const std::size_t most = std::max<std::size_t>(1, given.size() / 3);
  std::optional<std::string> nearest;
  std::size_t nearest_distance = most + 1;
  for (const std::string& candidate : known) {
    const std::string other = bare(candidate);
    const bool begun = given.size() >= least_beginning && other.starts_with(given);
    const std::size_t distance = begun ? 1 : spelling_distance(given, other);
    if (distance >= nearest_distance) continue;
    nearest_distance = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace hariko
