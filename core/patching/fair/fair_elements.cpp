#include "core/patching/fair/fair_elements.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"

namespace hariko {

namespace {

constexpr std::size_t jump_points = 6;
constexpr int energy_points = 12;
constexpr std::size_t own_grain = 64;  ///< elements per task

/// Calls add(i, j, value) for the entries of a^T b, whose columns have `rows` numbers.
template <class A, class B, class Add>
void add_products(const A& a, const B& b, const Add& add) {
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
      double sum = 0;
      for (Eigen::Index k = 0; k < a.rows(); ++k) sum += a(k, i) * b(k, j);
      add(i, j, sum);
    }
}

/// Product of `left` with a matrix that is mostly zero.
template <class Left>
Eigen::Matrix<double, Left::RowsAtCompileTime, patch_unknown_count> times(const Left& left,
                                                                          const PatchMatrix& sparse) {
  Eigen::Matrix<double, Left::RowsAtCompileTime, patch_unknown_count> out;
  out.setZero();
  for (Eigen::Index j = 0; j < sparse.cols(); ++j)
    for (Eigen::Index k = 0; k < sparse.rows(); ++k)
      if (const double factor = sparse(k, j); factor != 0) out.col(j) += factor * left.col(k);
  return out;
}

/// Dependence of the 18 control points of a patch on its 9 unknowns.
PatchMatrix patch_dependence(const PatchMeasure& first, const PatchMeasure& second) {
  using namespace quartic;
  PatchMatrix m = PatchMatrix::Zero();
  m(d400, 0) = m(d310, 0) = m(d301, 0) = 1;
  m(d220, 0) = m(d202, 0) = 0.5;
  struct SplitEdge {
    const PatchMeasure& of;
    Control outer, middle, at_centre, at_vertex;
    int z;
    double centre_share;  ///< Factor of z in the patch's point at the centre; its negative at the vertex.
  };
  const SplitEdge splits[2] = {{first, d310, d220, d211w, d121w, 3, 1 - first.own_split},
                               {second, d301, d202, d211v, d112v, 5, -second.own_split}};
  for (const SplitEdge& s : splits) {
    const double y[2] = {s.of.corner.y(), s.of.corner.x()};
    for (int i = 0; i < 2; ++i) {
      m(s.outer, 1 + i) += 0.75 * y[i];
      m(s.middle, 1 + i) += 0.5 * y[i];
      m(s.at_centre, 1 + i) += (3 - 2 * s.of.c_centre - s.of.c_split) / 3 * y[i];
      m(s.at_vertex, 1 + i) += 2 * s.of.c_split / 3 * y[i];
    }
    m(s.at_centre, 0) += 1 - 2 * s.of.c_centre / 3;
    m(s.at_vertex, 0) += 2 * s.of.c_split / 3;
    m(s.at_centre, s.z) = s.centre_share;
    m(s.at_vertex, s.z + 1) = -s.centre_share;
  }
  m(d121u, 7) = 1;
  m(d112u, 8) = 1;
  return m;
}

}  // namespace

FairTables::FairTables() : points_(gauss_legendre_unit(int(jump_points))) {
  for (ControlMatrix& matrix : second_) matrix.setZero();
  for (ControlMatrix& matrix : first_) matrix.setZero();
  const auto gauss = gauss_legendre_unit(energy_points);
  for (const auto& gs : gauss)
    for (const auto& gt : gauss) {
      const double s = gs.node, t = gt.node, weight = gs.weight * gt.weight * s;
      const QuarticBasis basis = quartic_basis(1 - s, s * (1 - t), s * t);
      std::array<std::array<double, quartic_control_count>, 3> second;
      std::array<std::array<double, quartic_control_count>, 2> first;
      for (std::size_t k = 0; k < quartic_control_count; ++k) {
        const auto g = basis.gradient.row(Eigen::Index(k));
        const Eigen::Matrix3d& h = basis.hessian[k];
        first[0][k] = g(1) - g(0);
        first[1][k] = g(2) - g(0);
        second[0][k] = h(1, 1) - 2 * h(0, 1) + h(0, 0);
        second[1][k] = h(1, 2) - h(0, 1) - h(0, 2) + h(0, 0);
        second[2][k] = h(2, 2) - 2 * h(0, 2) + h(0, 0);
      }
      const auto add = [&](const auto& derivatives, std::size_t a, std::size_t b, ControlMatrix& to) {
        for (std::size_t j = 0; j < quartic_control_count; ++j)
          for (std::size_t i = 0; i < quartic_control_count; ++i)
            to(Eigen::Index(i), Eigen::Index(j)) +=
                weight / 2 * (derivatives[a][i] * derivatives[b][j] + derivatives[b][i] * derivatives[a][j]);
      };
      constexpr std::size_t pairs[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
      for (std::size_t p = 0; p < 6; ++p) add(second, pairs[p][0], pairs[p][1], second_[p]);
      add(first, 0, 0, first_[0]);
      add(first, 0, 1, first_[1]);
      add(first, 1, 1, first_[2]);
    }

  // Indices of u, v, w: the centre, the first and the second end of the face's side.
  constexpr Eigen::Index variables[4][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {2, 1, 0}};
  constexpr std::size_t entries[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (std::size_t side = 0; side < 4; ++side)
    for (std::size_t i = 0; i < jump_points; ++i) {
      const auto* variable = variables[side];
      Vector3 point = Vector3::Zero();
      point[variable[0]] = 1 - points_[i].node;
      point[variable[1]] = points_[i].node;
      const QuarticBasis basis = quartic_basis(point[0], point[1], point[2]);
      for (std::size_t e = 0; e < 6; ++e)
        for (std::size_t k = 0; k < quartic_control_count; ++k)
          sides_[side][i][e][k] =
              (e < 3 ? 1 : 2) * basis.hessian[k](variable[entries[e][0]], variable[entries[e][1]]);
    }
}

ControlMatrix FairTables::energy(const ChartTriangle& triangle, double plate, double membrane) const {
  const double det = triangle.determinant, square = det * det;
  // Inverse of the matrix of scalar products.
  const double vv = triangle.qq / square, vw = -triangle.pq / square, ww = triangle.pp / square;
  const double k = plate * det, m = membrane * det;
  ControlMatrix out = k * vv * vv * second_[0];
  out += 4 * k * vv * vw * second_[1];
  out += 2 * k * vw * vw * second_[2];
  out += 2 * k * (vv * ww + vw * vw) * second_[3];
  out += 4 * k * vw * ww * second_[4];
  out += k * ww * ww * second_[5];
  if (m != 0) {
    out += m * vv * first_[0];
    out += 2 * m * vw * first_[1];
    out += m * ww * first_[2];
  }
  return out;
}

JumpRows FairTables::jump_rows(Side side, double c_start, double c_end, double amount, double weight) const {
  JumpRows rows;
  for (std::size_t i = 0; i < jump_points; ++i) {
    const double t = points_[i].node, scale = std::sqrt(weight * points_[i].weight) * amount * amount;
    const double p = (1 - t) * (1 - c_start) + t * c_end;
    const double start = -(4 * p / 3 - (1 - t) / 3), end = -(4 * (1 - p) / 3 - t / 3);
    const PointTable& table = sides_[side][i];
    const double factors[6] = {scale * start * start, scale * end * end, scale,
                               scale * start * end,   scale * start,     scale * end};
    for (std::size_t k = 0; k < quartic_control_count; ++k) {
      double sum = 0;
      for (std::size_t e = 0; e < 6; ++e) sum += factors[e] * table[e][k];
      rows(Eigen::Index(i), Eigen::Index(k)) = sum;
    }
  }
  return rows;
}

PatchEnergy patch_energy(Index sides) {
  const FairTables tables;
  const ChartTriangle triangle = regular_triangle(sides);
  return {tables.energy(triangle, 1, 0), tables.energy(triangle, 0, 1)};
}

PatchParts patch_parts(const FairTables& tables, const PatchMeasure& patch, const PatchMeasure& following) {
  PatchParts out;
  out.energy = tables.energy(patch.triangle, patch.plate, patch.membrane);
  for (const Eigen::Index first : {12, 14, 16}) {
    out.energy(first, first) += patch.pair;
    out.energy(first + 1, first + 1) += patch.pair;
    out.energy(first, first + 1) -= patch.pair;
    out.energy(first + 1, first) -= patch.pair;
  }
  out.dependence = patch_dependence(patch, following);
  // Seen from O outward, the patch lies on the left of its first split edge and on the right of its second
  // one.
  out.first = tables.jump_rows(FairTables::centre_to_first, patch.c_centre, patch.c_split, patch.own_split,
                               patch.split_jump);
  out.second = -tables.jump_rows(FairTables::centre_to_second, following.c_centre, following.c_split,
                                 1 - following.own_split, following.split_jump);
  return out;
}

EdgeRows edge_rows(const FairTables& tables, const EdgeMeasure& edge) {
  // The first face's half-edge runs from start to end, the second face's from end to start.
  return {tables.jump_rows(FairTables::first_to_second, edge.c_start, edge.c_end, edge.own, edge.jump),
          -tables.jump_rows(FairTables::second_to_first, edge.c_start, edge.c_end, 1 - edge.own, edge.jump)};
}

std::array<int, patch_unknown_count> FaceElement::columns(Index side) const {
  const int n = int(sides), j = int(side), following = (j + 1) % n;
  return {0,
          1,
          2,
          3 + 2 * j,
          4 + 2 * j,
          3 + 2 * following,
          4 + 2 * following,
          3 + 2 * n + 2 * j,
          4 + 2 * n + 2 * j};
}

FairElements::FairElements(const FairMeasures& measures, const HalfEdgeMesh& mesh, bool shared)
    : mesh_(mesh),
      measures_(measures),
      shared_(shared),
      faces_(mesh.face_count()),
      edges_(mesh.edge_count()) {
  if (shared) {
    share();
    return;
  }
  parallel_for(faces_.size(), own_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) faces_[f] = make_face(Index(f));
  });
  parallel_for(edges_.size(), own_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (measures_.edge[e].jump >= 0) edges_[e] = make_edge(Index(e));
  });
}

std::vector<double> FairElements::key_of_face(Index face) const {
  std::vector<double> key;
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    const PatchMeasure& p = measures_.patch[h];
    for (const double value :
         {p.triangle.pp, p.triangle.pq, p.triangle.qq, p.triangle.determinant, p.plate, p.membrane, p.pair,
          p.split_jump, p.c_centre, p.c_split, p.own_split, p.corner.x(), p.corner.y()})
      key.push_back(value);
  }
  return key;
}

void FairElements::share() {
  std::map<std::vector<double>, std::shared_ptr<const FaceElement>> faces;
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    auto& slot = faces[key_of_face(f)];
    if (!slot) slot = make_face(f);
    faces_[f] = slot;
  }
  std::map<std::vector<double>, std::shared_ptr<const EdgeElement>> edges;
  for (Index e = 0; e < mesh_.edge_count(); ++e) {
    const EdgeMeasure& edge = measures_.edge[e];
    if (edge.jump < 0) continue;
    const Index h = mesh_.half_edge_of_edge(e), twin = mesh_.twin(h);
    // Element addresses do not change during the life of this object, so they represent the properties the
    // elements were made from.
    const auto place = [&](Index side) {
      return double(reinterpret_cast<std::uintptr_t>(faces_[mesh_.face(side)].get()));
    };
    auto& slot = edges[{place(h), double(h - mesh_.face_begin(mesh_.face(h))), place(twin),
                        double(twin - mesh_.face_begin(mesh_.face(twin))), edge.jump, edge.c_start,
                        edge.c_end, edge.own}];
    if (!slot) slot = make_edge(e);
    edges_[e] = slot;
  }
}

std::span<const PatchParts> FairElements::parts(Index face, std::vector<PatchParts>& room) const {
  if (!faces_[face]->parts.empty()) return faces_[face]->parts;
  room.clear();
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h)
    room.push_back(patch_parts(tables_, measures_.patch[h], measures_.patch[mesh_.next(h)]));
  return room;
}

const EdgeRows& FairElements::rows(Index edge, EdgeRows& room) const {
  if (edges_[edge]->rows) return *edges_[edge]->rows;
  room = edge_rows(tables_, measures_.edge[edge]);
  return room;
}

std::shared_ptr<FaceElement> FairElements::make_face(Index face) const {
  auto out = std::make_shared<FaceElement>();
  FaceElement& element = *out;
  const Index sides = mesh_.side_count(face), first = mesh_.face_begin(face);
  element.sides = sides;
  const int size = 3 + 4 * int(sides);
  element.matrix = Eigen::MatrixXd::Zero(size, size);
  // Jump columns of each patch, at its first and second split edge.
  std::vector<JumpColumns> left(sides), right(sides);
  if (shared_) element.parts.reserve(sides);
  for (Index j = 0; j < sides; ++j) {
    const Index h = first + j;
    PatchParts parts = patch_parts(tables_, measures_.patch[h], measures_.patch[mesh_.next(h)]);
    const auto columns = element.columns(j);
    const PatchMatrix product = times(parts.energy, parts.dependence);
    add_products(parts.dependence, product, [&](Eigen::Index a, Eigen::Index b, double value) {
      element.matrix(columns[std::size_t(a)], columns[std::size_t(b)]) += value;
    });
    left[j] = times(parts.first, parts.dependence);
    right[j] = times(parts.second, parts.dependence);
    if (shared_) element.parts.push_back(std::move(parts));
  }
  // The jump across a split edge involves only the unknowns of the two patches beside it.
  for (Index j = 0; j < sides; ++j) {
    const Index behind = (j + sides - 1) % sides;
    const auto own = element.columns(j), other = element.columns(behind);
    const auto add = [&](const JumpColumns& a, const auto& rows, const JumpColumns& b, const auto& columns) {
      add_products(a, b, [&](Eigen::Index i, Eigen::Index k, double value) {
        element.matrix(rows[std::size_t(i)], columns[std::size_t(k)]) += value;
      });
    };
    add(left[j], own, left[j], own);
    add(left[j], own, right[behind], other);
    add(right[behind], other, left[j], own);
    add(right[behind], other, right[behind], other);
  }
  return out;
}

std::shared_ptr<EdgeElement> FairElements::make_edge(Index edge) const {
  auto out = std::make_shared<EdgeElement>();
  const Index h = mesh_.half_edge_of_edge(edge), twin = mesh_.twin(h);
  const auto dependence = [&](Index side) {
    return patch_dependence(measures_.patch[side], measures_.patch[mesh_.next(side)]);
  };
  EdgeRows rows = edge_rows(tables_, measures_.edge[edge]);
  out->first_columns = times(rows.first, dependence(h));
  out->second_columns = times(rows.second, dependence(twin));
  if (shared_) out->rows = std::make_unique<EdgeRows>(std::move(rows));
  return out;
}

}  // namespace hariko
