#include "core/g2/g2_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "core/base/dense_solver.hpp"
#include "core/base/parallel.hpp"
#include "core/g2/corner_shapes.hpp"
#include "core/g2/curvature_target.hpp"
#include "core/g2/face_measure.hpp"

namespace hariko {

namespace {

constexpr std::size_t face_grain = 16;
/// In equal frames faces with more sides ask for no curvature: the reference's is too far from what is seen.
constexpr Index largest_equal_target_side_count = 6;
/// Faces with more sides measure their bending over their charts always.
constexpr Index largest_reference_side_count = 12;
/// Smoothing of target curvatures, in widths of a face.
constexpr double smoothing_width = 0.4;
/// Mean alpha at which half of a face's bending is measured over the reference.
constexpr double half_reference_alpha = 0.05;

}  // namespace

G2System::G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
                   const G2Weights& weights, const std::vector<GivenRibbon>& ribbons)
    : mesh_(std::move(mesh)),
      frames_(network.frames()),
      unknowns_(g2_unknowns(*mesh_, frames_)),
      weights_(weights),
      joined_(given_unknowns(*mesh_, frames_, unknowns_, ribbons)),
      shapes_(corner_shapes(*mesh_, frames_)) {
  for (const CornerUnknowns& corner : unknowns_.corner) {
    inverse_turn_.push_back(corner.turn.inverse());
    inverse_tangent_turn_.push_back(corner.tangent_turn.inverse());
  }
  for (Index h = 0; h < ribbons.size(); ++h) {
    if (ribbons[h] == GivenRibbon::none) continue;
    joined_vertex_.resize(mesh_->vertex_count());
    joined_vertex_[mesh_->origin(h)] = joined_vertex_[mesh_->target(h)] = true;
  }
  weigh(network);
  choose_charts(ribbons);
  incidence_.assign(unknowns_.count, 0);
  for (Index f = 0; f < mesh_->face_count(); ++f)
    for (int i = 0; i < unknown_slots(f); ++i) ++incidence_[slot_unknown(f, i)];
  build_elements();
  build_blocks();
  fix_tangents({});
}

G2System::~G2System() = default;

void G2System::fix_tangents(const std::vector<bool>& vertices) {
  fixed_ = vertices;
  if (fixed_.empty()) fixed_ = joined_vertex_;
  for (Index v = 0; v < joined_vertex_.size(); ++v)
    if (joined_vertex_[v]) fixed_[v] = true;
  given_ = joined_;
  for (Index h = 0; !fixed_.empty() && h < mesh_->half_edge_count(); ++h) {
    if (!fixed_[mesh_->origin(h)]) continue;
    const CornerUnknowns& corner = unknowns_.corner[h];
    given_[corner.tangent[0]] = true;
    if (!is_straight(frames_.step[h])) given_[corner.tangent[1]] = true;
  }
  whole_ = make_region(nullptr);
}

/// Weights of faces, curves and tangents by tensions and tags.
void G2System::weigh(const NetworkSystem& network) {
  const HalfEdgeMesh& mesh = *mesh_;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double excess = 0, alpha = 0;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      excess += std::max(network.beta()[mesh.edge(h)] - 1, 0.0);
      alpha += network.alpha()[mesh.origin(h)] / double(mesh.side_count(f));
    }
    tau_.push_back(weights_.tension * (excess / double(mesh.side_count(f)) + alpha));
    const bool few = mesh.side_count(f) <= largest_reference_side_count;
    over_reference_.push_back(few ? alpha / (alpha + half_reference_alpha) : 0);
  }
  curve_weight_.resize(mesh.half_edge_count());
  tangent_weight_.resize(2 * std::size_t(mesh.half_edge_count()));
  const FaceCharts& charts = frames_.charts;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
    const bool border = twin == no_index, sharp = frames_.sharp[e];
    const double at_origin = network.alpha()[mesh.origin(h)], at_target = network.alpha()[mesh.target(h)];
    const double loose = 1 + at_origin + at_target;
    const double tau = border ? tau_[mesh.face(h)] : (tau_[mesh.face(h)] + tau_[mesh.face(twin)]) / 2;
    // Both faces carry half of an inner edge.
    const double share = (border ? 1.0 : 0.5) * edge_measure(charts, e);
    const double curve = share * (weights_.curve / (loose * loose) + weights_.curve_tension * tau +
                                  (sharp ? weights_.sharp_curve : 0));
    const auto tangent = [&](double alpha) {
      return share *
             (weights_.tangent + weights_.tangent_tension * (alpha + std::abs(network.beta()[e] - 1)) +
              (sharp ? weights_.sharp_tangent : 0));
    };
    curve_weight_[h] = curve;
    tangent_weight_[2 * h] = tangent(at_origin);
    tangent_weight_[2 * h + 1] = tangent(at_target);
    if (border) continue;
    curve_weight_[twin] = curve;
    tangent_weight_[2 * twin] = tangent(at_target);
    tangent_weight_[2 * twin + 1] = tangent(at_origin);
  }
}

void G2System::choose_charts(const std::vector<GivenRibbon>& ribbons) {
  const HalfEdgeMesh& mesh = *mesh_;
  chart_half_edge_.resize(mesh.half_edge_count());
  chart_side_.resize(mesh.half_edge_count());
  const auto is_joined = [&](Index h) { return !ribbons.empty() && ribbons[h] != GivenRibbon::none; };
  using CornerKey = std::tuple<CornerShape, std::array<double, 3>, bool>;
  std::map<std::pair<std::vector<CornerShape>, std::vector<int>>, std::shared_ptr<const PlacedChart>> known;
  std::vector<CornerShape> corners;
  std::vector<int> joined;
  std::vector<CornerKey> turned, best;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index n = mesh.side_count(f), first = mesh.face_begin(f);
    Index shift = 0;
    for (Index s = 0; s < n; ++s) {
      turned.clear();
      for (Index j = 0; j < n; ++j) {
        const Index h = first + (j + s) % n;
        turned.emplace_back(
            shapes_[h],
            std::array{curve_weight_[h], tangent_weight_[2 * h], tangent_weight_[2 * mesh.previous(h) + 1]},
            is_joined(h));
      }
      if (s > 0 && !(turned < best)) continue;
      best = turned;
      shift = s;
    }
    for (Index j = 0; j < n; ++j) {
      chart_half_edge_[first + j] = first + (j + shift) % n;
      chart_side_[first + (j + shift) % n] = static_cast<int>(j);
    }
    corners.clear();
    joined.clear();
    FaceWeights weights;
    weights.tau = tau_[f];
    for (const auto& [corner, weight, is_given] : best) {
      if (is_given) joined.push_back(static_cast<int>(corners.size()));
      corners.push_back(corner);
      weights.curve.push_back(weight[0]);
      weights.tangent_out.push_back(weight[1]);
      weights.tangent_in.push_back(weight[2]);
    }
    weights.measure = face_measure(mesh, frames_.charts, f, shift);
    face_weights_.push_back(std::move(weights));
    auto& slot = known[{corners, joined}];
    if (!slot) slot = std::make_shared<const PlacedChart>(corners, joined);
    charts_.push_back(slot);
  }
  auto atlas = std::make_shared<G2Atlas>();
  for (const auto& placed : charts_) atlas->chart.emplace_back(placed, &placed->chart);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    atlas->face.push_back(mesh.face(h));
    atlas->side.push_back(chart_side_[h]);
  }
  atlas_ = std::move(atlas);
}

template <class Jet, class Body>
void G2System::for_charts(std::vector<Index> faces, const Body& body) const {
  std::map<const PlacedChart*, Index> first;
  for (const Index f : faces) first.try_emplace(charts_[f].get(), f);
  std::stable_sort(faces.begin(), faces.end(),
                   [&](Index a, Index b) { return first.at(charts_[a].get()) < first.at(charts_[b].get()); });
  parallel_for(faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    std::optional<SamplesOf<Jet>> samples;
    for (std::size_t k = begin; k < end; ++k) {
      if (!samples || &samples->chart() != &chart(faces[k])) samples.emplace(chart(faces[k]));
      body(faces[k], *samples);
    }
  });
}

Eigen::MatrixXd G2System::chart_energy(Index face, const SamplesOf<Jet3>& samples) const {
  const FaceWeights& weights = face_weights_[face];
  Eigen::MatrixXd energy = plate_matrix(samples, weights_.third, weights.measure);
  if (weights.plate != 1) energy *= weights.plate;
  if (weights.tau != 0) energy += weights.tau * membrane_matrix(samples, weights.measure);
  add_network_terms(chart(face), weights, energy);
  return energy;
}

void G2System::build_elements() {
  element_.resize(mesh_->face_count());
  std::vector<Index> fresh, same_as(mesh_->face_count());
  std::map<std::pair<const PlacedChart*, FaceWeights>, Index> known;
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    same_as[f] = known.try_emplace({charts_[f].get(), face_weights_[f]}, f).first->second;
    if (same_as[f] == f) fresh.push_back(f);
  }
  for_charts<Jet3>(fresh, [&](Index f, const SamplesOf<Jet3>& samples) {
    element_[f] =
        std::make_shared<const CondensedFace>(condense(charts_[f]->places, chart_energy(f, samples)));
  });
  for (Index f = 0; f < mesh_->face_count(); ++f) element_[f] = element_[same_as[f]];
}

G2System::References G2System::over(ReferencePatches patches) const {
  return [this, patches = std::move(patches)](Index face, const ChartSamples& samples) {
    return reference_of_patches(samples, patches, [&](int side) { return half_edge(face, side); });
  };
}

G2System::References G2System::over(std::shared_ptr<const G2PatchSet> surface) const {
  return [surface = std::move(surface)](Index face, const ChartSamples& samples) {
    return reference_of_controls(samples, surface->face(face));
  };
}

/// Share of the target. In equal frames none where a vertex of the face has edges of very different lengths,
/// which these frames make nothing good of.
double G2System::target_share(Index face, std::span<const Vector3> positions) const {
  const HalfEdgeMesh& mesh = *mesh_;
  if (frames_.charts.frames == Frames::metric) return 1;
  if (mesh.side_count(face) > largest_equal_target_side_count) return 0;
  double largest = 1;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    const auto add = [&](Index edge) {
      const double length = (positions[mesh.target(edge)] - positions[mesh.origin(edge)]).norm();
      low = std::min(low, length);
      high = std::max(high, length);
    };
    Index g = mesh.outgoing(mesh.origin(h));
    do {
      add(g);
      add(mesh.previous(g));
      g = mesh.rotate(g);
    } while (g != no_index && g != mesh.outgoing(mesh.origin(h)));
    if (high > 0) largest = std::max(largest, high / low);
  }
  return std::clamp((8 - largest) / 3, 0.0, 1.0);
}

G2Target G2System::target(const References& references, std::span<const Vector3> positions,
                          const References* at_sharp_edges) const {
  const HalfEdgeMesh& mesh = *mesh_;
  G2Target out(mesh.face_count());
  std::vector<Index> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), Index(0));
  const auto touches_sharp = [&](Index f) {
    bool any = false;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) any = any || frames_.sharp[mesh.edge(h)];
    return any;
  };
  for_charts<Jet2>(std::move(faces), [&](Index f, const ChartSamples& samples) {
    const ControlPlaces& places = charts_[f]->places;
    out[f].load.assign(places.unknown.size(), Vector3::Zero());
    out[f].centre.assign(places.centre.size(), Vector3::Zero());
    const double share = target_share(f, positions);
    if (share == 0) return;
    const FaceReference reference =
        (at_sharp_edges && touches_sharp(f) ? *at_sharp_edges : references)(f, samples);
    const FramedFace own = framed(samples, reference);
    if (own.empty()) return;
    FramedFace smooth = own;
    smooth_forms(samples, smoothing_width, smooth);
    const double over = over_reference_[f];
    std::vector<Vector3> load =
        chart_load(samples, reference, own, smooth, (1 - over) * share, face_weights_[f].measure);
    if (over > 0) {
      const std::vector<Vector3> more = metric_load(samples, reference, smooth);
      for (std::size_t i = 0; i < load.size(); ++i) load[i] += over * reference_scale_ * more[i];
    }
    // The centre's coefficients minimise the energy with their part of the load.
    std::vector<Vector3> centre(places.centre.size());
    for (std::size_t i = 0; i < centre.size(); ++i) centre[i] = load[std::size_t(places.centre[i])];
    const PaddedMatrix& by_unknowns = element_[f]->centre;
    for (std::size_t i = 0; i < places.unknown.size(); ++i) {
      Vector3 sum = load[std::size_t(places.unknown[i])];
      for (std::size_t k = 0; k < centre.size(); ++k)
        sum += by_unknowns.value[i * by_unknowns.stride + k] * centre[k];
      out[f].load[i] = sum;
    }
    hariko::multiply(element_[f]->inverse, centre.data(), out[f].centre.data());
  });
  return out;
}

void G2System::bend_over(const References& references) {
  std::vector<Index> tense, all(mesh_->face_count());
  for (Index f = 0; f < mesh_->face_count(); ++f)
    if (over_reference_[f] > 0) tense.push_back(f);
  if (tense.empty()) return;
  std::iota(all.begin(), all.end(), Index(0));
  std::vector<double> area(mesh_->face_count());
  for_charts<Jet2>(std::move(all), [&](Index f, const ChartSamples& samples) {
    area[f] = area_of(samples, references(f, samples));
  });
  const double surface = std::accumulate(area.begin(), area.end(), 0.0);
  double charts = 0;
  for (Index f = 0; f < mesh_->face_count(); ++f) charts += chart(f).area();
  reference_scale_ = surface > 0 ? surface / charts : 1;
  for_charts<Jet3>(std::move(tense), [&](Index f, const SamplesOf<Jet3>& samples) {
    const ChartSamples second_order(chart(f));
    const FaceReference reference = references(f, second_order);
    const FramedFace frames = framed(second_order, reference);
    face_weights_[f].plate = frames.empty() ? 1 : 1 - over_reference_[f];
    Eigen::MatrixXd energy = chart_energy(f, samples);
    if (!frames.empty())
      energy += over_reference_[f] * reference_scale_ * metric_plate(second_order, reference, frames);
    element_[f] = std::make_shared<const CondensedFace>(condense(charts_[f]->places, energy));
  });
  build_blocks();
}

void G2System::build_blocks() {
  const Index faces = mesh_->face_count();
  block_.assign(faces, nullptr);
  std::vector<Index> fresh;  // faces whose block is new
  std::vector<Index> same_as(faces);
  std::map<std::vector<std::uintptr_t>, Index> known;
  for (Index f = 0; f < faces; ++f) {
    same_as[f] = f;
    same_as[f] = known.try_emplace(block_key(f), f).first->second;
    if (same_as[f] == f) fresh.push_back(f);
  }
  parallel_for(fresh.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      block_[fresh[k]] = std::make_shared<const PaddedMatrix>(make_block(fresh[k]));
  });
  for (Index f = 0; f < faces; ++f) block_[f] = block_[same_as[f]];
}

/// Everything that a block depends on: the elements round each corner, in order from the face itself.
std::vector<std::uintptr_t> G2System::block_key(Index face) const {
  const HalfEdgeMesh& mesh = *mesh_;
  std::vector<std::uintptr_t> key;
  const auto add = [&](Index h) {
    key.push_back(reinterpret_cast<std::uintptr_t>(element_[mesh.face(h)].get()));
    key.push_back(static_cast<std::uintptr_t>(2 * chart_side(h) + (frames_.sharp[mesh.edge(h)] ? 1 : 0)));
  };
  for (int j = 0; j < int(mesh.side_count(face)); ++j) {
    const Index own = half_edge(face, j);
    key.push_back(static_cast<std::uintptr_t>(frames_.kind[mesh.origin(own)]));
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

/// Inverse of the whole matrix restricted to the face's unknowns, seen in its own controls.
PaddedMatrix G2System::make_block(Index face) const {
  const HalfEdgeMesh& mesh = *mesh_;
  const int size = unknown_slots(face);
  std::map<Index, int> place;  // of the face's unknowns
  for (int i = 0; i < size; ++i) place[slot_unknown(face, i)] = i;
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
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  struct Column {
    int place = 0;                                ///< among the face's unknowns
    std::array<std::pair<int, double>, 3> entry;  ///< what it moves of the neighbour's controls
    int entries = 0;
  };
  std::vector<Column> columns;
  for (const Index g : around) {
    const int slots = unknown_slots(g);
    columns.clear();
    for (int i = 0; i < slots; ++i) {
      const auto found = place.find(slot_unknown(g, i));
      if (found == place.end()) continue;
      Column column{found->second, {}, 0};
      column.entries = turn_column(g, i, column.entry);
      columns.push_back(column);
    }
    const PaddedMatrix& m = element_[g]->matrix;
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
  const auto solved =
      solve_definite(0.5 * (matrix + matrix.transpose()), Eigen::MatrixXd::Identity(size, size));
  HARIKO_ASSERT(solved, "the energy round a face is positive definite");
  Eigen::MatrixXd inverse = *solved;
  // In the face's controls: turn * inverse * turn^T, a column at a time, then a row at a time.
  std::vector<Vector3> column;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < size; ++k) {
      column.assign(std::size_t(size), Vector3::Zero());
      for (int r = 0; r < size; ++r) column[std::size_t(r)].setConstant(inverse(r, k));
      turn<Turn::plain>(face, column.data());
      for (int r = 0; r < size; ++r) inverse(r, k) = column[std::size_t(r)].x();
    }
    inverse.transposeInPlace();
  }
  return PaddedMatrix(0.5 * (inverse + inverse.transpose()));
}

Index G2System::slot_unknown(Index face, int slot) const {
  const int n = static_cast<int>(mesh_->side_count(face));
  if (slot < 3 * n) return unknowns_.corner[half_edge(face, slot / 3)].unknown[std::size_t(slot % 3)];
  if (slot < 8 * n)
    return unknowns_.side[half_edge(face, (slot - 3 * n) / 5)].unknown[std::size_t((slot - 3 * n) % 5)];
  return unknowns_.corner[half_edge(face, (slot - 8 * n) / 2)].tangent[std::size_t((slot - 8 * n) % 2)];
}

/// Controls of the face that one of its unknowns moves, and by how much.
int G2System::turn_column(Index face, int slot, std::array<std::pair<int, double>, 3>& entry) const {
  const int n = static_cast<int>(mesh_->side_count(face));
  if (slot < 3 * n) {
    const Matrix3& turn = unknowns_.corner[half_edge(face, slot / 3)].turn;
    for (int i = 0; i < 3; ++i) entry[std::size_t(i)] = {slot - slot % 3 + i, turn(i, slot % 3)};
    return 3;
  }
  if (slot < 8 * n) {
    const int k = slot - 3 * n;
    entry[0] = {slot, unknowns_.side[half_edge(face, k / 5)].sign[std::size_t(k % 5)]};
    return 1;
  }
  const int k = slot - 8 * n;
  const Eigen::Matrix2d& turn = unknowns_.corner[half_edge(face, k / 2)].tangent_turn;
  for (int i = 0; i < 2; ++i) entry[std::size_t(i)] = {slot - k % 2 + i, turn(i, k % 2)};
  return 2;
}

Vector3 G2System::face_mean(Index face, const Given& given) const {
  Vector3 sum = Vector3::Zero();
  for (const Index v : mesh_->face_vertices(face)) sum += given.positions[v];
  return sum / double(mesh_->side_count(face));
}

/// In the order of `ControlPlaces::given`; positions are relative to `origin`.
void G2System::given_controls(Index face, const Given& given, const Vector3& origin, Vector3* out) const {
  const FaceChart& of = chart(face);
  for (int j = 0; j < of.sides(); ++j) *out++ = given.positions[mesh_->origin(half_edge(face, j))] - origin;
  for (int j = 0; j < of.sides(); ++j) {
    if (!of.joined(j)) continue;
    const GivenSides::Side* side = given.sides ? given.sides->find(half_edge(face, j)) : nullptr;
    for (int i = 0; i < side_departure_count; ++i)
      *out++ = side ? side->departure[std::size_t(i)] : Vector3(Vector3::Zero());
  }
}

std::array<Vector3, 2> G2System::network_frame(Index h, const Network& network) const {
  const CornerShape& at = shapes_[h];
  const Vector3 g1 = 3 / at.out * network.start[h];
  if (is_straight(at.angle)) return {g1, Vector3::Zero()};
  // The edge that closes the corner lies at its angle: 3 T = cos g1 + sin g2.
  const Vector3 closing = 3 / at.in * network.end[mesh_->previous(h)];
  return {g1, (closing - std::cos(at.angle) * g1) / std::sin(at.angle)};
}

void G2System::add_tangents(Index face, const Network& network, Vector3* local) const {
  const FaceChart& of = chart(face);
  const FaceWeights& weights = face_weights_[face];
  const int n = of.sides();
  for (int j = 0; j < n; ++j) {
    const Index h = half_edge(face, j);
    const auto at = static_cast<std::size_t>(j);
    const Vector3 out = 3 * weights.tangent_out[at] * of.corner(j).out * network.start[h];
    const Vector3 in = 3 * weights.tangent_in[at] * of.corner(j).in * network.end[mesh_->previous(h)];
    local[8 * n + 2 * j] += out + of.cosine(j) * in;
    local[8 * n + 2 * j + 1] += of.sine(j) * in;
  }
}

std::vector<std::pair<Index, Vector3>> G2System::known(const Given& given) const {
  std::vector<std::pair<Index, Vector3>> out;
  if (given.sides) out = given.sides->unknowns;
  for (Index h = 0; !fixed_.empty() && h < mesh_->half_edge_count(); ++h) {
    if (!fixed_[mesh_->origin(h)]) continue;
    const CornerUnknowns& corner = unknowns_.corner[h];
    const Eigen::Matrix2d& inverse = inverse_tangent_turn_[h];
    const auto [g1, g2] = network_frame(h, *given.network);
    if (is_straight(frames_.step[h])) {
      out.emplace_back(corner.tangent[0], inverse(0, 0) * g1);
      continue;
    }
    for (int i = 0; i < 2; ++i)
      out.emplace_back(corner.tangent[std::size_t(i)], inverse(i, 0) * g1 + inverse(i, 1) * g2);
  }
  return out;
}

std::array<Vector3, 2> G2System::corner_frame(Index h, const Field& unknowns) const {
  const CornerUnknowns& corner = unknowns_.corner[h];
  const Vector3 &a = unknowns[corner.tangent[0]], &b = unknowns[corner.tangent[1]];
  const Eigen::Matrix2d& turn = corner.tangent_turn;
  return {turn(0, 0) * a + turn(0, 1) * b, turn(1, 0) * a + turn(1, 1) * b};
}

Network G2System::network_of(const Given& given, const Field& unknowns) const {
  Network out = *given.network;
  for (Index h = 0; h < mesh_->half_edge_count(); ++h) {
    const CornerShape &a = shapes_[h], &b = shapes_[mesh_->next(h)];
    out.start[h] = a.out / 3 * corner_frame(h, unknowns)[0];
    const auto [g1, g2] = corner_frame(mesh_->next(h), unknowns);
    const bool straight = is_straight(b.angle);
    out.end[h] =
        b.in / 3 * (straight ? Vector3(-g1) : Vector3(std::cos(b.angle) * g1 + std::sin(b.angle) * g2));
  }
  return out;
}

/// Bezier points of degree six along the edge's first half-edge.
std::array<Vector3, 7> G2System::edge_curve(Index edge, const Given& given, const Field& unknowns) const {
  const Index h = mesh_->half_edge_of_edge(edge), following = mesh_->next(h);
  const auto form = [&](Index corner) {
    const CornerUnknowns& at = unknowns_.corner[corner];
    std::array<Vector3, 3> out;
    for (int i = 0; i < 3; ++i)
      out[std::size_t(i)] = at.turn(i, 0) * unknowns[at.unknown[0]] +
                            at.turn(i, 1) * unknowns[at.unknown[1]] + at.turn(i, 2) * unknowns[at.unknown[2]];
    return out;
  };
  const Vector3 a = given.positions[mesh_->origin(h)], b = given.positions[mesh_->target(h)];
  const double angle = frames_.step[following];
  const double c = is_straight(angle) ? -1 : std::cos(angle), s = is_straight(angle) ? 0 : std::sin(angle);
  const double length_a = shapes_[h].out, length_b = shapes_[following].in;
  const auto [g1, g2] = corner_frame(following, unknowns);
  const Vector3 ga = length_a * corner_frame(h, unknowns)[0], gb = length_b * (c * g1 + s * g2);
  Vector3 second_a = length_a * length_a * form(h)[0];
  const auto at_b = form(following);
  Vector3 second_b = length_b * length_b * (c * c * at_b[0] + 2 * c * s * at_b[1] + s * s * at_b[2]);
  if (const GivenSides::Side* side = given.sides ? given.sides->find(h) : nullptr) {
    second_a = side->given.second_origin;
    second_b = side->given.second_target;
  }
  const Vector3 five[6] = {
      a, a + ga / 5, a + 2 * ga / 5 + second_a / 20, b + 2 * gb / 5 + second_b / 20, b + gb / 5, b};
  std::array<Vector3, 7> out;
  out[0] = a;
  out[6] = b;
  for (int i = 1; i < 6; ++i) out[std::size_t(i)] = (double(i) * five[i - 1] + double(6 - i) * five[i]) / 6;
  out[3] += unknowns[unknowns_.side[h].unknown[side_e0]] / 20;
  return out;
}

G2Face G2System::controls(Index face, const Given& given, const Field& unknowns) const {
  const FaceChart& of = chart(face);
  const ControlPlaces& places = charts_[face]->places;
  const Vector3 mean = face_mean(face, given);
  const int slots = unknown_slots(face);
  std::vector<Vector3> local(std::size_t(slots) + places.given.size());
  for (int i = 0; i < slots; ++i) local[std::size_t(i)] = unknowns[slot_unknown(face, i)];
  turn<Turn::plain>(face, local.data());
  given_controls(face, given, mean, local.data() + slots);
  std::vector<Vector3> centre(places.centre.size());
  hariko::multiply(element_[face]->centre, local.data(), centre.data());
  if (given.target)
    for (std::size_t i = 0; i < centre.size(); ++i) centre[i] += (*given.target)[face].centre[i];
  centre[0] += mean;

  G2Face out(std::size_t(of.control_count()) + 7 * std::size_t(of.sides()));
  for (int i = 0; i < slots; ++i) out[std::size_t(places.unknown[std::size_t(i)])] = local[std::size_t(i)];
  for (std::size_t i = 0; i < places.given.size(); ++i)
    out[std::size_t(places.given[i])] = local[std::size_t(slots) + i];
  for (std::size_t i = 0; i < centre.size(); ++i) out[std::size_t(places.centre[i])] = centre[i];
  for (int j = 0; j < of.sides(); ++j) {
    const Index h = half_edge(face, j), e = mesh_->edge(h);
    out[std::size_t(of.corner_control(j, corner_p))] = given.positions[mesh_->origin(h)];
    const auto curve = edge_curve(e, given, unknowns);
    Vector3* side = out.data() + of.control_count() + 7 * j;
    const bool forward = mesh_->half_edge_of_edge(e) == h;
    for (std::size_t i = 0; i < 7; ++i) side[i] = curve[forward ? i : 6 - i];
  }
  return out;
}

std::size_t G2System::chart_count() const {
  return std::set<std::shared_ptr<const PlacedChart>>(charts_.begin(), charts_.end()).size();
}

std::size_t G2System::element_count() const {
  std::set<const CondensedFace*> all;
  for (const auto& element : element_) all.insert(element.get());
  return all.size();
}

std::size_t G2System::matrix_bytes() const {
  std::set<const void*> seen;
  std::size_t bytes = 0;
  const auto add = [&](const void* owner, const PaddedMatrix& matrix) {
    if (seen.insert(owner).second) bytes += matrix.value.size() * sizeof(double);
  };
  for (const auto& element : element_) {
    add(&element->matrix, element->matrix);
    add(&element->load, element->load);
    add(&element->centre, element->centre);
    add(&element->inverse, element->inverse);
  }
  for (const auto& block : block_) add(block.get(), *block);
  return bytes;
}

}  // namespace hariko
