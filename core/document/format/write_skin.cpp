#include "core/document/format/format_names.hpp"
#include "core/document/format/write_source.hpp"

namespace hariko::detail {

namespace {

void write_curve(DocumentText& out, std::string_view name, const SubdivisionCurve& curve) {
  out.key(name);
  out.open('{');
  out.key("points");
  out.vectors(curve.points);
  out.key("closed");
  out.boolean(curve.closed);
  if (!curve.sharp.empty()) {
    std::vector<std::uint32_t> sharp;
    for (int i = 0; i < curve.size(); ++i)
      if (curve.is_sharp(i)) sharp.push_back(std::uint32_t(i));
    out.key("sharp");
    out.numbers(sharp);
  }
  out.close('}');
}

void write_section(DocumentText& out, const SkinSection& section) {
  out.open('{');
  out.key("id");
  out.number(section.id);
  out.key("v");
  out.number(section.v);
  out.key("closed");
  out.boolean(section.closed);
  if (section.direction_chosen) {
    out.key("direction_chosen");
    out.boolean(true);
  }
  if (section.start_chosen) {
    out.key("start_chosen");
    out.boolean(true);
  }
  if (section.reference) {
    out.key("reference");
    out.vector(*section.reference);
  }
  std::vector<Vector3> points;
  std::vector<std::uint32_t> ids, sharp;
  for (const SectionPoint& point : section.points) {
    if (point.sharp) sharp.push_back(std::uint32_t(points.size()));
    points.push_back(point.position);
    ids.push_back(point.id);
  }
  out.key("points");
  out.vectors(points);
  out.key("ids");
  out.numbers(ids);
  if (!sharp.empty()) {
    out.key("sharp");
    out.numbers(sharp);
  }
  out.close('}');
}

void write_strip(DocumentText& out, std::uint32_t id, std::uint32_t first, std::uint32_t second) {
  out.raw("{\"id\": ");
  out.number(id);
  out.raw(", \"sections\": ");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? first : second); });
}

void write_link(DocumentText& out, const SkinLink& link) {
  write_strip(out, link.id, link.first, link.second);
  out.raw(", \"a\": ");
  out.numbers(link.a);
  out.raw(", \"b\": ");
  out.numbers(link.b);
  if (link.lasso) out.raw(", \"lasso\": true");
  if (link.locked) out.raw(", \"locked\": true");
  out.raw("}");
}

void write_merge(DocumentText& out, const SkinMerge& merge) {
  write_strip(out, merge.id, merge.first, merge.second);
  out.raw(", \"side\": ");
  out.string(name_of(merge.side, strip_side_names));
  out.raw(", \"members\": ");
  out.numbers(merge.members);
  out.raw(", \"target\": ");
  out.number(merge.target);
  out.raw(", \"v\": ");
  out.number(merge.v);
  if (merge.locked) out.raw(", \"locked\": true");
  out.raw("}");
}

void write_smooth(DocumentText& out, const SmoothOptions& options) {
  out.key("smooth");
  out.open('{');
  out.key("columns");
  out.number(std::uint32_t(options.columns));
  out.key("rows");
  out.number(std::uint32_t(options.rows));
  out.key("parameters");
  out.string(name_of(options.parameters, parameters_names));
  out.key("blend");
  out.string(name_of(options.blend, blend_names));
  out.list("anchors", options.anchors, [&](const std::vector<double>& row) { out.numbers(row); });
  out.close('}');
}

void write_pleat(DocumentText& out, const PleatOptions& options) {
  out.key("pleat");
  out.open('{');
  out.key("rows");
  out.string(name_of(options.rows, row_names));
  out.key("quad_fans");
  out.boolean(options.quad_fans);
  out.key("collars");
  out.boolean(options.collars);
  out.key("exact");
  out.string(name_of(options.fit, fit_names));
  out.key("cost");
  out.string(name_of(options.cost, cost_names));
  out.key("tension");
  out.number(options.tension);
  out.key("density");
  out.number(options.density);
  out.close('}');
}

}  // namespace

void write_source(DocumentText& out, const SkinSource& source) {
  const Skin& skin = *source.skin;
  out.open('{');
  out.key("kind");
  out.string("skin");
  write_curve(out, "path", skin.path);
  if (skin.second_rail) write_curve(out, "rail2", *skin.second_rail);
  out.key("frame");
  out.string(name_of(skin.frame, frame_names));
  out.key("sections");
  out.open('[');
  for (const SkinSection& section : skin.sections) {
    out.next();
    write_section(out, section);
  }
  out.close(']');
  out.key("method");
  out.string(name_of(skin.method, skin_method_names));
  out.key("caps");
  out.string(name_of(skin.caps, caps_names));
  out.key("creases");
  out.boolean(skin.creases);
  out.key("flip_normals");
  out.boolean(skin.flip_normals);
  if (skin.mirror) {
    out.key("mirror");
    out.raw("{\"axis\": ");
    out.string(axis_names[std::size_t(skin.mirror->axis)]);
    out.raw(", \"position\": ");
    out.number(skin.mirror->position);
    out.raw("}");
  }
  write_smooth(out, skin.smooth);
  write_pleat(out, skin.pleat);
  out.list("links", skin.links, [&](const SkinLink& link) { write_link(out, link); });
  out.list("merges", skin.merges, [&](const SkinMerge& merge) { write_merge(out, merge); });
  out.kept(*source.kept);
  out.close('}');
}

}  // namespace hariko::detail
