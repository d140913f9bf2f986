#include <charconv>
#include <numbers>

#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

class DxfWriter {
 public:
  explicit DxfWriter(const SheetDrawing& drawing) : drawing_(drawing) {}

  std::string write() {
    header();
    tables();
    pair(0, "SECTION");
    pair(2, "ENTITIES");
    for (const DrawnLine& line : drawing_.lines) {
      pair(0, "LINE");
      pair(8, to_string(line.layer));
      point(10, line.page, line.from);
      point(11, line.page, line.to);
    }
    for (const DrawnText& text : drawing_.texts) {
      pair(0, "TEXT");
      pair(8, to_string(SheetLayer::label));
      point(10, text.page, text.centre);
      number(40, text.height);
      pair(1, text.text);
      number(50, text.angle * 180 / std::numbers::pi);
      pair(72, "1");  // centred at the second point
      point(11, text.page, text.centre);
      pair(73, "2");
    }
    pair(0, "ENDSEC");
    pair(0, "EOF");
    return std::move(out_);
  }

 private:
  void pair(int code, std::string_view value) {
    out_ += std::to_string(code);
    out_ += '\n';
    out_ += value;
    out_ += '\n';
  }
  void number(int code, double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 9).ptr;
    pair(code, std::string_view(text, static_cast<std::size_t>(end - text)));
  }
  void point(int code, Index page, const Vector2& p) {
    number(code, page * (drawing_.page.width + page_spacing) + p.x());
    number(code + 10, p.y());
    number(code + 20, 0);
  }

  void header() {
    const Index pages = std::max<Index>(1, drawing_.page_count);
    pair(0, "SECTION");
    pair(2, "HEADER");
    pair(9, "$ACADVER");
    pair(1, "AC1009");
    pair(9, "$INSUNITS");
    pair(70, "4");  // millimetres
    pair(9, "$MEASUREMENT");
    pair(70, "1");
    pair(9, "$EXTMIN");
    point(10, 0, {0, 0});
    pair(9, "$EXTMAX");
    point(10, pages - 1, {drawing_.page.width, drawing_.page.height});
    pair(0, "ENDSEC");
  }

  void line_type(const char* name, const char* looks, std::initializer_list<double> dashes) {
    double length = 0;
    for (const double dash : dashes) length += std::abs(dash);
    pair(0, "LTYPE");
    pair(2, name);
    pair(70, "0");
    pair(3, looks);
    pair(72, "65");
    pair(73, std::to_string(dashes.size()));
    number(40, length);
    for (const double dash : dashes) number(49, dash);
  }

  void tables() {
    pair(0, "SECTION");
    pair(2, "TABLES");
    pair(0, "TABLE");
    pair(2, "LTYPE");
    pair(70, "2");
    line_type("CONTINUOUS", "Solid line", {});
    line_type("DASHED", "__ __ __ __", {1.6, -1.1});
    pair(0, "ENDTAB");
    pair(0, "TABLE");
    pair(2, "LAYER");
    pair(70, std::to_string(std::size(sheet_layers)));
    constexpr const char* colours[] = {"7", "1", "5", "8", "3", "6"};
    for (const SheetLayer layer : sheet_layers) {
      pair(0, "LAYER");
      pair(2, to_string(layer));
      pair(70, "0");
      pair(62, colours[static_cast<std::size_t>(layer)]);
      pair(6, layer == SheetLayer::fold_valley ? "DASHED" : "CONTINUOUS");
    }
    pair(0, "ENDTAB");
    pair(0, "ENDSEC");
  }

  const SheetDrawing& drawing_;
  std::string out_;
};

}  // namespace

std::string write_sheet_dxf(const SheetDrawing& drawing) {
  return DxfWriter(drawing).write();
}

}  // namespace hariko
