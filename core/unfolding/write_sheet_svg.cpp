#include <numbers>

#include "core/exchange/number_text.hpp"
#include "core/unfolding/write_sheets.hpp"

namespace hariko {

namespace {

class SvgWriter {
 public:
  explicit SvgWriter(const SheetDrawing& drawing) : drawing_(drawing) {}

  std::string write() {
    head();
    facets();
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
  double page_x(Index page) const { return page * (drawing_.page.width + page_spacing); }
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
  void ends(Index page, const Vector2& from, const Vector2& to) {
    attribute("x1", page_x(page) + from.x());
    attribute("y1", drawing_.page.height - from.y());
    attribute("x2", page_x(page) + to.x());
    attribute("y2", drawing_.page.height - to.y());
  }

  void head() {
    const Index pages = std::max<Index>(1, drawing_.page_count);
    const double width = pages * drawing_.page.width + (pages - 1) * page_spacing;
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
    out_ += "<g id=\"pages\">\n";
    for (Index page = 0; page < drawing_.page_count; ++page) {
      out_ += "<rect class=\"page\"";
      attribute("x", page_x(page));
      attribute("width", drawing_.page.width);
      attribute("height", drawing_.page.height);
      out_ += "/>\n";
    }
    out_ += "</g>\n";
  }

  void facets() {
    out_ += "<g id=\"facets\">\n";
    for (const DrawnFacet& facet : drawing_.facets) {
      out_ += "<polygon class=\"face\"";
      attribute("data-face", std::uint64_t{facet.facet});
      attribute("data-piece", std::uint64_t{facet.piece});
      attribute("data-page", std::uint64_t{facet.page});
      out_ += " points=\"";
      for (std::size_t k = 0; k < 3; ++k) {
        if (k) out_ += ' ';
        append_real(out_, page_x(facet.page) + facet.corners[k].x());
        out_ += ',';
        append_real(out_, drawing_.page.height - facet.corners[k].y());
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
      if (fold.kind != kind) continue;
      out_ += "<line class=\"fold ";
      out_ += words[static_cast<std::size_t>(kind)];
      out_ += "\" data-faces=\"";
      append_integer(out_, fold.facets[0]);
      out_ += ',';
      append_integer(out_, fold.facets[1]);
      out_ += '"';
      attribute("data-angle", fold.angle * 180 / std::numbers::pi);
      ends(fold.page, fold.from, fold.to);
      out_ += "/>\n";
    }
  }

  void lines(SheetLayer layer) {
    for (const DrawnLine& line : drawing_.lines) {
      if (line.layer != layer || line.inner_fold) continue;
      out_ += "<line";
      ends(line.page, line.from, line.to);
      out_ += "/>\n";
    }
  }

  void texts() {
    for (const DrawnText& text : drawing_.texts) {
      const double size = text.height / helvetica_capital_height;
      out_ += "<text";
      attribute("font-size", size);
      out_ += " transform=\"translate(";
      append_real(out_, page_x(text.page) + text.centre.x());
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
  std::string out_;
};

}  // namespace

std::string write_sheet_svg(const SheetDrawing& drawing) {
  return SvgWriter(drawing).write();
}

}  // namespace hariko
