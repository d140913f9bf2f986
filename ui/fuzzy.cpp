#include "ui/fuzzy.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "ui/language.hpp"

namespace hariko {

namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double at_word = 9, in_run = 7, ideograph = 5, per_gap = 0.15;
/// Penalty of the first letter of a piece from the middle of a word.
constexpr double in_word = 0.5;
/// Below this mean of points a letter a match is chance.
constexpr double least_mean = 4.5;

std::u32string folded(std::string_view text) {
  std::u32string points = code_points(text);
  for (char32_t& c : points) {
    if (c >= 0xff01 && c <= 0xff5e) c -= 0xfee0;  // full-width forms of ASCII
    if (c >= U'A' && c <= U'Z') c += U'a' - U'A';
  }
  return points;
}

bool is_letter(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'0' && c <= U'9') || c >= 0x80;
}

bool begins_word(const std::u32string& text, std::size_t i) {
  return i == 0 || (is_letter(text[i]) && !is_letter(text[i - 1]));
}

double points_at(const std::u32string& text, std::size_t i) {
  if (begins_word(text, i)) return at_word;
  // Japanese has no spaces: any character may begin a word.
  return text[i] >= 0x2e80 ? ideograph : nothing;
}

/// Points of the word as one piece of the text; 0 where it is none.
double piece_score(const std::u32string& word, const std::u32string& text) {
  double best = 0;
  for (std::size_t at = text.find(word); at != std::u32string::npos; at = text.find(word, at + 1))
    best = std::max(best,
                    std::max(points_at(text, at), in_word) + in_run * static_cast<double>(word.size() - 1));
  return best;
}

/// The best sum of points of all ways to find the word's letters in order, each at the beginning of a word or
/// behind the one before, or all in one piece.
double word_score(const std::u32string& word, const std::u32string& text) {
  if (word.size() > text.size()) return 0;
  std::vector<double> ends(text.size(), nothing), before;  // best sum with the letter so far at this place
  for (std::size_t w = 0; w < word.size(); ++w) {
    before.swap(ends);
    ends.assign(text.size(), nothing);
    double reach = nothing;  // best of `before` up to the letter before the last, less the gap
    for (std::size_t t = 0; t < text.size(); ++t) {
      if (w > 0 && t > 1) reach = std::max(reach, before[t - 2]) - per_gap;
      if (text[t] != word[w]) continue;
      const double points = points_at(text, t);
      if (w == 0) {
        ends[t] = points;
        continue;
      }
      ends[t] = reach + points;
      if (t > 0) ends[t] = std::max(ends[t], before[t - 1] + std::max(points, in_run));
    }
  }
  const double best = std::max(*std::max_element(ends.begin(), ends.end()), piece_score(word, text));
  // So a piece from the middle of a word needs three letters.
  return best >= least_mean * static_cast<double>(word.size()) ? best : 0;
}

}  // namespace

bool holds_words(std::string_view query, std::string_view text) {
  const std::u32string wanted = folded(query), in = folded(text);
  constexpr std::size_t least_letters = 3, least_ideographs = 2;
  bool any = false;
  for (std::size_t i = 0; i < wanted.size();) {
    const std::size_t end = std::min(wanted.find_first_of(U" \u3000", i), wanted.size());
    const std::u32string word = wanted.substr(i, end - i);
    i = end + 1;
    if (word.empty()) continue;
    const bool spaced = word.front() < 0x2e80;
    // "in" and "of" say too little alone.
    any = any || word.size() >= (spaced ? least_letters : least_ideographs);
    bool found = false;
    for (std::size_t at = in.find(word); at != std::u32string::npos && !found; at = in.find(word, at + 1)) {
      const std::size_t after = at + word.size();
      found = !spaced || (begins_word(in, at) && (after == in.size() || !is_letter(in[after])));
    }
    if (!found) return false;
  }
  return any;
}

double fuzzy_score(std::string_view query, std::string_view text) {
  const std::u32string wanted = folded(query), in = folded(text);
  double sum = 0;
  std::size_t words = 0;
  for (std::size_t i = 0; i < wanted.size();) {
    const std::size_t end = std::min(wanted.find_first_of(U" \u3000", i), wanted.size());
    if (end > i) {
      const std::u32string word = wanted.substr(i, end - i);
      double score = word_score(word, in);
      if (score <= 0) return 0;
      if (in.starts_with(word)) score += 3;
      sum += score / static_cast<double>(word.size());
      ++words;
    }
    i = end + 1;
  }
  if (words == 0) return 1;
  // Among equals the shorter text, of which more was typed.
  return sum / static_cast<double>(words) + 1 / (1 + static_cast<double>(in.size()));
}

}  // namespace hariko
