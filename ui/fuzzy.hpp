#pragma once

// Fuzzy search: how well a few typed letters stand for a text.

#include <string_view>

namespace hariko {

/// 0 when the text does not match; higher is better. Every word of the query must be found, its letters in
/// order: in one piece, or at the beginnings of words ("fs" finds "Frame selection"). Letters that are merely
/// strewn over the text do not match. Upper and lower case are the same. Both are UTF-8. An empty query
/// matches everything equally. O(query · text) characters.
double fuzzy_score(std::string_view query, std::string_view text);

/// Whether a sentence has every word of the query, whole, and one of them has at least three letters, or two
/// characters of a script without spaces, which may stand anywhere. False for an empty query.
bool holds_words(std::string_view query, std::string_view text);

}  // namespace hariko
