#include "core/document/format/write_source.hpp"

namespace hariko::detail {

namespace {

void write_patch(DocumentText& out, const BezierPatch& patch) {
  out.open('{');
  out.key("degree");
  out.row(2, [&](std::size_t i) { out.number(std::uint32_t(i == 0 ? patch.degree_s : patch.degree_t)); });
  out.key("points");
  out.open('[');
  for (const Vector3& point : patch.points) {
    out.next();
    out.vector(point);
  }
  out.close(']');
  if (patch.rational()) {
    out.key("weights");
    out.numbers(patch.weights);
  }
  out.close('}');
}

}  // namespace

void write_source(DocumentText& out, const BezierSource& source) {
  out.open('{');
  out.key("kind");
  out.string("bezier");
  out.key("origin");
  out.vector(source.origin);
  out.key("patches");
  out.open('[');
  for (const BezierPatch& patch : *source.patches) {
    out.next();
    write_patch(out, patch);
  }
  out.close(']');
  out.kept(*source.kept);
  out.close('}');
}

}  // namespace hariko::detail
