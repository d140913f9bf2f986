#include "ui/outline/outline_rows.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

constexpr std::array mode_steps{translatable("Outline mode Curvature"), translatable("Outline mode Round"),
                                translatable("Outline mode Minkowski"),
                                translatable("Outline mode As published"),
                                translatable("Outline mode Position")};

using ChangeSettings = std::function<void(OutlineSettings&)>;

Result<Document> edit_settings(const Document& document, ObjectId id, const ChangeSettings& change) {
  const Object* object = document.find(id);
  if (!object || !object->outline()) return document;
  OutlineSettings settings = object->outline()->settings;
  change(settings);
  return set_outline_settings(document, id, settings);
}

void set(PanelContext& context, const Object& object, const std::string& step, const ChangeSettings& change) {
  context.editor.commit(edit_settings(context.editor.history.current(), object.id, change), step);
}

double outline_size(const Object& object) {
  const double size = object.outline()->outline->size();
  return size > 0 && std::isfinite(size) ? size : 1;
}

void method_rows(PanelContext& context, const Object& object) {
  const OutlineSource& source = *object.outline();
  const OutlineSettings& settings = source.settings;
  if (const auto chosen = choose(context, "outline_mode", "Mode", "How the control points inside are found",
                                 std::optional(settings.mode)))
    set(context, object, mode_steps[static_cast<std::size_t>(*chosen)],
        [&](OutlineSettings& changed) { changed.mode = *chosen; });
  if (!source.outline->has_curvature() && settings.mode != GaussMode::position)
    if (const auto chosen = choose(context, "outline_sign", "Shape", "Which way the surface bends",
                                   std::optional(settings.sign)))
      set(context, object, translatable("Shape of the outline"),
          [&](OutlineSettings& changed) { changed.sign = *chosen; });
}

/// A gap is asked for or not: without one there is no length to show.
void gap_rows(PanelContext& context, const Object& object) {
  const OutlineSettings& settings = object.outline()->settings;
  const double size = outline_size(object);
  const char* help =
      "Inserts points until the control points' polyhedron and the tangent planes' are nowhere further apart";
  if (const auto limited =
          check_row(context, "outline_gap_limited", "Limit gap", help, settings.gap.has_value())) {
    // A hundredth of the outline, in one digit.
    const double digit = std::pow(10, std::floor(std::log10(size / 100)));
    const double usual = std::max(1.0, std::round(size / 100 / digit)) * digit;
    set(context, object, translatable("Gap of the outline"),
        [&](OutlineSettings& changed) { changed.gap = *limited ? std::optional(usual) : std::nullopt; });
  }
  if (!settings.gap) return;
  Quantity gap = length_quantity(context.editor.document().unit, size);
  gap.low = 0;
  value_row(context,
            {"outline_gap", "Largest gap",
             "Between the control points' polyhedron and the tangent planes'; 0 asks for none",
             translatable("Gap of the outline"), gap},
            *settings.gap, [id = object.id, gap](const Document& document, const ValueChange& change) {
              return edit_settings(document, id, [&](OutlineSettings& changed) {
                const double wanted = change.apply(gap, changed.gap.value_or(0));
                changed.gap = wanted > 0 ? std::optional(wanted) : std::nullopt;
              });
            });
}

void density_rows(PanelContext& context, const Object& object) {
  const OutlineSettings& settings = object.outline()->settings;
  const ObjectId id = object.id;
  Quantity radius = plain_quantity(2, 0.05);
  radius.multiplies = true;
  radius.low = 0.2;
  radius.high = 3;
  radius.standard = 0.6;
  slider_row(context,
             {"outline_radius", "Spacing", "Of the points inside, in steps of the points along the loops",
              translatable("Spacing of the points inside"), radius},
             radius.low, radius.high, true, settings.radius,
             [id, radius](const Document& document, const ValueChange& change) {
               return edit_settings(document, id, [&](OutlineSettings& changed) {
                 changed.radius = change.apply(radius, changed.radius);
               });
             });
  Quantity count = plain_quantity(0, 10);
  count.low = 0;
  count.high = OutlineSettings::point_limit;
  count.whole = true;
  count.standard = OutlineSettings::point_limit;
  value_row(context,
            {"outline_count", "Most points", "Insertion inside ends at so many points",
             translatable("Number of points inside"), count},
            double(settings.most_points), [id, count](const Document& document, const ValueChange& change) {
              return edit_settings(document, id, [&](OutlineSettings& changed) {
                changed.most_points = Index(std::lround(change.apply(count, double(changed.most_points))));
              });
            });
  if (settings.mode != GaussMode::position && settings.mode != GaussMode::paper) gap_rows(context, object);
}

void button(PanelContext& context, const char* label, const char* id) {
  if (ImGui::Button((std::string(context.tr(label)) + "###" + id).c_str(), {-1, 0})) context.run(id);
  if (const Command* command = context.commands.find(id); command && ImGui::IsItemHovered())
    show_tip(context.tr(command->help.c_str()));
  context.marks.item(std::string("button.") + id);
}

/// The angle of a normal from the outline's axis about the loop: positive away from the surface.
double tilt_of(const Outline& outline, const Vector3& axis, const OutlinePoint& at) {
  const OutlineLoop& loop = outline.loops[at.loop];
  const std::size_t count = loop.points.size();
  const Vector3 tangent =
      (loop.points[(at.place + 1) % count] - loop.points[(at.place + count - 1) % count]).stableNormalized();
  const Vector3 up = axis - axis.dot(tangent) * tangent;
  return std::atan2(loop.normals[at.place].dot(tangent.cross(up)), loop.normals[at.place].dot(up));
}

/// Where the outline's normals point on the whole.
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
  std::array<std::optional<double>, 3> values;
  for (int axis = 0; axis < 3; ++axis)
    values[static_cast<std::size_t>(axis)] =
        common<double>(points, [&](Index number) { return position(outline, number)[axis]; });
  vector_row(context, "Position", "Coordinates of the point, in the object's own axes",
             {FieldSpec{"x", "X", "", step, length}, FieldSpec{"y", "Y", "", step, length},
              FieldSpec{"z", "Z", "", step, length}},
             values,
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
  method_rows(context, object);
  density_rows(context, object);
  const bool g2 = object.outline()->settings.curvature_continuous;
  constexpr std::array surfaces{enum_choice(Mode::fair), enum_choice(Mode::g2)};
  if (const auto chosen = choose(context, "outline_surface", "Surface", "How the surface spans the curves",
                                 surfaces, g2 ? 1 : 0))
    set(context, object, *chosen == 1 ? "Surface G2" : "Surface Fair",
        [&](OutlineSettings& changed) { changed.curvature_continuous = *chosen == 1; });
  const std::size_t given = object.outline()->outline->point_count();
  row_label(context, context.tr("Count"), context.tr("On the loops, and inserted inside"));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      fill(context.tr("{0} on the loops, {1} inside"),
           {std::to_string(given), std::to_string(inserted_points(context.editor, object))})
          .c_str());
  context.marks.item("outline.points");
  button(context, "Gauss sphere", "outline.sphere");
  button(context, "Resample by normals", "outline.resample");
  button(context, "Add loop", "outline.add_loop");
  button(context, "Convert to polyhedron", "outline.convert");
}

void outline_point_section(PanelContext& context) {
  const Object* object = active_outline(context.editor);
  if (!object) return;
  const std::set<Index> points = selected_points(context.editor, *object);
  if (points.empty()) return;
  heading(context, points.size() == 1
                       ? context.tr("1 point")
                       : fill(context.tr("{0} points"), {std::to_string(points.size())}).c_str());
  const auto step = [&](const char* one, const char* many) {
    return points.size() == 1 ? std::string(one) : fill(many, {std::to_string(points.size())});
  };
  tilt_row(context, *object, points, step(translatable("Turn normal"), translatable("Turn {0} normals")));
  position_row(context, *object, points, step("Move vertex", "Move {0} vertices"));
  button(context, "Spread normals", "outline.spread");
  button(context, "Insert points", "outline.insert_points");
}

void draw_outline_fix(PanelContext& context, const Object& object, const Message& error) {
  if (!object.outline() || object.locked) return;
  const GaussMode mode = object.outline()->settings.mode;
  const auto offer = [&](const char* label, const char* id, GaussMode other) {
    if (mode == other) return;
    if (ImGui::Button((std::string(context.tr(label)) + "###" + id).c_str(), {-1, 0}))
      set(context, object, mode_steps[static_cast<std::size_t>(other)],
          [&](OutlineSettings& changed) { changed.mode = other; });
    context.marks.item(std::string("button.") + id);
  };
  const bool not_dome = error.code == e_not_convex || error.code == e_mixed_curvature ||
                        error.code == e_image_crosses || error.code == e_same_normal;
  if (not_dome) offer("Use mode Position", "outline_position", GaussMode::position);
  if (error.code == e_no_curvature || error.code == e_negative_curvature)
    offer("Use mode Round", "outline_umbilic", GaussMode::umbilic);
}

}  // namespace hariko
