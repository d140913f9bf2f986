#include "core/skinning/columns/smooth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/skinning/columns/column_cache.hpp"
#include "core/skinning/columns/column_parameters.hpp"
#include "core/skinning/columns/skin_caps.hpp"
#include "core/skinning/sections/monotone_cubic.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_smooth_vertices = 2'000'000;

std::vector<double> places_of(const Skin& skin) {
  std::vector<double> out;
  for (const SkinSection& section : skin.sections) out.push_back(section.v);
  return out;
}

/// Distributes intervals between breakpoints: at least one each, then one more for the longest until there
/// are `total`; ends included.
std::vector<double> distributed(const std::vector<double>& breaks, int total) {
  std::vector<int> count(breaks.size() - 1, 1);
  for (int given = int(count.size()); given < total; ++given) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < count.size(); ++k)
      if ((breaks[k + 1] - breaks[k]) / count[k] > (breaks[longest + 1] - breaks[longest]) / count[longest])
        longest = k;
    ++count[longest];
  }
  std::vector<double> out;
  for (std::size_t k = 0; k < count.size(); ++k)
    for (int i = 0; i < count[k]; ++i) out.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * i / count[k]);
  out.push_back(breaks.back());
  return out;
}

}  // namespace

VirtualSurface::VirtualSurface(const Skin& skin, const SkinPlan& plan,
                               std::vector<std::vector<double>> anchors)
    : plan_(plan),
      weights_(places_of(skin), skin.path.closed, skin.smooth.blend),
      closed_sections_(plan.closed_sections) {
  for (int k = 0; k < skin.section_count(); ++k) offsets_.push_back(plan.offset_curve(skin, k));
  if (anchors.empty()) return;
  for (const auto& row : anchors)
    places_.push_back(std::accumulate(row.begin(), row.end(), 0.0) / double(row.size()));
  anchors_.resize(offsets_.size());
  for (std::size_t k = 0; k < offsets_.size(); ++k)
    for (const auto& row : anchors) anchors_[k].push_back(row[k]);
}

double VirtualSurface::parameter(int section, double u) const {
  const double start = plan_.starts[std::size_t(section)];
  if (anchors_.empty()) return start + u;
  std::vector<double> x, y;
  const auto& own = anchors_[std::size_t(section)];
  if (closed_sections_) {
    for (const double turn : {-1.0, 0.0, 1.0})
      for (std::size_t a = 0; a < places_.size(); ++a) {
        x.push_back(places_[a] + turn);
        y.push_back(own[a] + turn);
      }
  } else {
    x = places_, y = own;
    x.insert(x.begin(), 0.0), y.insert(y.begin(), 0.0);
    x.push_back(1), y.push_back(1);
  }
  return start + hermite(x, y, monotone_slopes(x, y), u);
}

Vector3 VirtualSurface::point(const std::vector<double>& u, double v) const {
  const std::vector<double> weight = weights_.at(v);
  Vector3 offset = Vector3::Zero();
  for (std::size_t k = 0; k < offsets_.size(); ++k)
    if (weight[k] != 0) offset += weight[k] * evaluate(offsets_[k], u[k]).position;
  return plan_.frames.position(v) + plan_.frames.frame(v) * offset;
}

Vector3 VirtualSurface::point(double u, double v) const {
  std::vector<double> all;
  for (int k = 0; k < int(offsets_.size()); ++k) all.push_back(parameter(k, u));
  return point(all, v);
}

namespace {

/// Parameters of points that links connect, one group per chain of links.
class AnchorChains {
 public:
  AnchorChains(const Skin& skin, const SkinPlan& plan) : skin_(skin), plan_(plan) {
    for (const SkinLink& link : skin.links) {
      const int a = skin.find_section(link.first), b = skin.find_section(link.second);
      const Index x = node(a, link.a), y = node(b, link.b);
      tied_.join(x, y);
    }
  }

  /// Makes one row per chain with one parameter per section: those of a chain on a section are averaged,
  /// missing ones are interpolated along the path.
  std::vector<std::vector<double>> rows() {
    std::map<Index, std::map<int, std::vector<double>>> chains;
    for (Index i = 0; i < nodes_.size(); ++i)
      chains[tied_.find(i)][nodes_[i].first].push_back(nodes_[i].second);
    std::vector<std::vector<double>> out;
    for (auto& [root, sections] : chains) {
      // All on the turn of the chain's first parameter.
      if (plan_.closed_sections) {
        const double first = sections.begin()->second.front();
        for (auto& [k, list] : sections)
          for (double& u : list) u -= std::round(u - first);
      }
      std::vector<std::pair<double, double>> known;  // v, u
      for (const auto& [k, u] : sections)
        known.emplace_back(skin_.sections[std::size_t(k)].v,
                           std::accumulate(u.begin(), u.end(), 0.0) / double(u.size()));
      std::sort(known.begin(), known.end());
      std::vector<double> row;
      for (const SkinSection& section : skin_.sections) {
        const auto above = std::lower_bound(known.begin(), known.end(), std::pair(section.v, -1e9));
        if (above == known.begin()) {
          row.push_back(known.front().second);
        } else if (above == known.end()) {
          row.push_back(known.back().second);
        } else {
          const auto [v0, u0] = *(above - 1);
          const auto [v1, u1] = *above;
          row.push_back(u0 + (u1 - u0) * (section.v - v0) / (v1 - v0));
        }
      }
      out.push_back(std::move(row));
    }
    return out;
  }

 private:
  Index node(int section, const std::vector<std::uint32_t>& ids) {
    const SkinSection& s = skin_.sections[std::size_t(section)];
    double sum = 0;
    for (const std::uint32_t id : ids) sum += s.curve().parameter(find_point(s, id));
    const std::pair<int, double> made{section, sum / double(ids.size()) - plan_.starts[std::size_t(section)]};
    const auto found = std::find(nodes_.begin(), nodes_.end(), made);
    if (found != nodes_.end()) return Index(found - nodes_.begin());
    nodes_.push_back(made);
    return tied_.add();
  }
  const Skin& skin_;
  const SkinPlan& plan_;
  std::vector<std::pair<int, double>> nodes_;
  DisjointSets tied_;
};

/// Rotates a row cyclically so that the sum of the differences from `first` is least.
void turn_to(const std::vector<double>& first, std::vector<double>& own) {
  std::vector<double> best = own, turned = own;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < own.size(); ++turn) {
    double sum = 0;
    for (std::size_t c = 0; c < own.size(); ++c) {
      const double gap = turned[c] - first[c];
      sum += (gap - std::round(gap)) * (gap - std::round(gap));
    }
    if (sum < least - 1e-12) least = sum, best = turned;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  own = std::move(best);
}

/// Rows of inner corners of the sections, where all have the same number of them; one row per corner. Counted
/// from the starts of the sections.
std::vector<std::vector<double>> corner_rows(const Skin& skin, const SkinPlan& plan) {
  if (!skin.creases) return {};
  std::vector<std::vector<double>> rows;
  for (std::size_t k = 0; k < skin.sections.size(); ++k) {
    const SubdivisionCurve curve = skin.sections[k].curve();
    std::vector<double> corners;
    for (int i = 0; i < curve.size(); ++i)
      if (curve.is_sharp(i) && (curve.closed || (i > 0 && i + 1 < curve.size())))
        corners.push_back(curve.parameter(i) - plan.starts[k]);
    if (k == 0) rows.resize(corners.size());
    if (corners.size() != rows.size()) return {};
    if (k > 0 && plan.closed_sections) {
      std::vector<double> first;
      for (const auto& row : rows) first.push_back(row[0]);
      turn_to(first, corners);
    }
    for (std::size_t c = 0; c < corners.size(); ++c) rows[c].push_back(corners[c]);
  }
  return rows;
}

bool near(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::abs(a[k] - b[k]) > 1e-9) return false;
  return true;
}

}  // namespace

Result<std::vector<std::vector<double>>> skin_anchors(const Skin& skin, const SkinPlan& plan) {
  std::vector<std::vector<double>> rows;
  if (skin.method == SkinMethod::anchored) {
    rows = skin.smooth.anchors;
    for (auto& row : rows) {
      if (row.size() != skin.sections.size())
        return make_error(e_skin_index, "An anchor needs one parameter for each section.", "Delete it.");
      for (std::size_t k = 0; k < row.size(); ++k) row[k] -= plan.starts[k];
    }
    for (auto& row : AnchorChains(skin, plan).rows()) rows.push_back(std::move(row));
  }
  for (auto& row : corner_rows(skin, plan)) rows.push_back(std::move(row));
  if (!plan.closed_sections)
    std::erase_if(rows, [](const auto& row) {
      return std::all_of(row.begin(), row.end(), [](double u) { return u <= 0; }) ||
             std::all_of(row.begin(), row.end(), [](double u) { return u >= 1; });
    });
  // On closed sections a row may begin on another turn: it is moved next to the first section's parameter.
  if (plan.closed_sections)
    for (auto& row : rows)
      for (double& u : row) u -= std::round(u - row[0]);
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return std::accumulate(a.begin(), a.end(), 0.0) < std::accumulate(b.begin(), b.end(), 0.0);
  });
  std::vector<std::vector<double>> out;
  for (auto& row : rows)
    if (out.empty() || !near(out.back(), row)) out.push_back(std::move(row));
  const auto crossing =
      make_error(e_link_cross, "These correspondences cross: they are not in the same order on all sections.",
                 "Delete one of them.");
  for (std::size_t k = 0; k < skin.sections.size(); ++k)
    for (std::size_t a = 0; a < out.size(); ++a) {
      const double u = out[a][k];
      const double low = a > 0 ? out[a - 1][k] : plan.closed_sections ? out.back()[k] - 1 : 0.0;
      const double high = a + 1 < out.size()     ? out[a + 1][k]
                          : plan.closed_sections ? out.front()[k] + 1
                                                 : 1.0;
      if (!std::isfinite(u) || !(u > low && u < high)) return crossing;
    }
  return out;
}

namespace {

/// Cache key of the search for columns that all sections share; no section has this id.
constexpr std::uint32_t shared_columns = 0xffffffffU;

class SmoothBuilder {
 public:
  SmoothBuilder(const Skin& skin, const SkinPlan& plan, std::vector<std::vector<double>> anchors)
      : skin_(skin), plan_(plan), surface_(skin, plan, std::move(anchors)) {}

  Result<SkinMesh> build(const SkinWork& work) {
    int most = 0;
    for (const SkinSection& section : skin_.sections) most = std::max(most, section.size());
    const int sections = skin_.section_count();
    // Columns that shift between sections fit no section well, so there are more of them.
    const bool turning = columns_turn();
    columns_ = skin_.smooth.columns > 0 ? skin_.smooth.columns : most + (turning ? 6 : 2);
    const int strip_rows = turning ? 4 : 3;
    int rows = skin_.smooth.rows > 0 ? skin_.smooth.rows
                                     : std::max(skin_.path.size(), strip_rows * (sections - 1) + 1);
    const int anchors = int(surface_.anchor_places().size());
    if (rows < (skin_.path.closed ? std::max(3, sections) : std::max(2, sections)))
      return make_error(e_few_rows, "More rows than sections are needed.", "Raise the number of rows.");
    if (columns_ < (plan_.closed_sections ? std::max(3, anchors) : anchors + 2))
      return make_error(e_few_rows, "More columns than anchors are needed.", "Raise the number of columns.");
    if (std::size_t(columns_) > max_smooth_vertices / std::size_t(rows))
      return make_error(e_skin_size, "The skin has more than two million control points.",
                        "Lower its rows and columns.");
    make_rows(rows);
    make_columns(work);
    fit();
    add_faces();
    return std::move(out_);
  }

 private:
  int row_count() const { return int(v_.size()); }

  /// Point of a closed section nearest to its start: the search for columns begins there, because columns fit
  /// well relative to points.
  double point_start(std::size_t k) const {
    const int points = skin_.sections[k].size();
    return std::round(plan_.starts[k] * points) / points;
  }
  /// Whether columns shift along the sections from one section to the next, because their best places differ.
  bool columns_turn() const {
    if (skin_.smooth.parameters != ColumnParameters::per_section || !surface_.anchor_places().empty())
      return false;
    for (std::size_t k = 0; k < plan_.starts.size(); ++k)
      if (std::abs(point_start(k) - plan_.starts[k]) > 1e-9) return true;
    return false;
  }
  /// Weights of the sections for the places of columns. Columns that shift leave and meet sections without
  /// sideways motion.
  std::vector<double> column_weights(const std::vector<double>& blend, double v) const {
    if (!columns_turn()) return blend;
    std::vector<double> out(blend.size(), 0);
    for (const PlannedStrip& strip : plan_.strips) {
      const double x = v < strip.v0 ? v + 1 : v;
      if (x < strip.v0 || x > strip.v1) continue;
      const double t = (x - strip.v0) / (strip.v1 - strip.v0), gone = t * t * (3 - 2 * t);
      out[std::size_t(strip.a)] += 1 - gone;
      out[std::size_t(strip.b)] += gone;
      break;
    }
    return out;
  }

  void make_rows(int rows) {
    std::vector<double> breaks = places_of(skin_);
    if (skin_.path.closed) breaks.push_back(breaks[0] + 1);
    v_ = distributed(breaks, skin_.path.closed ? rows : rows - 1);
    if (skin_.path.closed) v_.pop_back();
  }

  /// Computes the parameters of each column on each section.
  void make_columns(const SkinWork& work) {
    const std::vector<double>& places = surface_.anchor_places();
    const bool optimised = places.empty() && skin_.smooth.parameters != ColumnParameters::uniform;
    ColumnCache nothing;
    ColumnCache& memory = work.columns ? *work.columns : nothing;
    const std::vector<double> uniform = uniform_parameters(columns_, plan_.closed_sections);
    std::vector<ColumnCache::Search> searches;
    for (std::size_t k = 0; k < skin_.sections.size(); ++k)
      if (const SkinSection& section = skin_.sections[k]; optimised && section.size() > 1)
        searches.push_back({section.id, {section.curve()}, {point_start(k)}});
    if (optimised && skin_.smooth.parameters == ColumnParameters::per_section) {
      auto found = memory.parameters(searches, columns_, work);
      std::size_t next = 0;
      for (const SkinSection& section : skin_.sections)
        out_.parameters.push_back(section.size() > 1 ? std::move(found[next++]) : uniform);
      for (std::size_t k = 0; k < out_.parameters.size(); ++k)
        for (double& u : out_.parameters[k]) u += point_start(k);
      section_parameters_ = out_.parameters;
      return;
    }
    for (std::size_t i = 1; i < searches.size(); ++i) {
      searches[0].curves.push_back(std::move(searches[i].curves[0]));
      searches[0].starts.push_back(plan_.starts[i]);
    }
    searches.resize(std::min<std::size_t>(searches.size(), 1));
    if (!searches.empty()) searches[0].key = shared_columns;
    std::vector<double> u = searches.empty() ? uniform : memory.parameters(searches, columns_, work)[0];
    if (!places.empty()) {
      std::vector<double> breaks = places;
      if (plan_.closed_sections) {
        breaks.push_back(breaks[0] + 1);
      } else {
        breaks.insert(breaks.begin(), 0.0);
        breaks.push_back(1);
      }
      u = distributed(breaks, plan_.closed_sections ? columns_ : columns_ - 1);
      if (plan_.closed_sections) u.pop_back();
    }
    out_.parameters.push_back(u);
    for (int k = 0; k < skin_.section_count(); ++k) {
      auto& own = section_parameters_.emplace_back();
      for (const double x : u) own.push_back(surface_.parameter(k, x));
    }
  }

  /// Flags of columns that run through a corner of every section.
  std::vector<char> creased_columns() const {
    std::vector<char> out(std::size_t(columns_), 0);
    if (!skin_.creases) return out;
    for (const auto& row : corner_rows(skin_, plan_))
      for (int c = 0; c < columns_; ++c) {
        bool all = true;
        for (std::size_t k = 0; k < row.size(); ++k) {
          const double gap = section_parameters_[k][std::size_t(c)] - plan_.starts[k] - row[k];
          all = all && std::abs(gap - (plan_.closed_sections ? std::round(gap) : 0)) < 1e-9;
        }
        if (all) out[std::size_t(c)] = 1;
      }
    return out;
  }

  /// Solves L1_v V L1_u^T = T for the control points V.
  void fit() {
    std::vector<Vector3>& points = out_.control.mesh.positions;
    const std::size_t n = std::size_t(columns_);
    for (const double v : v_) {
      const std::vector<double> weight = surface_.weights().at(v), places = column_weights(weight, v);
      for (std::size_t c = 0; c < n; ++c) {
        std::vector<double> u;
        if (skin_.smooth.parameters == ColumnParameters::per_section && surface_.anchor_places().empty()) {
          double mixed = 0;
          for (std::size_t k = 0; k < weight.size(); ++k)
            mixed += places[k] * (section_parameters_[k][c] - plan_.starts[k]);
          if (!plan_.closed_sections) mixed = std::clamp(mixed, 0.0, 1.0);
          for (std::size_t k = 0; k < weight.size(); ++k) u.push_back(mixed + plan_.starts[k]);
        } else {
          for (const auto& own : section_parameters_) u.push_back(own[c]);
        }
        points.push_back(surface_.point(u, v));
      }
    }
    std::vector<char> fixed_rows(v_.size(), 0), fixed_columns = creased_columns();
    if (!skin_.path.closed) fixed_rows.front() = fixed_rows.back() = 1;
    if (!plan_.closed_sections) fixed_columns.front() = fixed_columns.back() = 1;
    const LimitSystem along_rows(fixed_columns, plan_.closed_sections),
        along_columns(fixed_rows, skin_.path.closed);
    for (std::size_t r = 0; r < v_.size(); ++r) along_rows.solve(&points[r * n]);
    for (std::size_t c = 0; c < n; ++c) along_columns.solve(&points[c], n);
  }

  void add_faces() {
    const int rows = row_count(), n = columns_;
    const auto at = [&](int r, int c) { return Index((r % rows) * n + c % n); };
    out_.grid_rows = rows, out_.grid_columns = n;
    out_.grid_places = v_;
    PolygonMesh& mesh = out_.control.mesh;
    for (int r = 0; r < (skin_.path.closed ? rows : rows - 1); ++r)
      for (int c = 0; c < (plan_.closed_sections ? n : n - 1); ++c)
        mesh.add_face({at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)});
    out_.section_rows.resize(skin_.sections.size());
    for (int r = 0; r < rows; ++r) {
      int section = -1;
      for (int k = 0; k < skin_.section_count(); ++k)
        if (std::abs(v_[std::size_t(r)] - skin_.sections[std::size_t(k)].v) < 1e-12) section = k;
      for (int c = 0; c < n; ++c) {
        out_.vertices.push_back({section, -1, -1, c, r});
        if (section >= 0) out_.section_rows[std::size_t(section)].push_back(at(r, c));
      }
    }
    const std::vector<char> creased = creased_columns();
    for (int c = 0; c < n; ++c) {
      if (!creased[std::size_t(c)]) continue;
      for (int r = 0; r < (skin_.path.closed ? rows : rows - 1); ++r)
        out_.control.creases.push_back(
            {std::min(at(r, c), at(r + 1, c)), std::max(at(r, c), at(r + 1, c)), infinitely_sharp});
      if (skin_.path.closed) continue;
      out_.control.corners.push_back({at(0, c), infinitely_sharp});
      out_.control.corners.push_back({at(rows - 1, c), infinitely_sharp});
    }
    if (plan_.closed_sections) {
      const bool inside_out = tube_volume(mesh) < 0;
      add_caps(skin_, plan_, out_);
      if (inside_out) flip_faces(mesh);
    }
    if (skin_.flip_normals) flip_faces(mesh);
  }

  const Skin& skin_;
  const SkinPlan& plan_;
  VirtualSurface surface_;
  SkinMesh out_;
  int columns_ = 0;
  std::vector<double> v_;
  std::vector<std::vector<double>> section_parameters_;  ///< [section][column]
};

}  // namespace

Result<SkinMesh> smooth_mesh(const Skin& skin, const SkinPlan& plan, const SkinWork& work) {
  auto anchors = skin_anchors(skin, plan);
  if (!anchors) return anchors.error();
  return SmoothBuilder(skin, plan, *std::move(anchors)).build(work);
}

}  // namespace hariko
