#include "ui/solids/solids_properties.hpp"

#include <algorithm>
#include <array>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/envelope.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/value_fields.hpp"

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

Quantity share(double low, double high, double standard) {
  Quantity quantity = plain_quantity(3, 0.02);
  quantity.low = low;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

Quantity length_of(const PanelContext& context, const Object& object) {
  const Box3 box = box_at_own_place(object);
  return length_quantity(context.editor.document().unit, box.isEmpty() ? 1 : box.sizes().maxCoeff());
}

// The surface.

/// A number of the settings: `get` gives a reference to it.
template <class Get>
EditValues edit_setting(ObjectId object, const Quantity& quantity, Get get) {
  return [object, quantity, get](const Document& document, const ValueChange& change) {
    return change_envelope(document, object, [&](EnvelopeInput& input) {
      get(input.settings) = change.apply(quantity, get(input.settings));
    });
  };
}

template <class Get>
void setting_row(PanelContext& context, const Object& object, const FieldSpec& spec, Get get) {
  EnvelopeSettings now = object.solids()->input->settings;
  slider_row(context, spec, spec.quantity.low, spec.quantity.high, false, get(now),
             edit_setting(object.id, spec.quantity, get));
}

void choice_rows(PanelContext& context, const Object& object) {
  const EnvelopeSettings& now = object.solids()->input->settings;
  const auto set = [&](const char* step, const std::function<void(EnvelopeSettings&)>& change) {
    context.editor.commit(change_envelope(context.editor.history.current(), object.id,
                                          [&](EnvelopeInput& input) { change(input.settings); }),
                          step);
  };
  if (const auto chosen = choose(context, "envelope_method", "Method", "What decides the surface's shape",
                                 std::optional(now.method)))
    context.editor.commit(change_envelope(context.editor.history.current(), object.id,
                                          [&](EnvelopeInput& input) {
                                            if (*chosen == EnvelopeMethod::network)
                                              input.settings.method = EnvelopeMethod::network;
                                            else if (input.settings.rounding > 0)
                                              input.settings.method = EnvelopeMethod::ball;
                                            else
                                              choose_ball(input);
                                          }),
                          "Method of the surface");
  if (const auto chosen = choose(context, "envelope_symmetry", "Symmetry",
                                 "A plane through the object's zero, across an axis of the object",
                                 std::optional(now.symmetry)))
    set("Symmetry of the surface", [&](EnvelopeSettings& settings) { settings.symmetry = *chosen; });
}

/// Nothing while it is not known.
void sticks_out_row(PanelContext& context, const Object& object, std::optional<double> length) {
  row_label(context, "Sticks out",
            "How far edges, corners and round sides of the solids reach out of the surface at most");
  ImGui::TextUnformatted(length ? format_quantity(length_of(context, object), *length).c_str() : "\u2026");
  context.marks.item("solids.sticks_out");
}

/// Whether the surface contains the solids, and whether it is symmetric. While it is being made the rows
/// stay and say nothing, so that those below do not jump.
void state_rows(PanelContext& context, const Object& object) {
  const SurfaceView* view = context.editor.view_of(object.id);
  const bool known = view && view->mesh && !view->error && view->quality == Quality::final;
  const auto says = [&](Code code) {
    return std::any_of(view->warnings.begin(), view->warnings.end(),
                       [&](const Message& message) { return message.code == code; });
  };
  const auto state = [&](const char* label, const char* help, const char* mark, const auto& text) {
    row_label(context, label, help);
    ImGui::TextUnformatted(known ? context.tr(text()) : "\u2026");
    context.marks.item(mark);
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

void clearance_row(PanelContext& context, const Object& object) {
  Quantity length = length_of(context, object);
  length.low = 0;
  length.standard = 0;
  const auto clearance = [](EnvelopeSettings& settings) -> double& { return settings.clearance; };
  value_row(context,
            {"clearance", translatable("Clearance"), translatable("Distance that is kept from every solid"),
             translatable("Clearance of the surface"), length},
            object.solids()->input->settings.clearance, edit_setting(object.id, length, clearance));
}

/// A check box of the settings.
void option_row(PanelContext& context, const Object& object, const char* id, const char* label,
                const char* help, bool EnvelopeSettings::*option, const char* step) {
  const auto on = check_row(context, id, label, help, object.solids()->input->settings.*option);
  if (!on) return;
  context.editor.commit(change_envelope(context.editor.history.current(), object.id,
                                        [&](EnvelopeInput& input) { input.settings.*option = *on; }),
                        step);
}

/// Rows of the ball: tightness is its radius, seen from the solids' size.
void ball_rows(PanelContext& context, const Object& object) {
  const EnvelopeInput& input = *object.solids()->input;
  const double size = solids_size(input.solids);
  const Quantity tightness = share(0, 1, 0.5);
  slider_row(context,
             {"tightness", translatable("Tightness"),
              translatable("0 is the rounded hull, 1 rolls the smallest ball into the notches"),
              translatable("Tightness of the surface"), tightness},
             0, 1, false, tightness_of(input.settings.ball_radius, input.settings.rounding, size),
             [object = object.id, tightness, size](const Document& document, const ValueChange& change) {
               return change_envelope(document, object, [&](EnvelopeInput& changed) {
                 EnvelopeSettings& settings = changed.settings;
                 const double now = tightness_of(settings.ball_radius, settings.rounding, size);
                 settings.ball_radius = ball_radius_at(change.apply(tightness, now), settings.rounding, size);
               });
             });
  Quantity length = length_of(context, object);
  length.low = 1e-9;
  const auto rounding = [](EnvelopeSettings& settings) -> double& { return settings.rounding; };
  value_row(context,
            {"rounding", translatable("Rounding"),
             translatable("Edges are rounded by one and a half times this length; faces lie about as far "
                          "outside of the solids as it is long"),
             translatable("Rounding of the surface"), length},
            input.settings.rounding, edit_setting(object.id, length, rounding));
  clearance_row(context, object);
  option_row(
      context, object, "on_faces", translatable("On the faces"),
      translatable("Flat faces of the surface lie on those of the solids, and edges stick out; off, the "
                   "surface contains the solids"),
      &EnvelopeSettings::on_faces, translatable("Surface on the faces"));
  option_row(context, object, "finer_patches", translatable("Finer patches"),
             translatable("About twice as many patches, which are nearer to the shape"),
             &EnvelopeSettings::finer_patches, translatable("Finer patches of the surface"));
}

void surface_rows(PanelContext& context, const Object& object) {
  heading(context, "Surface round the solids");
  state_rows(context, object);
  if (object.solids()->input->settings.method == EnvelopeMethod::ball) {
    ball_rows(context, object);
    return choice_rows(context, object);
  }
  setting_row(context, object,
              {"roundness", translatable("Roundness"), translatable("Of the parts round single solids"),
               translatable("Roundness of the surface"), share(0.01, 1, 0.35)},
              [](EnvelopeSettings& settings) -> double& { return settings.roundness; });
  clearance_row(context, object);
  choice_rows(context, object);
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

std::vector<Solid> solids_of(const Object& object, const Ids& ids) {
  std::vector<Solid> out;
  for (const std::uint32_t id : ids) out.push_back(*find_solid(object, id));
  return out;
}

template <class Get>
EditValues edit_solid(ObjectId object, const Ids& ids, const Quantity& quantity, Get get) {
  return [object, ids, quantity, get](const Document& document, const ValueChange& change) {
    return change_solids(document, object, ids,
                         [&](Solid& solid) { get(solid) = change.apply(quantity, get(solid)); });
  };
}

/// Three numbers of solids, of which `get` gives the vector.
template <class Get>
void solid_vector(PanelContext& context, const Object& object, const Ids& ids, const char* label,
                  const char* help, const std::array<const char*, 3>& names, const char* step,
                  const Quantity& quantity, Get get) {
  std::array<std::optional<double>, 3> values;
  const auto solids = solids_of(object, ids);
  for (int axis = 0; axis < 3; ++axis)
    values[static_cast<std::size_t>(axis)] =
        common<double>(solids, [&](Solid solid) { return get(solid)[axis]; });
  vector_row(context, label, help,
             {FieldSpec{names[0], "X", "", step, quantity}, FieldSpec{names[1], "Y", "", step, quantity},
              FieldSpec{names[2], "Z", "", step, quantity}},
             values,
             [object = object.id, ids, quantity, get](const Document& document, int axis,
                                                      const ValueChange& change) {
               return change_solids(document, object, ids, [&](Solid& solid) {
                 get(solid)[axis] = change.apply(quantity, get(solid)[axis]);
               });
             });
}

template <class Get>
void solid_number(PanelContext& context, const Object& object, const Ids& ids, const FieldSpec& spec,
                  Get get) {
  const auto solids = solids_of(object, ids);
  value_row(context, spec, common<double>(solids, [&](Solid solid) { return double(get(solid)); }),
            edit_solid(object.id, ids, spec.quantity, get));
}

/// What the kind has of sizes; only where all are of one kind.
void size_rows(PanelContext& context, const Object& object, const Ids& ids) {
  const auto kind = common<SolidKind>(solids_of(object, ids), [](const Solid& solid) { return solid.kind; });
  if (!kind || *kind == SolidKind::polyhedron) return;
  Quantity length = length_of(context, object);
  length.low = 1e-9;
  if (*kind == SolidKind::box)
    return solid_vector(context, object, ids, "Size", "Lengths of the edges",
                        {"solid.width", "solid.depth", "solid.height"}, "Size of solid", length,
                        [](Solid& solid) -> Vector3& { return solid.size; });
  solid_number(context, object, ids, {"solid.radius", translatable("Radius"), "", "Size of solid", length},
               [](Solid& solid) -> double& { return solid.radius; });
  if (*kind == SolidKind::capsule)
    solid_number(context, object, ids,
                 {"solid.length", translatable("Length"), translatable("Between the centres of the ends"),
                  "Size of solid", length},
                 [](Solid& solid) -> double& { return solid.length; });
  else if (*kind == SolidKind::torus)
    solid_number(context, object, ids,
                 {"solid.tube", translatable("Tube radius"), "", "Size of solid", length},
                 [](Solid& solid) -> double& { return solid.tube; });
  else if (*kind != SolidKind::sphere)
    solid_number(context, object, ids, {"solid.height", translatable("Height"), "", "Size of solid", length},
                 [](Solid& solid) -> double& { return solid.height; });
  if (*kind == SolidKind::prism || *kind == SolidKind::pyramid) {
    Quantity sides = plain_quantity(0, 1);
    sides.whole = true;
    sides.low = 3;
    sides.high = double(max_solid_sides);
    const auto edit = [object = object.id, ids, sides](const Document& document, const ValueChange& change) {
      return change_solids(document, object, ids, [&](Solid& solid) {
        solid.sides = static_cast<std::uint32_t>(change.apply(sides, double(solid.sides)));
      });
    };
    value_row(context, {"solid.sides", translatable("Sides"), "", "Sides of solid", sides},
              common<double>(solids_of(object, ids), [](const Solid& solid) { return double(solid.sides); }),
              edit);
  }
}

void roundness_rows(PanelContext& context, const Object& object, const Ids& ids) {
  const auto solids = solids_of(object, ids);
  const EnvelopeSettings& settings = object.solids()->input->settings;
  const bool ball = settings.method == EnvelopeMethod::ball;
  const auto own = common<bool>(solids, [](const Solid& solid) { return solid.roundness.has_value(); });
  const double standard = ball ? ball_roundness : settings.roundness;
  if (const auto on =
          check_row(context, "own_roundness", "Roundness",
                    ball ? translatable("Round the edges of this solid more than those of the others")
                         : translatable("Round this solid more or less than the others"),
                    own))
    context.editor.commit(change_solids(context.editor.history.current(), object.id, ids,
                                        [&](Solid& solid) {
                                          if (*on)
                                            solid.roundness = solid.roundness.value_or(standard);
                                          else
                                            solid.roundness.reset();
                                        }),
                          *on ? "Own roundness" : "Common roundness");
  if (!own || !*own) return;
  const Quantity quantity = share(0.01, 1, standard);
  slider_row(
      context, {"solid.roundness", translatable("Amount"), "", "Roundness of solid", quantity}, 0.01, 1,
      false, common<double>(solids, [&](const Solid& solid) { return solid.roundness.value_or(standard); }),
      [object = object.id, ids, quantity, standard](const Document& document, const ValueChange& change) {
        return change_solids(document, object, ids, [&](Solid& solid) {
          solid.roundness = change.apply(quantity, solid.roundness.value_or(standard));
        });
      });
}

/// The ball between solids that are joined by bridges; only where all selected ones are bridges.
void bridge_rows(PanelContext& context, const Object& object, const Ids& ids) {
  const std::vector<Solid> solids = solids_of(object, ids);
  const bool bars = std::ranges::all_of(solids, [](const Solid& s) { return s.bridge.has_value(); });
  if (!bars || object.solids()->input->settings.method != EnvelopeMethod::ball) return;
  const auto own =
      common<bool>(solids, [](const Solid& solid) { return solid.bridge->ball_radius.has_value(); });
  const auto radius_of = [](const Solid& solid) { return solid.bridge->ball_radius.value_or(solid.radius); };
  if (const auto on = check_row(context, "own_ball", "Own ball",
                                "Another ball rolls between the two solids that this bar joins", own))
    context.editor.commit(change_solids(context.editor.history.current(), object.id, ids,
                                        [&](Solid& solid) {
                                          if (*on)
                                            solid.bridge->ball_radius = radius_of(solid);
                                          else
                                            solid.bridge->ball_radius.reset();
                                        }),
                          *on ? translatable("Own ball") : translatable("Common ball"));
  if (!own || !*own) return;
  Quantity length = length_of(context, object);
  length.low = 1e-9;
  value_row(
      context,
      {"solid.ball_radius", translatable("Ball radius"),
       translatable("Rounds where the bar meets its solids; less than three times the rounding counts as "
                    "that"),
       translatable("Ball of the bridge"), length},
      common<double>(solids, radius_of),
      [object = object.id, ids, length, radius_of](const Document& document, const ValueChange& change) {
        return change_solids(document, object, ids, [&](Solid& solid) {
          solid.bridge->ball_radius = change.apply(length, radius_of(solid));
        });
      });
}

/// Radius of the places at which the surface is pulled by hand.
void pull_rows(PanelContext& context, const Object& object, const Ids& ids) {
  std::vector<Solid> solids = solids_of(object, ids);
  std::erase_if(solids, [](const Solid& solid) { return solid.pulls.empty(); });
  if (solids.empty() || object.solids()->input->settings.method != EnvelopeMethod::ball) return;
  Quantity length = length_of(context, object);
  length.low = 1e-9;
  std::vector<Pull> pulls;
  for (const Solid& solid : solids) pulls.insert(pulls.end(), solid.pulls.begin(), solid.pulls.end());
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

/// How far the ball's surface lies outside; of one solid, as each takes a while.
void outside_row(PanelContext& context, const Object& object, const Ids& ids) {
  const EnvelopeInput& input = *object.solids()->input;
  if (input.settings.method != EnvelopeMethod::ball || ids.size() != 1) return;
  row_label(context, "Faces outside", "How far flat faces of the surface lie outside of those of this solid");
  const double outside =
      faces_outside(*find_solid(object, ids.front()), input.settings, solids_size(input.solids));
  ImGui::TextUnformatted(format_quantity(length_of(context, object), outside).c_str());
  context.marks.item("solid.outside");
}

void selected_rows(PanelContext& context, const Object& object, const Ids& ids) {
  heading(context, ids.size() == 1 ? context.tr(kind_name(find_solid(object, ids.front())->kind))
                                   : fill(context.tr("{0} solids"), {std::to_string(ids.size())}).c_str());
  Quantity length = length_of(context, object);
  solid_vector(context, object, ids, "Position", "In the object's own axes",
               {"solid.x", "solid.y", "solid.z"}, "Place solid", length,
               [](Solid& solid) -> Vector3& { return solid.position; });
  solid_vector(context, object, ids, "Rotation", "About the x axis first, then y, then z",
               {"solid.turn_x", "solid.turn_y", "solid.turn_z"}, "Rotate solid", angle_quantity(),
               [](Solid& solid) -> Vector3& { return solid.rotation; });
  size_rows(context, object, ids);
  Quantity scale = plain_quantity(3, 0.1);
  scale.multiplies = true;
  scale.low = 1e-6;
  scale.high = 1e6;
  scale.standard = 1;
  solid_vector(context, object, ids, "Scale", "Along the solid's own axes",
               {"solid.scale_x", "solid.scale_y", "solid.scale_z"}, "Scale solid", scale,
               [](Solid& solid) -> Vector3& { return solid.scale; });
  roundness_rows(context, object, ids);
  bridge_rows(context, object, ids);
  pull_rows(context, object, ids);
  outside_row(context, object, ids);
}

void list_rows(PanelContext& context, const Object& object, const Ids& ids) {
  heading(context, "Solids");
  Editor& editor = context.editor;
  std::array<int, kind_names.size()> count{};
  for (const Solid& solid : object.solids()->input->solids) {
    const int number = ++count[static_cast<std::size_t>(solid.kind)];
    const bool chosen = std::find(ids.begin(), ids.end(), solid.id) != ids.end();
    const std::string name = std::string(context.tr(kind_name(solid.kind))) + " " + std::to_string(number) +
                             "##solid" + std::to_string(solid.id);
    if (ImGui::Selectable(name.c_str(), chosen)) {
      if (editor.mode == ElementMode::object) editor.mode = ElementMode::vertex;
      const bool more = ImGui::GetIO().KeyShift;
      editor.selection.select({object.id, element_of(VertexId{solid.id})}, !more    ? Selection::How::replace
                                                                           : chosen ? Selection::How::remove
                                                                                    : Selection::How::add);
    }
    context.marks.item("solid." + std::to_string(solid.id));
  }
}

}  // namespace

void draw_solids(PanelContext& context, const Object& object) {
  const Ids ids = selected_ids(context.editor, object);
  if (!ids.empty()) selected_rows(context, object, ids);
  list_rows(context, object, ids);
  if (ids.empty()) hint_text(context, "Click a solid to change it, drag it to move it.");
  surface_rows(context, object);
}

}  // namespace hariko
