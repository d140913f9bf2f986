#include "core/envelope/field_handles.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace hariko {

namespace {

// A place in a solid's frame is three numbers of ten bits. Networks number their vertices below that.
constexpr std::uint32_t field_flag = 1U << 30, steps = 1U << 10;
constexpr double widest_match = 0.75;  ///< of the cell

/// The whole line to (0, 1), finest about the solid's sides, which are at -1 and 1.
std::uint32_t step_of(double x) {
  const double share = 0.5 + 0.5 * x / (1 + std::abs(x));
  return std::uint32_t(std::clamp(std::floor(share * steps), 1.0, double(steps) - 2));
}
double place_of(std::uint32_t step) {
  const double share = 2 * (std::clamp(step, 1U, steps - 2) + 0.5) / steps - 1;
  return share / (1 - std::abs(share));
}

NetworkVertexKey name_at(const Solid& solid, const SolidDistance& frame, const Vector3& place) {
  const Vector3 unit = (frame.rotation().transpose() * (place - frame.centre())).cwiseQuotient(frame.half());
  return {solid.id,
          field_flag | step_of(unit.x()) * steps * steps | step_of(unit.y()) * steps | step_of(unit.z())};
}

Vector3 place_of(const NetworkVertexKey& name, const SolidDistance& frame) {
  const std::uint32_t code = name.vertex & ~field_flag;
  const Vector3 unit(place_of(code / steps / steps), place_of(code / steps % steps), place_of(code % steps));
  return frame.centre() + frame.rotation() * unit.cwiseProduct(frame.half());
}

/// The next place, for the rare vertices that would share a name.
NetworkVertexKey next_name(NetworkVertexKey name) {
  name.vertex = field_flag | ((name.vertex + 1) & (field_flag - 1));
  return name;
}

/// In order, each once.
std::vector<NetworkVertexKey> names_in(const EnvelopeSettings& settings) {
  std::set<NetworkVertexKey> out;
  for (const auto& [name, offset] : settings.offsets) out.insert(name);
  for (const auto& [curve, factor] : settings.fullness) out.insert({curve.low, curve.high});
  std::erase_if(out, [](const NetworkVertexKey& name) { return !is_field_name(name); });
  return {out.begin(), out.end()};
}

class Namer {
 public:
  Namer(const FieldNamesInput& input, const EnvelopeSettings& settings)
      : input_(input), known_(names_in(settings)) {
    for (Index s = 0; s < input.solids.size(); ++s)
      authored_.push_back(std::ranges::find(input.solids.first(s), input.solids[s].id, &Solid::id) ==
                          input.solids.begin() + s);
    const std::size_t count = input.positions.size();
    out_.name.resize(count);
    out_.owner.assign(count, no_index);
    out_.axes.assign(count, Matrix3::Identity());
  }

  FieldNames make() {
    give_known_names();
    for (Index v = 0; v < out_.name.size(); ++v)
      if (out_.owner[v] == no_index) give_new_name(v);
    return std::move(out_);
  }

 private:
  Index image(Index v) const { return input_.mirror ? input_.mirror->image[v] : v; }

  void give(Index v, const NetworkVertexKey& name, const Matrix3& axes) {
    taken_.insert(name);
    for (const Index w : {v, image(v)}) {
      out_.name[w] = name;
      out_.owner[w] = v;
      out_.axes[w] = axes;
      if (w != v) out_.axes[w].row(input_.mirror->axis) *= -1;
    }
  }

  void give_known_names() {
    struct Match {
      double distance;
      Index name, vertex, solid;
    };
    std::vector<Match> matches;
    for (Index n = 0; n < known_.size(); ++n) {
      const auto solid = std::ranges::find(input_.solids, known_[n].solid, &Solid::id);
      if (solid == input_.solids.end()) continue;
      const auto s = Index(solid - input_.solids.begin());
      const Vector3 place = place_of(known_[n], input_.distances[s]);
      for (Index v = 0; v < input_.positions.size(); ++v)
        if (const double d = (input_.positions[v] - place).norm() / input_.cell[v]; d <= widest_match)
          matches.push_back({d, n, v, s});
    }
    std::ranges::sort(matches, {}, [](const Match& m) { return std::tie(m.distance, m.name, m.vertex); });
    std::set<Index> given;
    for (const Match& match : matches) {
      if (given.contains(match.name) || out_.owner[match.vertex] != no_index) continue;
      given.insert(match.name);
      give(match.vertex, known_[match.name], input_.distances[match.solid].rotation());
    }
  }

  void give_new_name(Index v) {
    Index owner = v;
    Index solid = nearest_solid(input_.distances, input_.positions[v]).first;
    if (!authored_[solid] && image(v) != v) {
      owner = image(v);
      solid = nearest_solid(input_.distances, input_.positions[owner]).first;
    }
    // In the plane of symmetry a solid and its image are equally near.
    const auto own = std::ranges::find(input_.solids, input_.solids[solid].id, &Solid::id);
    solid = Index(own - input_.solids.begin());
    const SolidDistance& frame = input_.distances[solid];
    NetworkVertexKey name = name_at(*own, frame, input_.positions[owner]);
    while (taken_.contains(name) || std::ranges::binary_search(known_, name)) name = next_name(name);
    give(owner, name, frame.rotation());
  }

  const FieldNamesInput& input_;
  std::vector<NetworkVertexKey> known_;
  std::vector<bool> authored_;  ///< no image
  std::set<NetworkVertexKey> taken_;
  FieldNames out_;
};

}  // namespace

bool is_field_name(const NetworkVertexKey& key) {
  return !key.in_valley() && (key.vertex & field_flag) != 0;
}

FieldNames field_names(const FieldNamesInput& input, const EnvelopeSettings& settings) {
  return Namer(input, settings).make();
}

FieldPulls field_pulls(const FieldNames& names, const HalfEdgeMesh& cage, const EnvelopeSettings& settings,
                       const CageMirror* mirror) {
  FieldPulls out;
  std::vector<Vector3> moves(names.name.size(), Vector3::Zero());
  bool any = false;
  for (Index v = 0; v < moves.size(); ++v)
    if (const Vector3* offset = settings.offsets.find(names.name[v])) {
      any = true;
      moves[v] = names.axes[v] * *offset;
      // In the plane of symmetry only what stays in it.
      if (mirror && mirror->image[v] == v) moves[v] = mirror->evened(moves[v], moves[v]);
    }
  if (any) out.moves = std::move(moves);
  if (settings.fullness.empty()) return out;
  for (Index e = 0; e < cage.edge_count(); ++e) {
    const Index h = cage.half_edge_of_edge(e), a = cage.origin(h), b = cage.target(h);
    if (std::max(a, b) >= names.name.size()) continue;
    if (const double* factor = settings.fullness.find(NetworkEdgeKey::of(names.name[a], names.name[b])))
      out.fullness.push_back({a, b, *factor});
  }
  return out;
}

void add_field_handles(const FieldNames& names, const CageSurface& surface, const EnvelopeSettings& settings,
                       const CageMirror* mirror, EnvelopeHandles& out) {
  const HalfEdgeMesh& mesh = surface.cage.topology();
  const Surface& made = surface.made.surface;
  for (Index v = 0; v < names.name.size(); ++v) {
    EnvelopeVertex vertex{names.name[v], surface.cage.position(v), made.normal(mesh.outgoing(v), {1, 0}),
                          names.axes[v]};
    if (mirror && mirror->image[v] == v) {
      vertex.outward[mirror->axis] = 0;
      vertex.outward.normalize();
    }
    out.vertices.push_back(vertex);
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    if (std::max(a, b) >= names.name.size()) continue;
    EnvelopeCurve curve;
    curve.curve = NetworkEdgeKey::of(names.name[a], names.name[b]);
    curve.middle = made.patches().evaluate(h, {0.5, 0.5}, Order::first).position;
    curve.outward = made.normal(h, {0.5, 0.5});
    curve.way = (curve.middle - 0.5 * (surface.cage.position(a) + surface.cage.position(b))) /
                settings.fullness.get_or(curve.curve, 1.0);
    out.curves.push_back(curve);
  }
}

}  // namespace hariko
