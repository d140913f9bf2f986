#include "core/patching/fair/fair_sweeps.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/parallel.hpp"
#include "core/base/solvers/dense_solver.hpp"
#include "core/patching/fair/fair_locals.hpp"

namespace hariko {

namespace {

constexpr std::size_t block_grain = 16, copy_grain = 64;  ///< faces per task
/// Faces of a cluster: small enough that the data they exchange stays in the cache, and that a thousand faces
/// keep several threads busy.
constexpr std::size_t cluster_size = 32;

/// Number of a patch's unknowns that no other face has; they come first.
constexpr std::size_t own_unknown_count = patch_unknown_count - 2;

}  // namespace

FairSweeps::FairSweeps(const FairElements& elements, const FairNumbering& numbering, bool shared)
    : elements_(elements), numbering_(numbering), mesh_(*numbering.mesh) {
  find_clusters();
  find_colours();
  make_blocks(shared);
}

/// Groups faces into clusters of neighbours, in breadth-first order from the first free face.
void FairSweeps::find_clusters() {
  std::vector<bool> taken(mesh_.face_count(), false);
  for (Index seed = 0; seed < mesh_.face_count(); ++seed) {
    if (taken[seed]) continue;
    std::vector<Index> cluster{seed};
    taken[seed] = true;
    for (std::size_t k = 0; k < cluster.size(); ++k)
      for_neighbours(cluster[k], [&](Index g) {
        if (taken[g] || cluster.size() == cluster_size) return;
        taken[g] = true;
        cluster.push_back(g);
      });
    clusters_.push_back(std::move(cluster));
  }
}

/// Colours the clusters: each gets the least colour that no face within two steps of it has, so that clusters
/// of one colour have no common neighbour.
void FairSweeps::find_colours() {
  std::vector<int> colour(mesh_.face_count(), -1);
  std::vector<std::size_t> last_taker;  // per colour: the last cluster that could not have it, plus 1
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const auto take = [&](Index g) {
      if (colour[g] >= 0) last_taker[std::size_t(colour[g])] = c + 1;
    };
    for (const Index f : clusters_[c])
      for_neighbours(f, [&](Index g) {
        take(g);
        for_neighbours(g, take);
      });
    const auto found =
        std::find_if(last_taker.begin(), last_taker.end(), [&](std::size_t by) { return by != c + 1; });
    const auto own = found - last_taker.begin();
    if (found == last_taker.end()) last_taker.push_back(0);
    for (const Index f : clusters_[c]) colour[f] = int(own);
    colour_.push_back(std::size_t(own));
  }
  colour_count_ = last_taker.size();
}

void FairSweeps::make_blocks(bool shared) {
  block_begin_.resize(mesh_.face_count());
  const auto entries = [&](Index f) { return numbering_.local_size(f) * numbering_.local_size(f); };
  const auto store = [&](Index f) {
    const Block block = make_block(f);
    std::copy_n(block.data(), block.size(), entries_.data() + block_begin_[f]);
  };
  if (!shared) {
    std::size_t count = 0;
    for (const auto& cluster : clusters_)
      for (const Index f : cluster) {
        block_begin_[f] = count;
        count += entries(f);
      }
    entries_.resize(count);
    parallel_for(mesh_.face_count(), block_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) store(Index(f));
    });
    return;
  }
  std::map<std::vector<std::uintptr_t>, std::size_t> known;
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    const auto [place, fresh] = known.emplace(surroundings(f), entries_.size());
    block_begin_[f] = place->second;
    if (!fresh) continue;
    entries_.resize(entries_.size() + entries(f));
    store(f);
  }
}

/// Key of a face's block: equal elements of the face and all its neighbours give an equal block; the
/// neighbour's element also decides the scale of shared z.
std::vector<std::uintptr_t> FairSweeps::surroundings(Index face) const {
  const auto address = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p); };
  const auto neighbour = [&](Index h) {
    return elements_.edge(mesh_.edge(h)) ? mesh_.face(mesh_.twin(h)) : no_index;
  };
  std::vector<std::uintptr_t> key{address(elements_.face(face))};
  const Index first = mesh_.face_begin(face);
  for (Index h = first; h < mesh_.face_end(face); ++h) {
    const Index e = mesh_.edge(h), beside = neighbour(h);
    key.push_back(address(elements_.edge(e)));
    key.push_back(beside == no_index ? 0 : address(elements_.face(beside)));
    Index same = first;  // the first side with that neighbour
    while (neighbour(same) != beside) ++same;
    key.push_back(same - first);
    key.push_back((mesh_.half_edge_of_edge(e) == h ? 1 : 0) + (numbering_.is_given(h) ? 2 : 0));
  }
  return key;
}

FairSweeps::Block FairSweeps::make_block(Index face) const {
  const FaceElement& element = *elements_.face(face);
  const Index first = mesh_.face_begin(face);
  const Eigen::Index size = Eigen::Index(numbering_.local_size(face));
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(size);
  for (Index h = first; h < mesh_.face_end(face); ++h)
    scale.segment(Eigen::Index(numbering_.local_side(h)), 2).setConstant(numbering_.side_scale[h]);
  Eigen::MatrixXd matrix = scaled_both_sides(scale, element.matrix);
  add_neighbours(face, scale, matrix);
  std::vector<Eigen::Index> known;
  for (Index h = first; h < mesh_.face_end(face); ++h)
    if (numbering_.is_given(h))
      for (const std::size_t end : {0, 1}) known.push_back(Eigen::Index(numbering_.local_side(h) + end));
  for (const Eigen::Index k : known) {
    matrix.row(k).setZero();
    matrix.col(k).setZero();
    matrix(k, k) = 1;
  }
  Eigen::MatrixXd inverse = solve_nearly_definite(matrix, Eigen::MatrixXd::Identity(size, size));
  for (const Eigen::Index k : known) inverse(k, k) = 0;
  return inverse;
}

/// Adds the jumps across the face's sides, and the action of the neighbours' own elements on shared z.
void FairSweeps::add_neighbours(Index face, const Eigen::VectorXd& scale, Eigen::MatrixXd& matrix) const {
  const FaceElement& element = *elements_.face(face);
  const Index first_side = mesh_.face_begin(face);
  for (Index h = first_side; h < mesh_.face_end(face); ++h) {
    const Index e = mesh_.edge(h);
    const EdgeElement* edge = elements_.edge(e);
    if (!edge) continue;
    const bool first = mesh_.half_edge_of_edge(e) == h;
    const JumpColumns& own = first ? edge->first_columns : edge->second_columns;
    const JumpColumns& other = first ? edge->second_columns : edge->first_columns;
    const Index twin = mesh_.twin(h), beside = mesh_.face(twin);
    const auto columns = element.columns(h - first_side);
    JumpColumns rows = own;
    for (int a = 0; a < patch_unknown_count; ++a) rows.col(a) *= scale[columns[std::size_t(a)]];
    // The neighbour's z at its origin is ours at the target.
    rows.col(8) += numbering_.side_scale[twin] * other.col(7);
    rows.col(7) += numbering_.side_scale[twin] * other.col(8);
    for (int a = 0; a < patch_unknown_count; ++a)
      for (int b = 0; b < patch_unknown_count; ++b)
        matrix(columns[std::size_t(a)], columns[std::size_t(b)]) += rows.col(a).dot(rows.col(b));
    // The neighbour may share several sides with the face.
    for (Index k = first_side; k < mesh_.face_end(face); ++k) {
      if (!elements_.edge(mesh_.edge(k)) || mesh_.face(mesh_.twin(k)) != beside) continue;
      const double product = numbering_.side_scale[twin] * numbering_.side_scale[mesh_.twin(k)];
      const auto mine = numbering_.local_side(h), mine_k = numbering_.local_side(k);
      const auto theirs = numbering_.local_side(twin), theirs_k = numbering_.local_side(mesh_.twin(k));
      for (const std::size_t a : {0, 1})
        for (const std::size_t b : {0, 1})
          matrix(Eigen::Index(mine + a), Eigen::Index(mine_k + b)) +=
              product *
              elements_.face(beside)->matrix(Eigen::Index(theirs + 1 - a), Eigen::Index(theirs_k + 1 - b));
    }
  }
}

/// Inverse of the face's matrix without the rows and columns of sides whose other face is not active; zero in
/// these.
FairSweeps::Block FairSweeps::without_held_sides(Index face, const std::vector<bool>& active) const {
  const auto size = Eigen::Index(numbering_.local_size(face));
  Block block = Eigen::Map<const Block>(entries_.data() + block_begin_[face], size, size);
  std::vector<Eigen::Index> held;
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h)
    if (elements_.edge(mesh_.edge(h)) && !active[mesh_.face(mesh_.twin(h))])
      for (const std::size_t end : {0, 1}) held.push_back(Eigen::Index(numbering_.local_side(h) + end));
  const Eigen::MatrixXd columns = block(Eigen::all, held);
  block -= matrix_product(
      columns, solve_nearly_definite(Eigen::MatrixXd(columns(held, Eigen::all)), columns.transpose()));
  for (const Eigen::Index k : held) {
    block.row(k).setZero();
    block.col(k).setZero();
  }
  return block;
}

FairSweeps::Plan FairSweeps::plan(std::vector<Index> faces) const {
  Plan out;
  out.faces = std::move(faces);
  out.active.assign(mesh_.face_count(), false);
  for (const Index f : out.faces) out.active[f] = true;
  for (const Index f : out.faces)
    for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h)
      if (elements_.edge(mesh_.edge(h)) && !out.active[mesh_.face(mesh_.twin(h))]) {
        out.rim.emplace(f, without_held_sides(f, out.active));
        break;
      }
  out.colours.resize(colour_count_);
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    std::vector<Index> cluster;
    for (const Index f : clusters_[c])
      if (out.active[f]) cluster.push_back(f);
    if (!cluster.empty()) out.colours[colour_[c]].push_back(std::move(cluster));
  }
  std::erase_if(out.colours, [](const auto& colour) { return colour.empty(); });
  out.residual = ZeroedArray<double>(3 * numbering_.local_begin.back());
  out.correction = ZeroedArray<double>(3 * numbering_.local_begin.back());
  return out;
}

/// Whether the face on the other side is active and shares z.
bool FairSweeps::joins(const Plan& plan, Index h) const {
  return elements_.edge(mesh_.edge(h)) && plan.active[mesh_.face(mesh_.twin(h))];
}

/// Splits the residual at shared z into a sum over both faces; at first the edge's first face has all of it.
void FairSweeps::begin(Plan& plan, Index face, const FairField& r) const {
  const std::size_t size = numbering_.local_size(face), at = 3 * numbering_.local_begin[face];
  double* residual = plan.residual.data() + at;
  numbering_.gather(face, r, false, residual);
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    const bool other = joins(plan, h) && mesh_.half_edge_of_edge(mesh_.edge(h)) != h;
    const double factor = other ? 0 : 1 / numbering_.side_scale[h];
    for (std::size_t c = 0; c < 3; ++c) {
      double* z = residual + c * size + numbering_.local_side(h);
      z[0] *= factor;
      z[1] *= factor;
    }
  }
  std::fill_n(plan.correction.data() + at, 3 * size, 0.0);
}

void FairSweeps::solve_face(Plan& plan, Index face, std::vector<double>& change) const {
  const std::size_t size = numbering_.local_size(face), at = 3 * numbering_.local_begin[face];
  double* residual = plan.residual.data() + at;
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    const double scale = numbering_.side_scale[h];
    double* mine = residual + numbering_.local_side(h);
    if (!joins(plan, h)) {
      for (std::size_t c = 0; c < 3; ++c, mine += size) {
        mine[0] *= scale;
        mine[1] *= scale;
      }
      continue;
    }
    const Index twin = mesh_.twin(h), beside = mesh_.face(twin);
    const double their_scale = numbering_.side_scale[twin];
    const std::size_t their_size = numbering_.local_size(beside);
    double* theirs = plan.residual.data() + 3 * numbering_.local_begin[beside] + numbering_.local_side(twin);
    for (std::size_t c = 0; c < 3; ++c, mine += size, theirs += their_size) {
      mine[0] = scale * mine[0] + their_scale * theirs[1];
      mine[1] = scale * mine[1] + their_scale * theirs[0];
    }
  }
  const auto rim = plan.rim.empty() ? plan.rim.end() : plan.rim.find(face);
  const double* block = rim == plan.rim.end() ? entries_.data() + block_begin_[face] : rim->second.data();
  change.assign(3 * size, 0.0);
  add_product(size, size, block, residual, change.data());
  double* correction = plan.correction.data() + at;
  for (std::size_t i = 0; i < 3 * size; ++i) correction[i] += change[i];
  std::fill_n(residual, 3 * size, 0.0);
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h)
    if (joins(plan, h)) tell_neighbour(plan, h, change.data());
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    if (!joins(plan, h)) continue;
    const Index twin = mesh_.twin(h), beside = mesh_.face(twin);
    double* theirs = plan.residual.data() + 3 * numbering_.local_begin[beside] + numbering_.local_side(twin);
    for (std::size_t c = 0; c < 3; ++c, theirs += numbering_.local_size(beside)) theirs[0] = theirs[1] = 0;
  }
}

/// Subtracts the effect of a face's change from the neighbour's residual: through the jump across side h, and
/// through the neighbour's own element.
void FairSweeps::tell_neighbour(Plan& plan, Index h, const double* change) const {
  const Index face = mesh_.face(h), twin = mesh_.twin(h), beside = mesh_.face(twin);
  const std::size_t size = numbering_.local_size(face), their_size = numbering_.local_size(beside);
  const FaceElement &element = *elements_.face(face), &their_element = *elements_.face(beside);
  const EdgeElement& edge = *elements_.edge(mesh_.edge(h));
  const bool first = mesh_.half_edge_of_edge(mesh_.edge(h)) == h;
  const JumpColumns& own = first ? edge.first_columns : edge.second_columns;
  const JumpColumns& other = first ? edge.second_columns : edge.first_columns;

  // Negative of the change, for both faces, scaled as the elements have it.
  const auto columns = element.columns(h - mesh_.face_begin(face));
  FairUnknowns values;
  std::array<double, 6> shared;
  for (std::size_t c = 0; c < 3; ++c) {
    const double* mine = change + c * size;
    double* to = values.data() + c * fair_unknown_count;
    for (std::size_t a = 0; a < own_unknown_count; ++a) to[a] = -mine[columns[a]];
    for (const std::size_t end : {0, 1}) {
      const double z = -mine[columns[own_unknown_count + end]];
      to[own_unknown_count + end] = numbering_.side_scale[h] * z;
      shared[2 * c + 1 - end] = numbering_.side_scale[twin] * z;
    }
  }
  FairJump jump{};
  add_product(fair_jump_size, fair_unknown_count, own.data(), values.data(), jump.data());
  add_product(fair_jump_size, 2, other.data() + fair_jump_size * own_unknown_count, shared.data(),
              jump.data());
  std::array<double, 3 * own_unknown_count> felt{};
  add_transposed_product(own_unknown_count, fair_jump_size, other.data(), jump.data(), felt.data());

  double* residual = plan.residual.data() + 3 * numbering_.local_begin[beside];
  add_product(their_size, 2, their_element.matrix.data() + their_size * numbering_.local_side(twin),
              shared.data(), residual);
  const auto their_columns = their_element.columns(twin - mesh_.face_begin(beside));
  for (std::size_t c = 0; c < 3; ++c, residual += their_size)
    for (std::size_t a = 0; a < own_unknown_count; ++a)
      residual[their_columns[a]] += felt[c * own_unknown_count + a];
}

/// Prefetches the data of a face, so that it is in the cache when the face is solved.
void FairSweeps::fetch(const Plan& plan, Index face) const {
  constexpr std::size_t line = 8, most = 64;  // doubles, lines of one matrix
  const auto ask = [](const double* from, std::size_t count) {
    for (std::size_t i = 0; i < std::min(count, line * most); i += line) __builtin_prefetch(from + i);
  };
  const std::size_t own = numbering_.local_size(face), at = 3 * numbering_.local_begin[face];
  ask(plan.residual.data() + at, 3 * own);
  ask(plan.correction.data() + at, 3 * own);
  ask(entries_.data() + block_begin_[face], own * own);
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    const EdgeElement* edge = elements_.edge(mesh_.edge(h));
    if (!edge) continue;
    ask(edge->first_columns.data(), std::size_t(edge->first_columns.size()));
    ask(edge->second_columns.data(), std::size_t(edge->second_columns.size()));
    const Index twin = mesh_.twin(h), beside = mesh_.face(twin);
    const std::size_t size = numbering_.local_size(beside);
    ask(elements_.face(beside)->matrix.data() + size * numbering_.local_side(twin), 2 * size);
  }
}

/// Writes the unknowns of the face alone, and those of the sides for which it has the edge's first half-edge.
void FairSweeps::finish(const Plan& plan, Index face, const FairField& r, FairField& z,
                        FairField& image) const {
  const std::size_t size = numbering_.local_size(face), at = 3 * numbering_.local_begin[face];
  const double* correction = plan.correction.data() + at;
  const double* residual = plan.residual.data() + at;
  const auto vector = [](const double* local, std::size_t stride, std::size_t i) {
    return Vector3(local[i], local[stride + i], local[2 * stride + i]);
  };
  const auto put = [&](std::size_t unknown, const Vector3& corrected, const Vector3& left) {
    z[unknown] = corrected;
    image[unknown] = r[unknown] - left;
  };
  const std::size_t interior = 3 + 2 * std::size_t(mesh_.side_count(face));
  for (std::size_t i = 0; i < interior; ++i)
    put(numbering_.face_begin[face] + i, vector(correction, size, i), vector(residual, size, i));
  for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h) {
    const Index e = mesh_.edge(h);
    const bool smooth = elements_.edge(e) != nullptr, shared = joins(plan, h);
    if (numbering_.is_given(h) || (smooth && !shared) || (shared && mesh_.half_edge_of_edge(e) != h))
      continue;
    for (const std::size_t end : {0, 1}) {
      const std::size_t mine = numbering_.local_side(h) + end;
      Vector3 corrected = vector(correction, size, mine);
      Vector3 left = numbering_.side_scale[h] * vector(residual, size, mine);
      if (shared) {
        const Index twin = mesh_.twin(h), beside = mesh_.face(twin);
        const std::size_t their_size = numbering_.local_size(beside),
                          begin = 3 * numbering_.local_begin[beside];
        const std::size_t theirs = numbering_.local_side(twin) + 1 - end;
        corrected += vector(plan.correction.data() + begin, their_size, theirs);
        left += numbering_.side_scale[twin] * vector(plan.residual.data() + begin, their_size, theirs);
      }
      put(end == 0 ? numbering_.side_origin[h] : numbering_.side_target[h], corrected, left);
    }
  }
}

void FairSweeps::apply(Plan& plan, const FairField& r, FairField& z, FairField& image) const {
  const auto for_faces = [&](const auto& body) {
    parallel_for(plan.faces.size(), copy_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) body(plan.faces[k]);
    });
  };
  const auto solve = [&](const std::vector<std::vector<Index>>& clusters, bool back) {
    parallel_for(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<double> change;
      for (std::size_t k = begin; k < end; ++k) {
        const std::vector<Index>& faces = clusters[k];
        const auto face = [&](std::size_t i) { return faces[back ? faces.size() - 1 - i : i]; };
        for (std::size_t i = 0; i < faces.size(); ++i) {
          if (i + 1 < faces.size()) fetch(plan, face(i + 1));
          solve_face(plan, face(i), change);
        }
      }
    });
  };
  for_faces([&](Index f) { begin(plan, f, r); });
  for (const auto& colour : plan.colours) solve(colour, false);
  for (std::size_t k = plan.colours.size(); k-- > 0;) solve(plan.colours[k], true);
  for_faces([&](Index f) { finish(plan, f, r, z, image); });
}

}  // namespace hariko
