#include "core/patching/compare_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>

namespace hariko {

namespace {

/// Controls of a patch, where its form has them; the first `vectors` are derivatives and not points.
struct ComparedControls {
  std::span<const Vector3> all = {};
  std::size_t vectors = 0;
};
ComparedControls controls_of(const ExactForm& form) {
  if (const auto* quartic = std::get_if<PairedQuartic>(&form)) return {quartic->controls};
  if (const auto* chart = std::get_if<ChartPatch>(&form)) return {chart->controls, chart->vectors};
  if (const auto* bicubic = std::get_if<BicubicPatch>(&form)) return {bicubic->controls};
  return {};
}

using Source = std::tuple<Element::Kind, std::uint64_t, std::uint32_t>;
Source source_of(const Surface& surface, Index patch) {
  const Provenance& from = surface.provenance()[patch];
  return {from.element.kind, from.element.id, from.side};
}

}  // namespace

SurfaceComparison compare_surfaces(const Surface& surface, const Surface& other) {
  SurfaceComparison out;
  out.patches = surface.patch_count();
  if (surface.patch_count() == 0) return out;
  std::map<Source, Index> there;
  for (Index p = 0; p < other.patch_count(); ++p) there[source_of(other, p)] = p;
  if (other.patch_count() == 0) {
    out.unmatched = out.patches;
    return out;
  }
  const Vector3 shift = other.origin() - surface.origin();
  Eigen::AlignedBox3d box;
  double largest = 0;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const auto partner = there.find(source_of(surface, p));
    const ExactForm form = surface.patches().exact_form(p);
    const ComparedControls own = controls_of(form);
    const std::span<const Vector3> a = own.all;
    for (std::size_t i = own.vectors; i < a.size(); ++i) box.extend(a[i]);
    const ExactForm beyond =
        partner == there.end() ? ExactForm() : other.patches().exact_form(partner->second);
    const std::span<const Vector3> b = controls_of(beyond).all;
    if (a.empty() || form.index() != beyond.index() || a.size() != b.size()) {
      ++out.unmatched;
      continue;
    }
    const bool same = shift.isZero(0) && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    ++(same ? out.unchanged : out.changed);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vector3 moved = b[i] - a[i];
      largest = std::max(largest, (i >= own.vectors ? Vector3(moved + shift) : moved).norm());
    }
  }
  const double size = box.isEmpty() ? 0 : box.diagonal().norm();
  if (out.unmatched < out.patches) out.largest_distance = size > 0 ? largest / size : largest;
  return out;
}

}  // namespace hariko
