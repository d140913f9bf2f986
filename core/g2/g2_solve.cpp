// Solution of G2System by conjugate gradients over faces, in x, y and z or in x alone (g2.md section 6).

#include <numeric>
#include <type_traits>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/base/solvers/conjugate_gradients.hpp"
#include "core/g2/g2_system.hpp"

namespace hariko {

namespace {

constexpr std::size_t product_grain = 32;  ///< faces per task
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

/// System restricted to a region, for fields of vectors or of numbers.
template <class Value>
class G2System::Restricted {
 public:
  using Field = std::vector<Value>;
  /// Scalar of a step: one number per coordinate.
  using Coefficient = std::conditional_t<std::is_same_v<Value, double>, double, Coefficients3>;

  Restricted(const G2System& system, const FaceRegion& region)
      : system_(system), region_(region), local_(region.slot.size()) {}

  void apply(const Field& x, Field& y) {
    for_faces([&](Index f, std::size_t first, std::size_t count, Value* in) {
      for (std::size_t i = 0; i < count; ++i) {
        const Index at = region_.slot[first + i];
        in[i] = at == no_index ? zero<Value>() : x[at];
      }
      Value* out = local_.data() + first;
      system_.layout_.turn<G2Layout::Turn::plain>(f, in);
      multiply(system_.elements_[f].matrix, in, out);
      system_.layout_.turn<G2Layout::Turn::transposed>(f, out);
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
      system_.layout_.turn<G2Layout::Turn::inverse_transposed>(f, in);
      multiply(*system_.blocks_[f], in, out);
      system_.layout_.turn<G2Layout::Turn::inverse>(f, out);
    });
    collect(z, true);
  }

  void right_side(const Given& given, Field& b) {
    const G2Layout& layout = system_.layout_;
    Field known;  // given unknowns; zero for others
    const auto values = known_unknowns(system_.layout_, system_.fixed_, given);
    if (!values.empty()) known.assign(system_.unknown_count(), zero<Value>());
    for (const auto& [unknown, value] : values) known[unknown] = part<Value>(value);
    for_faces([&](Index f, std::size_t first, std::size_t count, Value* in) {
      const std::size_t width = layout.places(f).given.size();
      std::vector<Vector3> corners(width), asked(count, Vector3::Zero());
      given_controls(layout, f, given, face_mean(layout.mesh(), f, given), corners.data());
      add_tangents(layout, system_.elements_.weights(f), f, *given.network, asked.data());
      if (given.target)
        for (std::size_t i = 0; i < count; ++i) asked[i] += (*given.target)[f].load[i];
      Field load(width), more(count);
      for (std::size_t i = 0; i < width; ++i) load[i] = part<Value>(corners[i]);
      Value* out = local_.data() + first;
      multiply(system_.elements_[f].load, load.data(), out);
      if (!known.empty()) {
        for (std::size_t i = 0; i < count; ++i) in[i] = known[layout.slot_unknown(f, int(i))];
        system_.layout_.turn<G2Layout::Turn::plain>(f, in);
        multiply(system_.elements_[f].matrix, in, more.data());
        for (std::size_t i = 0; i < count; ++i) out[i] += more[i];
      }
      for (std::size_t i = 0; i < count; ++i) out[i] = part<Value>(asked[i]) - out[i];
      system_.layout_.turn<G2Layout::Turn::transposed>(f, out);
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
  /// Calls body(face, first slot, number of slots, workspace for one face's vector).
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
  const FaceRegion& region_;
  Field local_;  ///< one value per slot
};

struct G2System::Paused {
  std::shared_ptr<const FaceRegion> region;
  std::vector<double> x;
  ConjugateGradientsWorkspace<std::vector<double>, double> room;
};

template <class Value>
G2System::Solution G2System::solve_in(std::shared_ptr<const FaceRegion> region, const Given& given,
                                      const SolveOptions& options, const CancelToken& cancel) const {
  using System = Restricted<Value>;
  System system(*this, *region);
  std::vector<Value> x;
  ConjugateGradientsWorkspace<std::vector<Value>, typename System::Coefficient> room;
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
  Solution solution{Field(unknown_count(), Vector3::Zero()), report.iterations, report.converged,
                    report.cancelled, nullptr};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if constexpr (std::is_same_v<Value, double>)
      solution.unknowns[region->global[i]].x() = x[i];
    else
      solution.unknowns[region->global[i]] = x[i];
  }
  for (const auto& [unknown, value] : known_unknowns(layout_, fixed_, given))
    solution.unknowns[unknown] = value;
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
  auto region = options.paused ? options.paused->region
                : options.active_faces
                    ? std::make_shared<const FaceRegion>(face_region(layout_, given_, *options.active_faces))
                    : whole_;
  return options.only_x ? solve_in<double>(std::move(region), given, options, cancel)
                        : solve_in<Vector3>(std::move(region), given, options, cancel);
}

}  // namespace hariko
