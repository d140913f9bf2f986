#include "ui/solids/solids_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/envelope.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/lists.hpp"

namespace hariko {

namespace {

constexpr std::array kind_names{
    translatable("Box"),     translatable("Sphere"), translatable("Cylinder"),
    translatable("Cone"),    translatable("Prism"),  translatable("Pyramid"),
    translatable("Capsule"), translatable("Torus"),  translatable("Polyhedron"),
};

const char* kind_name(SolidKind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

constexpr double ball_roundness = 0.3;  ///< own roundness of a solid to begin with

double size_of_solids(const Object& object) {
  const Box3 box = box_at_own_place(object);
  return box.isEmpty() ? 1 : box.sizes().maxCoeff();
}

Quantity length_of(const PanelContext& context, const Object& object) {
  return length_quantity(context.editor.document().unit, size_of_solids(object));
}

// The surface.

bool by_ball(const EnvelopeInput& input) {
  return input.settings.method == EnvelopeMethod::ball;
}
bool by_network(const EnvelopeInput& input) {
  return input.settings.method == EnvelopeMethod::network;
}

/// The ball's radius, seen from the solids' size. Rounded: the radius is what is kept.
double tightness_now(const EnvelopeInput& input) {
  constexpr double steps = 1e9;
  const EnvelopeSettings& settings = input.settings;
  if (!by_ball(input)) return std::numeric_limits<double>::quiet_NaN();
  return std::round(steps *
                    tightness_of(settings.ball_radius, settings.rounding, solids_size(input.solids))) /
         steps;
}
void set_tightness(EnvelopeInput& input, double tightness) {
  input.settings.ball_radius = ball_radius_at(tightness, input.settings.rounding, solids_size(input.solids));
}

void set_method(EnvelopeInput& input, double method) {
  if (static_cast<EnvelopeMethod>(std::lround(method)) == EnvelopeMethod::network)
    input.settings.method = EnvelopeMethod::network;
  else if (input.settings.rounding > 0)
    input.settings.method = EnvelopeMethod::ball;
  else
    choose_ball(input);
}

constexpr Property<EnvelopeInput> method_property{
    list_row("envelope_method", "Method", "What decides the surface's shape", "Method of the surface",
             enum_choices<EnvelopeMethod>, enum_words<EnvelopeMethod>),
    [](const EnvelopeInput& input) { return double(input.settings.method); }, &set_method};
constexpr auto symmetry_property = member_property<&EnvelopeInput::settings, &EnvelopeSettings::symmetry>(
    {"envelope_symmetry", "Symmetry", "A plane through the object's zero, across an axis of the object",
     "Symmetry of the surface"});
/// The method first: which of the others there are depends on it.
constexpr std::array surface_properties{
    method_property,
    Property<EnvelopeInput>{
        {"tightness", "Tightness", "0 is the rounded hull, 1 rolls the smallest ball into the notches",
         "Tightness of the surface", linear_range(0, 1, 0.5, 3, 0.02)},
        &tightness_now,
        &set_tightness,
        &by_ball},
    member_property<&EnvelopeInput::settings, &EnvelopeSettings::rounding>(
        {"rounding", "Rounding",
         "Edges are rounded by one and a half times this length; faces lie about as far outside of the "
         "solids as it is long",
         "Rounding of the surface", lengths_from(1e-9)},
        &by_ball),
    member_property<&EnvelopeInput::settings, &EnvelopeSettings::roundness>(
        {"roundness", "Roundness", "Of the parts round single solids", "Roundness of the surface",
         linear_range(0.01, 1, 0.35, 3, 0.02)},
        &by_network),
    member_property<&EnvelopeInput::settings, &EnvelopeSettings::clearance>(
        {"clearance", "Clearance", "Distance that is kept from every solid", "Clearance of the surface",
         lengths_from(0, 0)}),
    member_property<&EnvelopeInput::settings, &EnvelopeSettings::on_faces>(
        {"on_faces", "On the faces",
         "Flat faces of the surface lie on those of the solids, and edges stick out; off, the surface "
         "contains the solids",
         "Surface on the faces"},
        &by_ball),
    member_property<&EnvelopeInput::settings, &EnvelopeSettings::finer_patches>(
        {"finer_patches", "Finer patches", "About twice as many patches, which are nearer to the shape",
         "Finer patches of the surface"},
        &by_ball),
    symmetry_property,
};

/// Nothing while it is not known.
void sticks_out_row(PanelContext& context, const Object& object, std::optional<double> length) {
  text_row(context, "solids.sticks_out", "Sticks out",
           "How far edges, corners and round sides of the solids reach out of the surface at most",
           length ? format_quantity(length_of(context, object), *length) : "\u2026");
}

/// Whether the surface contains the solids, and whether it is symmetric. While it is being made the rows
/// stay and say nothing, so that those below do not jump.
void state_rows(PanelContext& context, const Object& object) {
  const SurfaceView* view = context.editor.view_of(object.id);
  const bool known = view && view->mesh && !view->error && view->quality == Quality::final;
  const auto says = [&](Code code) {
    return std::ranges::any_of(view->warnings, [&](const Message& message) { return message.code == code; });
  };
  const auto state = [&](const char* label, const char* help, const char* mark, const auto& text) {
    text_row(context, mark, label, help, known ? context.tr(text()) : "\u2026");
  };
  const EnvelopeSettings& settings = object.solids()->input->settings;
  if (settings.method == EnvelopeMethod::ball && settings.on_faces)
    sticks_out_row(context, object, known ? view->sticks_out : std::nullopt);
  else
    state("Contains", "Points of the solids are tested against the surface", "solids.contains", [&] {
      return says(w_not_enclosed) ? translatable("Not all of the solids") : translatable("All of the solids");
    });
  if (settings.symmetry != SymmetryPlane::none)
    state("Symmetric", "Whether the surface is its own image in the plane", "solids.symmetric", [&] {
      return says(w_not_symmetric) ? translatable("No: its faces differ on both sides")
                                   : translatable("On both sides of the plane");
    });
}

void surface_rows(PanelContext& context, const Object& object) {
  heading(context, "Surface round the solids");
  state_rows(context, object);
  const Binding<EnvelopeInput> rows =
      bind_part(context, object, envelope_properties().part, size_of_solids(object));
  rows.rows(std::span(surface_properties).subspan(1, surface_properties.size() - 2));
  rows.row(method_property);
  rows.row(symmetry_property);
}

// Solids.

using Ids = std::vector<std::uint32_t>;

Ids selected_ids(const Editor& editor, const Object& object) {
  Ids out;
  if (editor.mode == ElementMode::object) return out;
  for (const VertexId id : editor.selection.of(object.id).vertices)
    if (find_solid(object, id.value)) out.push_back(id.value);
  return out;
}

constexpr const char* solid_size_step = "Size of solid";
constexpr PropertyRange solid_length = lengths_from(1e-9);

bool is_prismatic(const Solid& solid) {
  return solid.kind == SolidKind::prism || solid.kind == SolidKind::pyramid;
}
bool has_height(const Solid& solid) {
  return is_prismatic(solid) || solid.kind == SolidKind::cylinder || solid.kind == SolidKind::cone;
}

/// Sizes of round and prismatic solids.
constexpr std::array size_properties{
    member_property<&Solid::radius>({"solid.radius", "Radius", "", solid_size_step, solid_length}),
    member_property<&Solid::length>(
        {"solid.length", "Length", "Between the centres of the ends", solid_size_step, solid_length},
        [](const Solid& solid) { return solid.kind == SolidKind::capsule; }),
    member_property<&Solid::tube>({"solid.tube", "Tube radius", "", solid_size_step, solid_length},
                                  [](const Solid& solid) { return solid.kind == SolidKind::torus; }),
    member_property<&Solid::height>({"solid.height", "Height", "", solid_size_step, solid_length},
                                    &has_height),
    member_property<&Solid::sides>(
        {"solid.sides", "Sides", "", "Sides of solid", {.low = 3, .high = double(max_solid_sides)}},
        &is_prismatic),
};

/// Sizes of the solids' kind; only where all are of one kind.
void size_rows(const Binding<Solid>& solids, Quantity length) {
  const auto kind = solids.common_value(&Solid::kind);
  if (!kind || *kind == SolidKind::polyhedron) return;
  length.low = 1e-9;
  if (*kind != SolidKind::box) return solids.rows(size_properties);
  const VectorSpec spec{{"solid.width", "solid.depth", "solid.height"},
                        "Size",
                        "Lengths of the edges",
                        solid_size_step,
                        length};
  solids.vector(spec, &Solid::size);
}

void roundness_rows(const Binding<Solid>& solids, const EnvelopeSettings& settings) {
  const bool ball = settings.method == EnvelopeMethod::ball;
  const double standard = ball ? ball_roundness : settings.roundness;
  solids.row(
      switch_row("own_roundness", "Roundness",
                 ball ? "Round the edges of this solid more than those of the others"
                      : "Round this solid more or less than the others",
                 "Own roundness", "Common roundness"),
      [](const Solid& solid) { return solid.roundness ? 1.0 : 0.0; },
      [standard](Solid& solid, double on) {
        if (on != 0)
          solid.roundness = solid.roundness.value_or(standard);
        else
          solid.roundness.reset();
      });
  if (solids.common_value([](const Solid& solid) { return solid.roundness.has_value(); }) != true) return;
  solids.row(
      {"solid.roundness", "Amount", "", "Roundness of solid", linear_range(0.01, 1, standard, 3, 0.02)},
      [standard](const Solid& solid) { return solid.roundness.value_or(standard); },
      [](Solid& solid, double roundness) { solid.roundness = roundness; });
}

double ball_of_bridge(const Solid& solid) {
  return solid.bridge->ball_radius.value_or(solid.radius);
}

/// The ball between solids that are joined by bridges; only where all selected ones are bridges.
void bridge_rows(const Binding<Solid>& solids) {
  if (solids.common_value([](const Solid& solid) { return solid.bridge.has_value(); }) != true) return;
  const auto owns = [](const Solid& solid) { return solid.bridge->ball_radius.has_value(); };
  solids.row(
      switch_row("own_ball", "Own ball", "Another ball rolls between the two solids that this bar joins",
                 "Own ball", "Common ball"),
      [&](const Solid& solid) { return owns(solid) ? 1.0 : 0.0; },
      [](Solid& solid, double on) {
        if (on != 0)
          solid.bridge->ball_radius = ball_of_bridge(solid);
        else
          solid.bridge->ball_radius.reset();
      });
  if (solids.common_value(owns) != true) return;
  solids.row({"solid.ball_radius", "Ball radius",
              "Rounds where the bar meets its solids; less than three times the rounding counts as that",
              "Ball of the bridge", solid_length},
             &ball_of_bridge, [](Solid& solid, double radius) { solid.bridge->ball_radius = radius; });
}

/// Radius of the places at which the surface is pulled by hand.
void pull_rows(PanelContext& context, const Object& object, const Ids& ids) {
  std::vector<Pull> pulls;
  for (const std::uint32_t id : ids) {
    const Solid& solid = *find_solid(object, id);
    pulls.insert(pulls.end(), solid.pulls.begin(), solid.pulls.end());
  }
  if (pulls.empty()) return;
  Quantity length = length_of(context, object);
  length.low = 1e-9;
  value_row(context,
            {"solid.pull_radius", translatable("Pull radius"),
             translatable("How far about a pulled place the surface follows, at least"),
             translatable("Radius of pulls"), length},
            common<double>(pulls, [](const Pull& pull) { return pull.radius; }),
            [object = object.id, ids, length](const Document& document, const ValueChange& change) {
              return change_solids(document, object, ids, [&](Solid& solid) {
                for (Pull& pull : solid.pulls) pull.radius = change.apply(length, pull.radius);
              });
            });
}

/// Distance that the ball's surface lies outside; of one solid, as each takes a while.
void outside_row(PanelContext& context, const Object& object, const Ids& ids) {
  const EnvelopeInput& input = *object.solids()->input;
  if (input.settings.method != EnvelopeMethod::ball || ids.size() != 1) return;
  const double outside =
      faces_outside(*find_solid(object, ids.front()), input.settings, solids_size(input.solids));
  text_row(context, "solid.outside", "Faces outside",
           "How far flat faces of the surface lie outside of those of this solid",
           format_quantity(length_of(context, object), outside));
}

void selected_rows(PanelContext& context, const Object& object, const Ids& ids) {
  heading(context, ids.size() == 1 ? context.tr(kind_name(find_solid(object, ids.front())->kind))
                                   : fill(context.tr("{0} solids"), {std::to_string(ids.size())}).c_str());
  std::vector<const Solid*> shown;
  for (const std::uint32_t id : ids) shown.push_back(find_solid(object, id));
  const Binding<Solid> solids(
      context, std::move(shown),
      [object = object.id, ids](const Document& document, const Binding<Solid>::Change& change) {
        return change_solids(document, object, ids, change);
      },
      size_of_solids(object));
  const Quantity length = length_of(context, object);
  const VectorSpec position{
      {"solid.x", "solid.y", "solid.z"}, "Position", "In the object's own axes", "Place solid", length};
  solids.vector(position, &Solid::position);
  const VectorSpec rotation{{"solid.turn_x", "solid.turn_y", "solid.turn_z"},
                            "Rotation",
                            "About the x axis first, then y, then z",
                            "Rotate solid",
                            angle_quantity()};
  solids.vector(rotation, &Solid::rotation);
  size_rows(solids, length);
  constexpr PropertyRange factors{.low = 1e-6, .high = 1e6, .standard = 1, .multiplies = true};
  const VectorSpec scale{{"solid.scale_x", "solid.scale_y", "solid.scale_z"},
                         "Scale",
                         "Along the solid's own axes",
                         "Scale solid",
                         quantity_in(factors, context.editor.document().unit, 1)};
  solids.vector(scale, &Solid::scale);
  roundness_rows(solids, object.solids()->input->settings);
  if (by_ball(*object.solids()->input)) {
    bridge_rows(solids);
    pull_rows(context, object, ids);
  }
  outside_row(context, object, ids);
}

/// Scrolls to the row that was drawn last, unless it was the last one to be scrolled to.
void bring_solid_into_sight(std::uint32_t id) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID("in_sight");
  const int number = static_cast<int>(id) + 1;
  if (storage.GetInt(key) == number) return;
  storage.SetInt(key, number);
  if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
}

void list_rows(PanelContext& context, const Object& object, const Ids& ids) {
  heading(context, "Solids");
  Editor& editor = context.editor;
  const std::vector<Solid>& solids = object.solids()->input->solids;
  // A long list scrolls, so that the numbers below it are in sight.
  constexpr std::size_t most_rows = 8;
  const bool many = solids.size() > most_rows;
  if (many)
    ImGui::BeginChild("solids", {0, (float(most_rows) + 0.5F) * ImGui::GetTextLineHeightWithSpacing()}, false,
                      ImGuiWindowFlags_NavFlattened);
  std::array<int, kind_names.size()> count{};
  for (const Solid& solid : solids) {
    const int number = ++count[static_cast<std::size_t>(solid.kind)];
    const bool chosen = std::find(ids.begin(), ids.end(), solid.id) != ids.end();
    const std::string name = std::string(context.tr(kind_name(solid.kind))) + " " + std::to_string(number);
    if (selectable_row(context.marks, "solid." + std::to_string(solid.id), name, chosen)) {
      if (editor.mode == ElementMode::object) editor.mode = ElementMode::vertex;
      const bool more = ImGui::GetIO().KeyShift;
      editor.selection.select({object.id, element_of(VertexId{solid.id})}, !more    ? Selection::How::replace
                                                                           : chosen ? Selection::How::remove
                                                                                    : Selection::How::add);
    }
    if (many && !ids.empty() && solid.id == ids.front()) bring_solid_into_sight(solid.id);
  }
  if (many) ImGui::EndChild();
}

}  // namespace

ObjectProperties<EnvelopeInput> envelope_properties() {
  return {{[](const Object& object) { return object.solids() ? object.solids()->input.get() : nullptr; },
           &change_envelope},
          surface_properties};
}

void draw_solids(PanelContext& context, const Object& object) {
  if (!object.solids()) return;
  const Ids ids = selected_ids(context.editor, object);
  // The rows of a solid that is chosen in the list come below it: the list stays under the pointer.
  list_rows(context, object, ids);
  if (ids.empty())
    hint_text(context, "Click a solid to change it, drag it to move it.");
  else
    selected_rows(context, object, ids);
  surface_rows(context, object);
}

}  // namespace hariko
