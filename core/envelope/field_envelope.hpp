#pragma once

// The envelope on a field's cage: the ladder of settings until the surface contains the solids, has no fold
// and has the wanted topology.

#include "core/envelope/cage_surface.hpp"
#include "core/envelope/envelope_handles.hpp"
#include "core/envelope/field_cage.hpp"
#include "core/envelope/field_handles.hpp"

namespace hariko {

/// The cage keeps away from the solids and fills narrow notches.
inline constexpr Code w_tightness_loose{"W_TIGHTNESS_LOOSE"};
/// A bridge is nearer to its usual thickness than its waist asks for.
inline constexpr Code w_waist_limited{"W_WAIST_LIMITED"};

/// A vertex of the surface is nearer to its place than it was pulled.
inline constexpr Code w_pull_limited{"W_PULL_LIMITED"};

struct FieldEnvelope {
  CageSurface surface;
  int level = 0;        ///< of the ladder, 0: the first settings
  double distance = 0;  ///< that the cage keeps from the solids, over the diagonal; narrow notches are filled
  bool enclosed = false;  ///< within the tolerance, by the independent check where there was one
  int components = 0, tunnels = 0, wanted_tunnels = 0;
  EnvelopeHandles handles = {};  ///< bridges on bars and in notches; the cage's vertices and curves
  double fillet = 0;             ///< in notches, over the cell, where no waist asks for another
  bool waists_followed = true;   ///< else the surface would fold or miss a solid, or a bar has no ring
  bool pulls_followed = true;    ///< else there is no surface with vertices that far
  bool sound() const { return enclosed && !surface.is_folded(); }
};

/// What does not depend on the waists of bars and on what was pulled by hand.
struct FieldBase {
  FieldScene scene;
  FieldEnvelope envelope;         ///< without handles
  std::vector<double> cell;       ///< one a vertex of its cage
  std::vector<GridChoice> grids;  ///< one a cluster
};

/// What a drag goes on from.
struct FieldStart {
  int level = 0;
  std::span<const GridChoice> grids = {};
};

/// The first level that is sound and has the wanted topology; else the first sound one that keeps a distance;
/// else the best there is. While dragging the level of `start`, with its grids where they still serve.
/// `placed`: relative to `origin`. Errors: E_ENVELOPE_FLAT where no cage was found, those of `cage_surface`.
Result<FieldBase> field_base(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                             const Vector3& origin, Quality quality, const FieldStart& start = {},
                             const CancelToken& cancel = {});

/// Whether the base of solids that were placed alike has fillets as wide as `input` asks for.
bool suits(const FieldBase& base, const EnvelopeInput& input);

/// With waists and pulls as `input` has them; all else is that of the base. What is pulled may fold the
/// surface.
Result<FieldEnvelope> field_envelope(const FieldBase& base, const EnvelopeInput& input,
                                     std::span<const PlacedSolid> placed, const Vector3& origin,
                                     Quality quality, const CancelToken& cancel = {});

}  // namespace hariko
