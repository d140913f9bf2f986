#pragma once

// FaceChart: a face's surface as a linear function of its controls. The face lies over a convex polygon;
// ribbons of second order along its sides and a polynomial in its middle are blended by weights that depend
// on the distances from the sides (g2.md sections 3 and 4).

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/g2/faces/corner_side.hpp"
#include "core/g2/faces/jet3.hpp"

namespace hariko {

/// Controls of a corner, in the frame of the edge that opens it (rotated from the sector's by the edge's
/// angle): position, first and second derivatives.
enum CornerControl { corner_p, corner_g1, corner_g2, corner_g11, corner_g12, corner_g22 };
inline constexpr int corner_control_count = 6;
/// Controls of a side, in the direction in which the face runs along it: one of the curve, and a pair each of
/// the first and second cross derivatives.
enum SideControl { side_e0, side_e1, side_e1_odd, side_e2, side_e2_odd };
inline constexpr int side_control_count = 5;
/// Departures of a joined side's ribbon from the quadratics of its corners: second derivative of its curve
/// and derivative of its cross derivative at both ends, along the side.
enum SideDeparture { departs_curve_a, departs_cross_a, departs_curve_b, departs_cross_b };
inline constexpr int side_departure_count = 4;

/// Shape of a corner: its two edges in the chart of its vertex (y of g2.md section 1).
struct CornerShape {
  /// Angle between the edges, in (0, pi]; pi means a straight corner, whose second tangent is free.
  double angle = 0;
  double out = 1, in = 1;  ///< Lengths of the edge that opens the corner and of the one that closes it.
  /// Unit of distance across these edges; the same for both faces of an edge.
  double across_out = 1, across_in = 1;
  /// Distance of the face's centre; 0: where the corner's linear map has it.
  double centre_distance = 0;
  friend auto operator<=>(const CornerShape&, const CornerShape&) = default;
};

/// Chart shared by all faces with the same corners. Controls are numbered: six per corner, five per side,
/// then the coefficients of the centre's polynomial in (x, y) / circumradius by ascending degree, then the
/// departures of joined sides. All in the face's own numbering of corners, which begins at the rotation that
/// makes equal faces equal.
class FaceChart {
 public:
  /// Builds a chart over a polygon (`chart_polygon`), counter-clockwise around 0. `joined`: sides whose
  /// ribbons may depart from the corners, ascending.
  FaceChart(std::vector<CornerShape> corners, std::vector<Vector2> polygon,
            const std::vector<int>& joined = {});

  int sides() const { return static_cast<int>(corners_.size()); }
  const CornerShape& corner(int j) const { return corners_[static_cast<std::size_t>(j)]; }
  double angle(int j) const { return corner(j).angle; }
  double cosine(int corner) const { return cosine_[static_cast<std::size_t>(corner)]; }
  double sine(int corner) const { return sine_[static_cast<std::size_t>(corner)]; }
  bool straight(int corner) const { return straight_[static_cast<std::size_t>(corner)]; }
  const std::vector<Vector2>& vertices() const { return vertices_; }
  const Vector2& vertex(int corner) const { return vertices_[static_cast<std::size_t>(corner)]; }
  double radius() const { return radius_; }    ///< Largest distance of a vertex from the centre.
  double apothem() const { return apothem_; }  ///< Mean distance of the sides from the centre, by length.
  double area() const { return area_; }
  /// Distance from a side, in its apothem, at which its ribbon ends.
  double reach(int side) const { return reach_[static_cast<std::size_t>(side)]; }
  /// Whether it ends early because the side is short.
  bool ends_early(int side) const;
  /// Place along a side, as a share from the given end of it, where the ribbon of the side beside it ends.
  double end_along(int side, int end) const;

  int corner_control(int corner, CornerControl which) const { return corner_control_count * corner + which; }
  int side_control(int side, SideControl which) const {
    return corner_control_count * sides() + side_control_count * side + which;
  }
  int first_centre_control() const { return (corner_control_count + side_control_count) * sides(); }
  int centre_control_count() const { return (degree_ + 1) * (degree_ + 2) / 2; }
  int first_departure_control() const { return first_centre_control() + centre_control_count(); }
  bool joined(int side) const { return departure_[static_cast<std::size_t>(side)] >= 0; }
  /// Control of a departure; joined sides only.
  int departure_control(int side, SideDeparture which) const {
    return departure_[static_cast<std::size_t>(side)] + which;
  }
  int control_count() const { return first_departure_control() + departure_count_; }

  /// Controls, ascending, on which the triangle (centre, vertex(side), vertex(side + 1)) depends.
  std::span<const int> active_controls(int side) const { return active_[static_cast<std::size_t>(side)]; }

  /// Workspace of `basis`; one per thread.
  template <class Jet>
  struct Room {
    std::vector<Jet> all, distance;
  };
  using Scratch = Room<Jet2>;
  /// Basis functions of the active controls of a triangle at one of its points, with derivatives by the
  /// chart's x and y, aligned with `active_controls(side)`. Within 1e-6 of a vertex: those of the vertex's
  /// quadratic alone. Bit for bit the same from both triangles where they meet. For Jet2 and Jet3.
  template <class Jet>
  void basis(int side, const Vector2& point, std::span<Jet> out, Room<Jet>& room) const;

  /// Whether maps of corners turn about them (`linear_angle`).
  bool opens() const { return opens_; }
  /// Coordinates in which the chart is measured: the chart's own, opened at such corners so that their maps
  /// are linear there. The chart's sides become slightly curved.
  std::array<Jet3, 2> opened(const Vector2& point) const;

  /// Curve of a side at fraction t as coefficients of the corner controls at both ends and E0: (P_a, g1_a,
  /// g11_a, P_b, g1_b, g11_b, E0), with g1_b and g11_b along the edge seen from b.
  struct Curve {
    double value[7], first[7], second[7];
  };
  /// Coefficients at a fraction t.
  static Curve curve(double t);
  /// Transforms the seven coefficients to ten of the face's controls, because g1_b and g11_b rotate with the
  /// angle at b, and tangents scale with their edges in the vertices' charts.
  static constexpr int curve_control_count = 10;
  std::array<int, curve_control_count> curve_controls(int side) const;
  std::array<double, curve_control_count> spread_curve(int side, const double (&seven)[7]) const;

 private:
  /// Coordinates of a point in the basis of a corner's two sides.
  template <class Jet>
  struct CornerPoint {
    Jet alpha, beta;
  };
  template <class Jet>
  CornerPoint<Jet> in_corner(int corner, const Vector2& point) const;
  template <class Jet>
  CornerMap<Jet> outgoing(int corner, const Vector2& point) const;
  template <class Jet>
  CornerMap<Jet> incoming(int corner, const Vector2& point) const;
  template <class Jet>
  void vertex_jet(int corner, const Vector2& point, std::vector<Jet>& all) const;
  template <class Jet>
  Jet distance(int side, const Vector2& point) const;
  template <class Jet>
  void add_ribbon(int side, const Vector2& point, const Jet& weight, Room<Jet>& room) const;
  template <class Jet>
  void add_centre(const Vector2& point, const Jet& weight, std::vector<Jet>& all) const;
  void set_corners();
  void bend_toward_centre(int corner, CornerSide& out, CornerSide& in) const;
  void set_sides();
  void set_active();
  double slenderness(int side) const;
  double side_length(int side) const { return (vertex((side + 1) % sides()) - vertex(side)).norm(); }
  double full_reach(int side) const;
  /// Corner that is straight in its vertex but not in the polygon: its map is not linear.
  void add_opening(int corner, const Vector2& point, std::array<Jet3, 2>& out) const;
  bool singular(int corner) const { return singular_[static_cast<std::size_t>(corner)]; }

  std::vector<CornerShape> corners_;
  std::vector<double> cosine_, sine_;
  std::vector<bool> straight_, singular_;
  std::vector<CornerSide> out_,
      in_;  ///< per corner: beside the edge that opens it, and the one that closes it
  bool opens_ = false;
  std::vector<double> opening_;  ///< per corner: how far distances open beside it, 0 .. 1
  std::vector<int> departure_;   ///< per side: the control of its first departure, or -1
  int departure_count_ = 0;
  std::vector<Vector2> vertices_, normals_;  ///< normals: inward, unit length
  double radius_ = 0, apothem_ = 0, area_ = 0;
  std::vector<double> apothems_, reach_, unit_;  ///< per side
  int degree_ = 4;
  std::vector<std::vector<int>> near_sides_;  ///< per triangle: sides whose ribbon reaches into it, ascending
  std::vector<std::vector<int>> active_;
};

/// Whether an angle is that of a straight corner.
bool is_straight(double angle);
/// Whether a corner of a convex polygon, between two others, lies on the line through them.
bool lies_straight(const Vector2& previous, const Vector2& corner, const Vector2& next);

}  // namespace hariko
