#include "core/base/text/base64.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/write_source.hpp"

namespace hariko::detail {

void write_source(DocumentText& out, const PictureSource& source) {
  out.open('{');
  out.key("kind");
  out.string("picture");
  out.key("path");
  out.string(source.path);
  out.key("pixels");
  out.row(2, [&](std::size_t i) { out.number(i == 0 ? source.columns : source.rows); });
  out.key("width");
  out.number(source.width);
  out.key("layer");
  out.string(name_of(source.look.layer, layer_names));
  out.key("opacity");
  out.number(source.look.opacity);
  if (source.look.only_from) {
    out.key("only_from");
    out.string(name_of(*source.look.only_from, side_names));
  }
  if (source.packed()) {
    out.key("data");
    out.raw("\"" + to_base64(*source.bytes) + "\"");
  }
  out.kept(*source.kept);
  out.close('}');
}

}  // namespace hariko::detail
