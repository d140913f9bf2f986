#include <numbers>

#include "core/exchange/number_text.hpp"
#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

class SvgWriter {
 public:
  SvgWriter(const SheetDrawing& drawing, Index page) : drawing_(drawing), page_(page) {}

  std::string write() {
    head();
    faces();
    for (const SheetLayer layer : sheet_layers) {
      open_layer(to_string(layer));
      if (layer == SheetLayer::fold_mountain) folds(FoldKind::mountain);
      if (layer == SheetLayer::fold_valley) folds(FoldKind::valley);
      lines(layer);
      if (layer == SheetLayer::label) texts();
      out_ += "</g>\n";
    }
    open_layer("fold-flat");
    folds(FoldKind::flat);
    return std::move(out_) + "</g>\n</svg>\n";
  }

 private:
  void attribute(const char* name, double value) {
    out_ += ' ';
    out_ += name;
    out_ += "=\"";
    append_real(out_, value);
    out_ += '"';
  }
  void attribute(const char* name, std::uint64_t value) {
    out_ += ' ';
    out_ += name;
    out_ += "=\"";
    append_integer(out_, value);
    out_ += '"';
  }
  void ends(const Vector2& from, const Vector2& to) {
    attribute("x1", from.x());
    attribute("y1", drawing_.page.height - from.y());
    attribute("x2", to.x());
    attribute("y2", drawing_.page.height - to.y());
  }

  void head() {
    const double width = drawing_.page.width;
    out_ +=
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"";
    append_real(out_, width);
    out_ += "mm\" height=\"";
    append_real(out_, drawing_.page.height);
    out_ += "mm\" viewBox=\"0 0 ";
    append_real(out_, width);
    out_ += ' ';
    append_real(out_, drawing_.page.height);
    out_ += '"';
    attribute("data-scale", drawing_.scale);
    attribute("data-page", std::uint64_t{page_});
    attribute("data-pages", std::uint64_t{drawing_.page_count});
    out_ +=
        ">\n<style>\n"
        ".page{fill:#fff;stroke:none}\n.face{fill:none;stroke:none}\n"
        "line{stroke-width:0.2;stroke-linecap:round;stroke:#000}\n"
        "#fold-mountain line{stroke:#c22f2f;stroke-width:0.15}\n"
        "#fold-valley line{stroke:#2255bb;stroke-width:0.15;stroke-dasharray:1.6 1.1;stroke-linecap:butt}\n"
        "#fold-flat line{stroke:none}\n#tab line,#strip line{stroke:#777}\n"
        "#label line{stroke:#444}\n"
        "text{font-family:Helvetica,Arial,sans-serif;text-anchor:middle;fill:#222}\n</style>\n";
    out_ += "<rect class=\"page\"";
    attribute("width", drawing_.page.width);
    attribute("height", drawing_.page.height);
    out_ += "/>\n";
  }

  void faces() {
    out_ += "<g id=\"facets\">\n";
    for (const DrawnFace& face : drawing_.faces) {
      if (face.page != page_) continue;
      out_ += "<polygon class=\"face\"";
      attribute("data-face", std::uint64_t{face.face});
      attribute("data-piece", std::uint64_t{face.piece});
      attribute("data-page", std::uint64_t{face.page});
      out_ += " points=\"";
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        if (k) out_ += ' ';
        append_real(out_, face.corners[k].x());
        out_ += ',';
        append_real(out_, drawing_.page.height - face.corners[k].y());
      }
      out_ += "\"/>\n";
    }
    out_ += "</g>\n";
  }

  void open_layer(std::string_view name) {
    out_ += "<g id=\"";
    out_ += name;
    out_ += "\" inkscape:groupmode=\"layer\" inkscape:label=\"";
    out_ += name;
    out_ += "\">\n";
  }

  void folds(FoldKind kind) {
    const char* words[] = {"mountain", "valley", "flat"};
    for (const DrawnFold& fold : drawing_.folds) {
      if (fold.kind != kind || fold.page != page_) continue;
      out_ += "<line class=\"fold ";
      out_ += words[static_cast<std::size_t>(kind)];
      out_ += "\" data-faces=\"";
      append_integer(out_, fold.faces[0]);
      out_ += ',';
      append_integer(out_, fold.faces[1]);
      out_ += '"';
      attribute("data-angle", fold.angle * 180 / std::numbers::pi);
      ends(fold.from, fold.to);
      out_ += "/>\n";
    }
  }

  void lines(SheetLayer layer) {
    for (const DrawnLine& line : drawing_.lines) {
      if (line.layer != layer || line.inner_fold || line.page != page_) continue;
      out_ += "<line";
      ends(line.from, line.to);
      out_ += "/>\n";
    }
  }

  void texts() {
    for (const DrawnText& text : drawing_.texts) {
      if (text.page != page_) continue;
      const double size = text.height / helvetica_capital_height;
      out_ += "<text";
      attribute("font-size", size);
      out_ += " transform=\"translate(";
      append_real(out_, text.centre.x());
      out_ += ' ';
      append_real(out_, drawing_.page.height - text.centre.y());
      out_ += ") rotate(";
      append_real(out_, -text.angle * 180 / std::numbers::pi);
      out_ += ")\"";
      attribute("y", text.height / 2);
      out_ += '>' + text.text + "</text>\n";
    }
  }

  const SheetDrawing& drawing_;
  Index page_;
  std::string out_;
};

}  // namespace

std::string write_sheet_svg(const SheetDrawing& drawing, Index page) {
  return SvgWriter(drawing, page).write();
}

}  // namespace hariko
