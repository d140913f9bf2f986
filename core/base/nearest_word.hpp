#pragma once

// Spelling: the word that was probably meant.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// The least number of letters to insert, leave out, replace, or swap with their neighbour to make one word
/// of the other (optimal string alignment). O(product of the lengths).
std::size_t spelling_distance(std::string_view a, std::string_view b);

/// The first of the words in `known` that are nearest to `word`; nothing where none is near: more than a
/// third of its letters differ. What begins with `word` (at least three letters) is near. Dashes in front and
/// capitals do not count.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace hariko
