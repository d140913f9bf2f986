#include <array>

#include "core/document/format/document_text.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/write_dimensions.hpp"
#include "core/document/format/write_paper.hpp"
#include "core/document/format/write_source.hpp"

namespace hariko {
namespace {

using Writer = detail::DocumentText;
using detail::write_source;

void write_shaping(Writer& out, const Shaping& shaping) {
  out.list("alpha", shaping.alpha, [&](const auto& entry) {
    out.row(2, [&](std::size_t i) { i == 0 ? out.number(entry.first.value) : out.number(entry.second); });
  });
  out.list("beta", shaping.beta, [&](const auto& entry) {
    out.row(3, [&](std::size_t i) {
      if (i < 2) out.number(i == 0 ? entry.first.low.value : entry.first.high.value);
      if (i == 2) out.number(entry.second);
    });
  });
  out.list("crease", shaping.crease, [&](const auto& entry) {
    out.row(2, [&](std::size_t i) { out.number(i == 0 ? entry.first.low.value : entry.first.high.value); });
  });
  out.list("tag", shaping.tag, [&](const auto& entry) {
    out.row(2, [&](std::size_t i) {
      i == 0 ? out.number(entry.first.value) : out.string(detail::name_of(entry.second, detail::tag_names));
    });
  });
  out.list("pin", shaping.pin, [&](const auto& entry) {
    out.raw("{\"vertex\": ");
    out.number(entry.first.value);
    out.raw(", \"kind\": ");
    out.string(detail::name_of(entry.second.kind, detail::pin_names));
    out.raw(", \"vectors\": ");
    out.row(entry.second.vectors.size(), [&](std::size_t i) { out.vector(entry.second.vectors[i]); });
    out.raw("}");
  });
  out.list("form", shaping.form, [&](const auto& entry) {
    out.raw("{\"vertex\": ");
    out.number(entry.first.value);
    out.raw(", \"edges\": ");
    out.row(entry.second.edges.size(), [&](std::size_t i) {
      const KeptForm::Edge& edge = entry.second.edges[i];
      const double numbers[] = {edge.turn,       edge.stretch, edge.offset.x(), edge.offset.y(),
                                edge.offset.z(), edge.lean,    edge.side};
      out.row(8, [&](std::size_t k) { k == 0 ? out.number(edge.to.value) : out.number(numbers[k - 1]); });
    });
    out.raw("}");
  });
  out.list("kept_area", shaping.kept_area, [&](const auto& entry) {
    out.row(2, [&](std::size_t i) { i == 0 ? out.number(entry.first.value) : out.number(entry.second); });
  });
}

void write_points(Writer& out, const std::array<Vector3, 4>& points) {
  out.row(4, [&](std::size_t i) { out.vector(points[i]); });
}

void write_attachment(Writer& out, EdgeId edge, const Attachment& attachment) {
  out.raw("{\"edge\": ");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? edge.low.value : edge.high.value); });
  if (attachment.frozen) {
    out.raw(", \"frozen\": {\"curve\": ");
    write_points(out, attachment.frozen->curve);
    out.raw(", \"row\": ");
    write_points(out, attachment.frozen->row);
    out.raw("}");
  } else {
    out.raw(", \"patch\": ");
    out.number(attachment.patch.value);
    out.raw(", \"side\": ");
    out.row(2, [&](std::size_t i) {
      out.number(i == 0 ? std::uint32_t(attachment.side.side) : attachment.side.place);
    });
    out.raw(", \"reversed\": ");
    out.boolean(attachment.reversed);
  }
  out.raw(", \"continuity\": ");
  out.string(detail::name_of(attachment.continuity, detail::continuity_names));
  out.raw(", \"adapts\": ");
  out.string(detail::name_of(attachment.adapts, detail::adapts_names));
  out.raw("}");
}

void write_source(Writer& out, const PolyhedronSource& source) {
  const Polyhedron& polyhedron = source.polyhedron;
  out.open('{');
  out.key("kind");
  out.string("polyhedron");
  out.key("mode");
  out.string(detail::name_of(source.mode, detail::mode_names));
  if (source.frames != Frames::equal) {
    out.key("frames");
    out.string(detail::name_of(source.frames, detail::frames_names));
  }
  if (source.mirror) {
    out.key("mirror");
    out.raw("{\"axis\": ");
    out.string(detail::name_of(source.mirror->axis, detail::axis_names));
    out.raw(", \"weld_distance\": ");
    out.number(source.mirror->weld_distance);
    out.raw("}");
  }
  if (source.preparation != Preparation{}) {
    out.key("preparation");
    out.raw("{\"split_concave\": ");
    out.raw(source.preparation.split_concave ? "true" : "false");
    if (source.preparation.merge_coplanar) out.raw(", \"merge_coplanar\": true");
    out.raw(", \"automatic_tension\": ");
    out.number(source.preparation.automatic_tension);
    out.raw("}");
  }
  out.key("origin");
  out.vector(source.origin);
  out.key("vertices");
  out.open('[');
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    out.next();
    out.row(4, [&](std::size_t i) {
      i == 0 ? out.number(polyhedron.vertex_id(v).value)
             : out.number(polyhedron.position(v)[static_cast<Eigen::Index>(i) - 1]);
    });
  }
  out.close(']');
  out.key("faces");
  out.open('[');
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto corners = polyhedron.topology().face_vertices(f);
    out.next();
    out.row(corners.size() + 1, [&](std::size_t i) {
      out.number(i == 0 ? polyhedron.face_id(f).value : polyhedron.vertex_id(corners[i - 1]).value);
    });
  }
  out.close(']');
  write_shaping(out, *source.shaping);
  out.list("attached", *source.attachments,
           [&](const auto& entry) { write_attachment(out, entry.first, entry.second); });
  out.kept(*source.kept);
  out.close('}');
}

void write_source(Writer& out, const PatchSource& source) {
  out.open('{');
  out.key("kind");
  out.string("patches");
  out.key("origin");
  out.vector(source.origin);
  out.key("columns");
  out.number(source.columns);
  out.key("rows");
  out.number(source.rows);
  out.key("points");
  out.open('[');
  for (Index v = 0; v < source.net.vertex_count(); ++v) {
    out.next();
    out.vector(source.net.position(v));
  }
  out.close(']');
  out.kept(*source.kept);
  out.close('}');
}

void write_source(Writer& out, const MeshSource& source) {
  const PolygonMesh& mesh = *source.mesh;
  out.open('{');
  out.key("kind");
  out.string("mesh");
  out.key("origin");
  out.vector(source.origin);
  out.key("vertices");
  out.open('[');
  for (const Vector3& position : mesh.positions) {
    out.next();
    out.vector(position);
  }
  out.close(']');
  out.key("faces");
  out.open('[');
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    out.next();
    out.row(corners.size(), [&](std::size_t i) { out.number(corners[i]); });
  }
  out.close(']');
  out.kept(*source.kept);
  out.close('}');
}

void write_source(Writer& out, const UnknownSource& source) {
  out.raw(*source.json);
}

void write_transform(Writer& out, const Similarity& transform) {
  const Eigen::Quaterniond& q = transform.rotation;
  const std::array<double, 4> rotation{q.w(), q.x(), q.y(), q.z()};
  out.raw("{\"rotation\": ");
  out.row(4, [&](std::size_t i) { out.number(rotation[i]); });
  out.raw(", \"scale\": ");
  out.number(transform.scale);
  out.raw(", \"translation\": ");
  out.vector(transform.translation);
  out.raw("}");
}

void write_combs(Writer& out, const CombSettings& combs) {
  out.raw(", \"combs\": {\"shown\": ");
  out.boolean(combs.shown);
  out.raw(", \"density\": ");
  out.number(static_cast<std::uint32_t>(combs.density));
  out.raw(", \"scale\": ");
  out.number(combs.scale);
  out.raw("}");
}

/// Writes the ranges that differ from the defaults.
void write_ranges(Writer& out, const DisplaySettings& display) {
  out.raw(", \"ranges\": {");
  bool first = true;
  for (std::size_t i = 0; i < display.ranges.size(); ++i) {
    const MapRange& range = display.ranges[i];
    if (range == MapRange{}) continue;
    if (!first) out.raw(", ");
    first = false;
    out.string(detail::ranges_members[i]);
    out.raw(": {\"mode\": ");
    out.string(detail::name_of(range.mode, detail::range_mode_names));
    out.raw(", \"low\": ");
    out.number(range.low);
    out.raw(", \"high\": ");
    out.number(range.high);
    out.raw("}");
  }
  out.raw("}");
}

/// Writes display settings that differ from the defaults, so that simple files stay simple.
void write_changed_display(Writer& out, const DisplaySettings& display) {
  const DisplaySettings plain;
  const auto word = [&](std::string_view name, std::string_view value) {
    out.raw(", ");
    out.string(name);
    out.raw(": ");
    out.string(value);
  };
  const auto flag = [&](std::string_view name, bool value, bool usual) {
    if (value == usual) return;
    out.raw(", ");
    out.string(name);
    out.raw(": ");
    out.boolean(value);
  };
  if (display.material != plain.material)
    word("material", detail::name_of(display.material, detail::material_names));
  flag("points", display.points, plain.points);
  if (display.wire != plain.wire) word("wire", detail::name_of(display.wire, detail::wire_names));
  flag("tensions", display.tensions, plain.tensions);
  flag("marks", display.marks, plain.marks);
  if (!(display.combs == plain.combs)) write_combs(out, display.combs);
  if (display.ranges != plain.ranges) write_ranges(out, display);
}

void write_display(Writer& out, const DisplaySettings& display) {
  const auto flag = [&](std::string_view name, bool value) {
    out.string(name);
    out.raw(": ");
    out.boolean(value);
    out.raw(", ");
  };
  out.raw("{");
  flag("surface", display.surface);
  flag("polyhedron", display.polyhedron);
  flag("network", display.network);
  out.raw("\"map\": ");
  out.string(detail::name_of(display.map, detail::map_names));
  out.raw(", \"density\": ");
  out.number(static_cast<std::uint32_t>(display.density));
  constexpr std::string_view digits = "0123456789abcdef";
  std::string colour = "#";
  for (const std::uint8_t part : {display.colour.red, display.colour.green, display.colour.blue}) {
    colour += digits[part / 16];
    colour += digits[part % 16];
  }
  out.raw(", \"colour\": ");
  out.string(colour);
  write_changed_display(out, display);
  out.raw("}");
}

void write_object(Writer& out, const Object& object) {
  out.open('{');
  out.key("id");
  out.number(object.id.value);
  out.key("name");
  out.string(object.name);
  out.key("visible");
  out.boolean(object.visible);
  out.key("locked");
  out.boolean(object.locked);
  out.key("transform");
  write_transform(out, object.transform);
  out.key("display");
  write_display(out, object.display);
  out.key("source");
  std::visit([&](const auto& source) { write_source(out, source); }, object.source);
  out.kept(*object.kept);
  out.close('}');
}

void write_making(Writer& out, const MakingSettings& making) {
  out.key("making");
  out.raw("{\"pull\": ");
  out.vector(making.pull);
  out.raw(", \"draft\": ");
  out.number(making.draft);
  out.raw(", \"radius\": ");
  out.number(making.radius);
  out.raw(", \"thickness\": ");
  out.number(making.thickness);
  if (making.reference != ObjectId{}) {
    out.raw(", \"reference\": ");
    out.number(making.reference.value);
  }
  out.raw("}");
}

}  // namespace

std::string write_document(const Document& document) {
  Writer out;
  out.open('{');
  out.key("format");
  out.string("hariko");
  out.key("version");
  out.number(static_cast<std::uint32_t>(format_version));
  out.key("unit");
  out.string(detail::name_of(document.unit, detail::unit_names));
  out.key("next_object_id");
  out.number(document.next_object_id.value);
  out.key("objects");
  out.open('[');
  for (const auto& object : document.objects) {
    out.next();
    write_object(out, *object);
  }
  out.close(']');
  detail::write_dimensions(out, *document.dimensions);
  if (document.making != MakingSettings{}) write_making(out, document.making);
  if (document.paper) {
    out.key("paper");
    detail::write_paper(out, *document.paper);
  }
  out.kept(*document.kept);
  out.close('}');
  return out.take();
}

}  // namespace hariko
