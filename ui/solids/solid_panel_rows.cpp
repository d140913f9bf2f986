// Rows of the properties about the selected solids, for commands that name them.

#include <algorithm>
#include <array>
#include <vector>

#include "core/document/edits/edit_solids.hpp"
#include "ui/solids/solids_properties.hpp"

namespace hariko {

namespace {

using There = bool (*)(const Editor&);

std::vector<const Solid*> selected_solids_of(const Editor& editor) {
  std::vector<const Solid*> out;
  const Object& object = *editor.active_object();
  if (!object.solids() || editor.mode == ElementMode::object) return out;
  for (const VertexId id : editor.selection.of(object.id).vertices)
    if (const Solid* solid = find_solid(object, id.value)) out.push_back(solid);
  return out;
}

template <class Test>
bool all_selected_solids(const Editor& editor, const Test& test) {
  const std::vector<const Solid*> solids = selected_solids_of(editor);
  return !solids.empty() && std::ranges::all_of(solids, [&](const Solid* solid) { return test(*solid); });
}
bool made_by_ball(const Editor& editor) {
  return editor.active_object()->solids()->input->settings.method == EnvelopeMethod::ball;
}

bool row_of_solids(const Editor& editor) {
  return !selected_solids_of(editor).empty();
}
/// All selected solids are of one of these kinds, and of the same.
template <SolidKind... kinds>
bool row_of_sizes(const Editor& editor) {
  const std::vector<const Solid*> solids = selected_solids_of(editor);
  return !solids.empty() && std::ranges::all_of(solids, [&](const Solid* solid) {
    return solid->kind == solids.front()->kind && ((solid->kind == kinds) || ...);
  });
}
constexpr There row_of_box = row_of_sizes<SolidKind::box>;
constexpr There row_of_capsule = row_of_sizes<SolidKind::capsule>;
constexpr There row_of_torus = row_of_sizes<SolidKind::torus>;
constexpr There row_of_prism = row_of_sizes<SolidKind::prism, SolidKind::pyramid>;
constexpr There row_of_height =
    row_of_sizes<SolidKind::box, SolidKind::cylinder, SolidKind::cone, SolidKind::prism, SolidKind::pyramid>;
constexpr There row_of_radius =
    row_of_sizes<SolidKind::sphere, SolidKind::cylinder, SolidKind::cone, SolidKind::prism,
                 SolidKind::pyramid, SolidKind::capsule, SolidKind::torus>;
bool row_of_own_roundness(const Editor& editor) {
  return all_selected_solids(editor, [](const Solid& solid) { return solid.roundness.has_value(); });
}
bool row_of_bridges(const Editor& editor) {
  return all_selected_solids(editor, [](const Solid& solid) { return solid.bridge.has_value(); }) &&
         made_by_ball(editor);
}
bool row_of_own_balls(const Editor& editor) {
  return row_of_bridges(editor) && all_selected_solids(editor, [](const Solid& solid) {
           return solid.bridge->ball_radius.has_value();
         });
}
bool row_of_pulls(const Editor& editor) {
  const std::vector<const Solid*> solids = selected_solids_of(editor);
  return std::ranges::any_of(solids, [](const Solid* solid) { return !solid->pulls.empty(); }) &&
         made_by_ball(editor);
}

constexpr const char* no_solid = translatable("No solid is selected. Click one.");
constexpr const char* other_solids =
    translatable("The selected solids do not all have this property. Select one of another kind.");
constexpr const char* no_own = translatable("The selected solids have none of their own. Tick it first.");
constexpr const char* no_bridge =
    translatable("Only bars between solids have a ball of their own, where a ball makes the surface.");
constexpr const char* no_pull =
    translatable("The surface of the selected solids is not pulled. Pull it first: Solids > Pull surface.");

constexpr std::array solid_rows{
    PanelRow{"solid.x", "Position", "In the object's own axes", "Solids", row_of_solids, no_solid},
    PanelRow{"solid.turn_x", "Rotation", "About the x axis first, then y, then z", "Solids", row_of_solids,
             no_solid},
    PanelRow{"solid.width", "Size", "Lengths of the edges", "Solids", row_of_box, other_solids},
    PanelRow{"solid.radius", "Radius", "Of the selected solids", "Solids", row_of_radius, other_solids},
    PanelRow{"solid.length", "Length", "Between the centres of the ends", "Solids", row_of_capsule,
             other_solids},
    PanelRow{"solid.tube", "Tube radius", "Of the selected solids", "Solids", row_of_torus, other_solids},
    PanelRow{"solid.height", "Height", "Of the selected solids", "Solids", row_of_height, other_solids},
    PanelRow{"solid.sides", "Sides", "Of the selected solids", "Solids", row_of_prism, other_solids},
    PanelRow{"solid.scale_x", "Scale", "Along the solid's own axes", "Solids", row_of_solids, no_solid},
    PanelRow{"own_roundness", "Roundness", "Round this solid more or less than the others", "Solids",
             row_of_solids, no_solid},
    PanelRow{"solid.roundness", "Amount", "Of the selected solids' own roundness", "Solids",
             row_of_own_roundness, no_own},
    PanelRow{"own_ball", "Own ball", "Another ball rolls between the two solids that this bar joins",
             "Solids", row_of_bridges, no_bridge},
    PanelRow{"solid.ball_radius", "Ball radius",
             "Rounds where the bar meets its solids; less than three times the rounding counts as that",
             "Solids", row_of_own_balls, no_own},
    PanelRow{"solid.pull_radius", "Pull radius", "How far about a pulled place the surface follows, at least",
             "Solids", row_of_pulls, no_pull},
};

}  // namespace

std::vector<PanelRow> solid_panel_rows() {
  return {solid_rows.begin(), solid_rows.end()};
}

}  // namespace hariko
