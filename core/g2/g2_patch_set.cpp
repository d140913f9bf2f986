#include "core/g2/g2_patch_set.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/g2/g2_kernel.hpp"

namespace hariko {

namespace {

/// Derivatives by the triangle's (s, t); a and b are the chart's vectors from the centre.
struct TriangleRow {
  double value, ds, dt, dss, dst, dtt;
};
TriangleRow in_triangle(const Jet2& f, const Vector2& a, const Vector2& b) {
  return {f.v,
          f.x * a.x() + f.y * a.y(),
          f.x * b.x() + f.y * b.y(),
          f.xx * (a.x() * a.x()) + 2 * (f.xy * (a.x() * a.y())) + f.yy * (a.y() * a.y()),
          f.xx * (a.x() * b.x()) + f.xy * (a.x() * b.y() + a.y() * b.x()) + f.yy * (a.y() * b.y()),
          f.xx * (b.x() * b.x()) + 2 * (f.xy * (b.x() * b.y())) + f.yy * (b.y() * b.y())};
}

/// Point of the chart at a parameter: the same bits from both triangles along their common line.
Vector2 chart_point(const Vector2& a, const Vector2& b, const Vector2& parameter) {
  if (parameter.y() == 0) return parameter.x() * a;
  if (parameter.x() == 0) return parameter.y() * b;
  return parameter.x() * a + parameter.y() * b;
}

bool on_face_side(const Vector2& parameter) {
  return 1 - parameter.x() - parameter.y() == 0;
}

G2GridTable make_table(const FaceChart& chart, int side, int density, G2Tables::Derivatives which) {
  const GridPattern pattern{Domain::triangle, density};
  const std::vector<Vector2> parameters = pattern.parameters();
  const std::span<const int> active = chart.active_controls(side);
  const Vector2 &a = chart.vertex(side), &b = chart.vertex((side + 1) % chart.sides());
  constexpr std::size_t width = G2GridTable::width;
  G2GridTable table;
  table.blocks = (parameters.size() + width - 1) / width;
  table.value.resize(table.blocks * active.size() * 3 * width);
  FaceChart::Scratch scratch;
  std::vector<Jet2> basis(active.size());
  for (std::size_t i = 0; i < table.blocks * width; ++i) {
    // The last block repeats the last point.
    chart.basis(side, chart_point(a, b, parameters[std::min(i, parameters.size() - 1)]),
                std::span<Jet2>(basis), scratch);
    for (std::size_t k = 0; k < active.size(); ++k) {
      const TriangleRow row = in_triangle(basis[k], a, b);
      double* at = table.value.data() + ((i / width) * active.size() + k) * 3 * width + i % width;
      const bool first = which == G2Tables::Derivatives::first;
      at[0] = first ? row.value : row.dss;
      at[width] = first ? row.ds : row.dst;
      at[2 * width] = first ? row.dt : row.dtt;
    }
  }
  return table;
}

}  // namespace

std::shared_ptr<const G2GridTable> G2Tables::table(const FaceChart& chart, int side, int density,
                                                   Derivatives which) const {
  const Key key{&chart, side, density, which};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = tables_.find(key); found != tables_.end()) return found->second;
  }
  auto made = std::make_shared<const G2GridTable>(make_table(chart, side, density, which));
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = made->value.size() * sizeof(double);
  if (bytes_ + bytes > byte_limit_) return made;
  const auto [at, fresh] = tables_.try_emplace(key, made);
  if (fresh) bytes_ += bytes;
  return at->second;
}

G2PatchSet::G2PatchSet(std::shared_ptr<const G2Atlas> atlas, std::vector<std::shared_ptr<const G2Face>> faces)
    : atlas_(std::move(atlas)), faces_(std::move(faces)) {
  HARIKO_ASSERT(faces_.size() == atlas_->chart.size(), "controls for every face");
}

Vector3 G2PatchSet::side_position(Index patch, double x, double one_minus_x) const {
  const FaceChart& chart = chart_of(patch);
  const Vector3* c = face(atlas_->face[patch]).data() + chart.control_count() + 7 * atlas_->side[patch];
  const double y = one_minus_x, x2 = x * x, y2 = y * y, x3 = x2 * x, y3 = y2 * y;
  return ((y3 * y3 * c[0] + x3 * x3 * c[6]) + (6 * (y3 * y2 * x) * c[1] + 6 * (x3 * x2 * y) * c[5])) +
         ((15 * (y2 * y2 * x2) * c[2] + 15 * (x2 * x2 * y2) * c[4]) + 20 * (y3 * x3) * c[3]);
}

PatchPoint G2PatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  const FaceChart& chart = chart_of(patch);
  const G2Face& controls = face(atlas_->face[patch]);
  const int side = atlas_->side[patch];
  const Vector2 &a = chart.vertex(side), &b = chart.vertex((side + 1) % chart.sides());
  const std::span<const int> active = chart.active_controls(side);
  FaceChart::Scratch scratch;
  std::vector<Jet2> basis(active.size());
  chart.basis(side, chart_point(a, b, parameter), std::span<Jet2>(basis), scratch);
  PatchPoint point;
  for (std::size_t k = 0; k < active.size(); ++k) {
    const TriangleRow row = in_triangle(basis[k], a, b);
    const Vector3& d = controls[std::size_t(active[k])];
    point.position += row.value * d;
    point.ds += row.ds * d;
    point.dt += row.dt * d;
    if (order != Order::second) continue;
    point.dss += row.dss * d;
    point.dst += row.dst * d;
    point.dtt += row.dtt * d;
  }
  if (on_face_side(parameter)) point.position = side_position(patch, parameter.y(), parameter.x());
  return point;
}

ExactForm G2PatchSet::exact_form(Index patch) const {
  const Index at = atlas_->face[patch];
  return ChartPatch{this, at, atlas_->side[patch], face(at), std::size_t(chart_of(patch).control_count())};
}

PatchPoint G2PatchSet::evaluate_chart(Index at, const Vector2& point, Order order) const {
  const FaceChart& chart = *atlas_->chart[at];
  const int n = chart.sides();
  int side = 0;
  for (int j = 0; j < n; ++j) {
    const Vector2 &a = chart.vertex(j), &b = chart.vertex((j + 1) % n);
    if (a.x() * point.y() - a.y() * point.x() >= 0 && point.x() * b.y() - point.y() * b.x() >= 0) side = j;
  }
  const std::span<const int> active = chart.active_controls(side);
  FaceChart::Scratch scratch;
  std::vector<Jet2> basis(active.size());
  chart.basis(side, point, std::span<Jet2>(basis), scratch);
  PatchPoint out;
  for (std::size_t k = 0; k < active.size(); ++k) {
    const Vector3& d = face(at)[std::size_t(active[k])];
    out.position += basis[k].v * d;
    out.ds += basis[k].x * d;
    out.dt += basis[k].y * d;
    if (order != Order::second) continue;
    out.dss += basis[k].xx * d;
    out.dst += basis[k].xy * d;
    out.dtt += basis[k].yy * d;
  }
  return out;
}

Vector3 G2PatchSet::corner_normal(Index patch, int corner) const {
  const FaceChart& chart = chart_of(patch);
  if (corner == 0) return unit_normal(evaluate(patch, Vector2(0, 0), Order::first));
  const int at = (atlas_->side[patch] + corner - 1) % chart.sides();
  const G2Face& controls = face(atlas_->face[patch]);
  return controls[std::size_t(chart.corner_control(at, corner_g1))]
      .cross(controls[std::size_t(chart.corner_control(at, corner_g2))])
      .stableNormalized();
}

std::array<Vector3, 4> G2PatchSet::side_cross_derivative(Index patch) const {
  const FaceChart& chart = chart_of(patch);
  const G2Face& controls = face(atlas_->face[patch]);
  const int a = atlas_->side[patch], b = (a + 1) % chart.sides();
  const auto at = [&](int corner, CornerControl which) -> const Vector3& {
    return controls[std::size_t(chart.corner_control(corner, which))];
  };
  HARIKO_ASSERT(controls[std::size_t(chart.side_control(a, side_e1))].isZero(0) &&
                    controls[std::size_t(chart.side_control(a, side_e1_odd))].isZero(0),
                "the side's cross derivative is cubic");
  const CornerShape &at_a = chart.corner(a), &at_b = chart.corner(b);
  const double c = chart.cosine(b), s = chart.sine(b), sb = at_b.across_in;
  const Vector3 value_a = at_a.across_out * at(a, corner_g2),
                first_a = at_a.across_out * at_a.out * at(a, corner_g12);
  // In the frame of the edge that closes corner b, as in `FaceChart::add_ribbon`.
  const Vector3 value_b = -sb * (c * at(b, corner_g2) - s * at(b, corner_g1));
  const Vector3 first_b =
      sb * at_b.in * ((c * c - s * s) * at(b, corner_g12) + c * s * (at(b, corner_g22) - at(b, corner_g11)));
  return {value_a, value_a + first_a / 3, value_b - first_b / 3, value_b};
}

CornerSecondOrder G2PatchSet::second_order_at_corner(Index patch, int corner) const {
  const FaceChart& chart = chart_of(patch);
  if (corner == 0 || chart.control_count() == chart.first_departure_control())
    return CornerSecondOrder::exact;
  const int n = chart.sides(), at = (atlas_->side[patch] + corner - 1) % n, before = (at + n - 1) % n;
  const G2Face& controls = face(atlas_->face[patch]);
  double departure = 0, size = 0;
  const auto add = [&](int side, SideDeparture which) {
    departure += controls[std::size_t(chart.departure_control(side, which))].norm();
  };
  if (chart.joined(at)) add(at, departs_curve_a), add(at, departs_cross_a);
  if (chart.joined(before)) add(before, departs_curve_b), add(before, departs_cross_b);
  for (const CornerControl which : {corner_g1, corner_g2, corner_g11, corner_g12, corner_g22})
    size += controls[std::size_t(chart.corner_control(at, which))].norm();
  return departure <= 1e-9 * size ? CornerSecondOrder::exact : CornerSecondOrder::direction_dependent;
}

/// Calls each(k, active, table, controls) for every patch; consecutive patches of the same triangle share one
/// look-up.
template <class Each>
void G2PatchSet::for_tables(std::span<const Index> patches, int density, G2Tables::Derivatives which,
                            const Each& each) const {
  std::vector<std::pair<std::pair<const FaceChart*, int>, std::shared_ptr<const G2GridTable>>> known;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Index patch = patches[k];
    const FaceChart& chart = chart_of(patch);
    const std::pair<const FaceChart*, int> key{&chart, atlas_->side[patch]};
    auto found =
        std::find_if(known.begin(), known.end(), [&](const auto& entry) { return entry.first == key; });
    if (found == known.end()) {
      known.emplace_back(key, atlas_->tables.table(chart, key.second, density, which));
      if (known.size() > 16) known.erase(known.begin());
      found = known.end() - 1;
    }
    each(k, chart.active_controls(key.second), *found->second, face(atlas_->face[patch]).data());
  }
}

void G2PatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                               std::span<Vector3> positions, std::span<Vector3> normals) const {
  HARIKO_ASSERT(pattern.domain == Domain::triangle, "patches of mode G2 are triangles");
  const auto points = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(positions.size() >= patches.size() * points && normals.size() >= patches.size() * points,
                "output arrays are too small");
  const std::vector<int> side = pattern.side(1);
  const std::vector<Vector2> parameters = pattern.parameters();
  const G2Kernel kernel = g2_kernel();
  for_tables(
      patches, pattern.density, G2Tables::Derivatives::first,
      [&](std::size_t k, std::span<const int> active, const G2GridTable& table, const Vector3* controls) {
        Vector3 *position = positions.data() + k * points, *normal = normals.data() + k * points;
        const bool degenerate = kernel.position_normal(controls, active, table, points, position, normal);
        for (const int i : side) {
          const Vector2& p = parameters[std::size_t(i)];
          position[i] = side_position(patches[k], p.y(), p.x());
        }
        if (!degenerate) return;
        for (std::size_t i = 0; i < points; ++i)
          if (normal[i].isZero(0)) normal[i] = inner_normal(patches[k], parameters[i]);
      });
}

void G2PatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                               std::span<PatchPoint> out) const {
  HARIKO_ASSERT(pattern.domain == Domain::triangle, "patches of mode G2 are triangles");
  const auto points = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(out.size() >= patches.size() * points, "output array is too small");
  const std::vector<int> side = pattern.side(1);
  const std::vector<Vector2> parameters = pattern.parameters();
  const G2Kernel kernel = g2_kernel();
  std::vector<Vector3> sums(3 * points);
  for (const auto which : {G2Tables::Derivatives::first, G2Tables::Derivatives::second})
    for_tables(
        patches, pattern.density, which,
        [&](std::size_t k, std::span<const int> active, const G2GridTable& table, const Vector3* controls) {
          PatchPoint* point = out.data() + k * points;
          kernel.accumulate(controls, active, table, points, sums.data());
          for (std::size_t i = 0; i < points; ++i) {
            const Vector3* three = sums.data() + 3 * i;
            if (which == G2Tables::Derivatives::first)
              point[i].position = three[0], point[i].ds = three[1], point[i].dt = three[2];
            else
              point[i].dss = three[0], point[i].dst = three[1], point[i].dtt = three[2];
          }
        });
  for (std::size_t k = 0; k < patches.size(); ++k)
    for (const int i : side) {
      const Vector2& p = parameters[std::size_t(i)];
      out[k * points + std::size_t(i)].position = side_position(patches[k], p.y(), p.x());
    }
}

}  // namespace hariko
