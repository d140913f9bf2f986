#pragma once

// Spelling suggestions: the word that was probably meant.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// Edit distance: the least number of letters to insert, delete, replace, or swap with their neighbour to
/// turn one word into the other (optimal string alignment). O(product of the lengths).
std::size_t spelling_distance(std::string_view a, std::string_view b);

/// Spelling suggestion: the first of the words in `known` that are nearest to `word`, or nothing where none
/// is near, that is, where more than a third of the letters differ. A word that begins with `word` (at least
/// three letters) is near. Leading dashes and case are ignored.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace hariko
