#include "ui/skin_view.hpp"

#include <algorithm>
#include <limits>

#include "core/skinning/stroke.hpp"

namespace hariko {

namespace {

std::vector<Vector3> sampled(const SubdivisionCurve& curve) {
  constexpr int per_span = 12;
  const int count = per_span * std::max(0, curve.spans());
  std::vector<Vector3> out;
  if (count == 0) return curve.points;
  for (int i = 0; i <= count; ++i) out.push_back(evaluate(curve, double(i) / count).position);
  return out;
}

void add_curves(const Skin& skin, SkinView& out) {
  const auto add_path = [&](const SubdivisionCurve& path, std::uint32_t ids) {
    out.paths.push_back(path.size() >= 2 ? sampled(path) : path.points);
    for (int i = 0; i < path.size(); ++i)
      out.handles.push_back({SkinView::Handle::Kind::path, ids + std::uint32_t(i), -1,
                             path.points[std::size_t(i)], path.is_sharp(i)});
  };
  add_path(skin.path, path_point_ids);
  if (skin.second_rail) add_path(*skin.second_rail, rail_point_ids);
  for (int k = 0; k < skin.section_count(); ++k) {
    const SkinSection& section = skin.sections[std::size_t(k)];
    const SubdivisionCurve curve = section.curve();
    if (curve.points.empty()) continue;
    out.sections.push_back({section.id, curve.closed, sampled(curve), curve.points});
    const std::vector<Vector3> limits = limit_points(curve);
    for (int i = 0; i < curve.size(); ++i) {
      const SectionPoint& p = section.points[std::size_t(i)];
      out.handles.push_back({SkinView::Handle::Kind::control, p.id, k, p.position, p.sharp});
      if (!curve.is_fixed(i))
        out.handles.push_back({SkinView::Handle::Kind::limit, p.id, k, limits[std::size_t(i)], p.sharp});
    }
  }
}

/// The link or merge that a line belongs to.
void name_entry(const Skin& skin, const PlannedStrip& strip, const PointPair& pair, SkinView::Line& line) {
  const std::uint32_t first = skin.sections[std::size_t(strip.a)].id,
                      second = skin.sections[std::size_t(strip.b)].id;
  const auto look = [&](const auto& entries) {
    for (const auto& entry : entries) {
      if (entry.first != first || entry.second != second) continue;
      const auto pairs = forced_pairs(skin, entry);
      if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) continue;
      line.entry = entry.id;
      line.locked = entry.locked;
    }
  };
  look(skin.links);
  if (skin.method == SkinMethod::pleat) look(skin.merges);
}

void add_lines(const Skin& skin, const SkinResult& result, const Surface* surface, SkinView& out) {
  const SkinPlan& plan = result.plan;
  const bool pleat = skin.method == SkinMethod::pleat;
  const SubdivisionPatchSet* patches = surface ? subdivision_patches(*surface) : nullptr;
  const auto vertex = [&](Index v) {
    return patches ? patches->limit_position(v) : result.mesh.control.mesh.positions[v];
  };
  for (std::size_t s = 0; s < plan.strips.size(); ++s) {
    const PlannedStrip& strip = plan.strips[s];
    for (std::size_t p = 0; p < strip.lines.size(); ++p) {
      // Lines that only a pleat has; the anchored method knows links.
      if (!pleat && strip.origins[p] == LineOrigin::matched) continue;
      const PointPair pair = strip.lines[p];
      SkinView::Line line;
      line.strip = int(s);
      line.a = skin.sections[std::size_t(strip.a)].points[std::size_t(pair.a)].id;
      line.b = skin.sections[std::size_t(strip.b)].points[std::size_t(pair.b)].id;
      line.origin = strip.origins[p];
      name_entry(skin, strip, pair, line);
      if (pleat) {
        const auto& rows = result.mesh.rows[s];
        for (std::size_t q = 0; q < rows.size(); ++q) {
          line.points.push_back(vertex(result.mesh.representative[s][q][p]));
          line.along.push_back((rows[q] - rows.front()) / (rows.back() - rows.front()));
        }
      } else {
        for (const auto& [section, point] : {std::pair(strip.a, pair.a), std::pair(strip.b, pair.b)})
          line.points.push_back(
              limit_points(skin.sections[std::size_t(section)].curve())[std::size_t(point)]);
        line.along = {0, 1};
      }
      out.lines.push_back(std::move(line));
    }
    if (!pleat) continue;
    // Planned merges of a strip stand in the order of the skin's.
    const auto& places = result.mesh.merge_vertices[s];
    std::size_t next = 0;
    for (const SkinMerge& merge : skin.merges)
      if (merge.first == skin.sections[std::size_t(strip.a)].id &&
          merge.second == skin.sections[std::size_t(strip.b)].id && next < places.size())
        out.diamonds.push_back({merge.id, int(s), vertex(places[next++])});
  }
}

std::optional<Vector2> pixel_of(const Object& object, const Projector& projector, const Vector3& point) {
  const auto at = projector.project(object.transform.apply(point));
  return at ? std::optional<Vector2>(at->head<2>()) : std::nullopt;
}

}  // namespace

SkinView view_of(const Skin& skin, SkinSurfacer& surfacer) {
  SkinView out;
  add_curves(skin, out);
  const auto made = surfacer.surface(skin, Vector3::Zero());
  if (!made) return out;
  const SkinMesh& mesh = made->result.mesh;
  out.vertices = int(mesh.control.mesh.positions.size());
  out.rows = mesh.grid_rows, out.columns = mesh.grid_columns;
  for (const auto& rows : mesh.rows) out.rows += int(rows.size()) - 1;
  if (!mesh.rows.empty() && !skin.path.closed) ++out.rows;
  if (skin.method != SkinMethod::smooth) add_lines(skin, made->result, &made->surface, out);
  return out;
}

const SkinView& SkinViewCache::of(const Shared<Skin>& skin) {
  if (!skin_ || skin_->get() != skin.get()) {
    view_ = view_of(*skin, surfacer_);
    skin_ = skin;
  }
  return view_;
}

const Object* shown_skin(const Editor& editor) {
  const Object* object = editor.active_object();
  if (!object || !object->visible || !object->skin()) return nullptr;
  if (editor.paper.shown && editor.paper.in_space) return nullptr;
  return object;
}

SkinHit skin_hit(const SkinView& view, const Object& object, const Projector& projector, const Vector2& pixel,
                 double pixel_scale) {
  SkinHit best;
  double least = 14 * pixel_scale;
  for (std::size_t i = 0; i < view.handles.size(); ++i) {
    const auto at = pixel_of(object, projector, view.handles[i].position);
    if (!at) continue;
    // Points of the curve are what the designer looks at.
    const double distance =
        (*at - pixel).norm() + (view.handles[i].kind == SkinView::Handle::Kind::limit ? 0 : 2 * pixel_scale);
    if (distance < least) least = distance, best = {SkinHit::Kind::handle, i};
  }
  for (std::size_t i = 0; i < view.diamonds.size(); ++i) {
    const auto at = pixel_of(object, projector, view.diamonds[i].position);
    const double distance = at ? (*at - pixel).norm() : std::numeric_limits<double>::infinity();
    if (distance < std::min(least, 10 * pixel_scale)) least = distance, best = {SkinHit::Kind::diamond, i};
  }
  return best;
}

std::optional<LineHit> nearest_line(const SkinView& view, const Object& object, const Projector& projector,
                                    const Vector2& pixel, const std::vector<int>& strips) {
  std::optional<LineHit> best;
  for (std::size_t l = 0; l < view.lines.size(); ++l) {
    const SkinView::Line& line = view.lines[l];
    if (!strips.empty() && std::find(strips.begin(), strips.end(), line.strip) == strips.end()) continue;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const auto a = pixel_of(object, projector, line.points[i]),
                 b = pixel_of(object, projector, line.points[i + 1]);
      if (!a || !b) continue;
      const SegmentFoot foot = foot_on_segment(*a, *b, pixel);
      if (best && foot.distance >= best->distance) continue;
      best = LineHit{l, line.along[i] + foot.along * (line.along[i + 1] - line.along[i]), foot.distance};
    }
  }
  return best;
}

}  // namespace hariko
