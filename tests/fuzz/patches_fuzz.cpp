#include "core/exchange/detect_json_format.hpp"
#include "core/exchange/read_patches.hpp"
#include "tests/fuzz/check.hpp"

namespace {

using namespace hariko;

/// Points and weights are finite, weights positive, and there are as many as the degrees say.
void check(const std::vector<BezierPatch>& patches, std::size_t bytes) {
  std::size_t points = 0;
  for (const BezierPatch& patch : patches) {
    const auto count = std::size_t((patch.degree_s + 1) * (patch.degree_t + 1));
    fuzz::require(patch.degree_s >= 1 && patch.degree_t >= 1, "degrees are positive");
    fuzz::require(patch.points.size() == count, "points fit the degrees");
    fuzz::require(!patch.rational() || patch.weights.size() == count, "weights fit the degrees");
    for (const Vector3& p : patch.points) fuzz::require(p.allFinite(), "points are finite");
    for (const double w : patch.weights) fuzz::require(w > 0 && w < 1e300, "weights are positive");
    points += count;
  }
  // Sixteen numbers name the points of an indexed patch.
  fuzz::require(points <= bytes, "size in proportion");
}

}  // namespace

/// The readers of patches: text, plain or indexed, and JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  const auto plain = read_bezier_text(text);
  if (plain.ok())
    check(*plain, size);
  else
    fuzz::check(plain.error(), Severity::error);
  const auto named = read_bezier_json(text);
  if (named.ok()) {
    for (const NamedPatches& group : *named) check(group.patches, size);
  } else {
    fuzz::check(named.error(), Severity::error);
  }
  if (const auto kind = json_kind(text); !kind.ok()) fuzz::check(kind.error(), Severity::error);
  return 0;
}
