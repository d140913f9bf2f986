#include "ui/outline/outline_rows.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/widgets/binding.hpp"

namespace hariko {

namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

constexpr std::array mode_steps{translatable("Outline mode Curvature"), translatable("Outline mode Round"),
                                translatable("Outline mode As published"),
                                translatable("Outline mode Position")};

void choose_mode(OutlineSettings& settings, GaussMode mode) {
  settings.mode = mode;
  settings.mode_replaced = false;
}

const OutlineSettings* outline_settings_of(const Object& object) {
  return object.outline() ? &object.outline()->settings : nullptr;
}
constexpr auto settings_part = whole_part<OutlineSettings, &outline_settings_of, &set_outline_settings>();
using OutlineRows = Binding<OutlineSettings>;

double outline_size(const Object& object) {
  const double size = object.outline()->outline->size();
  return size > 0 && std::isfinite(size) ? size : 1;
}

void method_rows(PanelContext& context, const OutlineRows& rows, const OutlineSource& source) {
  if (const auto chosen = choose(context, "outline_mode", "Mode", "How the control points inside are found",
                                 std::optional(source.settings.mode)))
    rows.commit(mode_steps[static_cast<std::size_t>(*chosen)],
                [&](OutlineSettings& changed) { choose_mode(changed, *chosen); });
  if (!source.outline->has_curvature() && source.settings.mode != GaussMode::position)
    rows.row(member_property<&OutlineSettings::sign>(
        {"outline_sign", "Shape", "Which way the surface bends", "Shape of the outline"}));
}

/// A gap is asked for or not: without one there is no length to show.
void gap_rows(const OutlineRows& rows, const Object& object) {
  const char* step = "Gap of the outline";
  // A hundredth of the outline, in one digit.
  const double size = outline_size(object), digit = std::pow(10, std::floor(std::log10(size / 100)));
  const double usual = std::max(1.0, std::round(size / 100 / digit)) * digit;
  rows.row(
      switch_row("outline_gap_limited", "Limit gap",
                 "Inserts points until the control points' polyhedron and the tangent planes' are "
                 "nowhere further apart",
                 step),
      [](const OutlineSettings& settings) { return settings.gap ? 1.0 : 0.0; },
      [usual](OutlineSettings& settings, double limited) {
        settings.gap = limited != 0 ? std::optional(usual) : std::nullopt;
      });
  if (!object.outline()->settings.gap) return;
  rows.row(
      {"outline_gap", "Largest gap",
       "Between the control points' polyhedron and the tangent planes'; 0 asks for none", step,
       lengths_from(0)},
      [](const OutlineSettings& settings) { return settings.gap.value_or(0); },
      [](OutlineSettings& settings, double gap) {
        settings.gap = gap > 0 ? std::optional(gap) : std::nullopt;
      });
}

constexpr std::array spacing_properties{
    member_property<&OutlineSettings::radius>(
        {"outline_radius", "Spacing", "Of the points inside, in steps of the points along the loops",
         "Spacing of the points inside", logarithmic_range(0.2, 3, 0.6, 2, 0.05)}),
    member_property<&OutlineSettings::most_points>({"outline_count",
                                                    "Most points",
                                                    "Insertion inside ends at so many points",
                                                    "Number of points inside",
                                                    {.low = 0,
                                                     .high = OutlineSettings::point_limit,
                                                     .standard = OutlineSettings::point_limit,
                                                     .step = 10}}),
};

/// The angle of a normal from the outline's axis about the loop: positive away from the surface.
double tilt_of(const Outline& outline, const Vector3& axis, const OutlinePoint& at) {
  const OutlineLoop& loop = outline.loops[at.loop];
  const std::size_t count = loop.points.size();
  const Vector3 tangent =
      (loop.points[(at.place + 1) % count] - loop.points[(at.place + count - 1) % count]).stableNormalized();
  const Vector3 up = axis - axis.dot(tangent) * tangent;
  return std::atan2(loop.normals[at.place].dot(tangent.cross(up)), loop.normals[at.place].dot(up));
}

/// Direction of the outline's normals on the whole.
Vector3 axis_of(const Outline& outline) {
  Vector3 sum = Vector3::Zero(), area = Vector3::Zero();
  for (const OutlineLoop& loop : outline.loops) {
    for (const Vector3& normal : loop.normals)
      sum += normal.stableNormalized() / double(outline.point_count());
    area += vector_area(loop.points);
  }
  if (sum.norm() > 0.05) return sum.normalized();
  return area.norm() > 0 ? Vector3(area.normalized()) : Vector3(Vector3::UnitZ());
}

void tilt_row(PanelContext& context, const Object& object, const std::set<Index>& points,
              const std::string& step) {
  const Outline& outline = *object.outline()->outline;
  const Vector3 axis = axis_of(outline);
  std::optional<double> value;
  bool same = true;
  for (const Index number : points) {
    const double tilt = tilt_of(outline, axis, outline_point(outline, number)) * degrees_per_radian;
    same = same && (!value || std::abs(*value - tilt) < 0.05);
    value = value.value_or(tilt);
  }
  if (!same) value.reset();
  Quantity angle = angle_quantity();
  angle.low = -180;
  angle.high = 180;
  angle.standard = 45;
  value_row(context,
            {"outline_tilt", "Tilt",
             "Angle of the normals from the middle of all normals; more leans outward", step, angle},
            value,
            [id = object.id, points, angle, axis](const Document& document, const ValueChange& change) {
              return edit_outline(document, id, [&](const Outline& old) -> Result<Outline> {
                Outline out = old;
                for (const Index number : points) {
                  const double before = tilt_of(old, axis, outline_point(old, number)) * degrees_per_radian;
                  out = tilted(out, {number}, (change.apply(angle, before) - before) / degrees_per_radian);
                }
                return out;
              });
            });
}

void position_row(PanelContext& context, const Object& object, const std::set<Index>& points,
                  const std::string& step) {
  const Outline& outline = *object.outline()->outline;
  const Quantity length = length_quantity(context.editor.document().unit, outline_size(object));
  const auto position = [](const Outline& of, Index number) {
    const OutlinePoint at = outline_point(of, number);
    return of.loops[at.loop].points[at.place];
  };
  const auto values = common_axes(points, [&](Index number) { return position(outline, number); });
  const VectorSpec spec{
      {"x", "y", "z"}, "Position", "Coordinates of the point, in the object's own axes", step, length};
  vector_row(context, spec, values,
             [id = object.id, points, length, position](const Document& document, int axis,
                                                        const ValueChange& change) {
               return edit_outline(document, id, [&](const Outline& old) -> Result<Outline> {
                 std::vector<Index> numbers(points.begin(), points.end());
                 std::vector<Vector3> places;
                 for (const Index number : numbers) {
                   places.push_back(position(old, number));
                   places.back()[axis] = change.apply(length, places.back()[axis]);
                 }
                 return with_points(old, numbers, places);
               });
             });
}

}  // namespace

void outline_section(PanelContext& context, const Object& object) {
  if (!object.outline()) return;
  heading(context, context.tr("Outline"));
  const OutlineRows rows = bind_part(context, object, settings_part, outline_size(object));
  const OutlineSettings& settings = object.outline()->settings;
  method_rows(context, rows, *object.outline());
  rows.rows(spacing_properties);
  if (settings.mode != GaussMode::position && settings.mode != GaussMode::paper) gap_rows(rows, object);
  constexpr std::array surfaces{enum_choice(Mode::fair), enum_choice(Mode::g2)};
  if (const auto chosen = choose(context, "outline_surface", "Surface", "How the surface spans the curves",
                                 surfaces, settings.curvature_continuous ? 1 : 0))
    rows.commit(*chosen == 1 ? "Surface G2" : "Surface Fair",
                [&](OutlineSettings& changed) { changed.curvature_continuous = *chosen == 1; });
  const std::size_t given = object.outline()->outline->point_count();
  text_row(context, "outline.points", "Count", "On the loops, and inserted inside",
           fill(context.tr("{0} on the loops, {1} inside"),
                {std::to_string(given), std::to_string(inserted_points(context.editor, object))}));
  run_button(context, "Gauss sphere", "outline.sphere");
  run_button(context, "Resample by normals", "outline.resample");
  run_button(context, "Add loop", "outline.add_loop");
  run_button(context, "Convert to polyhedron", "outline.convert");
}

ObjectProperties<OutlineSettings> outline_properties() {
  return {settings_part, spacing_properties};
}

void outline_point_section(PanelContext& context) {
  const Object* object = active_outline(context.editor);
  if (!object) return;
  const std::set<Index> points = selected_points(context.editor, *object);
  if (points.empty()) return;
  heading(context, context.tr.counted(points.size(), "1 point", "{0} points").c_str());
  const auto step = [&](const char* one, const char* many) {
    return points.size() == 1 ? std::string(one) : fill(many, {std::to_string(points.size())});
  };
  tilt_row(context, *object, points, step(translatable("Turn normal"), translatable("Turn {0} normals")));
  position_row(context, *object, points, step("Move vertex", "Move {0} vertices"));
  run_button(context, "Spread normals", "outline.spread");
  run_button(context, "Insert points", "outline.insert_points");
}

void draw_outline_fix(PanelContext& context, const Object& object, const Message& error) {
  if (!object.outline() || object.locked) return;
  const GaussMode mode = object.outline()->settings.mode;
  const auto offer = [&](const char* label, const char* id, GaussMode other) {
    if (mode == other) return;
    if (row_button(context, id, label, ""))
      bind_part(context, object, settings_part)
          .commit(mode_steps[static_cast<std::size_t>(other)],
                  [&](OutlineSettings& changed) { choose_mode(changed, other); });
  };
  const bool not_dome = error.code == e_not_convex || error.code == e_mixed_curvature ||
                        error.code == e_image_crosses || error.code == e_same_normal;
  if (not_dome) offer("Use mode Position", "outline_position", GaussMode::position);
  if (error.code == e_no_curvature || error.code == e_negative_curvature)
    offer("Use mode Round", "outline_umbilic", GaussMode::umbilic);
}

namespace {

bool row_of_outline(const Editor& editor) {
  return editor.active_object()->outline() != nullptr;
}
bool row_of_outline_shape(const Editor& editor) {
  const OutlineSource* source = editor.active_object()->outline();
  return source && !source->outline->has_curvature() && source->settings.mode != GaussMode::position;
}
bool row_of_gap_limit(const Editor& editor) {
  const OutlineSource* source = editor.active_object()->outline();
  return source && source->settings.mode != GaussMode::position && source->settings.mode != GaussMode::paper;
}
bool row_of_gap(const Editor& editor) {
  return row_of_gap_limit(editor) && editor.active_object()->outline()->settings.gap.has_value();
}
bool row_of_outline_points(const Editor& editor) {
  const Object* outline = active_outline(editor);
  return outline && !selected_points(editor, *outline).empty();
}

constexpr const char* no_such_outline =
    translatable("The active object is no outline, or one whose mode does without this.");
constexpr const char* no_points = translatable("No points are selected. Press 1 and click one.");

constexpr std::array rows_of_outlines{
    PanelRow{"outline_mode", "Mode", "How the control points inside are found", "Outline", row_of_outline},
    PanelRow{"outline_sign", "Shape", "Which way the surface bends", "Outline", row_of_outline_shape,
             no_such_outline},
    PanelRow{"outline_gap_limited", "Limit gap",
             "Inserts points until the control points' polyhedron and the tangent planes' are nowhere "
             "further apart",
             "Outline", row_of_gap_limit, no_such_outline},
    PanelRow{"outline_gap", "Largest gap",
             "Between the control points' polyhedron and the tangent planes'; 0 asks for none", "Outline",
             row_of_gap, no_such_outline},
    PanelRow{"outline_surface", "Surface", "How the surface spans the curves", "Outline", row_of_outline},
    PanelRow{"outline_tilt", "Tilt",
             "Angle of the normals from the middle of all normals; more leans outward", "Outline",
             row_of_outline_points, no_points},
};

}  // namespace

std::vector<PanelRow> outline_panel_rows() {
  return {rows_of_outlines.begin(), rows_of_outlines.end()};
}

}  // namespace hariko
