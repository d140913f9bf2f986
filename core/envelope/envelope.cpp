#include "core/envelope/envelope.hpp"

#include <algorithm>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/cage_surface.hpp"
#include "core/envelope/convex_hull.hpp"
#include "core/envelope/network_handles.hpp"
#include "core/envelope/valley_tips.hpp"

namespace hariko {

namespace {

constexpr double tolerance = 1e-4;  ///< of the diagonal
constexpr int drag_builds = 2;
constexpr double least_ball = 3;  ///< of the rounding
/// Share of the solids' size: lattices of finer roundings would not fit into memory.
constexpr double least_rounding = 1.0 / 160;
/// Multiple of the solids' size. What such a ball leaves is the hull to a sixteenth of a thousandth of the
/// size.
constexpr double hull_ball = 2000;
constexpr int hull_level = 9;
constexpr int automatic_levels = 2;  ///< of the valleys' ladder; below that a field's cage is closer
constexpr double decay = 0.98;       ///< of what growth is above 1, a frame
constexpr double fair_details[] = {0.03, 0.06, 0.12, 0.2};  ///< added to the thinning distance, in turn

EnclosureSettings search_settings(const EnvelopeInput& input,
                                  const std::map<std::pair<Index, Index>, double>& waists, Quality quality) {
  EnclosureSettings out;
  out.detail = input.settings.detail;
  out.merge_angle = input.settings.merge_angle;
  out.waist = input.settings.waist;
  out.tolerance = tolerance;
  out.waists = &waists;
  out.fullness = &input.settings.fullness;
  out.offsets = &input.settings.offsets;
  if (quality == Quality::drag) {
    out.largest_builds = drag_builds;
    out.fine = false;
    out.strict = false;
  }
  return out;
}

/// The designer's factors, between the placed parts of two solids.
std::map<std::pair<Index, Index>, double> waists_of(const EnvelopeInput& input,
                                                    std::span<const PlacedSolid> solids) {
  std::map<std::pair<Index, Index>, double> out;
  if (input.settings.waists.empty()) return out;
  for (Index a = 0; a < solids.size(); ++a)
    for (Index b = a + 1; b < solids.size(); ++b)
      if (const double* factor = input.settings.waists.find(SolidPair::of(solids[a].id, solids[b].id)))
        out[{a, b}] = *factor;
  return out;
}

void relax(GrowthState& state) {
  for (double& s : state.sigma) s = 1 + decay * (s - 1);
  for (auto& [pair, factor] : state.cuts) factor = 1 - decay * (1 - factor);
}

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", 100 * part);
  return text;
}

void add_warnings(EnvelopeSurface& out) {
  const double miss = out.check ? std::max(out.check->worst, out.enclosed ? 0.0 : out.worst) : out.worst;
  if (miss > tolerance * out.diagonal)
    out.warnings.push_back(make_warning(w_not_enclosed,
                                        "The surface does not contain the solids: they reach out by up to " +
                                            percent(miss / out.diagonal) + " % of their size.",
                                        "Give a larger clearance, or raise the detail."));
  if (out.folds > 0)
    out.warnings.push_back(make_warning(w_envelope_fold,
                                        std::to_string(out.folds) + " patches of the surface fold over.",
                                        "Lower the waist or the roundness, or move the solids apart."));
  if (out.check && out.check->covered > 0)
    out.warnings.push_back(make_warning(
        w_envelope_crossing,
        "The surface runs into itself: " + std::to_string(out.check->covered) + " patches lie inside of it.",
        "Move the solids apart or into each other, or pull vertices less far."));
}

/// Pulls on a field's cage rest while there is a network, and the other way round.
bool has_network_pulls(const EnvelopeSettings& settings) {
  const auto of_network = [](const NetworkVertexKey& name) { return !is_field_name(name); };
  return std::ranges::any_of(settings.offsets, [&](const auto& entry) { return of_network(entry.first); }) ||
         std::ranges::any_of(settings.fullness,
                             [&](const auto& entry) { return of_network(entry.first.low); });
}

/// Of solids whose points are not all on their hull.
void add_hull_warnings(const EnvelopeInput& input, std::vector<Message>& warnings) {
  for (std::size_t i = 0; i < input.solids.size(); ++i)
    if (input.solids[i].kind == SolidKind::polyhedron && !is_convex(input.solids[i].points))
      warnings.push_back(make_warning(w_solid_hull,
                                      "Solid " + std::to_string(i) + " is not convex; its hull is used.",
                                      "Make it of several convex solids."));
}

void add_field_warnings(const FieldEnvelope& made, std::vector<Message>& warnings) {
  if (made.distance > 0)
    warnings.push_back(
        make_warning(w_tightness_loose,
                     "The surface keeps away from the solids by " + percent(made.distance) +
                         " % of their size and fills narrow notches: a closer one folds or misses a solid.",
                     "Move the solids apart or into each other, or choose smaller cells."));
  if (!made.waists_followed)
    warnings.push_back(
        make_warning(w_waist_limited,
                     "A bridge is not as thin or as thick as its waist asks for: the surface would fold "
                     "or miss a solid, or it runs into others there.",
                     "Choose a waist nearer to the usual one, or move the solids apart."));
  if (!made.pulls_followed)
    warnings.push_back(make_warning(w_pull_limited,
                                    "Vertices cannot be pulled so far: there is no surface with them there.",
                                    "Pull them less far, or reset what was pulled by hand."));
}

void take_cage(CageSurface cage, EnvelopeSurface& out) {
  out.surface = std::move(cage.made.surface);
  out.cage = std::make_shared<const Polyhedron>(std::move(cage.cage));
  out.shaping = std::move(cage.shaping);
  out.worst = cage.worst;
  out.folds = cage.folds;
  out.builds = cage.rounds + 1;
  out.check = std::move(cage.check);
  const double miss = out.check ? out.check->worst : out.worst;
  out.enclosed = miss <= tolerance * out.diagonal;
}

/// The ball's quads, whose normals are those of its surface.
Result<Done> take_quads(const BallEnvelope& made, EnvelopeSurface& out) {
  PolygonMesh mesh;
  mesh.positions = made.cage.positions;
  for (const auto& quad : made.cage.quads) mesh.add_face(quad);
  auto built = Polyhedron::build(mesh);
  if (!built) return built.error();
  out.shaping = length_tensions(*built);
  for (Index v = 0; v < mesh.positions.size(); ++v)
    out.shaping.pin.set(VertexId{v}, {Pin::Kind::normal, {out.surface.node_normal(v)}});
  out.cage = std::make_shared<const Polyhedron>(*std::move(built));
  return Done{};
}

/// Adds warnings of what the ball's patches miss.
void add_ball_warnings(const BallEnvelope& made, double asked, double rounding, EnvelopeSurface& out) {
  if (rounding > asked)
    out.warnings.push_back(
        make_warning(w_rounding_raised,
                     "The rounding is too small for solids of this size; " +
                         percent(rounding / out.diagonal) + " % of the size is used.",
                     "Choose a larger rounding, or distribute the solids over several objects."));
  if (made.coarse > 0)
    out.warnings.push_back(
        make_warning(w_envelope_coarse,
                     std::to_string(made.coarse) + " patches are up to " +
                         percent(std::max(made.outward, made.inward) / out.diagonal) +
                         " % of the size away from the shape, as it bends too tightly there.",
                     "Choose a larger ball or rounding, or move the solids a little."));
}

/// The fair surface over the cage of a network, which is pushed out on its own.
Result<Done> make_fair(const EnvelopeInput& input, std::span<const PlacedSolid> solids, Quality quality,
                       const CancelToken& cancel, EnvelopeSurface& out) {
  std::vector<SolidDistance> distances;
  for (const Solid& solid : input.solids) distances.emplace_back(solid, input.settings.clearance, out.origin);
  CageSurfaceRequest request;
  for (const CageVertex& vertex : out.network->cage.vertices)
    request.cage.positions.push_back(vertex.position);
  for (const CageFace& face : out.network->cage.faces) request.cage.add_face(face.loop);
  request.cell.assign(request.cage.positions.size(), 0.25 * out.diagonal);
  request.origin = out.origin;
  request.diagonal = out.diagonal;
  request.distances = distances;
  request.placed = solids;
  request.mirror = out.network->cage.mirror;
  request.strict = quality == Quality::final;
  if (quality == Quality::drag) request.rounds = drag_builds;
  auto made = cage_surface(request, cancel);
  if (!made) return made.error();
  take_cage(std::move(made).value(), out);
  return Done{};
}

}  // namespace

struct EnvelopeSurfacer::Job {
  const EnvelopeInput& input;  ///< with the images of solids
  Quality quality;
  const CancelToken& cancel;
  const SceneSymmetry* symmetry = nullptr;
  EnvelopeSurface out = {};
  std::vector<PlacedSolid> solids = {};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> names = {};
  std::map<std::pair<Index, Index>, double> waists = {};
  std::optional<int> dragged_level = {};  ///< of the field's ladder, where the last final result is on one

  EnclosureSettings search() const {
    EnclosureSettings settings = search_settings(input, waists, quality);
    settings.symmetry = symmetry;
    return settings;
  }
  Message cancelled() const { return make_error(e_cancelled, "The surface was cancelled."); }
};

Result<std::shared_ptr<const FieldBase>> EnvelopeSurfacer::base_of(const Job& job) {
  EnvelopeInput input = job.input;
  input.settings.waist = EnvelopeSettings{}.waist;
  input.settings.waists = {};
  input.settings.fullness = {};
  input.settings.offsets = {};
  if (last_base_ && input == last_base_input_ && suits(*last_base_, job.input)) {
    last_grids_ = last_base_->grids;
    return last_base_;
  }
  FieldStart start;
  if (job.dragged_level) start.level = *job.dragged_level;
  // A grid that had to give way does not come back while dragging: the surface would jump twice.
  if (job.dragged_level) start.grids = last_grids_;
  auto made = field_base(job.input, job.solids, job.out.origin, job.quality, start, job.cancel);
  if (!made) return made.error();
  auto base = std::make_shared<const FieldBase>(std::move(made).value());
  if (job.cancel.cancelled()) return base;
  last_grids_ = base->grids;
  if (job.quality == Quality::final) last_base_ = base, last_base_input_ = std::move(input);
  return base;
}

Result<bool> EnvelopeSurfacer::make_field(Job& job) {
  const auto base = base_of(job);
  if (job.cancel.cancelled()) return job.cancelled();
  // A folded surface, or one that has lost a solid, is no answer, unless the designer insists on the field.
  // What is pulled by hand may fold it.
  const bool insists = job.input.settings.method == EnvelopeMethod::field;
  if (!base && insists) return base.error();
  if (!base) return false;
  const FieldEnvelope& unpulled = (*base)->envelope;
  const bool answers =
      job.quality == Quality::final ? unpulled.sound() : job.dragged_level || unpulled.surface.folds == 0;
  if (!answers && !insists) return false;
  auto made = field_envelope(**base, job.input, job.solids, job.out.origin, job.quality, job.cancel);
  if (job.cancel.cancelled()) return job.cancelled();
  if (!made) return made.error();
  add_field_warnings(*made, job.out.warnings);
  job.out.network = nullptr;
  job.out.symmetric = job.symmetry != nullptr;  // a field's cage is its own image, or there is none
  job.out.level = made->level;
  job.out.components = made->components;
  job.out.tunnels = made->tunnels;
  job.out.handles = std::move(made->handles);
  take_cage(std::move(made->surface), job.out);
  return true;
}

GrowthState EnvelopeSurfacer::last_state(const Job& job) const {
  if (job.quality != Quality::drag || job.names != last_solids_) return {};
  GrowthState out = last_;
  relax(out);
  return out;
}

Result<bool> EnvelopeSurfacer::make_valleys(Job& job) {
  if (job.quality == Quality::drag) {
    const bool warm = job.names == last_solids_ && last_route_ == EnvelopeRoute::valleys;
    const ValleyAttempt attempt = warm ? last_attempt_ : ValleyAttempt{};
    ValleyEnvelope made = make_attempt(job.input, job.solids, job.out.origin, job.search(), attempt,
                                       warm ? last_state(job) : GrowthState{}, job.cancel);
    if (job.cancel.cancelled()) return job.cancelled();
    if (made.found.network.patches.empty()) return false;
    job.out.level = attempt.level;
    const auto taken = take_network(job, std::move(made.found));
    return taken ? Result<bool>(true) : Result<bool>(taken.error());
  }
  const EnvelopeSettings& wanted = job.input.settings;
  const bool insists = wanted.method == EnvelopeMethod::network;
  const bool pulled = has_network_pulls(wanted);
  EnclosureSettings unpulled = job.search();
  unpulled.offsets = nullptr;
  unpulled.fullness = nullptr;
  if (!insists && !suits_valleys(job.input, job.solids, job.out.origin, unpulled)) return false;
  const auto climb = [&](const EnclosureSettings& settings) {
    return valley_envelope(job.input, job.solids, job.out.origin, settings,
                           insists ? valley_levels : automatic_levels, job.cancel);
  };
  std::optional<ValleyEnvelope> made = climb(job.search());
  // What is pulled by hand may fold the surface; it does not make another one of it.
  if (!made && pulled)
    if (const auto plain = climb(unpulled))
      made =
          make_attempt(job.input, job.solids, job.out.origin, job.search(), plain->attempt, {}, job.cancel);
  if (job.cancel.cancelled()) return job.cancelled();
  if (!made || made->found.network.patches.empty()) return false;
  job.out.level = made->attempt.level;
  last_attempt_ = made->attempt;
  if (const auto taken = take_network(job, std::move(made->found)); !taken) return taken.error();
  return job.out.folds == 0 || insists || pulled;
}

Result<EnvelopeSurface> EnvelopeSurfacer::rebuild(const EnvelopeInput& input, Quality quality,
                                                  const CancelToken& cancel) {
  if (const auto checked = check_envelope(input); !checked) return checked.error();
  EnvelopedScene scene = enveloped_scene(input);
  Job job{scene.input, quality, cancel, scene.symmetry ? &*scene.symmetry : nullptr};
  job.solids = std::move(scene.placed);
  job.out.origin = scene.origin;
  job.out.diagonal = scene_diagonal(job.solids);
  for (const PlacedSolid& solid : job.solids) job.names.emplace_back(solid.id, solid.part);
  job.waists = waists_of(job.input, job.solids);
  if (input.settings.method == EnvelopeMethod::ball) {
    if (const auto taken = make_ball(job); !taken) return taken.error();
    if (quality == Quality::final) add_hull_warnings(input, job.out.warnings);
    last_route_ = EnvelopeRoute::ball;
    last_solids_ = std::move(job.names);
    add_warnings(job.out);
    return std::move(job.out);
  }
  // While dragging the kind of surface stays.
  const bool stays = quality == Quality::drag && job.names == last_solids_ && input.settings.tightness > 0 &&
                     input.settings.method == EnvelopeMethod::automatic &&
                     last_route_ != EnvelopeRoute::ball &&
                     (last_route_ != EnvelopeRoute::hull || last_level_ == hull_level);
  const EnvelopeRoute first = stays ? last_route_ : envelope_route(job.input, job.solids, job.out.origin);
  bool made = false;
  if (first == EnvelopeRoute::valleys) {
    const auto taken = make_valleys(job);
    if (!taken) return taken.error();
    made = *taken;
    if (made) job.out.route = EnvelopeRoute::valleys;
  }
  const bool field = first == EnvelopeRoute::field || (!made && first == EnvelopeRoute::valleys &&
                                                       input.settings.method != EnvelopeMethod::network);
  if (field) {
    if (quality == Quality::drag && job.names == last_solids_ && last_route_ == EnvelopeRoute::field)
      job.dragged_level = last_level_;
    const auto taken = make_field(job);
    if (!taken) return taken.error();
    made = *taken;
    if (made) job.out.route = EnvelopeRoute::field;
  }
  if (!made) {
    if (const auto taken = make_hull(job); !taken) return taken.error();
    if (first != EnvelopeRoute::hull) {
      job.out.level = hull_level;
      job.out.warnings.push_back(
          make_warning(w_tightness_reduced,
                       "The surface cannot follow the notches between these solids; it is their hull.",
                       "Move the solids apart or into each other, or choose smaller cells."));
    }
  }
  if (quality == Quality::final) {
    last_route_ = job.out.route;
    last_level_ = job.out.level;
    add_hull_warnings(input, job.out.warnings);
  }
  last_solids_ = std::move(job.names);
  add_warnings(job.out);
  if (job.symmetry && !job.out.symmetric)
    job.out.warnings.push_back(make_warning(w_not_symmetric,
                                            "The surface is not symmetric: its faces differ on both sides.",
                                            "Change the thinning, or move a solid a little."));
  return std::move(job.out);
}

Result<Done> EnvelopeSurfacer::make_ball(Job& job) {
  const EnvelopeSettings& wanted = job.input.settings;
  const bool last = job.quality == Quality::final;
  EnvelopeSurface& out = job.out;
  BallSettings ball;
  ball.sigma = std::max(wanted.rounding, least_rounding * out.diagonal);
  ball.radius = std::max(wanted.ball_radius.value_or(hull_ball * out.diagonal), least_ball * ball.sigma);
  ball.clearance = wanted.clearance;
  std::optional<Eigen::Index> mirror;
  if (job.symmetry) mirror = job.symmetry->axis;
  std::optional<BallEnvelope> made =
      ball_envelope(job.input.solids, ball, out.origin, mirror, job.quality, job.cancel);
  if (job.cancel.cancelled()) return job.cancelled();
  if (!made)
    return make_error(e_envelope_flat, "There is no surface round the solids.",
                      "Make one of them thicker, or the rounding larger.");
  out.route = EnvelopeRoute::ball;
  out.surface = std::move(made->surface);
  out.components = made->topology.components;
  out.tunnels = made->topology.tunnels;
  out.folds = made->folds;
  out.builds = made->cuts + 1;
  out.symmetric = job.symmetry != nullptr;
  // Patches that are as near to the shape as that lie outside of the solids (docs/envelope.md).
  out.enclosed = made->inward <= made->tolerance;
  if (!last) return Done{};
  if (made->coarse > 0) {
    out.check = check_enclosure(out.surface, job.solids, {}, tolerance * out.diagonal, job.cancel);
    if (job.cancel.cancelled()) return job.cancelled();
    out.enclosed = out.check->worst <= tolerance * out.diagonal;
  }
  if (wanted.from_before)
    out.warnings.push_back(make_warning(
        w_envelope_method,
        "The file is from an older Hariko, which made the surface round these solids in another way: its "
        "shape differs.",
        "Look at tightness and rounding, or choose the network of curves."));
  add_ball_warnings(*made, wanted.rounding, ball.sigma, out);
  return take_quads(*made, out);
}

Result<Done> EnvelopeSurfacer::make_hull(Job& job) {
  const bool drag = job.quality == Quality::drag;
  // While dragging the settings stay those of the last final result.
  const bool warm = job.names == last_solids_ && last_route_ == EnvelopeRoute::hull;
  HullEnvelope made = drag ? make_attempt(job.solids, job.search(), warm ? last_hull_ : HullAttempt{},
                                          last_state(job), job.cancel)
                           : hull_envelope(job.solids, job.search(), job.cancel);
  if (job.cancel.cancelled()) return job.cancelled();
  if (made.found.network.patches.empty())
    return make_error(e_envelope_flat, "The solids are too flat for a surface round them.",
                      "Make one of them thicker.");
  if (drag) return take_network(job, std::move(made.found));
  last_hull_ = made.attempt;
  if (job.input.settings.patches == EnvelopePatches::fair) return make_fair_hull(job, std::move(made));
  return take_network(job, std::move(made.found));
}

/// The fair surface folds over polygons that are very uneven, where rational patches do not: those of a hull
/// that is thinned more are larger.
Result<Done> EnvelopeSurfacer::make_fair_hull(Job& job, HullEnvelope first) {
  const EnvelopeSurface blank = job.out;
  const HullAttempt start = first.attempt;
  const auto badness = [](const EnvelopeSurface& made) {
    return double(made.folds) + (made.enclosed ? 0 : outside_folds);
  };
  if (const auto taken = take_network(job, std::move(first.found)); !taken) return taken.error();
  EnvelopeSurface best = std::move(job.out);
  GrowthState state = last_;
  for (const double more : fair_details) {
    if (!(badness(best) > 0)) break;
    HullAttempt attempt = start;
    attempt.more_detail += more;
    HullEnvelope other = make_attempt(job.solids, job.search(), attempt, {}, job.cancel);
    if (job.cancel.cancelled()) return job.cancelled();
    if (other.found.network.patches.empty()) continue;
    job.out = blank;
    if (const auto taken = take_network(job, std::move(other.found)); !taken) return taken.error();
    if (badness(job.out) >= badness(best)) continue;
    best = std::move(job.out);
    state = last_;
    last_hull_ = std::move(attempt);
  }
  job.out = std::move(best);
  last_ = std::move(state);
  return Done{};
}

Result<Done> EnvelopeSurfacer::take_network(Job& job, EnclosedNetwork found) {
  EnvelopeSurface& out = job.out;
  last_ = found.state;
  out.enclosed = found.enclosed;
  out.worst = found.worst;
  out.builds = found.builds;
  out.folds = 0;
  if (job.quality == Quality::final) {
    out.folds = folded_patches(found.network).size();
    out.check = std::move(found.check);
  }
  out.network = std::make_shared<const CurveNetwork>(std::move(found.network));
  out.symmetric = out.network->cage.mirror.has_value();
  out.handles = handles_of(*out.network, job.solids, job.input.settings);
  if (job.input.settings.patches == EnvelopePatches::fair)
    return make_fair(job.input, job.solids, job.quality, job.cancel, out);
  out.surface = network_surface(*out.network, out.origin);
  return Done{};
}

}  // namespace hariko
