#pragma once

// PaperSettings: how a paper model is to be printed. Authored by the designer.

#include <numbers>
#include <optional>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_paper_setting{"E_PAPER_SETTING"};

/// Width and height of paper, in mm.
struct PaperSize {
  double width = 0, height = 0;
  friend bool operator==(const PaperSize&, const PaperSize&) = default;
};

inline constexpr PaperSize a4_paper{210, 297}, a3_paper{297, 420}, letter_paper{215.9, 279.4};

/// Lengths in mm, angles in radians.
struct PaperSettings {
  double scale = 1;  ///< mm of paper for one unit of the mesh
  PaperSize page = a4_paper;
  double margin = 10;      ///< round each page, free of pieces
  double gap = 2;          ///< between things on a page
  double tab_height = 5;   ///< of glue tabs with room
  double least_tab = 2;    ///< of glue tabs; where there is no room for that a joint has a strip
  double strip_width = 8;  ///< of joint strips
  bool inside = false;     ///< what is printed comes to lie inside: mirrored, mountains and valleys swapped
  double flat_fold = 0.5 * std::numbers::pi / 180;  ///< smaller folds have no line
  std::optional<double> merge_angle = {};  ///< facets that fold no more than this are one polygon, never cut
  bool fold_angles = false;                ///< written beside the folds, in degrees

  /// What is left between the margins.
  PaperSize printable() const { return {page.width - 2 * margin, page.height - 2 * margin}; }
  /// What the facets of a piece may take, so that tabs have room all round.
  PaperSize piece_room() const {
    return {printable().width - 2 * tab_height, printable().height - 2 * tab_height};
  }
  friend bool operator==(const PaperSettings&, const PaperSettings&) = default;
};

/// E_PAPER_SETTING where lengths make no page: no room for pieces, pages above 10 m, or a mesh of which the
/// longest edge would be shorter than 1e-6 mm or longer than 1e6 mm on paper.
Result<Done> check_settings(const PaperSettings& settings, double longest_edge);

}  // namespace hariko
