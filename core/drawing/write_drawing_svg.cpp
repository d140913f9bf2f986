#include "core/drawing/write_drawing_svg.hpp"

#include <cmath>

#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

struct Pen {
  double width;
  const char* colour;
};

Pen pen_of(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::silhouette:
      return {1.8, "#111111"};
    case StrokeKind::section:
      return {1.8, "#b3261e"};
    case StrokeKind::border:
    case StrokeKind::crease:
      return {1.3, "#111111"};
    case StrokeKind::network:
      break;
  }
  return {0.7, "#5a6068"};
}

void append_rounded(std::string& out, double value) {
  append_real(out, std::round(100 * value) / 100 + 0.0);
}

void append_path(std::string& out, const Stroke& stroke) {
  const bool closed = stroke.points.size() > 3 && stroke.points.front() == stroke.points.back();
  const std::size_t count = stroke.points.size() - (closed ? 1 : 0);
  out += "<path d=\"";
  for (std::size_t i = 0; i < count; ++i) {
    out += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
    append_rounded(out, stroke.points[i].x());
    out += ' ';
    append_rounded(out, stroke.points[i].y());
  }
  if (closed) out += 'Z';
  out += "\"/>\n";
}

void open_layer(std::string& out, StrokeKind kind, bool hidden) {
  const Pen pen = pen_of(kind);
  const std::string name = std::string(to_string(kind)) + (hidden ? "-hidden" : "");
  out += "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + name + "\" stroke=\"" +
         pen.colour + "\" stroke-width=\"";
  append_real(out, hidden ? 0.6 * pen.width : pen.width);
  out += hidden ? "\" stroke-dasharray=\"4 3\">\n" : "\">\n";
}

}  // namespace

std::string write_drawing_svg(const LineDrawing& drawing, std::string_view unit) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
  append_real(out, drawing.width);
  out += unit;
  out += "\" height=\"";
  append_real(out, drawing.height);
  out += unit;
  out += "\" viewBox=\"0 0 ";
  append_real(out, drawing.width);
  out += ' ';
  append_real(out, drawing.height);
  out += "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const bool hidden : {true, false})
    for (const StrokeKind kind : stroke_kinds) {
      bool open = false;
      for (const Stroke& stroke : drawing.strokes) {
        if (stroke.kind != kind || stroke.hidden != hidden) continue;
        if (!open) open_layer(out, kind, hidden);
        open = true;
        append_path(out, stroke);
      }
      if (open) out += "</g>\n";
    }
  return out + "</svg>\n";
}

}  // namespace hariko
