#include "core/drawing/write_section_set.hpp"

#include <charconv>
#include <cmath>

#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

constexpr double page_edge = 5;                      ///< mm
constexpr double curve_pen = 0.35, comb_pen = 0.13;  ///< mm

/// Line in the axes of the planes, mm; z is along the direction.
struct FlatLine {
  int plane;
  bool comb;
  bool closed;
  std::vector<Vector3> points;
};

std::vector<FlatLine> flat_lines(const SectionSet& set, const SectionCombs& combs, double millimetres) {
  const Matrix3 to_plane = millimetres * section_axes(set.planes.direction).transpose();
  const double length = combs.shown ? tooth_length(set, combs.scale) : 0;
  std::vector<FlatLine> out;
  for (const SectionCurve& curve : set.curves) {
    const auto add = [&](bool comb, bool closed, const auto& points) {
      FlatLine line{curve.plane, comb, closed, {}};
      for (const Vector3& p : points) line.points.push_back(to_plane * p);
      if (closed) line.points.pop_back();
      out.push_back(std::move(line));
    };
    add(false, curve.closed, curve.points);
    if (!(length > 0)) continue;
    const CombShape comb = comb_shape(curve, set.size, length);
    for (const auto& tooth : comb.teeth) add(true, false, tooth);
    add(true, false, comb.tips);
  }
  return out;
}

class SectionSvg {
 public:
  explicit SectionSvg(std::vector<FlatLine> lines) : lines_(std::move(lines)) {
    Eigen::AlignedBox2d box;
    for (const FlatLine& line : lines_)
      for (const Vector3& p : line.points) box.extend(Vector2(p.head<2>()));
    if (box.isEmpty()) box.extend(Vector2(0, 0));
    corner_ = {box.min().x() - page_edge, box.max().y() + page_edge};
    page_ = box.sizes() + Vector2(2 * page_edge, 2 * page_edge);
  }

  std::string write(int planes) {
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
    append(page_.x());
    out_ += "mm\" height=\"";
    append(page_.y());
    out_ += "mm\" viewBox=\"0 0 ";
    append(page_.x());
    out_ += ' ';
    append(page_.y());
    out_ += "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (int plane = 0; plane < planes; ++plane)
      for (const bool comb : {true, false}) append_layer(plane, comb);
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  void append(double value) {
    constexpr double rounding = 1000;
    append_real(out_, std::round(rounding * value) / rounding + 0.0);
  }

  void append_layer(int plane, bool comb) {
    bool open = false;
    for (const FlatLine& line : lines_) {
      if (line.plane != plane || line.comb != comb) continue;
      if (!open) {
        const std::string name = (comb ? "comb-" : "section-") + std::to_string(plane + 1);
        out_ += "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + name +
                "\" stroke=\"" + (comb ? "#7b5cc4" : "#b3261e") + "\" stroke-width=\"";
        append(comb ? comb_pen : curve_pen);
        out_ += "\">\n";
      }
      open = true;
      append_path(line);
    }
    if (open) out_ += "</g>\n";
  }

  void append_path(const FlatLine& line) {
    out_ += "<path d=\"";
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      out_ += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
      append(line.points[i].x() - corner_.x());
      out_ += ' ';
      append(corner_.y() - line.points[i].y());
    }
    if (line.closed) out_ += 'Z';
    out_ += "\"/>\n";
  }

  std::vector<FlatLine> lines_;
  Vector2 corner_, page_;
  std::string out_;
};

class SectionDxf {
 public:
  std::string write(const std::vector<FlatLine>& lines, int planes) {
    pair(0, "SECTION");
    pair(2, "HEADER");
    pair(9, "$ACADVER");
    pair(1, "AC1009");
    pair(9, "$INSUNITS");
    pair(70, "4");  // millimetres
    pair(9, "$MEASUREMENT");
    pair(70, "1");
    pair(0, "ENDSEC");
    tables(planes);
    pair(0, "SECTION");
    pair(2, "ENTITIES");
    for (const FlatLine& line : lines) line.points.size() == 2 ? segment(line) : polyline(line);
    pair(0, "ENDSEC");
    pair(0, "EOF");
    return std::move(out_);
  }

 private:
  static std::string layer(int plane, bool comb) {
    return (comb ? "COMB_" : "SECTION_") + std::to_string(plane + 1);
  }
  void pair(int code, std::string_view value) {
    out_ += std::to_string(code);
    out_ += '\n';
    out_ += value;
    out_ += '\n';
  }
  void point(int code, const Vector3& p) {
    for (int k = 0; k < 3; ++k) {
      char text[400];  // every double has its place in fixed notation
      const auto end = std::to_chars(text, text + sizeof text, p[k] + 0.0, std::chars_format::fixed, 9).ptr;
      pair(code + 10 * k, std::string_view(text, static_cast<std::size_t>(end - text)));
    }
  }

  void tables(int planes) {
    pair(0, "SECTION");
    pair(2, "TABLES");
    pair(0, "TABLE");
    pair(2, "LAYER");
    pair(70, std::to_string(2 * planes));
    for (int plane = 0; plane < planes; ++plane)
      for (const bool comb : {false, true}) {
        pair(0, "LAYER");
        pair(2, layer(plane, comb));
        pair(70, "0");
        pair(62, comb ? "6" : "1");
        pair(6, "CONTINUOUS");
      }
    pair(0, "ENDTAB");
    pair(0, "ENDSEC");
  }

  void segment(const FlatLine& line) {
    pair(0, "LINE");
    pair(8, layer(line.plane, line.comb));
    point(10, line.points[0]);
    point(11, line.points[1]);
  }

  void polyline(const FlatLine& line) {
    constexpr int closed = 1, in_space = 8, vertex_in_space = 32;
    pair(0, "POLYLINE");
    pair(8, layer(line.plane, line.comb));
    pair(66, "1");  // vertices follow
    point(10, Vector3::Zero());
    pair(70, std::to_string(in_space + (line.closed ? closed : 0)));
    for (const Vector3& p : line.points) {
      pair(0, "VERTEX");
      pair(8, layer(line.plane, line.comb));
      point(10, p);
      pair(70, std::to_string(vertex_in_space));
    }
    pair(0, "SEQEND");
    pair(8, layer(line.plane, line.comb));
  }

  std::string out_;
};

}  // namespace

std::string write_sections_svg(const SectionSet& set, const SectionCombs& combs, double millimetres) {
  return SectionSvg(flat_lines(set, combs, millimetres)).write(set.planes.count);
}

std::string write_sections_dxf(const SectionSet& set, const SectionCombs& combs, double millimetres) {
  return SectionDxf().write(flat_lines(set, combs, millimetres), set.planes.count);
}

}  // namespace hariko
