#include <numbers>

#include "core/base/text/dxf_writer.hpp"
#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

class SheetDxf {
 public:
  explicit SheetDxf(const SheetDrawing& drawing) : drawing_(drawing) {}

  std::string write() {
    header();
    tables();
    out_.begin("SECTION", "ENTITIES");
    for (const DrawnLine& line : drawing_.lines) {
      out_.pair(0, "LINE");
      out_.pair(8, to_string(line.layer));
      point(10, line.page, line.from);
      point(11, line.page, line.to);
    }
    for (const DrawnText& text : drawing_.texts) {
      out_.pair(0, "TEXT");
      out_.pair(8, to_string(SheetLayer::label));
      point(10, text.page, text.centre);
      out_.number(40, text.height);
      out_.pair(1, text.text);
      out_.number(50, text.angle * 180 / std::numbers::pi);
      out_.pair(72, "1");  // centred at the second point
      point(11, text.page, text.centre);
      out_.pair(73, "2");
    }
    out_.end_section();
    return out_.take();
  }

 private:
  void point(int code, Index page, const Vector2& p) {
    out_.point(code, {page * (drawing_.page.width + page_spacing) + p.x(), p.y(), 0});
  }

  void header() {
    const Index pages = std::max<Index>(1, drawing_.page_count);
    out_.begin_header();
    out_.pair(9, "$EXTMIN");
    point(10, 0, {0, 0});
    out_.pair(9, "$EXTMAX");
    point(10, pages - 1, {drawing_.page.width, drawing_.page.height});
    out_.end_section();
  }

  void line_type(const char* name, const char* looks, std::initializer_list<double> dashes) {
    double length = 0;
    for (const double dash : dashes) length += std::abs(dash);
    out_.begin("LTYPE", name);
    out_.pair(70, "0");
    out_.pair(3, looks);
    out_.pair(72, "65");
    out_.pair(73, std::to_string(dashes.size()));
    out_.number(40, length);
    for (const double dash : dashes) out_.number(49, dash);
  }

  void tables() {
    out_.begin("SECTION", "TABLES");
    out_.begin("TABLE", "LTYPE");
    out_.pair(70, "2");
    line_type("CONTINUOUS", "Solid line", {});
    line_type("DASHED", "__ __ __ __", {1.6, -1.1});
    out_.end_table();
    out_.begin("TABLE", "LAYER");
    out_.pair(70, std::to_string(std::size(sheet_layers)));
    constexpr const char* colours[] = {"7", "1", "5", "8", "3", "6"};
    for (const SheetLayer layer : sheet_layers) {
      out_.begin("LAYER", to_string(layer));
      out_.pair(70, "0");
      out_.pair(62, colours[static_cast<std::size_t>(layer)]);
      out_.pair(6, layer == SheetLayer::fold_valley ? "DASHED" : "CONTINUOUS");
    }
    out_.end_table();
    out_.end_section();
  }

  const SheetDrawing& drawing_;
  DxfWriter out_;
};

}  // namespace

std::string write_sheet_dxf(const SheetDrawing& drawing) {
  return SheetDxf(drawing).write();
}

}  // namespace hariko
