#include "ui/editor/continuity_text.hpp"

#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "render/color_map.hpp"

namespace hariko {

namespace {

/// Kinks below it are rounding, in radians.
constexpr double rounding_kink = 1e-9;

/// "a, b and c"
std::string listed(const std::vector<std::string>& parts, const Language& tr) {
  std::string out = parts.front();
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) out += tr(", ") + parts[i];
  return parts.size() < 2 ? out : fill(tr("{0} and {1}"), {out, parts.back()});
}

}  // namespace

ReachedContinuity reached_continuity(const Surface& surface, const ContinuityReport& report,
                                     const ContinuityTolerance& tolerance) {
  ReachedContinuity out;
  const std::vector<Continuity> classes = classify(surface, report, tolerance);
  // The least of the seams over an edge; seams inside of faces by themselves.
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::pair<Continuity, bool>> edges;
  for (std::size_t s = 0; s < classes.size(); ++s) {
    const Seam& seam = surface.seams()[s];
    const bool crease = seam.intended == Continuity::g0;
    const bool edge = seam.source.kind != Element::Kind::none;
    const auto key = edge ? std::pair<std::uint64_t, std::uint64_t>(seam.source.id, 0)
                          : std::pair<std::uint64_t, std::uint64_t>(s, 1);
    auto& [least, sharp] = edges.try_emplace(key, classes[s], crease).first->second;
    least = std::min(least, classes[s]);
    sharp = sharp || crease;
    if (!crease) out.largest_kink = std::max(out.largest_kink, report.seams[s].normal_jump);
  }
  std::size_t smooth = 0, curved = 0;
  for (const auto& [key, edge] : edges) {
    out.creases += edge.second ? 1 : 0;
    if (edge.second) continue;
    ++smooth;
    curved += edge.first == Continuity::g2 ? 1 : 0;
  }
  out.joined = smooth > 0;
  out.smooth = 2 * curved > smooth ? Continuity::g2 : Continuity::g1;
  for (const auto& [key, edge] : edges)
    if (!edge.second && edge.first < out.smooth) ++(key.second == 0 ? out.less : out.inner_less);
  return out;
}

std::string text_of(const ReachedContinuity& reached, const Language& tr) {
  if (!reached.joined && reached.creases == 0) return {};
  const std::string creases = tr.counted(reached.creases, "1 creased edge", "{0} creased edges");
  if (!reached.joined) return creases;
  if (reached.largest_kink >= rounding_kink) {
    const std::string kink =
        fill(tr("largest kink {0}\u00b0"), {format_number(reached.largest_kink * 180 / std::numbers::pi, 3)});
    return reached.creases > 0 ? kink + ", " + creases : kink;
  }
  const char* name = reached.smooth == Continuity::g2 ? tr("curvature-continuous") : tr("tangent-continuous");
  std::vector<std::string> exceptions;
  if (reached.less > 0) exceptions.push_back(tr.counted(reached.less, "1 edge", "{0} edges"));
  if (reached.inner_less > 0)
    exceptions.push_back(
        tr.counted(reached.inner_less, "1 seam inside of a face", "{0} seams inside of faces"));
  if (reached.creases > 0) exceptions.push_back(creases);
  return exceptions.empty() ? std::string(name) : fill(tr("{0} but for {1}"), {name, listed(exceptions, tr)});
}

}  // namespace hariko
