#pragma once

// OnPaper: the program with its paper view, and where things are on the pages.

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {

class OnPaper : public ::testing::Test, protected ProgramHands {
 protected:
  const PaperLayout& pages() { return *editor().paper.layout; }
  std::size_t pieces() { return pages().unfolding.pieces.size(); }
  std::size_t facets() { return pages().unfolding.graph->facet_count(); }
  /// Page, angle and offset of each piece as it shows.
  std::vector<std::array<double, 4>> places() {
    std::vector<std::array<double, 4>> out;
    for (const PaperPiece& piece : editor().paper.visible()->unfolding.pieces) {
      const PiecePlacement& at = piece.placement;
      out.push_back({double(at.page), at.angle, at.offset.x(), at.offset.y()});
    }
    return out;
  }
  /// Middles of what bears marks of a kind ("folded", "cut", "tab", "piece"), by their numbers.
  std::map<Index, Vector2> marked(const std::string& kind) {
    const std::string prefix = "paper." + kind + ".";
    std::map<Index, Vector2> out;
    for (const auto& [mark, rect] : marks())
      if (mark.starts_with(prefix))
        out.emplace(static_cast<Index>(std::stoul(mark.substr(prefix.size()))), middle_of(mark));
    return out;
  }
  /// The fold whose middle is farthest from all else that a click may mean; no_index where there is none.
  Index lonely_fold() {
    std::vector<Vector2> others;
    for (const char* kind : {"cut", "tab"})
      for (const auto& [number, at] : marked(kind)) others.push_back(at);
    Index best = no_index;
    double most = 0;
    for (const auto& [edge, fold] : marked("folded")) {
      double near = 1e300;
      for (const Vector2& other : others) near = std::min(near, (other - fold).norm());
      if (near > most) most = near, best = edge;
    }
    return best;
  }
};

}  // namespace hariko::test
