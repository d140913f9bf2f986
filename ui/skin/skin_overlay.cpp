
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/skinning/skin_messages.hpp"
#include "ui/skin/skin_tools.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/skin_sight.hpp"

namespace hariko {

namespace {

struct SkinColours {
  ImU32 link, merge, path, section;
  ImU32 matched;  ///< lines that nobody drew
  ImU32 control;  ///< control points
  ImU32 outline;  ///< round points
};

/// Seen on the background of the theme and on the surface.
SkinColours colours_of(ThemeId theme) {
  if (theme == ThemeId::light)
    return {IM_COL32(0xb8, 0x55, 0x00, 0xff), IM_COL32(0x7a, 0x35, 0xc4, 0xff),
            IM_COL32(0x0d, 0x73, 0x66, 0xff), IM_COL32(0x1c, 0x20, 0x26, 0xe0),
            IM_COL32(0x3a, 0x40, 0x48, 0x90), IM_COL32(0x5d, 0x63, 0x6b, 0xff),
            IM_COL32(0xf8, 0xf9, 0xfa, 0xff)};
  return {IM_COL32(0xf2, 0x8c, 0x28, 0xff), IM_COL32(0xb0, 0x6c, 0xe8, 0xff),
          IM_COL32(0x5b, 0xb9, 0xa8, 0xff), IM_COL32(0xf0, 0xf0, 0xf0, 0xe0),
          IM_COL32(0xc8, 0xcc, 0xd2, 0x90), IM_COL32(0xa8, 0xac, 0xb2, 0xff),
          IM_COL32(0x18, 0x19, 0x1c, 0xff)};
}

constexpr float hidden_alpha = 0.3F;

class Drawing {
 public:
  Drawing(const Object& object, const Projector& projector, const ToolOverlay& overlay, ThemeId theme,
          const SkinSight& sight)
      : colours(colours_of(theme)),
        object_(object),
        projector_(projector),
        overlay_(overlay),
        sight_(sight) {}

  const SkinColours colours;

  std::optional<ImVec2> at(const Vector3& point) const {
    const auto projected = projector_.project(object_.transform.apply(point));
    if (!projected) return {};
    // Far beyond the window ImGui's single precision would make lines tremble.
    if (projected->head<2>().cwiseAbs().maxCoeff() > 1e5) return {};
    return on_screen(overlay_, projected->head<2>());
  }

  void polyline(const std::vector<Vector3>& points, ImU32 colour, float width, bool closed = false) const {
    std::vector<ImVec2> run;
    const auto flush = [&] {
      if (run.size() > 1)
        overlay_.list.AddPolyline(run.data(), int(run.size()), colour, 0, overlay_.metrics.px(width));
      run.clear();
    };
    for (std::size_t i = 0; i < points.size() + (closed ? 1 : 0); ++i) {
      if (const auto p = at(points[i % points.size()]))
        run.push_back(*p);
      else
        flush();
    }
    flush();
  }

  /// On the surface: what is hidden is pale.
  void polyline_on_surface(const std::vector<Vector3>& points, ImU32 colour, float width) const {
    std::vector<char> hidden;
    for (const Vector3& p : points) hidden.push_back(sight_.hides(p));
    // A span is as pale as its ends are; where they differ, as its end.
    for (std::size_t i = 0; i + 1 < points.size();) {
      std::size_t j = i + 1;
      while (j + 1 < points.size() && hidden[j + 1] == hidden[i + 1]) ++j;
      polyline({points.begin() + std::ptrdiff_t(i), points.begin() + std::ptrdiff_t(j) + 1},
               hidden[i + 1] ? with_alpha(colour, hidden_alpha) : colour, width);
      i = j;
    }
  }

  void dot(const Vector3& point, float radius, ImU32 colour, bool square, bool pale) const {
    const auto p = at(point);
    if (!p) return;
    if (pale) colour = with_alpha(colour, 0.5F);
    const ImU32 outline = pale ? 0 : colours.outline;
    const float r = overlay_.metrics.px(radius), rim = overlay_.metrics.px(1.5F);
    if (square) {
      overlay_.list.AddRectFilled({p->x - r - rim, p->y - r - rim}, {p->x + r + rim, p->y + r + rim},
                                  outline);
      overlay_.list.AddRectFilled({p->x - r, p->y - r}, {p->x + r, p->y + r}, colour);
    } else {
      overlay_.list.AddCircleFilled(*p, r + rim, outline);
      overlay_.list.AddCircleFilled(*p, r, colour);
    }
  }

  void ring(const Vector3& point, float radius, ImU32 colour) const {
    if (const auto p = at(point))
      overlay_.list.AddCircle(*p, overlay_.metrics.px(radius), colour, 0, overlay_.metrics.px(1.3F));
  }

  /// A convex polygon.
  void fill(std::span<const Vector3> corners, ImU32 colour) const {
    std::vector<ImVec2> pixels;
    for (const Vector3& corner : corners)
      if (const auto p = at(corner)) pixels.push_back(*p);
    if (pixels.size() == corners.size())
      overlay_.list.AddConvexPolyFilled(pixels.data(), int(pixels.size()), colour);
  }

  /// A head between two points, towards the second.
  void arrow(const Vector3& from, const Vector3& to, ImU32 colour) const {
    const auto p = at(from), q = at(to);
    if (!p || !q) return;
    const Vector2 way(q->x - p->x, q->y - p->y);
    if (way.norm() < 1e-3) return;
    const Vector2 middle(0.5 * (p->x + q->x), 0.5 * (p->y + q->y));
    const Vector2 ahead = double(overlay_.metrics.px(6)) * way.normalized(),
                  aside(0.7 * -ahead.y(), 0.7 * ahead.x());
    const auto corner = [](const Vector2& v) { return ImVec2(float(v.x()), float(v.y())); };
    overlay_.list.AddTriangleFilled(corner(middle + ahead), corner(middle - ahead + aside),
                                    corner(middle - ahead - aside), colour);
  }

  void diamond(const Vector3& point, float radius, ImU32 colour) const {
    const auto p = at(point);
    if (!p) return;
    const float r = overlay_.metrics.px(radius);
    const std::array<ImVec2, 4> corners{ImVec2(p->x, p->y - r), ImVec2(p->x + r, p->y),
                                        ImVec2(p->x, p->y + r), ImVec2(p->x - r, p->y)};
    overlay_.list.AddConvexPolyFilled(corners.data(), 4, colour);
    overlay_.list.AddPolyline(corners.data(), 4, colours.outline, ImDrawFlags_Closed,
                              overlay_.metrics.px(1.5F));
  }

  void mark(Marks* marks, const std::string& name, const Vector3& point) const {
    const auto p = marks ? at(point) : std::nullopt;
    if (p) marks->rect(name, {p->x - 2, p->y - 2}, {p->x + 2, p->y + 2});
  }

 private:
  const Object& object_;
  const Projector& projector_;
  const ToolOverlay& overlay_;
  const SkinSight& sight_;
};

/// Subject of an error: a point, all of the section that has it, or the path.
struct Wrong {
  std::optional<std::uint32_t> point;
  bool section = false, path = false;
};

Wrong wrong_of(const Editor& editor, const Object& object) {
  const SurfaceView* shown = editor.view_of(object.id);
  if (!shown || !shown->error) return {};
  const Code code = shown->error->code;
  Wrong out;
  out.path = code == e_path_cusp || code == e_path_short;
  if (shown->error->element.kind != Element::Kind::vertex) return out;
  out.point = std::uint32_t(shown->error->element.id);
  const std::array of_sections{e_section_order, e_section_range, e_few_points,
                               e_point_section, e_open_closed,   e_rail};
  out.section = std::find(of_sections.begin(), of_sections.end(), code) != of_sections.end();
  return out;
}

/// The plane of the mirror, as large as the skin.
void draw_mirror(const Drawing& drawing, const Skin& skin, Marks* marks) {
  const MirrorPlane& plane = *skin.mirror;
  Box3 box;
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& p : section.points) box.extend(p.position);
  for (const Vector3& p : skin.path.points) box.extend(p);
  if (box.isEmpty()) return;
  const double margin = 0.05 * box.sizes().maxCoeff();
  const int u = (plane.axis + 1) % 3, v = (plane.axis + 2) % 3;
  // Round the rectangle.
  std::vector<Vector3> corners(4, plane.point());
  for (const std::size_t i : {0U, 1U, 2U, 3U}) {
    corners[i][u] = i == 1 || i == 2 ? box.max()[u] + margin : box.min()[u] - margin;
    corners[i][v] = i >= 2 ? box.max()[v] + margin : box.min()[v] - margin;
  }
  drawing.fill(corners, axis_colour(plane.axis, 22));
  drawing.polyline(corners, axis_colour(plane.axis, 150), 1.2F, true);
  drawing.mark(marks, "skin.mirror", corners[0]);
}

/// Irregularities, which are not as in a regular grid: triangles tinted, extraordinary points ringed.
void draw_irregularities(const Drawing& drawing, const SkinView& view, const SkinSight& sight) {
  for (const auto& triangle : view.triangles)
    drawing.fill(triangle, with_alpha(drawing.colours.merge, 0.15F));
  for (const Vector3& point : view.extraordinary)
    if (!sight.hides(point)) drawing.ring(point, 4, with_alpha(drawing.colours.section, 0.75F));
}

void draw_lines(const Drawing& drawing, const SkinView& view) {
  // Those of the designer lie over the others.
  for (const bool own : {false, true})
    for (const SkinView::Line& line : view.lines) {
      if ((line.origin != LineOrigin::matched) != own) continue;
      const ImU32 colour = line.origin == LineOrigin::matched ? drawing.colours.matched
                           : line.origin == LineOrigin::link  ? drawing.colours.link
                                                              : drawing.colours.merge;
      drawing.polyline_on_surface(line.points, colour, line.locked ? 2.8F : own ? 2.0F : 1.1F);
    }
}

/// Looks of a handle.
enum class HandleState { plain, pale, hot, selected, wrong };

void draw_handle(const Drawing& drawing, const SkinView::Handle& handle, HandleState state, Marks* marks) {
  using Kind = SkinView::Handle::Kind;
  if (handle.kind == Kind::place) {
    drawing.ring(handle.position, 8, state == HandleState::hot ? palette().secondary : drawing.colours.path);
    drawing.mark(marks, "skin.place." + std::to_string(handle.id), handle.position);
    return;
  }
  const bool limit = handle.kind == Kind::limit, path = handle.kind == Kind::path;
  const ImU32 colour = state == HandleState::wrong      ? palette().error
                       : state == HandleState::selected ? palette().accent
                       : state == HandleState::hot      ? palette().secondary
                       : path                           ? drawing.colours.path
                       : limit                          ? drawing.colours.section
                                                        : drawing.colours.control;
  const bool quiet = state == HandleState::plain || state == HandleState::pale;
  drawing.dot(handle.position, (limit || path ? 3.5F : 2.5F) + (quiet ? 0 : 1.2F), colour, handle.sharp,
              state == HandleState::pale);
  const bool rail = path && handle.id >= rail_point_ids;
  drawing.mark(marks,
               rail    ? "skin.rail." + std::to_string(handle.id - rail_point_ids)
               : path  ? "skin.path." + std::to_string(handle.id - path_point_ids)
               : limit ? "skin.limit." + std::to_string(handle.id)
                       : "skin.point." + std::to_string(handle.id),
               handle.position);
}

}  // namespace

std::optional<std::unique_ptr<Tool>> SkinOverlay::press(const ToolContext& context,
                                                        const PointerEvent& press) {
  if (context.editor.view.surfaces_only) return {};
  auto tool = skin_tool_at(context, press);
  return tool ? std::optional(std::move(tool)) : std::nullopt;
}

void SkinOverlay::draw(const ToolContext& context, const LayerPane& pane) {
  const Editor& editor = context.editor;
  const Projector& projector = pane.projector;
  const ToolOverlay& overlay = pane.overlay;
  const std::optional<Vector2>& pointer = pane.pointer;
  Marks* marks = pane.active ? &pane.marks : nullptr;
  const Object* object = shown_skin(editor);
  if (!object || editor.view.surfaces_only) return;
  const SkinView& view = cache_.of(editor, *object);
  const SkinSight sight(editor, projector, view, *object);
  const Drawing drawing(*object, projector, overlay, editor.settings.theme, sight);
  const SkinColours& colours = drawing.colours;
  const Wrong wrong = wrong_of(editor, *object);
  const SkinHit hit = pointer ? sight.hit(projector, *pointer, editor.pixel_scale) : SkinHit{};
  if (object->skin()->skin->mirror) draw_mirror(drawing, *object->skin()->skin, marks);
  // Colours of a map are to be read as they are.
  if (shown_map(editor.view.map, *object) == SurfaceMap::shaded) draw_irregularities(drawing, view, sight);
  draw_lines(drawing, view);
  for (const auto& path : view.paths)
    drawing.polyline(path, wrong.path ? palette().error : colours.path, wrong.path ? 2.4F : 1.6F);
  const Skin& skin = *object->skin()->skin;
  for (const SkinView::Section& section : view.sections) {
    const int k = wrong.section ? skin.find_section(section.id) : -1;
    const bool red = k >= 0 && find_point(skin.sections[std::size_t(k)], *wrong.point) >= 0;
    drawing.polyline(section.polygon, with_alpha(colours.section, 0.35F), 1, section.closed);
    drawing.polyline_on_surface(section.curve, red ? palette().error : colours.section, 2);
    // Arrow in the first span: where the curve begins and which way it runs.
    if (constexpr std::size_t half = curve_samples / 2; section.curve.size() > 2 * half)
      drawing.arrow(section.curve[half - 1], section.curve[half + 1],
                    red ? palette().error : colours.section);
  }
  const auto& chosen = editor.selection.of(object->id).vertices;
  for (std::size_t i = 0; i < view.handles.size(); ++i) {
    const SkinView::Handle& handle = view.handles[i];
    const bool place = handle.kind == SkinView::Handle::Kind::place;
    const bool hot = hit.kind == SkinHit::Kind::handle && hit.index == i;
    const HandleState state = !place && wrong.point == handle.id               ? HandleState::wrong
                              : !place && chosen.contains(VertexId{handle.id}) ? HandleState::selected
                              : hot                                            ? HandleState::hot
                              : sight.hides_handle(i)                          ? HandleState::pale
                                                                               : HandleState::plain;
    // Handles that cannot be taken hold of are not shown.
    if (state != HandleState::pale || sight.through()) draw_handle(drawing, handle, state, marks);
  }
  for (std::size_t i = 0; i < view.diamonds.size(); ++i) {
    if (sight.hides(view.diamonds[i].position) && !sight.through()) continue;
    const bool hot = hit.kind == SkinHit::Kind::diamond && hit.index == i;
    drawing.diamond(view.diamonds[i].position, hot ? 8 : 6.5F, hot ? palette().secondary : colours.merge);
    drawing.mark(marks, "skin.diamond." + std::to_string(view.diamonds[i].merge), view.diamonds[i].position);
  }
}

}  // namespace hariko
