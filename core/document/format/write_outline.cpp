#include "core/document/format/format_names.hpp"
#include "core/document/format/write_source.hpp"

namespace hariko::detail {

namespace {

void write_loop(DocumentText& out, const OutlineLoop& loop) {
  out.open('{');
  out.key("points");
  out.vectors(loop.points);
  out.key("normals");
  out.vectors(loop.normals);
  if (!loop.curvature.empty()) {
    out.key("K");
    out.numbers(loop.curvature);
  }
  out.close('}');
}

}  // namespace

void write_source(DocumentText& out, const OutlineSource& source) {
  const OutlineSettings& settings = source.settings;
  out.open('{');
  out.key("kind");
  out.string("outline");
  out.key("loops");
  out.open('[');
  for (const OutlineLoop& loop : source.outline->loops) {
    out.next();
    write_loop(out, loop);
  }
  out.close(']');
  out.key("method");
  out.string(name_of(settings.mode, gauss_names));
  out.key("curvature_sign");
  out.string(name_of(settings.sign, sign_names));
  out.key("radius");
  out.number(settings.radius);
  out.key("most_points");
  out.number(settings.most_points);
  if (settings.gap) {
    out.key("gap");
    out.number(*settings.gap);
  }
  out.key("mode");
  out.string(outline_patch_names[settings.curvature_continuous ? 1 : 0]);
  out.kept(*source.kept);
  out.close('}');
}

}  // namespace hariko::detail
