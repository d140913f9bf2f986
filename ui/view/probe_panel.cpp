// The probe: what the surface is under the pointer, at the lower right, and at a point that was kept.

#include <imgui_internal.h>

#include <algorithm>

#include "ui/view/legend.hpp"
#include "ui/view/view_frame.hpp"

namespace hariko {

namespace {

struct Row {
  std::string name, value;
};

std::string vector_text(const Vector3& v, int digits) {
  return format_number(v.x(), digits) + "  " + format_number(v.y(), digits) + "  " +
         format_number(v.z(), digits);
}

std::vector<Row> rows_of(const PanelContext& context, const SurfacePoint& point,
                         const ProbeReading& reading) {
  const Language& tr = context.tr;
  const std::string unit(to_string(context.editor.document().unit));
  std::vector<Row> rows;
  const Object* object = context.editor.document().find(point.object);
  const SurfaceMap map = object ? shown_map(context.editor.view.map, *object) : SurfaceMap::shaded;
  // Curvature is told as the surface has it: the values of its maps lie between those at corners of
  // triangles.
  if (has_values(map) && !(reading.curvature && scale_power(map) > 0))
    rows.push_back({tr(std::string(title_of(map))), map_value_text(context.editor, tr, point)});
  if (reading.curvature) {
    const Curvature& c = *reading.curvature;
    if (map == SurfaceMap::mean)
      rows.push_back({tr(std::string(title_of(map))), format_number(c.mean, 4) + " 1/" + unit});
    rows.push_back({"k1  k2", format_number(c.k1, 4) + "  " + format_number(c.k2, 4) + " 1/" + unit});
    rows.push_back({tr("Gaussian"), format_number(c.gauss, 4) + " 1/" + unit + "\u00b2"});
  } else {
    rows.push_back({"k1  k2", tr("undefined")});
  }
  rows.push_back({tr("Normal"), vector_text(reading.normal, 3)});
  rows.push_back({tr("Position"), vector_text(reading.position, 4) + " " + unit});
  return rows;
}

/// The upper edge of the legend where it reaches into a box in a narrow view; else the lower edge of the box.
float edge_above_legend(const ImRect& box) {
  const ImGuiWindow* legend = ImGui::FindWindowByName(legend_window);
  return legend && legend->WasActive && legend->Rect().Overlaps(box) ? legend->Pos.y : box.Max.y;
}

/// Draws the rows with the lower right corner there, or above the legend; gives the box.
ImRect draw_rows(const PanelContext& context, const std::vector<Row>& rows, ImVec2 corner) {
  const Metrics& m = context.metrics;
  float names = 0, values = 0;
  for (const Row& row : rows) {
    names = std::max(names, ImGui::CalcTextSize(row.name.c_str()).x);
    values = std::max(values, ImGui::CalcTextSize(row.value.c_str()).x);
  }
  const float line = ImGui::GetTextLineHeight() + m.px(3);
  const ImVec2 size(names + values + m.px(36), line * float(rows.size()) + m.px(13));
  const float edge = edge_above_legend({corner.x - size.x, corner.y - size.y, corner.x, corner.y});
  if (edge < corner.y) corner.y = edge - m.px(6);
  const ImVec2 low(corner.x - size.x, corner.y - size.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, corner, palette().overlay, m.px(6));
  float y = low.y + m.px(8);
  for (const Row& row : rows) {
    list.AddText({low.x + m.px(10), y}, palette().dim_text, row.name.c_str());
    list.AddText({corner.x - m.px(10) - ImGui::CalcTextSize(row.value.c_str()).x, y}, palette().text,
                 row.value.c_str());
    y += line;
  }
  return {low, corner};
}

}  // namespace

void draw_probe(PanelContext& context, const Camera& camera, PixelSize size, const PanelRect& pane,
                const std::optional<SurfacePoint>& under_pointer) {
  const Metrics& m = context.metrics;
  Editor& editor = context.editor;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 corner(pane.max.x - m.px(8), pane.max.y - m.px(52));
  if (editor.kept_probe) {
    const auto reading = read_probe(editor, *editor.kept_probe);
    if (reading) {
      const ImRect box = draw_rows(context, rows_of(context, *editor.kept_probe, *reading), corner);
      context.marks.rect("probe.kept", box.Min, box.Max);
      corner.y = box.Min.y - m.px(6);
      if (const auto pixel = Projector(camera, size).project(reading->position)) {
        const double scale = double(pane.width()) / size.width;
        const ImVec2 at(pane.min.x + static_cast<float>(pixel->x() * scale),
                        pane.min.y + static_cast<float>(pixel->y() * scale));
        list.AddCircle(at, m.px(5.5F), IM_COL32(0, 0, 0, 170), 20, m.px(3));
        list.AddCircle(at, m.px(5.5F), palette().accent, 20, m.px(1.6F));
        list.AddCircleFilled(at, m.px(1.5F), palette().accent, 10);
      }
    } else {
      editor.kept_probe.reset();
    }
  }
  if (!under_pointer) return;
  const Object* object = editor.document().find(under_pointer->object);
  if (!object || shown_map(editor.view.map, *object) == SurfaceMap::shaded) return;
  if (const auto reading = read_probe(editor, *under_pointer)) {
    const ImRect box = draw_rows(context, rows_of(context, *under_pointer, *reading), corner);
    context.marks.rect("probe", box.Min, box.Max);
  }
}

}  // namespace hariko
