#include "core/document/format/write_dimensions.hpp"

#include "core/document/format/format_names.hpp"

namespace hariko::detail {

namespace {

void write_held(DocumentText& out, const SpaceAnchor& anchor) {
  out.raw("\"point\": ");
  out.vector(anchor.point);
}

void write_held(DocumentText& out, const ObjectAnchor& anchor) {
  out.raw(", \"point\": ");
  out.vector(anchor.point);
  if (!anchor.solid) return;
  out.raw(", \"solid\": ");
  out.number(*anchor.solid);
}

void write_held(DocumentText& out, const VertexAnchor& anchor) {
  out.raw(", \"vertex\": ");
  out.number(anchor.vertex.value);
  if (anchor.image) out.raw(", \"image\": true");
}

void write_held(DocumentText& out, const EdgeAnchor& anchor) {
  out.raw(", \"edge\": ");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? anchor.edge.low.value : anchor.edge.high.value); });
  out.raw(", \"share\": ");
  out.number(anchor.share);
  if (anchor.straight) out.raw(", \"straight\": true");
}

/// Writes the element as in the names of a paper model: an edge has two ids.
void write_held(DocumentText& out, const PatchAnchor& anchor) {
  const Element& element = anchor.element;
  const bool edge = element.kind == Element::Kind::edge;
  out.raw(", \"patch\": ");
  out.row(edge ? 3 : 2, [&](std::size_t i) {
    if (i == 0)
      out.string(name_of(element.kind, element_names));
    else
      out.number(static_cast<std::uint32_t>(edge && i == 1 ? element.id >> 32 : element.id));
  });
  out.raw(", \"side\": ");
  out.number(anchor.side);
  out.raw(", \"at\": ");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? anchor.parameter.x() : anchor.parameter.y()); });
}

void write_held(DocumentText& out, const NearestAnchor& anchor) {
  out.raw(", \"nearest\": ");
  out.vector(anchor.point);
}

void write_anchor(DocumentText& out, const Anchor& anchor) {
  out.raw("{");
  if (const ObjectId* object = object_of(anchor)) {
    out.raw("\"object\": ");
    out.number(object->value);
  }
  std::visit([&](const auto& held) { write_held(out, held); }, anchor);
  out.raw("}");
}

}  // namespace

void write_dimensions(DocumentText& out, const Dimensions& dimensions) {
  out.list("dimensions", dimensions, [&](const Dimension& dimension) {
    out.raw("{\"id\": ");
    out.number(dimension.id.value);
    out.raw(", \"kind\": ");
    out.string(name_of(dimension.kind, dimension_names));
    out.raw(", \"anchors\": ");
    out.row(dimension.anchors.size(), [&](std::size_t i) { write_anchor(out, dimension.anchors[i]); });
    if (!dimension.label.isZero(0)) {
      out.raw(", \"label\": ");
      out.vector(dimension.label);
    }
    out.raw("}");
  });
}

}  // namespace hariko::detail
