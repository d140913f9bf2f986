#include "core/document/format/write_paper.hpp"

#include "core/document/format/format_names.hpp"

namespace hariko::detail {

namespace {

void write_settings(DocumentText& out, const PaperSettings& settings) {
  const auto number = [&](std::string_view name, double value, bool first = false) {
    if (!first) out.raw(", ");
    out.string(name);
    out.raw(": ");
    out.number(value);
  };
  out.raw("{");
  number("scale", settings.scale, true);
  out.raw(", \"page\": ");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? settings.page.width : settings.page.height); });
  number("margin", settings.margin);
  number("gap", settings.gap);
  number("tab_height", settings.tab_height);
  number("least_tab", settings.least_tab);
  number("strip_width", settings.strip_width);
  out.raw(", \"inside\": ");
  out.boolean(settings.inside);
  number("flat_fold", settings.flat_fold);
  if (settings.merge_angle) number("merge_angle", *settings.merge_angle);
  out.raw(", \"fold_angles\": ");
  out.boolean(settings.fold_angles);
  out.raw("}");
}

/// Writes [object, vertex] for a reference mesh; [object, "face", id, side, u, v] for a surface, with two ids
/// for an edge.
void write_vertex(DocumentText& out, const PaperVertex& vertex) {
  out.raw("[");
  out.number(vertex.object.value);
  const auto next = [&](auto value) {
    out.raw(", ");
    out.number(value);
  };
  if (vertex.element.kind != Element::Kind::none) {
    out.raw(", ");
    out.string(name_of(vertex.element.kind, element_names));
    if (vertex.element.kind == Element::Kind::edge) next(static_cast<std::uint32_t>(vertex.element.id >> 32));
    next(static_cast<std::uint32_t>(vertex.element.id));
  }
  next(vertex.side);
  if (vertex.element.kind != Element::Kind::none) {
    next(vertex.u);
    next(vertex.v);
  }
  out.raw("]");
}

template <class Row>
void write_placed(DocumentText& out, const Row& corners, const PaperPlace& place) {
  const std::size_t n = corners.size();
  out.row(n + 4, [&](std::size_t i) {
    if (i < n)
      out.number(corners[i]);
    else if (i == n)
      out.number(place.page);
    else
      out.number(i == n + 1 ? place.angle : i == n + 2 ? place.x : place.y);
  });
}

}  // namespace

void write_paper(DocumentText& out, const PaperModel& paper) {
  out.open('{');
  out.key("objects");
  out.row(paper.objects.size(), [&](std::size_t i) { out.number(paper.objects[i].value); });
  out.key("of_polyhedra");
  out.boolean(paper.of_polyhedra);
  out.key("distance");
  out.number(paper.distance);
  out.key("normal_angle");
  out.number(paper.normal_angle);
  out.key("settings");
  write_settings(out, paper.settings);
  out.key("goal");
  out.string(name_of(paper.goal, goal_names));
  out.key("steps");
  out.number(static_cast<double>(paper.steps));
  out.list("vertices", paper.vertices, [&](const PaperVertex& vertex) { write_vertex(out, vertex); });
  const auto edges = [&](std::string_view name, const std::vector<PaperEdge>& list) {
    out.list(name, list,
             [&](const PaperEdge& edge) { out.row(2, [&](std::size_t i) { out.number(edge[i]); }); });
  };
  edges("folds", paper.folds);
  edges("cuts", paper.cuts);
  edges("own_folds", paper.own_folds);
  edges("own_cuts", paper.own_cuts);
  edges("tabs", paper.tabs);
  edges("strips", paper.strips);
  out.list("places", paper.places,
           [&](const PaperModel::FacetPlace& row) { write_placed(out, row.facet, row.place); });
  out.list("strip_places", paper.strip_places,
           [&](const PaperModel::StripPlace& row) { write_placed(out, row.edge, row.place); });
  out.kept(paper.kept);
  out.close('}');
}

}  // namespace hariko::detail
