// G2System's solution: conjugate gradients over faces, in x, y and z or in x alone (g2.md section 6).

#include <numeric>
#include <type_traits>

#include "core/base/assert.hpp"
#include "core/base/conjugate_gradients.hpp"
#include "core/base/parallel.hpp"
#include "core/g2/g2_system.hpp"

namespace hariko {

namespace {

constexpr std::size_t product_grain = 32;  ///< faces a task
constexpr std::size_t unknown_grain = 2048;

template <class Value>
Value zero() {
  if constexpr (std::is_same_v<Value, double>)
    return 0;
  else
    return Value::Zero();
}
template <class Value>
Value part(const Vector3& v) {
  if constexpr (std::is_same_v<Value, double>)
    return v.x();
  else
    return v;
}
inline Coefficients3 product(const Vector3& a, const Vector3& b) {
  return a.array() * b.array();
}
inline double product(double a, double b) {
  return a * b;
}
inline Vector3 combined(const Vector3& y, const Coefficients3& scale, const Coefficients3& factor,
                        const Vector3& x) {
  return scale * y.array() + factor * x.array();
}
inline double combined(double y, double scale, double factor, double x) {
  return scale * y + factor * x;
}

}  // namespace

/// Unknowns of some faces, numbered without gaps, and where faces' local vectors meet them.
struct G2System::Region {
  std::vector<Index> faces;
  std::vector<std::size_t> first_slot;  ///< per face of the region, plus one
  std::vector<Index> slot;              ///< own number of each slot's unknown; no_index where held at zero
  std::vector<Index> global;            ///< unknown of each own number
  std::vector<double> share;            ///< per own number: 1 / sqrt(faces that have it)
  std::vector<std::size_t> begin;       ///< per own number, plus one: its slots in `slots`
  std::vector<std::size_t> slots;

  std::size_t size() const { return global.size(); }
};

/// The system over a region, for fields of vectors or of numbers.
template <class Value>
class G2System::Restricted {
 public:
  using Field = std::vector<Value>;
  /// Of a step: one number a coordinate.
  using Coefficient = std::conditional_t<std::is_same_v<Value, double>, double, Coefficients3>;

  Restricted(const G2System& system, const Region& region)
      : system_(system), region_(region), local_(region.slot.size()) {}

  void apply(const Field& x, Field& y) {
    for_faces([&](Index f, std::size_t first, std::size_t count, Value* in) {
      for (std::size_t i = 0; i < count; ++i) {
        const Index at = region_.slot[first + i];
        in[i] = at == no_index ? zero<Value>() : x[at];
      }
      Value* out = local_.data() + first;
      system_.turn<Turn::plain>(f, in);
      hariko::multiply(system_.element_[f]->matrix, in, out);
      system_.turn<Turn::transposed>(f, out);
    });
    collect(y, false);
  }

  void precondition(const Field& r, Field& z) {
    for_faces([&](Index f, std::size_t first, std::size_t count, Value* in) {
      for (std::size_t i = 0; i < count; ++i) {
        const Index at = region_.slot[first + i];
        in[i] = at == no_index ? zero<Value>() : Value(region_.share[at] * r[at]);
      }
      Value* out = local_.data() + first;
      system_.turn<Turn::inverse_transposed>(f, in);
      hariko::multiply(*system_.block_[f], in, out);
      system_.turn<Turn::inverse>(f, out);
    });
    collect(z, true);
  }

  void right_side(const Given& given, Field& b) {
    Field known;  // given unknowns, others zero
    const auto values = system_.known(given);
    if (!values.empty()) known.assign(system_.unknowns_.count, zero<Value>());
    for (const auto& [unknown, value] : values) known[unknown] = part<Value>(value);
    for_faces([&](Index f, std::size_t first, std::size_t count, Value* in) {
      const std::size_t width = system_.charts_[f]->places.given.size();
      std::vector<Vector3> corners(width), asked(count, Vector3::Zero());
      system_.given_controls(f, given, system_.face_mean(f, given), corners.data());
      system_.add_tangents(f, *given.network, asked.data());
      if (given.target)
        for (std::size_t i = 0; i < count; ++i) asked[i] += (*given.target)[f].load[i];
      Field load(width), more(count);
      for (std::size_t i = 0; i < width; ++i) load[i] = part<Value>(corners[i]);
      Value* out = local_.data() + first;
      hariko::multiply(system_.element_[f]->load, load.data(), out);
      if (!known.empty()) {
        for (std::size_t i = 0; i < count; ++i) in[i] = known[system_.slot_unknown(f, int(i))];
        system_.turn<Turn::plain>(f, in);
        hariko::multiply(system_.element_[f]->matrix, in, more.data());
        for (std::size_t i = 0; i < count; ++i) out[i] += more[i];
      }
      for (std::size_t i = 0; i < count; ++i) out[i] = part<Value>(asked[i]) - out[i];
      system_.turn<Turn::transposed>(f, out);
    });
    collect(b, false);
  }

  Coefficient dot(const Field& a, const Field& b) const {
    const Coefficient none = product(zero<Value>(), zero<Value>());
    std::vector<Coefficient> parts((region_.size() + unknown_grain - 1) / unknown_grain, none);
    for_unknowns([&](std::size_t begin, std::size_t end) {
      Coefficient sum = none;
      for (std::size_t i = begin; i < end; ++i) sum += product(a[i], b[i]);
      parts[begin / unknown_grain] = sum;
    });
    return std::accumulate(parts.begin(), parts.end(), none);
  }
  void combine(Field& y, const Coefficient& scale, const Coefficient& factor, const Field& x) const {
    for_unknowns([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) y[i] = combined(y[i], scale, factor, x[i]);
    });
  }

 private:
  template <class Body>
  void for_unknowns(const Body& body) const {
    parallel_for(region_.size(), unknown_grain, body);
  }
  /// body(face, first slot, slots, room for one face's vector)
  template <class Body>
  void for_faces(const Body& body) const {
    parallel_for(region_.faces.size(), product_grain, [&](std::size_t begin, std::size_t end) {
      Field room;
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t first = region_.first_slot[k], count = region_.first_slot[k + 1] - first;
        if (room.size() < count) room.resize(count);
        body(region_.faces[k], first, count, room.data());
      }
    });
  }
  /// Sums the slots of each unknown, in order.
  void collect(Field& y, bool shared) const {
    for_unknowns([&](std::size_t begin_at, std::size_t end) {
      for (std::size_t i = begin_at; i < end; ++i) {
        Value sum = zero<Value>();
        for (std::size_t k = region_.begin[i]; k < region_.begin[i + 1]; ++k) sum += local_[region_.slots[k]];
        y[i] = shared ? Value(region_.share[i] * sum) : sum;
      }
    });
  }

  const G2System& system_;
  const Region& region_;
  Field local_;  ///< one value a slot
};

template <G2System::Turn which, class Value>
void G2System::turn(Index face, Value* local) const {
  constexpr bool inverse = which == Turn::inverse || which == Turn::inverse_transposed;
  constexpr bool transposed = which == Turn::transposed || which == Turn::inverse_transposed;
  const int n = static_cast<int>(mesh_->side_count(face));
  for (int j = 0; j < n; ++j) {
    const Index h = half_edge(face, j);
    const Matrix3& m = inverse ? inverse_turn_[h] : unknowns_.corner[h].turn;
    const auto at = [&](int i, int k) { return transposed ? m(k, i) : m(i, k); };
    Value* x = local + 3 * j;
    const Value a = x[0], b = x[1], c = x[2];
    for (int i = 0; i < 3; ++i) x[i] = at(i, 0) * a + at(i, 1) * b + at(i, 2) * c;
    const auto& sign = unknowns_.side[h].sign;
    for (int i = 0; i < 5; ++i) local[3 * n + 5 * j + i] *= sign[std::size_t(i)];
  }
  for (int j = 0; j < n; ++j) {
    const Index h = half_edge(face, j);
    const Eigen::Matrix2d& m = inverse ? inverse_tangent_turn_[h] : unknowns_.corner[h].tangent_turn;
    Value* x = local + 8 * n + 2 * j;
    const Value a = x[0], b = x[1];
    x[0] = m(0, 0) * a + (transposed ? m(1, 0) : m(0, 1)) * b;
    x[1] = (transposed ? m(0, 1) : m(1, 0)) * a + m(1, 1) * b;
  }
}
template void G2System::turn<G2System::Turn::plain>(Index, Vector3*) const;

std::shared_ptr<const G2System::Region> G2System::make_region(const std::vector<Index>* active_faces) const {
  auto made = std::make_shared<Region>();
  Region& region = *made;
  if (active_faces) {
    region.faces = *active_faces;
  } else {
    region.faces.resize(mesh_->face_count());
    std::iota(region.faces.begin(), region.faces.end(), Index(0));
  }
  std::vector<std::uint32_t> met(unknowns_.count, 0);
  for (const Index f : region.faces) {
    region.first_slot.push_back(region.slot.size());
    for (int i = 0; i < unknown_slots(f); ++i) {
      region.slot.push_back(slot_unknown(f, i));
      ++met[region.slot.back()];
    }
  }
  region.first_slot.push_back(region.slot.size());
  std::vector<Index> own(unknowns_.count, no_index);
  for (Index i = 0; i < unknowns_.count; ++i) {
    // Not here, or shared with a face outside, or given.
    if (met[i] == 0 || met[i] != incidence_[i] || given_[i]) continue;
    own[i] = static_cast<Index>(region.global.size());
    region.global.push_back(i);
    region.share.push_back(1 / std::sqrt(double(incidence_[i])));
  }
  region.begin.assign(region.global.size() + 1, 0);
  for (Index& slot : region.slot) {
    slot = own[slot];
    if (slot != no_index) ++region.begin[slot + 1];
  }
  std::partial_sum(region.begin.begin(), region.begin.end(), region.begin.begin());
  region.slots.resize(region.begin.back());
  std::vector<std::size_t> cursor(region.begin.begin(), region.begin.end() - 1);
  for (std::size_t k = 0; k < region.slot.size(); ++k)
    if (region.slot[k] != no_index) region.slots[cursor[region.slot[k]]++] = k;
  return made;
}

struct G2System::Paused {
  std::shared_ptr<const Region> region;
  std::vector<double> x;
  ConjugateGradientsRoom<std::vector<double>, double> room;
};

template <class Value>
G2System::Solution G2System::solve_in(std::shared_ptr<const Region> region, const Given& given,
                                      const SolveOptions& options, const CancelToken& cancel) const {
  using System = Restricted<Value>;
  System system(*this, *region);
  std::vector<Value> x;
  ConjugateGradientsRoom<std::vector<Value>, typename System::Coefficient> room;
  bool resumed = false;
  if constexpr (std::is_same_v<Value, double>) {
    if (options.paused) x = options.paused->x, room = options.paused->room, resumed = true;
  }
  if (!resumed) {
    const std::vector<Value> none(region->size(), zero<Value>());
    x = room.residual = room.preconditioned = room.direction = room.image = none;
    if (options.start)
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = part<Value>((*options.start)[region->global[i]]);
    system.right_side(given, room.residual);
  }
  const auto report = conjugate_gradients(
      system, x, room, {options.start != nullptr, options.tolerance, options.max_steps, resumed}, cancel);
  Solution solution{Field(unknowns_.count, Vector3::Zero()), report.iterations, report.converged,
                    report.cancelled, nullptr};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if constexpr (std::is_same_v<Value, double>)
      solution.unknowns[region->global[i]].x() = x[i];
    else
      solution.unknowns[region->global[i]] = x[i];
  }
  for (const auto& [unknown, value] : known(given)) solution.unknowns[unknown] = value;
  if constexpr (std::is_same_v<Value, double>) {
    if (!report.converged)
      solution.paused =
          std::make_shared<const Paused>(Paused{std::move(region), std::move(x), std::move(room)});
  }
  return solution;
}

G2System::Solution G2System::solve(const Given& given, const SolveOptions& options,
                                   const CancelToken& cancel) const {
  HARIKO_ASSERT(!options.paused || options.only_x, "only solutions in x alone pause");
  auto region = options.paused         ? options.paused->region
                : options.active_faces ? make_region(options.active_faces)
                                       : whole_;
  return options.only_x ? solve_in<double>(std::move(region), given, options, cancel)
                        : solve_in<Vector3>(std::move(region), given, options, cancel);
}

G2System::Field G2System::multiply(const Field& x) const {
  Field y(whole_->size(), Vector3::Zero());
  Restricted<Vector3>(*this, *whole_).apply(x, y);
  return y;
}

}  // namespace hariko
