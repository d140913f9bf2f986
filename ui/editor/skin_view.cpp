#include "ui/editor/skin_view.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "core/skinning/edit/stroke.hpp"

namespace hariko {

namespace {

std::vector<Vector3> sampled(const SubdivisionCurve& curve) {
  const int count = curve_samples * std::max(0, curve.spans());
  std::vector<Vector3> out;
  if (count == 0) return curve.points;
  for (int i = 0; i <= count; ++i) out.push_back(evaluate(curve, double(i) / count).position);
  return out;
}

void add_curves(const Skin& skin, SkinView& out) {
  out.path_closed = skin.path.closed;
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
    const bool slides = skin.path.closed || (k > 0 && k + 1 < skin.section_count());
    if (slides && skin.path.size() >= 2)
      out.handles.push_back(
          {SkinView::Handle::Kind::place, section.id, k, evaluate(skin.path, section.v).position, false});
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

/// Adds the irregularities of the mesh: what is not as in a regular grid.
void add_irregularities(const ControlMesh& control, const SubdivisionPatchSet& patches, const Vector3& origin,
                        SkinView& out) {
  const PolygonMesh& mesh = control.mesh;
  std::map<std::pair<Index, Index>, int> edges;
  std::vector<int> faces(mesh.positions.size(), 0);
  const auto limit = [&](Index v) { return Vector3(patches.limit_position(v) + origin); };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      ++faces[a], ++edges[{std::min(a, b), std::max(a, b)}];
    }
    if (face.size() == 3) out.triangles.push_back({limit(face[0]), limit(face[1]), limit(face[2])});
  }
  std::vector<char> border(mesh.positions.size(), 0);
  for (const auto& [edge, count] : edges)
    if (count == 1) border[edge.first] = border[edge.second] = 1;
  for (Index v = 0; v < Index(faces.size()); ++v)
    if (border[v] ? faces[v] > 2 : faces[v] > 0 && faces[v] != 4) out.extraordinary.push_back(limit(v));
}

/// By the skin that the surface was made from, which may no longer be the one that is edited.
void add_lines(const SkinResult& result, const SubdivisionPatchSet& patches, const Vector3& origin,
               SkinView& out) {
  const Skin& skin = result.skin;
  const bool pleat = skin.method == SkinMethod::pleat;
  const auto vertex = [&](Index v) { return Vector3(patches.limit_position(v) + origin); };
  for (std::size_t s = 0; s < result.plan.strips.size(); ++s) {
    const PlannedStrip& strip = result.plan.strips[s];
    const SkinSection &first = skin.sections[std::size_t(strip.a)],
                      &second = skin.sections[std::size_t(strip.b)];
    for (std::size_t p = 0; p < strip.lines.size(); ++p) {
      // Lines that only a pleat has; the anchored method knows links.
      if (!pleat && strip.origins[p] == LineOrigin::matched) continue;
      const PointPair pair = strip.lines[p];
      SkinView::Line line;
      line.first = first.id, line.second = second.id;
      line.a = first.points[std::size_t(pair.a)].id, line.b = second.points[std::size_t(pair.b)].id;
      line.origin = strip.origins[p];
      line.begin = strip.v0, line.end = strip.v1;
      name_entry(skin, strip, pair, line);
      if (pleat) {
        const auto& rows = result.mesh.rows[s];
        for (std::size_t q = 0; q < rows.size(); ++q) {
          line.points.push_back(vertex(result.mesh.representative[s][q][p]));
          line.along.push_back((rows[q] - rows.front()) / (rows.back() - rows.front()));
        }
      } else {
        line.points = {limit_points(first.curve())[std::size_t(pair.a)] + origin,
                       limit_points(second.curve())[std::size_t(pair.b)] + origin};
        line.along = {0, 1};
      }
      out.lines.push_back(std::move(line));
    }
    if (!pleat) continue;
    // Planned merges of a strip stand in the order of the skin's.
    const auto& places = result.mesh.merge_vertices[s];
    std::size_t next = 0;
    for (const SkinMerge& merge : skin.merges)
      if (merge.first == first.id && merge.second == second.id && next < places.size())
        out.diamonds.push_back({merge.id, first.id, vertex(places[next++])});
  }
}

void add_columns(const SkinMesh& mesh, const SubdivisionPatchSet& patches, const Vector3& origin,
                 SkinView& out) {
  for (int c = 0; c < mesh.grid_columns; ++c) {
    SkinView::Column column;
    column.places = mesh.grid_places;
    for (int r = 0; r < mesh.grid_rows; ++r)
      column.points.push_back(patches.limit_position(Index(r * mesh.grid_columns + c)) + origin);
    if (out.path_closed) {
      column.points.push_back(column.points.front());
      column.places.push_back(column.places.front() + 1);
    }
    out.columns.push_back(std::move(column));
  }
}

/// The point of a polyline at a value that ascends along it; nothing outside.
std::optional<Vector3> at_value(const std::vector<Vector3>& points, const std::vector<double>& values,
                                double value) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (value < values[i] || value > values[i + 1]) continue;
    const double t = (value - values[i]) / std::max(values[i + 1] - values[i], 1e-300);
    return points[i] + t * (points[i + 1] - points[i]);
  }
  return {};
}

}  // namespace

std::optional<Vector3> skin_point(const Skin& skin, std::uint32_t id) {
  if (!is_path_point(id)) {
    for (const SkinSection& section : skin.sections)
      if (const int i = find_point(section, id); i >= 0) return section.points[std::size_t(i)].position;
    return std::nullopt;
  }
  const bool rail = id >= rail_point_ids;
  if (rail && !skin.second_rail) return std::nullopt;
  const SubdivisionCurve& curve = rail ? *skin.second_rail : skin.path;
  const std::size_t index = id - (rail ? rail_point_ids : path_point_ids);
  return index < curve.points.size() ? std::optional(curve.points[index]) : std::nullopt;
}

std::optional<Vector2> pixel_of(const Object& object, const Projector& projector, const Vector3& point) {
  const auto at = projector.project(object.transform.apply(point));
  return at ? std::optional<Vector2>(at->head<2>()) : std::nullopt;
}

SkinView view_of(const Skin& skin, const Surface* surface) {
  SkinView out;
  add_curves(skin, out);
  const SubdivisionPatchSet* patches = surface ? subdivision_patches(*surface) : nullptr;
  if (!patches || !patches->skin()) return out;
  const SkinResult& result = *patches->skin();
  add_irregularities(result.mesh.control, *patches, surface->origin(), out);
  if (skin.method != SkinMethod::smooth) add_lines(result, *patches, surface->origin(), out);
  if (result.skin.method != SkinMethod::pleat) add_columns(result.mesh, *patches, surface->origin(), out);
  return out;
}

const SkinView& SkinViewCache::of(const Editor& editor, const Object& object) {
  const Shared<Skin>& skin = object.skin()->skin;
  const Surface* found = shown_surface(editor, object);
  const Surface surface = found ? *found : Surface();
  const bool same_surface =
      (surface.patch_count() == 0 && surface_.patch_count() == 0) ||
      (surface.patch_count() > 0 && surface_.patch_count() > 0 && &surface.patches() == &surface_.patches());
  if (!skin_ || skin_->get() != skin.get() || !same_surface) {
    view_ = view_of(*skin, found);
    skin_ = skin;
    surface_ = surface;
  }
  return view_;
}

const Surface* shown_surface(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  return view && view->surface.patch_count() > 0 ? &view->surface : nullptr;
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
    double distance = (*at - pixel).norm();
    // Points of the curve are what the designer looks at; places lie round points of the path.
    if (view.handles[i].kind == SkinView::Handle::Kind::place)
      distance = distance <= 11 * pixel_scale ? 7 * pixel_scale : 2 * least;
    else if (view.handles[i].kind != SkinView::Handle::Kind::limit)
      distance += 2 * pixel_scale;
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
                                    const Vector2& pixel, const std::vector<std::uint32_t>& strips) {
  std::optional<LineHit> best;
  for (std::size_t l = 0; l < view.lines.size(); ++l) {
    const SkinView::Line& line = view.lines[l];
    if (!strips.empty() && std::find(strips.begin(), strips.end(), line.first) == strips.end()) continue;
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

std::vector<std::size_t> connected_lines(const SkinView& view, std::size_t line) {
  std::vector<std::size_t> out{line};
  // From both ends outwards, so that lines which only share a point with one passed do not count.
  for (const bool onward : {true, false}) {
    std::vector<std::size_t> front{line};
    while (!front.empty()) {
      std::vector<std::size_t> next;
      for (std::size_t l = 0; l < view.lines.size(); ++l) {
        const bool joins = std::ranges::any_of(front, [&](std::size_t f) {
          const SkinView::Line &one = view.lines[f], &other = view.lines[l];
          return onward ? one.second == other.first && one.b == other.a
                        : other.second == one.first && other.b == one.a;
        });
        if (joins && std::find(out.begin(), out.end(), l) == out.end()) next.push_back(l), out.push_back(l);
      }
      front = std::move(next);
    }
  }
  return out;
}

std::optional<double> path_place(const SkinView& view, const Object& object, const Projector& projector,
                                 const Vector2& pixel) {
  if (view.paths.empty() || view.paths[0].size() < 2) return {};
  const std::vector<Vector3>& path = view.paths[0];
  std::optional<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto a = pixel_of(object, projector, path[i]), b = pixel_of(object, projector, path[i + 1]);
    if (!a || !b) continue;
    const SegmentFoot foot = foot_on_segment(*a, *b, pixel);
    if (foot.distance >= least) continue;
    least = foot.distance;
    best = (double(i) + foot.along) / double(path.size() - 1);
  }
  return best;
}

std::vector<Vector3> section_sketch(const SkinView& view, double place) {
  std::vector<Vector3> out;
  const auto add = [&](const auto& points, const auto& values, double value) {
    if (const auto at = at_value(points, values, value)) out.push_back(*at);
  };
  for (const SkinView::Column& column : view.columns)
    add(column.points, column.places, place < column.places.front() ? place + 1 : place);
  for (const SkinView::Line& line : view.lines) {
    const double v = place < line.begin ? place + 1 : place;
    if (view.columns.empty() && v <= line.end)
      add(line.points, line.along, (v - line.begin) / (line.end - line.begin));
  }
  const bool closed = !view.sections.empty() && view.sections.front().closed;
  if (closed && !out.empty()) out.push_back(Vector3(out.front()));
  return out;
}

}  // namespace hariko
