#include "core/skinning/columns/pleat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/skinning/columns/pleat_rows.hpp"
#include "core/skinning/columns/quad_fans.hpp"
#include "core/skinning/columns/skin_caps.hpp"
#include "core/skinning/sections/section_fit.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_vertices = 2'000'000;

std::pair<Index, Index> edge_key(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

class PleatBuilder {
 public:
  PleatBuilder(const Skin& skin, const SkinPlan& plan) : skin_(skin), plan_(plan) {}

  Result<SkinMesh> build() {
    std::size_t total = 0;
    for (int s = 0; s < int(plan_.strips.size()); ++s) {
      rows_.push_back(strip_rows(skin_, plan_, s));
      total += rows_.back().v.size() * plan_.strips[std::size_t(s)].lines.size();
    }
    if (total > max_vertices)
      return make_error(e_skin_size, "The skin has more than two million control points.",
                        "Lower the density of its rows.");
    make_base_points();
    add_section_vertices();
    for (int s = 0; s < int(plan_.strips.size()); ++s) add_strip_vertices(s);
    add_creases();
    for (int s = 0; s < int(plan_.strips.size()); ++s) add_strip_faces(s);
    add_corners();
    find_inexact();
    fit();
    if (plan_.closed_sections) {
      const bool inside_out = tube_volume(mesh()) < 0;
      add_caps(skin_, plan_, out_);
      if (inside_out) flip_faces(mesh());
    }
    if (skin_.flip_normals) flip_faces(mesh());
    return std::move(out_);
  }

 private:
  PolygonMesh& mesh() { return out_.control.mesh; }
  Vector3 section_point(int k, int i) const {
    return skin_.sections[std::size_t(k)].points[std::size_t(i)].position;
  }
  bool interior(int section) const {
    return skin_.path.closed || (section > 0 && section < skin_.section_count() - 1);
  }

  /// Solves L1 B = C(v) over all rows, so that the limits of the rows' base points lie on the path.
  void make_base_points() {
    std::vector<Vector3> path, rail;
    const bool rails = plan_.frames.mode() == FrameMode::two_rail;
    for (const StripRows& rows : rows_) {
      first_row_.push_back(int(path.size()));
      for (int q = 0; q < rows.last(); ++q) add_base(path, rail, rows.v[std::size_t(q)]);
    }
    if (!skin_.path.closed) add_base(path, rail, rows_.back().v.back());
    if (path.size() < 3 && skin_.path.closed) {
      base_ = path, rail_base_ = rail;  // too few rows for a closed curve: unchanged
      return;
    }
    base_ = curve_through(std::move(path), skin_.path.closed).points;
    if (rails) rail_base_ = curve_through(std::move(rail), skin_.path.closed).points;
  }
  void add_base(std::vector<Vector3>& path, std::vector<Vector3>& rail, double v) const {
    path.push_back(plan_.frames.position(v));
    if (plan_.frames.mode() == FrameMode::two_rail) rail.push_back(plan_.frames.rail(v));
  }
  std::size_t row_index(int strip, int q) const {
    return std::size_t(first_row_[std::size_t(strip)] + q) % base_.size();
  }
  Matrix3 frame(std::size_t row, double v) const {
    return plan_.frames.mode() == FrameMode::two_rail ? SkinFrames::rail_frame(base_[row], rail_base_[row])
                                                      : plan_.frames.frame(v);
  }

  Index add_vertex(const Vector3& position, const SkinVertex& meaning) {
    mesh().positions.push_back(position);
    out_.vertices.push_back(meaning);
    bows_.push_back(Vector3::Zero());
    end_bows_.push_back(Vector3::Zero());
    return Index(mesh().positions.size() - 1);
  }

  void add_section_vertices() {
    for (int k = 0; k < skin_.section_count(); ++k) {
      const SkinSection& section = skin_.sections[std::size_t(k)];
      Vector3 shift = Vector3::Zero();
      if (interior(k)) shift = base_[row_index(k, 0)] - plan_.frames.position(section.v);
      auto& row = out_.section_rows.emplace_back();
      const bool rails = interior(k) && plan_.frames.mode() == FrameMode::two_rail;
      for (int i = 0; i < section.size(); ++i) {
        Vector3 at = section_point(k, i) + shift;
        // Between rails the base and the axes are those of the rails' control points.
        if (rails)
          at = base_[row_index(k, 0)] +
               frame(row_index(k, 0), section.v) * plan_.offsets[std::size_t(k)][std::size_t(i)];
        row.push_back(add_vertex(at, {k, i, -1, -1, -1}));
      }
    }
  }

  void add_strip_vertices(int s) {
    const PlannedStrip& strip = plan_.strips[std::size_t(s)];
    const StripRows& rows = rows_[std::size_t(s)];
    const auto bows = line_bows(plan_, strip, rows);
    const int lines = int(strip.lines.size());
    auto& grid = out_.representative.emplace_back(rows.v.size(), std::vector<Index>(std::size_t(lines)));
    for (int p = 0; p < lines; ++p) {
      grid.front()[std::size_t(p)] =
          out_.section_rows[std::size_t(strip.a)][std::size_t(strip.lines[std::size_t(p)].a)];
      grid.back()[std::size_t(p)] =
          out_.section_rows[std::size_t(strip.b)][std::size_t(strip.lines[std::size_t(p)].b)];
    }
    for (int q = 1; q < rows.last(); ++q) {
      const std::size_t base = row_index(s, q);
      const Matrix3 axes = frame(base, rows.v[std::size_t(q)]);
      std::map<int, Index> shared;
      for (int p = 0; p < lines; ++p) {
        const int group = rows.shared(p, q);
        const auto known = group < 0 ? shared.end() : shared.find(group);
        if (known != shared.end()) {
          grid[std::size_t(q)][std::size_t(p)] = known->second;
          continue;
        }
        Vector3 at = line_offset(plan_, strip, rows, p, q);
        if (!bows.empty()) at += bows[std::size_t(p)].rows[std::size_t(q)];
        const Index v = add_vertex(base_[base] + axes * at, {-1, -1, s, p, q});
        if (!bows.empty()) {
          const LineBow& bow = bows[std::size_t(p)];
          bows_.back() = axes * bow.rows[std::size_t(q)];
          if (q == 1) end_bows_.back() = axes * bow.first;
          if (q == rows.last() - 1) end_bows_.back() = axes * bow.last;
        }
        grid[std::size_t(q)][std::size_t(p)] = v;
        if (group >= 0) shared[group] = v;
      }
    }
    auto& merged = out_.merge_vertices.emplace_back();
    for (std::size_t g = 0; g < strip.merges.size(); ++g) {
      const LineGroup& group = rows.groups[g];
      merged.push_back(grid[std::size_t(group.row)][std::size_t(group.lines[0])]);
    }
    out_.rows.push_back(rows.v);
  }

  /// Adds the faces of the paper's grid rep(p, q), with repeated vertices dropped.
  void add_strip_faces(int s) {
    const auto& grid = out_.representative[std::size_t(s)];
    const std::size_t lines = grid[0].size();
    const std::size_t steps = plan_.closed_sections ? lines : lines - 1;
    for (std::size_t q = 0; q + 1 < grid.size(); ++q) {
      TriangleFan fan;
      for (std::size_t p = 0; p < steps; ++p) {
        const std::size_t next = (p + 1) % lines;
        const Index a = grid[q][p], b = grid[q + 1][p], c = grid[q + 1][next], d = grid[q][next];
        if (a == d && b == c) continue;
        if (a != d && b != c) {
          add_fan(fan);
          mesh().add_face({a, b, c, d});
          continue;
        }
        const bool first = a == d;
        if (fan.apex != (first ? a : b) || fan.apex_on_first_row != first) {
          add_fan(fan);
          fan = {first ? a : b, {first ? b : a}, first};
        }
        fan.outer.push_back(first ? c : d);
      }
      add_fan(fan);
    }
  }
  /// Adds the faces of a fan and empties it.
  void add_fan(TriangleFan& fan) {
    if (fan.outer.empty()) return;
    const auto may_go = [&](Index mid) {
      return skin_.pleat.quad_fans && out_.vertices[mid].section < 0 &&
             !creased_.contains(edge_key(mid, fan.apex));
    };
    for (const auto& face : fan_faces(fan, may_go, [&](Index v) { return parameter_of(v); }))
      mesh().add_face(face);
    fan = {};
  }
  /// Parameter of a vertex along its row, to tell the middle of a section from its ends.
  double parameter_of(Index v) const {
    const SkinVertex& meaning = out_.vertices[v];
    if (meaning.section >= 0)
      return skin_.sections[std::size_t(meaning.section)].curve().parameter(meaning.point);
    const PlannedStrip& strip = plan_.strips[std::size_t(meaning.strip)];
    const PointPair& line = strip.lines[std::size_t(meaning.line)];
    return 0.5 * (skin_.sections[std::size_t(strip.a)].curve().parameter(line.a) +
                  skin_.sections[std::size_t(strip.b)].curve().parameter(line.b));
  }

  /// Adds creases: a corner of both sections makes one along the whole line; a corner of one section makes
  /// one that fades.
  void add_creases() {
    if (!skin_.creases) return;
    std::map<std::pair<Index, Index>, double> sharpness;
    for (std::size_t s = 0; s < plan_.strips.size(); ++s) {
      const PlannedStrip& strip = plan_.strips[s];
      const auto& grid = out_.representative[s];
      const int edges = int(grid.size()) - 1;
      for (std::size_t p = 0; p < strip.lines.size(); ++p) {
        const bool a = skin_.sections[std::size_t(strip.a)].points[std::size_t(strip.lines[p].a)].sharp;
        const bool b = skin_.sections[std::size_t(strip.b)].points[std::size_t(strip.lines[p].b)].sharp;
        if (!a && !b) continue;
        for (int q = 0; q < edges; ++q) {
          const int from = a ? q : edges - 1 - q;  // counted from the section with the corner
          double weight = infinitely_sharp;
          if (!(a && b)) {
            weight = from < edges - 1 ? std::floor(3 * (1 - double(from) / (edges - 1)) + 0.5) : 0;
            if (from == 0 && edges > 1 && interior(a ? strip.a : strip.b)) weight = infinitely_sharp;
          }
          double& slot = sharpness[edge_key(grid[std::size_t(q)][p], grid[std::size_t(q) + 1][p])];
          slot = std::max(slot, weight);
        }
      }
    }
    for (const auto& [edge, weight] : sharpness)
      if (weight > 0) {
        out_.control.creases.push_back({edge.first, edge.second, weight});
        creased_.insert(edge);
      }
  }

  void add_corners() {
    if (skin_.path.closed) return;
    std::set<Index> corners;
    for (const int k : {0, skin_.section_count() - 1}) {
      const SkinSection& section = skin_.sections[std::size_t(k)];
      const auto& row = out_.section_rows[std::size_t(k)];
      if (!plan_.closed_sections) corners.insert({row.front(), row.back()});
      for (std::size_t i = 0; i < row.size(); ++i)
        if (section.points[i].sharp && skin_.creases) corners.insert(row[i]);
    }
    for (const Index v : corners) out_.control.corners.push_back({v, infinitely_sharp});
  }

  /// Finds the points of interior sections whose vertices are not regular.
  void find_inexact() {
    struct Ring {
      int faces = 0, edges = 0;
      bool quads = true;
    };
    std::vector<Ring> ring(mesh().positions.size());
    std::set<std::pair<Index, Index>> edges;
    for (std::size_t f = 0; f < mesh().face_count(); ++f) {
      const auto face = mesh().face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        ++ring[face[i]].faces;
        ring[face[i]].quads = ring[face[i]].quads && face.size() == 4;
        edges.insert(edge_key(face[i], face[(i + 1) % face.size()]));
      }
    }
    for (const auto& [a, b] : edges) ++ring[a].edges, ++ring[b].edges;
    regular_.resize(ring.size());
    for (std::size_t v = 0; v < ring.size(); ++v)
      regular_[v] = ring[v].quads && ((ring[v].edges == 4 && ring[v].faces == 4) ||
                                      (ring[v].edges == 3 && ring[v].faces == 2));
    for (int k = 0; k < skin_.section_count(); ++k) {
      const auto& row = out_.section_rows[std::size_t(k)];
      for (std::size_t i = 0; i < row.size(); ++i) {
        const bool missed =
            interior(k) ? skin_.pleat.fit == SectionFit::none || !regular_[row[i]] || !neighbours(k, int(i))
                        : inside_surface(skin_, plan_, k) && !regular_[row[i]];
        if (missed) out_.inexact.emplace_back(k, int(i));
      }
    }
  }
  /// Vertices before and after a section's point, where both exist and neither belongs to another section.
  std::optional<std::pair<Index, Index>> neighbours(int k, int i) const {
    const int strips = int(plan_.strips.size());
    const auto beside = [&](int s, bool at_a) -> Index {
      const auto& grid = out_.representative[std::size_t(s)];
      const auto& own = at_a ? grid.front() : grid.back();
      const auto& next = at_a ? grid[1] : grid[grid.size() - 2];
      Index found = no_index;
      for (std::size_t p = 0; p < own.size(); ++p) {
        if (own[p] != out_.section_rows[std::size_t(k)][std::size_t(i)]) continue;
        if (found != no_index && found != next[p]) return no_index;
        found = next[p];
      }
      return found;
    };
    const Index before = beside((k - 1 + strips) % strips, false), after = beside(k, true);
    if (before == no_index || after == no_index) return {};
    const auto is_solved = [&](Index v) {
      return out_.vertices[v].section >= 0 && interior(out_.vertices[v].section);
    };
    if (is_solved(before) || is_solved(after)) return {};
    return std::pair{before, after};
  }

  void fit() {
    if (skin_.pleat.fit == SectionFit::none) return;
    std::vector<SectionEquation> equations;
    std::vector<char> held(mesh().positions.size(), 0);
    const std::set<std::pair<int, int>> inexact(out_.inexact.begin(), out_.inexact.end());
    for (int k = 0; k < skin_.section_count(); ++k) {
      const auto& row = out_.section_rows[std::size_t(k)];
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (!interior(k)) {
          held[row[i]] = 1;
        } else if (!inexact.contains({k, int(i)})) {
          const auto [before, after] = *neighbours(k, int(i));
          equations.push_back({row[i], before, after, section_point(k, int(i))});
        }
      }
    }
    if (skin_.pleat.fit == SectionFit::local) {
      fit_sections_locally(mesh().positions, equations);
      return;
    }
    // Side vertices stay on the rails, up to the offset of the ends of sections from these (limited by
    // E_RAIL).
    if (plan_.frames.mode() == FrameMode::two_rail)
      for (const auto& grid : out_.representative)
        for (const auto& row : grid) held[row.front()] = held[row.back()] = 1;
    fit_sections_fairly(mesh().positions, equations, bends(), held, skin_.pleat.tension);
  }

  std::vector<LineBend> bends() const {
    struct Sides {
      std::set<Index> before, after;
      double h1 = 0, h2 = 0;
    };
    double mean = 0;
    for (const PlannedStrip& strip : plan_.strips)
      mean += (strip.v1 - strip.v0) / double(plan_.strips.size());
    std::vector<Sides> sides(out_.control.mesh.positions.size());
    for (std::size_t s = 0; s < plan_.strips.size(); ++s) {
      const auto& grid = out_.representative[s];
      for (std::size_t q = 0; q + 1 < grid.size(); ++q) {
        const double h = (rows_[s].v[q + 1] - rows_[s].v[q]) / mean;
        for (std::size_t p = 0; p < grid[q].size(); ++p) {
          sides[grid[q][p]].after.insert(grid[q + 1][p]);
          sides[grid[q][p]].h2 = h;
          sides[grid[q + 1][p]].before.insert(grid[q][p]);
          sides[grid[q + 1][p]].h1 = h;
        }
      }
    }
    std::vector<LineBend> out;
    for (std::size_t v = 0; v < sides.size(); ++v)
      if (!sides[v].before.empty() && !sides[v].after.empty()) {
        out.push_back({Index(v),
                       {sides[v].before.begin(), sides[v].before.end()},
                       {sides[v].after.begin(), sides[v].after.end()},
                       sides[v].h1,
                       sides[v].h2});
        // The target is the difference of straight lines from section to section.
        out.back().own = second_difference(out.back(), out_.vertices[v].section < 0 ? bows_ : end_bows_);
      }
    return out;
  }

  const Skin& skin_;
  const SkinPlan& plan_;
  SkinMesh out_;
  std::vector<StripRows> rows_;
  std::vector<int> first_row_;
  std::vector<Vector3> base_, rail_base_;
  std::vector<Vector3> bows_, end_bows_;  ///< per vertex: displacement of twisted lines (LineBow)
  std::set<std::pair<Index, Index>> creased_;
  std::vector<char> regular_;
};

}  // namespace

Result<SkinMesh> pleat_mesh(const Skin& skin, const SkinPlan& plan) {
  return PleatBuilder(skin, plan).build();
}

}  // namespace hariko
