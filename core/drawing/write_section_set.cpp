#include "core/drawing/write_section_set.hpp"

#include <charconv>
#include <cmath>

#include "core/base/text/dxf_writer.hpp"
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
    out_.begin_header();
    out_.end_section();
    tables(planes);
    out_.begin("SECTION", "ENTITIES");
    for (const FlatLine& line : lines) line.points.size() == 2 ? segment(line) : polyline(line);
    out_.end_section();
    return out_.take();
  }

 private:
  static std::string layer(int plane, bool comb) {
    return (comb ? "COMB_" : "SECTION_") + std::to_string(plane + 1);
  }

  void tables(int planes) {
    out_.begin("SECTION", "TABLES");
    out_.begin("TABLE", "LAYER");
    out_.pair(70, std::to_string(2 * planes));
    for (int plane = 0; plane < planes; ++plane)
      for (const bool comb : {false, true}) {
        out_.begin("LAYER", layer(plane, comb));
        out_.pair(70, "0");
        out_.pair(62, comb ? "6" : "1");
        out_.pair(6, "CONTINUOUS");
      }
    out_.end_table();
    out_.end_section();
  }

  void segment(const FlatLine& line) {
    out_.pair(0, "LINE");
    out_.pair(8, layer(line.plane, line.comb));
    out_.point(10, line.points[0]);
    out_.point(11, line.points[1]);
  }

  void polyline(const FlatLine& line) {
    constexpr int closed = 1, in_space = 8, vertex_in_space = 32;
    out_.pair(0, "POLYLINE");
    out_.pair(8, layer(line.plane, line.comb));
    out_.pair(66, "1");  // vertices follow
    out_.point(10, Vector3::Zero());
    out_.pair(70, std::to_string(in_space + (line.closed ? closed : 0)));
    for (const Vector3& p : line.points) {
      out_.pair(0, "VERTEX");
      out_.pair(8, layer(line.plane, line.comb));
      out_.point(10, p);
      out_.pair(70, std::to_string(vertex_in_space));
    }
    out_.pair(0, "SEQEND");
    out_.pair(8, layer(line.plane, line.comb));
  }

  DxfWriter out_;
};

}  // namespace

std::string write_sections_svg(const SectionSet& set, const SectionCombs& combs, double millimetres) {
  return SectionSvg(flat_lines(set, combs, millimetres)).write(set.planes.count);
}

std::string write_sections_dxf(const SectionSet& set, const SectionCombs& combs, double millimetres) {
  return SectionDxf().write(flat_lines(set, combs, millimetres), set.planes.count);
}

}  // namespace hariko
