#include "ui/panels/skin_overlay.hpp"

#include <array>

#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr ImU32 link_colour = IM_COL32(0xf2, 0x8c, 0x28, 0xff),
                merge_colour = IM_COL32(0xb0, 0x6c, 0xe8, 0xff),
                path_colour = IM_COL32(0x5b, 0xb9, 0xa8, 0xff),
                section_colour = IM_COL32(0xf0, 0xf0, 0xf0, 0xe0), outline = IM_COL32(0x18, 0x19, 0x1c, 0xff);

class Drawing {
 public:
  Drawing(const Object& object, const Projector& projector, const ToolOverlay& overlay)
      : object_(object), projector_(projector), overlay_(overlay) {}

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

  void dot(const Vector3& point, float radius, ImU32 colour, bool square) const {
    const auto p = at(point);
    if (!p) return;
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

  void triangle(const std::array<Vector3, 3>& corners, ImU32 colour) const {
    const auto a = at(corners[0]), b = at(corners[1]), c = at(corners[2]);
    if (a && b && c) overlay_.list.AddTriangleFilled(*a, *b, *c, colour);
  }

  void diamond(const Vector3& point, float radius, ImU32 colour) const {
    const auto p = at(point);
    if (!p) return;
    const float r = overlay_.metrics.px(radius);
    const std::array<ImVec2, 4> corners{ImVec2(p->x, p->y - r), ImVec2(p->x + r, p->y),
                                        ImVec2(p->x, p->y + r), ImVec2(p->x - r, p->y)};
    overlay_.list.AddConvexPolyFilled(corners.data(), 4, colour);
    overlay_.list.AddPolyline(corners.data(), 4, outline, ImDrawFlags_Closed, overlay_.metrics.px(1.5F));
  }

  void mark(Marks* marks, const std::string& name, const Vector3& point) const {
    const auto p = marks ? at(point) : std::nullopt;
    if (p) marks->rect(name, {p->x - 2, p->y - 2}, {p->x + 2, p->y + 2});
  }

 private:
  const Object& object_;
  const Projector& projector_;
  const ToolOverlay& overlay_;
};

/// What is not as in a regular grid: triangles tinted, extraordinary points ringed.
void draw_irregularities(const Drawing& drawing, const SkinView& view) {
  for (const auto& triangle : view.triangles) drawing.triangle(triangle, with_alpha(merge_colour, 0.15F));
  for (const Vector3& point : view.extraordinary) drawing.ring(point, 4, with_alpha(section_colour, 0.75F));
}

void draw_lines(const Drawing& drawing, const SkinView& view) {
  // Those of the designer lie over the others.
  for (const bool own : {false, true})
    for (const SkinView::Line& line : view.lines) {
      if ((line.origin != LineOrigin::matched) != own) continue;
      const ImU32 colour = line.origin == LineOrigin::matched ? IM_COL32(0xc8, 0xcc, 0xd2, 0x90)
                           : line.origin == LineOrigin::link  ? link_colour
                                                              : merge_colour;
      drawing.polyline(line.points, colour, line.locked ? 2.8F : own ? 2.0F : 1.1F);
    }
}

void draw_handle(const Drawing& drawing, const SkinView::Handle& handle, bool hot, bool selected,
                 Marks* marks) {
  using Kind = SkinView::Handle::Kind;
  if (handle.kind == Kind::place) {
    drawing.ring(handle.position, 8, hot ? palette().secondary : path_colour);
    drawing.mark(marks, "skin.place." + std::to_string(handle.id), handle.position);
    return;
  }
  const bool limit = handle.kind == Kind::limit, path = handle.kind == Kind::path;
  const ImU32 colour = selected ? palette().accent
                       : hot    ? palette().secondary
                       : path   ? path_colour
                       : limit  ? section_colour
                                : IM_COL32(0xa8, 0xac, 0xb2, 0xff);
  drawing.dot(handle.position, (limit || path ? 3.5F : 2.5F) + (selected || hot ? 1.2F : 0), colour,
              handle.sharp);
  drawing.mark(marks,
               path    ? "skin.path." + std::to_string(handle.id & 0x3fffffffU)
               : limit ? "skin.limit." + std::to_string(handle.id)
                       : "skin.point." + std::to_string(handle.id),
               handle.position);
}

}  // namespace

void SkinOverlay::draw(const Editor& editor, const Projector& projector, const ToolOverlay& overlay,
                       const std::optional<Vector2>& pointer, Marks* marks) {
  const Object* object = shown_skin(editor);
  if (!object) return;
  const SkinView& view = cache_.of(editor, *object);
  const Drawing drawing(*object, projector, overlay);
  const SkinHit hit = pointer ? skin_hit(view, *object, projector, *pointer, editor.pixel_scale) : SkinHit{};
  draw_irregularities(drawing, view);
  draw_lines(drawing, view);
  for (const auto& path : view.paths) drawing.polyline(path, path_colour, 1.6F);
  for (const SkinView::Section& section : view.sections) {
    drawing.polyline(section.polygon, with_alpha(section_colour, 0.35F), 1, section.closed);
    drawing.polyline(section.curve, section_colour, 2);
  }
  const auto& chosen = editor.selection.of(object->id).vertices;
  for (std::size_t i = 0; i < view.handles.size(); ++i)
    draw_handle(drawing, view.handles[i], hit.kind == SkinHit::Kind::handle && hit.index == i,
                chosen.contains(VertexId{view.handles[i].id}), marks);
  for (std::size_t i = 0; i < view.diamonds.size(); ++i) {
    const bool hot = hit.kind == SkinHit::Kind::diamond && hit.index == i;
    drawing.diamond(view.diamonds[i].position, hot ? 8 : 6.5F, hot ? palette().secondary : merge_colour);
    drawing.mark(marks, "skin.diamond." + std::to_string(view.diamonds[i].merge), view.diamonds[i].position);
  }
}

}  // namespace hariko
