#include "core/drawing/write_drawing_svg.hpp"

#include <cmath>

#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

/// Pens of technical drawings (ISO 128): thick, medium and thin lines, whose widths differ by factors of 1.4
/// to 2.
struct Pen {
  double width;  ///< mm
  const char* colour;
};

Pen pen_of(LineKind kind) {
  switch (kind) {
    case LineKind::silhouette:
      return {0.5, "#111111"};
    case LineKind::section:
      return {0.5, "#b3261e"};
    case LineKind::border:
    case LineKind::crease:
      return {0.35, "#111111"};
    case LineKind::network:
      break;
  }
  return {0.18, "#5a6068"};
}

constexpr double hidden_width = 0.6;            ///< relative to the width of visible lines
constexpr double dash_length = 1.2, gap = 0.9;  ///< mm

class SvgWriter {
 public:
  explicit SvgWriter(PageUnit unit)
      : unit_(unit == PageUnit::pixel ? "px" : "mm"),
        scale_(unit == PageUnit::pixel ? 1 : 1 / pixels_per_millimetre),
        rounding_(unit == PageUnit::pixel ? 100 : 1000) {}

  std::string write(const LineDrawing& drawing) {
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
    append_pixels(drawing.width);
    out_ += unit_;
    out_ += "\" height=\"";
    append_pixels(drawing.height);
    out_ += unit_;
    out_ += "\" viewBox=\"0 0 ";
    append_pixels(drawing.width);
    out_ += ' ';
    append_pixels(drawing.height);
    out_ += "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const bool hidden : {true, false})
      for (const LineKind kind : line_kinds) append_layer(drawing, kind, hidden);
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  void append_rounded(double value) { append_real(out_, std::round(rounding_ * value) / rounding_ + 0.0); }
  void append_pixels(double value) { append_rounded(scale_ * value); }
  void append_millimetres(double value) { append_pixels(pixels_per_millimetre * value); }

  void append_layer(const LineDrawing& drawing, LineKind kind, bool hidden) {
    bool open = false;
    for (const PageLine& stroke : drawing.lines) {
      if (stroke.kind != kind || stroke.hidden != hidden) continue;
      if (!open) open_layer(kind, hidden);
      open = true;
      append_path(stroke);
    }
    if (open) out_ += "</g>\n";
  }

  void open_layer(LineKind kind, bool hidden) {
    const Pen pen = pen_of(kind);
    const std::string name = std::string(to_string(kind)) + (hidden ? "-hidden" : "");
    out_ += "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + name + "\" stroke=\"" +
            pen.colour + "\" stroke-width=\"";
    append_millimetres(hidden ? hidden_width * pen.width : pen.width);
    if (hidden) {
      out_ += "\" stroke-dasharray=\"";
      append_millimetres(dash_length);
      out_ += ' ';
      append_millimetres(gap);
    }
    out_ += "\">\n";
  }

  void append_path(const PageLine& stroke) {
    const bool closed = stroke.points.size() > 3 && stroke.points.front() == stroke.points.back();
    const std::size_t count = stroke.points.size() - (closed ? 1 : 0);
    out_ += "<path d=\"";
    for (std::size_t i = 0; i < count; ++i) {
      out_ += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
      append_pixels(stroke.points[i].x());
      out_ += ' ';
      append_pixels(stroke.points[i].y());
    }
    if (closed) out_ += 'Z';
    out_ += "\"/>\n";
  }

  const char* unit_;
  double scale_;     ///< numbers of the file per pixel
  double rounding_;  ///< reciprocal of the rounding unit
  std::string out_;
};

}  // namespace

std::string write_drawing_svg(const LineDrawing& drawing, PageUnit unit) {
  return SvgWriter(unit).write(drawing);
}

}  // namespace hariko
