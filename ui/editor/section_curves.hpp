#pragma once

// SectionCurves: the curves of several section planes through all visible surfaces, as the window has them.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/message.hpp"
#include "core/drawing/section_set.hpp"
#include "render/surface_lines.hpp"

namespace hariko {

class Editor;

/// Display of section curves: a part of the interface, not of the document.
struct SectionCurves {
  bool shown = false;
  bool placed = false;  ///< the planes were spread or chosen once
  SectionPlanes planes;
  SectionCombs combs;

  // Made by the application while they are shown; empty before.
  std::shared_ptr<const SectionSet> set;
  std::shared_ptr<const FacetLines> lines, teeth;  ///< null where there are none
  std::optional<Message> error;                    ///< reason why there are no curves

  void forget() {
    set.reset();
    lines.reset();
    teeth.reset();
    error.reset();
  }
};

/// Lines to draw of the curves, or of their combs with a scale; null where there are none. O(points).
std::shared_ptr<const FacetLines> drawn_section_lines(const SectionSet& set);
std::shared_ptr<const FacetLines> drawn_section_teeth(const SectionSet& set, const SectionCombs& combs);

/// Surfaces and reference facets of the visible objects that show them, as far as they are ready.
std::vector<DrawnSurface> surfaces_to_cut(const Editor& editor);

/// Around all that is visible and can be cut.
Box3 box_to_cut(const Editor& editor);
/// Planes in the middles of equal slices of what is visible, with the direction and number of `planes`;
/// unchanged where nothing is visible.
SectionPlanes spread_over_visible(const Editor& editor, const SectionPlanes& planes);

/// Section curves to be made and written as a file, as a value that needs no window.
struct SectionOrder {
  std::vector<DrawnSurface> surfaces;
  SectionPlanes planes;
  SectionCombs combs;
  double millimetres = 1;      ///< in the document's unit
  std::filesystem::path file;  ///< *.svg or *.dxf
};
/// Errors: E_NOTHING_TO_SHOW where no surface is visible, E_SURFACE_PENDING while one is being computed.
Result<SectionOrder> order_sections(const Editor& editor, const std::filesystem::path& file);

}  // namespace hariko
