#include <charconv>
#include <cmath>
#include <vector>

#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

constexpr double points_per_mm = 72 / 25.4;

/// Advance width of a character of Helvetica at font size 1; a mean for characters that drawings do not use.
double advance(char c) {
  constexpr int capitals[] = {667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833,
                              722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611};
  if (c >= 'A' && c <= 'Z') return capitals[c - 'A'] / 1000.0;
  if (c == ' ' || c == '/' || c == '.') return 0.278;
  if (c == 'm') return 0.833;
  return 0.556;
}

void append_fixed(std::string& out, double value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 5).ptr;
  out.append(text, end);
  out += ' ';
}

/// Pen of a layer.
struct Pen {
  const char* colour;
  double width;  ///< mm
  const char* dashes;
};

Pen pen_of(SheetLayer layer) {
  switch (layer) {
    case SheetLayer::fold_mountain:
      return {"0.76 0.18 0.18 RG", 0.15, "[] 0 d"};
    case SheetLayer::fold_valley:
      return {"0.13 0.33 0.73 RG", 0.15, "[1.6 1.1] 0 d"};
    case SheetLayer::tab:
    case SheetLayer::strip:
      return {"0.47 G", 0.2, "[] 0 d"};
    case SheetLayer::label:
      return {"0.27 G", 0.2, "[] 0 d"};
    case SheetLayer::cut:
      break;
  }
  return {"0 G", 0.2, "[] 0 d"};
}

std::string page_content(const SheetDrawing& drawing, Index page) {
  std::string out;
  append_fixed(out, points_per_mm);
  out += "0 0 ";
  append_fixed(out, points_per_mm);
  out += "0 0 cm 1 J\n";
  for (const SheetLayer layer : sheet_layers) {
    const Pen pen = pen_of(layer);
    out += std::string(pen.colour) + " ";
    append_fixed(out, pen.width);
    out += std::string("w ") + pen.dashes + (layer == SheetLayer::fold_valley ? " 0 J\n" : " 1 J\n");
    for (const DrawnLine& line : drawing.lines) {
      if (line.layer != layer || line.page != page) continue;
      append_fixed(out, line.from.x());
      append_fixed(out, line.from.y());
      out += "m ";
      append_fixed(out, line.to.x());
      append_fixed(out, line.to.y());
      out += "l S\n";
    }
  }
  out += "0.13 g BT\n";
  for (const DrawnText& text : drawing.texts) {
    if (text.page != page) continue;
    const double size = text.height / helvetica_capital_height, c = std::cos(text.angle),
                 s = std::sin(text.angle);
    double width = 0;
    for (const char each : text.text) width += size * advance(each);
    const Vector2 start = text.centre - 0.5 * width * Vector2(c, s) - 0.5 * text.height * Vector2(-s, c);
    out += "/F1 ";
    append_fixed(out, size);
    out += "Tf ";
    for (const double value : {c, s, -s, c, start.x(), start.y()}) append_fixed(out, value);
    out += "Tm (" + text.text + ") Tj\n";
  }
  return out + "ET\n";
}

/// Collects numbered PDF objects and writes them with their cross-reference table.
class PdfFile {
 public:
  /// Number of the next object.
  std::size_t next() const { return objects_.size() + 1; }
  std::size_t add(std::string body) {
    objects_.push_back(std::move(body));
    return objects_.size();
  }
  void set(std::size_t number, std::string body) { objects_[number - 1] = std::move(body); }

  std::string write(std::size_t catalogue) const {
    std::string out = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      places.push_back(out.size());
      out += std::to_string(k + 1) + " 0 obj\n" + objects_[k] + "\nendobj\n";
    }
    const std::size_t table = out.size();
    out += "xref\n0 " + std::to_string(objects_.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t place : places) {
      const std::string digits = std::to_string(place);
      out += std::string(10 - std::min<std::size_t>(10, digits.size()), '0') + digits + " 00000 n \n";
    }
    return out + "trailer\n<< /Size " + std::to_string(objects_.size() + 1) + " /Root " +
           std::to_string(catalogue) + " 0 R >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
  }

 private:
  std::vector<std::string> objects_;
};

}  // namespace

std::string write_sheet_pdf(const SheetDrawing& drawing) {
  PdfFile file;
  const std::size_t catalogue = file.add({}), pages = file.add({});
  const std::size_t font = file.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
  file.set(catalogue, "<< /Type /Catalog /Pages " + std::to_string(pages) + " 0 R >>");
  std::string box = "[0 0 ", kids;
  append_fixed(box, drawing.page.width * points_per_mm);
  append_fixed(box, drawing.page.height * points_per_mm);
  const Index count = std::max<Index>(1, drawing.page_count);
  for (Index page = 0; page < count; ++page) {
    const std::string content = page_content(drawing, page);
    const std::size_t stream =
        file.add("<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream");
    kids += std::to_string(file.add("<< /Type /Page /Parent " + std::to_string(pages) + " 0 R /Contents " +
                                    std::to_string(stream) + " 0 R /Resources << /Font << /F1 " +
                                    std::to_string(font) + " 0 R >> >> >>")) +
            " 0 R ";
  }
  file.set(pages, "<< /Type /Pages /Count " + std::to_string(count) + " /MediaBox " + box + "] /Kids [" +
                      kids + "] >>");
  return file.write(catalogue);
}

}  // namespace hariko
