#pragma once

// PaperSettings: print settings of a paper model, chosen by the designer.

#include <numbers>
#include <optional>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_paper_setting{"E_PAPER_SETTING"};

/// Width and height of a page, in mm.
struct PaperSize {
  double width = 0, height = 0;
  friend bool operator==(const PaperSize&, const PaperSize&) = default;
};

inline constexpr PaperSize a4_paper{210, 297}, a3_paper{297, 420}, letter_paper{215.9, 279.4};

/// Print settings; lengths in mm, angles in radians.
struct PaperSettings {
  double scale = 1;  ///< mm of paper for one unit of the mesh
  PaperSize page = a4_paper;
  double margin = 10;      ///< free border of each page
  double gap = 2;          ///< between parts on a page
  double tab_height = 5;   ///< height of glue tabs where there is room
  double least_tab = 2;    ///< smallest height of glue tabs; a joint with less room gets a strip
  double strip_width = 8;  ///< width of joint strips
  bool inside = false;  ///< the printed side becomes the inside: mirrored, mountain and valley folds swapped
  double flat_fold = 0.5 * std::numbers::pi / 180;  ///< smaller folds have no line
  std::optional<double> merge_angle = {};  ///< facets with a smaller fold form one polygon that is never cut
  bool fold_angles = false;                ///< fold angles are printed beside the folds, in degrees

  /// Area of the page between the margins.
  PaperSize printable_area() const { return {page.width - 2 * margin, page.height - 2 * margin}; }
  /// Largest extent of a piece's facets, so that tabs have room all round.
  PaperSize piece_room() const {
    return {printable_area().width - 2 * tab_height, printable_area().height - 2 * tab_height};
  }
  friend bool operator==(const PaperSettings&, const PaperSettings&) = default;
};

/// Checks the settings. E_PAPER_SETTING: no room for pieces, pages above 10 m, or a mesh whose longest edge
/// would be shorter than 1e-6 mm or longer than 1e6 mm on paper.
Result<Done> check_settings(const PaperSettings& settings, double longest_edge);

}  // namespace hariko
