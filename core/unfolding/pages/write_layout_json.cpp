#include "core/exchange/number_text.hpp"
#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

void append_point(std::string& out, const Vector2& p) {
  out += '[';
  append_real(out, p.x());
  out += ',';
  append_real(out, p.y());
  out += ']';
}

}  // namespace

std::string write_layout_json(const SheetDrawing& drawing) {
  std::string out = "{\"format\":\"unfolding-1\",\"unit\":\"mm\",\"scale\":";
  append_real(out, drawing.scale);
  out += ",\"page_size\":[";
  append_real(out, drawing.page.width);
  out += ',';
  append_real(out, drawing.page.height);
  out += "],\"pages\":";
  append_integer(out, drawing.page_count);
  out += ",\n\"faces\":[";
  for (std::size_t k = 0; k < drawing.faces.size(); ++k) {
    const DrawnFace& face = drawing.faces[k];
    out += k ? ",\n{\"id\":" : "\n{\"id\":";
    append_integer(out, face.face);
    out += ",\"piece\":";
    append_integer(out, face.piece);
    out += ",\"page\":";
    append_integer(out, face.page);
    out += ",\"xy\":[";
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
      if (c) out += ',';
      append_point(out, face.corners[c]);
    }
    out += "]}";
  }
  out += "],\n\"folds\":[";
  for (std::size_t k = 0; k < drawing.folds.size(); ++k) {
    out += k ? ",[" : "[";
    append_integer(out, drawing.folds[k].faces[0]);
    out += ',';
    append_integer(out, drawing.folds[k].faces[1]);
    out += ']';
  }
  return out + "]}\n";
}

}  // namespace hariko
