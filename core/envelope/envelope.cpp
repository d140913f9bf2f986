#include "core/envelope/envelope.hpp"

#include <algorithm>
#include <cstdio>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "core/geometry/tolerant_hull.hpp"

namespace hariko {

namespace {

constexpr double enclosure_tolerance = 1e-4;  ///< relative to the diagonal
/// Spacing of tested points on edges and rims, relative to the diagonal.
constexpr double curve_spacing = 1e-3;
constexpr double symmetry_tolerance = 1e-6;  ///< relative to the diagonal

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", 100 * part);
  return text;
}

Message cancelled() {
  return make_error(e_cancelled, "The surface was cancelled.");
}

/// Tests whether the surface contains the solids and intersects itself.
Result<Done> examine(const EnvelopedScene& scene, EnvelopeSurface& out, const CancelToken& cancel) {
  std::vector<SolidShape> shapes;
  for (const Solid& solid : scene.input.solids) shapes.emplace_back(solid, out.origin);
  EnclosureEffort effort;
  effort.spacing = curve_spacing * out.diagonal;
  const double tolerance = enclosure_tolerance * out.diagonal;
  out.check = check_enclosure(out.surface, shapes, effort, tolerance, cancel);
  if (cancel.cancelled()) return cancelled();
  out.enclosed = out.check->worst <= tolerance;
  return Done{};
}

/// Adds warnings about the results of a check, with remedies within method `ball`; a network's only remedy is
/// that method.
void add_warnings(bool network, EnvelopeSurface& out) {
  const auto add = [&](Code code, std::string text, const char* of_ball) {
    out.warnings.push_back(make_warning(
        code, std::move(text),
        network ? "Choose the method \"ball\": it contains the solids and does not fold." : of_ball));
  };
  // Edges are meant to protrude from a surface whose faces lie on the solids.
  if (out.check && !out.enclosed && !out.sticks_out)
    add(w_not_enclosed,
        "The surface does not contain the solids: they reach out by up to " +
            percent(out.check->worst / out.diagonal) + " % of their size.",
        "Choose a larger ball or rounding, or a larger clearance.");
  if (out.folds > 0)
    add(w_envelope_fold, std::to_string(out.folds) + " patches of the surface fold over.",
        "Choose a larger ball or rounding, or move the solids a little.");
  if (out.check && out.check->covered > 0)
    add(w_envelope_crossing,
        "The surface runs into itself: " + std::to_string(out.check->covered) + " patches lie inside of it.",
        "Choose a larger ball or rounding, or move the solids a little.");
}

/// Adds warnings about polyhedra with points inside their hull.
void add_hull_warnings(const EnvelopeInput& input, std::vector<Message>& warnings) {
  for (std::size_t i = 0; i < input.solids.size(); ++i)
    if (input.solids[i].kind == SolidKind::polyhedron && !is_convex(input.solids[i].points))
      warnings.push_back(make_warning(w_solid_hull,
                                      "Solid " + std::to_string(i) + " is not convex; its hull is used.",
                                      "Make it of several convex solids."));
}

/// Adds the warning about files older than method `ball`.
void add_file_warnings(const EnvelopeSettings& settings, std::vector<Message>& warnings) {
  if (!settings.converted.method && settings.converted.lost.empty()) return;
  std::string text =
      "The file is from an older Hariko, which made the surface round these solids in another way: its shape "
      "differs.";
  if (!settings.converted.method)
    text = "The file is from an older Hariko; these of its settings mean nothing any more: " +
           settings.converted.lost + ".";
  else if (!settings.converted.lost.empty())
    text =
        "The file is from an older Hariko, which made the surface round these solids in another way: its "
        "shape differs, and these settings mean nothing any more: " +
        settings.converted.lost + ".";
  warnings.push_back(make_warning(w_envelope_method, std::move(text),
                                  settings.method == EnvelopeMethod::ball
                                      ? "Look at tightness and rounding, or choose the network of curves."
                                      : "Look at the surface, or choose the ball."));
}

/// Adds warnings about deviations of the ball's patches.
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

Result<Done> make_ball(const EnvelopedScene& scene, Quality quality, const CancelToken& cancel,
                       BallMemory& memory, EnvelopeSurface& out) {
  const EnvelopeSettings& wanted = scene.input.settings;
  const BallSettings ball = ball_settings(wanted, out.diagonal);
  std::optional<BallEnvelope> made =
      ball_envelope(scene.input.solids, ball, out.origin, scene.mirror, quality, cancel, &memory);
  if (cancel.cancelled()) return cancelled();
  if (!made)
    return make_error(e_envelope_flat, "There is no surface round the solids.",
                      "Make one of them thicker, or the rounding larger.");
  out.surface = std::move(made->surface);
  out.cage = std::make_shared<const BallCage>(std::move(made->cage));
  out.components = made->topology.components;
  out.tunnels = made->topology.tunnels;
  out.folds = made->folds;
  out.coarse = made->coarse;
  out.rounds = made->rounds;
  out.symmetric = scene.mirror.has_value();
  // Patches within the tolerance of the shape lie outside the solids (docs/envelope.md).
  out.enclosed = made->contains_solids();
  if (ball.on_faces) {
    out.sticks_out = made->sticks_out;
    out.enclosed = made->lost == 0 && made->sticks_out + made->inward <= enclosure_tolerance * out.diagonal;
  }
  if (quality == Quality::drag) return Done{};
  if (made->coarse > 0 || made->lost > 0)
    if (const auto done = examine(scene, out, cancel); !done) return done;
  if (out.sticks_out && out.check) out.sticks_out = std::max(*out.sticks_out, out.check->worst);
  add_ball_warnings(*made, wanted.rounding, ball.sigma, out);
  return Done{};
}

Result<Done> make_network(const EnvelopedScene& scene, Quality quality, const CancelToken& cancel,
                          EnvelopeSurface& out) {
  const std::vector<NetworkSolid> solids = network_solids(scene.input, out.origin);
  NetworkCage cage = hull_cage(solids, network_size(solids));
  if (cage.faces.empty())
    return make_error(e_envelope_flat, "The solids are too flat for a surface round them.",
                      "Make one of them thicker.");
  out.network = std::make_shared<const CurveNetwork>(curve_network(std::move(cage), solids));
  out.symmetric =
      scene.mirror && is_symmetric(*out.network, *scene.mirror, symmetry_tolerance * out.diagonal);
  out.surface = network_surface(*out.network, out.origin);
  if (quality == Quality::drag) return Done{};
  out.folds = folded_patches(out.surface);
  if (scene.mirror && !out.symmetric)
    out.warnings.push_back(make_warning(w_not_symmetric,
                                        "The surface is not symmetric: its faces differ on both sides.",
                                        "Choose the method \"ball\", whose surface is symmetric."));
  return examine(scene, out, cancel);
}

}  // namespace

EnvelopeSurfacer::EnvelopeSurfacer() : memory_(std::make_unique<BallMemory>()) {}
EnvelopeSurfacer::~EnvelopeSurfacer() = default;

Result<EnvelopeSurface> EnvelopeSurfacer::rebuild(const EnvelopeInput& input, Quality quality,
                                                  const CancelToken& cancel) {
  if (const auto checked = check_envelope(input); !checked) return checked.error();
  const EnvelopedScene scene = enveloped_scene(input);
  const bool network = input.settings.method == EnvelopeMethod::network;
  EnvelopeSurface out;
  out.origin = scene.origin;
  out.diagonal = solids_size(scene.input.solids);
  const auto made =
      network ? make_network(scene, quality, cancel, out) : make_ball(scene, quality, cancel, *memory_, out);
  if (!made) return made.error();
  if (quality == Quality::drag) return out;
  add_file_warnings(input.settings, out.warnings);
  add_hull_warnings(input, out.warnings);
  const auto has_pulls = [](const Solid& solid) { return !solid.pulls.empty(); };
  if (network && std::ranges::any_of(input.solids, has_pulls))
    out.warnings.push_back(make_warning(w_pulls_unused, "The network of curves does not follow the pulls.",
                                        "Choose the method \"ball\", or remove the pulls."));
  add_warnings(network, out);
  return out;
}

}  // namespace hariko
