#pragma once

// Text in lines: where sentences may be broken, also in Japanese, which has no spaces.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// Width of a piece of text, in the unit of the width that is asked for.
using MeasureText = std::function<float(std::string_view)>;

/// Cuts a text at its line feeds and where a line would be wider than `width`: at spaces, and between
/// Japanese characters unless a line would begin with what closes or prolongs (kinsoku: no "。", "）", "ー"
/// or small kana first) or end with an opening bracket. A word that is too wide for a line keeps its own
/// line. Spaces at the cuts go. O(pieces), each measured once or twice.
std::vector<std::string> lines_of(std::string_view text, float width, const MeasureText& measure);

/// The lines joined again, for where ImGui draws the text: a tooltip, a label of a card. At most `most`
/// lines, of which the last one ends with an ellipsis where something is left out.
std::string in_lines(std::string_view text, float width, std::size_t most = 100);

/// "2026-11-21 07:30" in local time.
std::string local_time_text(std::int64_t unix_seconds);

}  // namespace hariko
