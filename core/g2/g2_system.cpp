#include "core/g2/g2_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "core/base/dense_solver.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr std::size_t face_grain = 32;

}  // namespace

G2System::G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
                   const G2Weights& weights, const std::vector<GivenRibbon>& ribbons)
    : mesh_(std::move(mesh)),
      frames_(network.frames()),
      unknowns_(g2_unknowns(*mesh_, frames_)),
      given_(given_unknowns(*mesh_, unknowns_, ribbons)) {
  for (const CornerUnknowns& corner : unknowns_.corner) inverse_turn_.push_back(corner.turn.inverse());
  choose_charts(network, weights, ribbons);
  incidence_.assign(unknowns_.count, 0);
  for (Index f = 0; f < mesh_->face_count(); ++f)
    for (int i = 0; i < unknown_slots(f); ++i) ++incidence_[slot_unknown(f, i)];
  bend_over_charts();
  whole_ = make_region(nullptr);
}

G2System::~G2System() = default;

void G2System::choose_charts(const NetworkSystem& network, const G2Weights& weights,
                             const std::vector<GivenRibbon>& ribbons) {
  const HalfEdgeMesh& mesh = *mesh_;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double excess = 0, alpha = 0;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      excess += std::max(network.beta()[mesh.edge(h)] - 1, 0.0);
      alpha += network.alpha()[mesh.origin(h)];
    }
    tau_.push_back(weights.tension * (excess + alpha) / double(mesh.side_count(f)));
  }
  curve_weight_.resize(mesh.half_edge_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
    const double loose = 1 + network.alpha()[mesh.origin(h)] + network.alpha()[mesh.target(h)];
    const double tau =
        twin == no_index ? tau_[mesh.face(h)] : (tau_[mesh.face(h)] + tau_[mesh.face(twin)]) / 2;
    const double weight = weights.curve / (loose * loose) + weights.curve_tension * tau +
                          (frames_.sharp[e] ? weights.sharp_curve : 0);
    // Both faces carry half of an inner edge.
    curve_weight_[h] = twin == no_index ? weight : weight / 2;
    if (twin != no_index) curve_weight_[twin] = weight / 2;
  }
  chart_half_edge_.resize(mesh.half_edge_count());
  chart_side_.resize(mesh.half_edge_count());
  const auto is_joined = [&](Index h) { return !ribbons.empty() && ribbons[h] != GivenRibbon::none; };
  std::vector<double> angles;
  std::vector<int> joined;
  std::vector<std::tuple<double, double, bool>> turned, best;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index n = mesh.side_count(f), first = mesh.face_begin(f);
    Index shift = 0;
    for (Index s = 0; s < n; ++s) {
      turned.clear();
      for (Index j = 0; j < n; ++j) {
        const Index h = first + (j + s) % n;
        turned.emplace_back(frames_.step[h], curve_weight_[h], is_joined(h));
      }
      if (s > 0 && !(turned < best)) continue;
      best = turned;
      shift = s;
    }
    for (Index j = 0; j < n; ++j) {
      chart_half_edge_[first + j] = first + (j + shift) % n;
      chart_side_[first + (j + shift) % n] = static_cast<int>(j);
    }
    angles.clear();
    joined.clear();
    for (const auto& [angle, weight, is_given] : best) {
      if (is_given) joined.push_back(static_cast<int>(angles.size()));
      angles.push_back(angle);
    }
    charts_.push_back(elements_.chart(angles, joined));
  }
  auto atlas = std::make_shared<G2Atlas>();
  for (const auto& energy : charts_) atlas->chart.emplace_back(energy, &energy->chart);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    atlas->face.push_back(mesh.face(h));
    atlas->side.push_back(chart_side_[h]);
  }
  atlas_ = std::move(atlas);
}

std::vector<double> G2System::curve_weights(Index face) const {
  std::vector<double> out;
  for (int j = 0; j < int(mesh_->side_count(face)); ++j) out.push_back(curve_weight_[half_edge(face, j)]);
  return out;
}

void G2System::bend_over_charts() {
  if (!round_ && !element_.empty()) return;
  round_ = false;
  element_.resize(mesh_->face_count());
  for (Index f = 0; f < mesh_->face_count(); ++f)
    element_[f] = elements_.element(charts_[f], tau_[f], curve_weights(f));
  build_blocks();
}

void G2System::bend_over(const ReferencePoints& reference) {
  round_ = true;
  const double scale = round_scale(
      *mesh_, reference, [&](Index f) -> const FaceChart& { return chart(f); },
      [&](Index f, int side) { return half_edge(f, side); });
  // Faces with equal charts one after the other, so that a chart's functions are computed once a task.
  std::vector<Index> order(mesh_->face_count());
  std::iota(order.begin(), order.end(), Index(0));
  std::map<const ChartEnergy*, Index> first;
  for (const Index f : order) first.try_emplace(charts_[f].get(), f);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return first.at(charts_[a].get()) < first.at(charts_[b].get()); });
  parallel_for(order.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    std::optional<ChartSamples> samples;
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = order[k];
      Eigen::MatrixXd plate = charts_[f]->plate;
      if (mesh_->side_count(f) <= largest_round_side_count) {
        if (!samples || samples->chart != &chart(f)) samples.emplace(chart(f));
        plate = scale * round_plate(*samples, reference, [&](int side) { return half_edge(f, side); });
      }
      element_[f] = std::make_shared<const CondensedFace>(
          condense(charts_[f]->places, face_energy(*charts_[f], plate, tau_[f], curve_weights(f))));
    }
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
    if (!round_) same_as[f] = known.try_emplace(block_key(f), f).first->second;
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
  std::vector<Vector3> column;
  for (const Index g : around) {
    const int slots = unknown_slots(g);
    std::vector<int> columns;          // slots of g whose unknown is one of the face's
    std::vector<Eigen::VectorXd> map;  // what each moves of g's controls
    for (int i = 0; i < slots; ++i) {
      if (!place.contains(slot_unknown(g, i))) continue;
      column.assign(std::size_t(slots), Vector3::Zero());
      column[std::size_t(i)].setOnes();
      turn<Turn::plain>(g, column.data());
      Eigen::VectorXd moved(slots);
      for (int r = 0; r < slots; ++r) moved[r] = column[std::size_t(r)].x();
      columns.push_back(i);
      map.push_back(std::move(moved));
    }
    const PaddedMatrix& m = element_[g]->matrix;
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> element(
        m.value.data(), slots, slots, Eigen::OuterStride<>(Eigen::Index(m.stride)));
    for (std::size_t a = 0; a < columns.size(); ++a) {
      // A column of the map has at most three entries.
      Eigen::VectorXd image = Eigen::VectorXd::Zero(slots);
      for (int r = 0; r < slots; ++r)
        if (map[a][r] != 0) image += map[a][r] * element.col(r);
      for (std::size_t b = 0; b < columns.size(); ++b) {
        double sum = 0;
        for (int r = 0; r < slots; ++r)
          if (map[b][r] != 0) sum += map[b][r] * image[r];
        matrix(place[slot_unknown(g, columns[b])], place[slot_unknown(g, columns[a])]) += sum;
      }
    }
  }
  const auto solved =
      solve_definite(0.5 * (matrix + matrix.transpose()), Eigen::MatrixXd::Identity(size, size));
  HARIKO_ASSERT(solved, "the energy round a face is positive definite");
  Eigen::MatrixXd inverse = *solved;
  // In the face's controls: turn * inverse * turn^T, a column at a time, then a row at a time.
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
  const int control = charts_[face]->places.unknown[std::size_t(slot)];
  return unknowns_.corner[half_edge(face, control / corner_control_count)].tangent;
}

Vector3 G2System::face_mean(Index face, const Given& given) const {
  Vector3 sum = Vector3::Zero();
  for (const Index v : mesh_->face_vertices(face)) sum += given.positions[v];
  return sum / double(mesh_->side_count(face));
}

/// In the order of `ControlPlaces::given`; positions are relative to `origin`.
void G2System::given_controls(Index face, const Given& given, const Vector3& origin, Vector3* out) const {
  const FaceChart& of = chart(face);
  for (int j = 0; j < of.sides(); ++j) {
    const Index h = half_edge(face, j);
    const Vector3 g1 = 3 * given.network->start[h];
    *out++ = given.positions[mesh_->origin(h)] - origin;
    *out++ = g1;
    if (of.straight(j)) continue;
    // The edge that closes the corner lies at its angle: 3 T = cos g1 + sin g2.
    const double angle = of.angle(j);
    *out++ = (3 * given.network->end[mesh_->previous(h)] - std::cos(angle) * g1) / std::sin(angle);
  }
  for (int j = 0; j < of.sides(); ++j) {
    if (!of.joined(j)) continue;
    const GivenSides::Side* side = given.sides ? given.sides->find(half_edge(face, j)) : nullptr;
    for (int i = 0; i < side_departure_count; ++i)
      *out++ = side ? side->departure[std::size_t(i)] : Vector3(Vector3::Zero());
  }
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
  const Vector3 ga = 3 * given.network->start[h], gb = 3 * given.network->end[h];
  Vector3 second_a = form(h)[0];
  const auto at_b = form(following);
  const double angle = frames_.step[following];
  const double c = is_straight(angle) ? -1 : std::cos(angle), s = is_straight(angle) ? 0 : std::sin(angle);
  Vector3 second_b = c * c * at_b[0] + 2 * c * s * at_b[1] + s * s * at_b[2];
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
  }
  for (const auto& block : block_) add(block.get(), *block);
  return bytes;
}

}  // namespace hariko
