#include "core/g2/faces/face_blocks.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "core/base/assert.hpp"
#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

constexpr std::size_t block_grain = 16;

/// Key of a block, all that it depends on: the elements around each corner, in order from the face itself.
std::vector<std::uintptr_t> block_key(const G2Layout& layout, const FaceElements& elements, Index face) {
  const HalfEdgeMesh& mesh = layout.mesh();
  const VertexFrames& frames = layout.frames();
  std::vector<std::uintptr_t> key;
  const auto add = [&](Index h) {
    key.push_back(reinterpret_cast<std::uintptr_t>(&elements[mesh.face(h)]));
    key.push_back(
        static_cast<std::uintptr_t>(2 * layout.chart_side(h) + (frames.sharp[mesh.edge(h)] ? 1 : 0)));
  };
  for (int j = 0; j < int(mesh.side_count(face)); ++j) {
    const Index own = layout.half_edge(face, j);
    key.push_back(static_cast<std::uintptr_t>(frames.kind[mesh.origin(own)]));
    Index h = own;
    do {
      add(h);
      h = mesh.rotate(h);
    } while (h != no_index && h != own);
    if (h == own) continue;
    key.push_back(0);
    for (h = mesh.twin(own); h != no_index; h = mesh.twin(h)) {
      h = mesh.next(h);
      add(h);
    }
  }
  return key;
}

/// Faces around a face's corners, including the face itself.
std::set<Index> faces_around(const HalfEdgeMesh& mesh, Index face) {
  std::set<Index> around;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    Index g = h;
    do {
      around.insert(mesh.face(g));
      g = mesh.rotate(g);
    } while (g != no_index && g != h);
    for (g = g == no_index ? mesh.twin(h) : no_index; g != no_index; g = mesh.twin(g)) {
      g = mesh.next(g);
      around.insert(mesh.face(g));
    }
  }
  return around;
}

/// Matrix of the whole system restricted to the face's unknowns.
Eigen::MatrixXd restricted_matrix(const G2Layout& layout, const FaceElements& elements, Index face) {
  const int size = layout.slot_count(face);
  std::map<Index, int> place;  // row of each of the face's unknowns
  for (int i = 0; i < size; ++i) place[layout.slot_unknown(face, i)] = i;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  struct Column {
    int place = 0;  ///< row among the face's unknowns
    /// neighbour's controls that the unknown moves, with factors
    std::array<std::pair<int, double>, 3> entry;
    int entries = 0;
  };
  std::vector<Column> columns;
  for (const Index g : faces_around(layout.mesh(), face)) {
    const int slots = layout.slot_count(g);
    columns.clear();
    for (int i = 0; i < slots; ++i) {
      const auto found = place.find(layout.slot_unknown(g, i));
      if (found == place.end()) continue;
      Column column{found->second, {}, 0};
      column.entries = layout.turn_column(g, i, column.entry);
      columns.push_back(column);
    }
    const PaddedMatrix& m = elements[g].matrix;
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> element(
        m.value.data(), slots, slots, Eigen::OuterStride<>(Eigen::Index(m.stride)));
    for (const Column& a : columns)
      for (const Column& b : columns) {
        double sum = 0;
        for (int i = 0; i < a.entries; ++i)
          for (int k = 0; k < b.entries; ++k) {
            const auto& [row, x] = a.entry[std::size_t(i)];
            const auto& [at, y] = b.entry[std::size_t(k)];
            sum += x * y * element(at, row);
          }
        matrix(b.place, a.place) += sum;
      }
  }
  return matrix;
}

/// Transforms the block from unknowns to controls: turn * inverse * turn^T, applied by columns, then by rows.
void turn_to_controls(const G2Layout& layout, Index face, Eigen::MatrixXd& inverse) {
  const int size = static_cast<int>(inverse.rows());
  std::vector<Vector3> column;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < size; ++k) {
      column.assign(std::size_t(size), Vector3::Zero());
      for (int r = 0; r < size; ++r) column[std::size_t(r)].setConstant(inverse(r, k));
      layout.turn<G2Layout::Turn::plain>(face, column.data());
      for (int r = 0; r < size; ++r) inverse(r, k) = column[std::size_t(r)].x();
    }
    inverse.transposeInPlace();
  }
}

PaddedMatrix make_block(const G2Layout& layout, const FaceElements& elements, Index face) {
  const Eigen::MatrixXd matrix = restricted_matrix(layout, elements, face);
  const auto solved = solve_definite(0.5 * (matrix + matrix.transpose()),
                                     Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows()));
  HARIKO_ASSERT(solved, "the energy round a face is positive definite");
  Eigen::MatrixXd inverse = *solved;
  turn_to_controls(layout, face, inverse);
  return PaddedMatrix(0.5 * (inverse + inverse.transpose()));
}

}  // namespace

std::vector<std::shared_ptr<const PaddedMatrix>> face_blocks(const G2Layout& layout,
                                                             const FaceElements& elements) {
  const Index faces = layout.mesh().face_count();
  std::vector<std::shared_ptr<const PaddedMatrix>> block(faces);
  std::vector<Index> fresh;  // faces whose block is new
  std::vector<Index> same_as(faces);
  std::map<std::vector<std::uintptr_t>, Index> known;
  for (Index f = 0; f < faces; ++f) {
    same_as[f] = known.try_emplace(block_key(layout, elements, f), f).first->second;
    if (same_as[f] == f) fresh.push_back(f);
  }
  parallel_for(fresh.size(), block_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      block[fresh[k]] = std::make_shared<const PaddedMatrix>(make_block(layout, elements, fresh[k]));
  });
  for (Index f = 0; f < faces; ++f) block[f] = block[same_as[f]];
  return block;
}

}  // namespace hariko
