#include "core/skinning/edit/edit_path.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/rotation.hpp"
#include "core/skinning/edit/skin_edit.hpp"
#include "core/skinning/sections/skin_frames.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

using namespace detail;

namespace {

bool usable(const SubdivisionCurve& path) {
  return path.size() >= (path.closed ? 3 : 2) &&
         std::all_of(path.points.begin(), path.points.end(), [](const Vector3& p) { return p.allFinite(); });
}

/// Moves points from places of one path to places of another. Where a path has no frames (a cusp) they are
/// translated without rotation.
class Carrier {
 public:
  Carrier(const Skin& from, const Skin& to) : from_path_(from.path), to_path_(to.path) {
    if (!usable(from.path) || !usable(to.path)) return;
    if (auto frames = SkinFrames::make(from)) from_ = *std::move(frames);
    if (!from_ || from_->mode() == FrameMode::translate) return;
    // The frame mode stays the same even if the path becomes straight or no longer is.
    Skin next = to;
    next.frame = from_->mode();
    if (auto frames = SkinFrames::make(next)) to_ = *std::move(frames);
    if (!to_ || from_->mode() != FrameMode::rotation_minimising || from_path_ == to_path_) return;
    // The first frame of a path is arbitrary; here it is the old one rotated as little as possible.
    const Matrix3 old = from_->frame(0), now = to_->frame(0);
    const Eigen::Quaterniond least = least_rotation(old.col(2), now.col(2));
    const Vector3 wanted = least * Vector3(old.col(0));
    turn_ = Eigen::AngleAxisd(std::atan2(wanted.dot(now.col(1)), wanted.dot(now.col(0))), Vector3::UnitZ())
                .toRotationMatrix();
  }

  void carry(SkinSection& section, double from, double to) const {
    // The reference point stays on the path; if it lay beside the path, it is moved onto it now.
    const Vector3 old = section.reference.value_or(position(from_path_, from)), now = position(to_path_, to);
    Matrix3 turn = Matrix3::Identity();
    if (from_ && to_) turn = to_->frame(to) * turn_ * from_->frame(from).inverse();
    if (!turn.allFinite()) turn = Matrix3::Identity();
    for (SectionPoint& p : section.points) p.position = now + turn * (p.position - old);
    if (section.reference) section.reference = now;
  }

 private:
  static Vector3 position(const SubdivisionCurve& path, double v) {
    return path.points.empty() ? Vector3(Vector3::Zero()) : evaluate(path, v).position;
  }
  const SubdivisionCurve &from_path_, &to_path_;
  std::optional<SkinFrames> from_, to_;
  Matrix3 turn_ = Matrix3::Identity();
};

bool has_rails(const Skin& skin) {
  return skin.second_rail.has_value() &&
         (skin.frame == FrameMode::two_rail || skin.frame == FrameMode::automatic);
}

Message uneven_rails() {
  return make_error(e_rail, "The rails have different numbers of points.",
                    "Give both the same number of points first.");
}

/// Restores the order of sections on a closed path after the first one passed the seam.
void rotate_order(Skin& skin) {
  const auto first = std::min_element(skin.sections.begin(), skin.sections.end(),
                                      [](const SkinSection& a, const SkinSection& b) { return a.v < b.v; });
  const auto steps = first - skin.sections.begin();
  for (auto& row : skin.smooth.anchors)
    if (row.size() == skin.sections.size()) std::rotate(row.begin(), row.begin() + steps, row.end());
  std::rotate(skin.sections.begin(), first, skin.sections.end());
}

}  // namespace

Result<SkinEdit> slide_section(const Skin& skin, std::uint32_t id, double v) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  Carrier(skin, skin).carry(section, section.v, v);
  section.v = v;
  if (skin.path.closed && std::isfinite(v)) {
    section.v = v - std::floor(v);
    rotate_order(edit.skin);
  }
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> move_path_points(const Skin& skin, std::span<const MovedPathPoint> points) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (const MovedPathPoint& moved : points) {
    if (moved.curve == PathCurve::second_rail && !edit.skin.second_rail) return no_such_point();
    SubdivisionCurve& curve = moved.curve == PathCurve::path ? edit.skin.path : *edit.skin.second_rail;
    if (moved.point < 0 || moved.point >= curve.size()) return no_such_point();
    curve.points[std::size_t(moved.point)] = moved.position;
  }
  const Carrier carrier(skin, edit.skin);
  for (SkinSection& section : edit.skin.sections) carrier.carry(section, section.v, section.v);
  return accepted(skin, std::move(edit));
}

namespace {

/// Replaces the path (and rail); `place` maps old places of sections to new ones, `carried` tells whether a
/// section at an old place moves with the path or stays where it is in space.
template <class Place, class Carried>
Result<SkinEdit> with_path(const Skin& skin, Reshaped path, const std::optional<Reshaped>& rail,
                           const Place& place, const Carried& carried) {
  SkinEdit edit{skin, path.deviation, {}, {}, {}};
  edit.skin.path = std::move(path.curve);
  if (rail) {
    edit.skin.second_rail = rail->curve;
    edit.deviation = std::max(edit.deviation, rail->deviation);
  }
  const Carrier carrier(skin, edit.skin);
  for (SkinSection& section : edit.skin.sections) {
    const double v = place(section.v);
    if (carried(section.v))
      carrier.carry(section, section.v, v);
    else
      section.reference.reset();  // the section stays in space, away from the new path
    section.v = v;
  }
  if (skin.path.closed) rotate_order(edit.skin);
  return accepted(skin, std::move(edit));
}

}  // namespace

Result<SkinEdit> insert_path_point(const Skin& skin, int span) {
  const int spans = skin.path.spans();
  if (span < 0 || span >= spans) return no_such_point();
  std::optional<Reshaped> rail;
  if (has_rails(skin)) {
    if (skin.second_rail->spans() != spans) return uneven_rails();
    rail = with_point_inserted(*skin.second_rail, span);
  }
  const auto place = [&](double v) { return inserted_parameter(v, spans, span, false); };
  return with_path(skin, with_point_inserted(skin.path, span), rail, place,
                   [&](double) { return has_rails(skin); });
}

Result<SkinEdit> refine_path(const Skin& skin) {
  if (skin.path.spans() < 1) return no_such_point();
  std::optional<Reshaped> rail;
  if (skin.second_rail && skin.second_rail->spans() > 0) rail = Reshaped{refined(*skin.second_rail), 0};
  return with_path(
      skin, {refined(skin.path), 0}, rail, [](double v) { return v; }, [](double) { return false; });
}

Result<SkinEdit> delete_path_point(const Skin& skin, int point) {
  const int spans = skin.path.spans();
  if (point < 0 || point >= skin.path.size()) return no_such_point();
  const Message few =
      make_error(e_path_short, "The path needs at least 2 points (3 if closed).", "Move the point instead.");
  if (skin.path.size() <= (skin.path.closed ? 3 : 2)) return few;
  std::optional<Reshaped> rail;
  if (has_rails(skin)) {
    if (skin.second_rail->spans() != spans) return uneven_rails();
    rail = with_point_deleted(*skin.second_rail, point);
  }
  const bool closed = skin.path.closed;
  const auto place = [&](double v) {
    const double v_new = deleted_parameter(v, spans, point, closed);
    return closed ? v_new - std::floor(v_new) : v_new;
  };
  // The section at a deleted end moves to the new end.
  const auto carried = [&](double v) {
    return has_rails(skin) || (!closed && ((point == 0 && v <= 0) || (point == spans && v >= 1)));
  };
  return with_path(skin, with_point_deleted(skin.path, point), rail, place, carried);
}

Result<SkinEdit> set_path_sharp(const Skin& skin, PathCurve which, int point, bool sharp) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  if (which == PathCurve::second_rail && !edit.skin.second_rail) return no_such_point();
  SubdivisionCurve& curve = which == PathCurve::path ? edit.skin.path : *edit.skin.second_rail;
  if (point < 0 || point >= curve.size()) return no_such_point();
  curve.sharp.resize(std::size_t(curve.size()), 0);
  curve.sharp[std::size_t(point)] = sharp;
  if (std::none_of(curve.sharp.begin(), curve.sharp.end(), [](char s) { return s != 0; }))
    curve.sharp.clear();
  const Carrier carrier(skin, edit.skin);
  for (SkinSection& section : edit.skin.sections) carrier.carry(section, section.v, section.v);
  return accepted(skin, std::move(edit));
}

namespace {

/// Cuts the path to the open part between its first and last section.
Result<SkinEdit> cut_path(const Skin& skin, SkinEdit edit) {
  const double first = skin.sections.front().v, last = skin.sections.back().v;
  if (!(last > first) || !std::isfinite(last - first))
    return make_error(e_section_order, "Sections are at the same place on the path (or in the wrong order).",
                      "Slide one of them along the path.");
  const auto part = [&](const SubdivisionCurve& curve) {
    const double spans = curve.spans() * (last - first);
    const int count = std::max(1, int(std::lround(std::min(spans, 1e4))));
    std::vector<Vector3> targets;
    std::vector<char> sharp;
    for (int i = 0; i <= count; ++i) {
      const double v = first + (last - first) * i / count, x = v * curve.spans();
      targets.push_back(evaluate(curve, v).position);
      const int near = std::clamp(int(std::lround(x)), 0, curve.spans());
      sharp.push_back(curve.is_sharp(near % curve.size()) && std::abs(x - near) < 1e-6);
    }
    if (std::none_of(sharp.begin(), sharp.end(), [](char s) { return s != 0; })) sharp.clear();
    Reshaped out{curve_through(std::move(targets), false, std::move(sharp)), 0};
    for (int i = 0; i <= 8 * count; ++i) {
      const Vector3 p = evaluate(curve, first + (last - first) * i / (8.0 * count)).position;
      out.deviation = std::max(out.deviation, nearest_point(out.curve, p).distance);
    }
    return out;
  };
  const Reshaped path = part(skin.path);
  edit.skin.path = path.curve;
  edit.deviation = path.deviation;
  if (skin.second_rail && skin.second_rail->spans() >= 1) {
    const Reshaped rail = part(*skin.second_rail);
    edit.skin.second_rail = rail.curve;
    edit.deviation = std::max(edit.deviation, rail.deviation);
  }
  const Carrier carrier(skin, edit.skin);
  for (SkinSection& section : edit.skin.sections) {
    const double v = (section.v - first) / (last - first);
    // Sections must stay on their rails, which have changed slightly.
    if (has_rails(skin)) carrier.carry(section, section.v, v);
    section.v = v;
  }
  edit.skin.sections.front().v = 0;
  edit.skin.sections.back().v = 1;
  return accepted(skin, std::move(edit));
}

/// Joins the first and the last point of the path, and the sections there.
void join_ends(Skin& skin, std::vector<std::uint32_t>& lost) {
  for (SubdivisionCurve* curve : {&skin.path, skin.second_rail ? &*skin.second_rail : nullptr}) {
    if (!curve) continue;
    curve->points.pop_back();
    if (!curve->sharp.empty()) curve->sharp.pop_back();
  }
  if (skin.sections.empty() || skin.sections.back().v < 1) return;
  for (auto& row : skin.smooth.anchors)
    if (row.size() == skin.sections.size()) row.pop_back();
  forget_section(skin, skin.sections.back().id, lost);
  skin.sections.pop_back();
}

Result<SkinEdit> close_path(const Skin& skin) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  const double gap = (skin.path.points.back() - skin.path.points.front()).norm();
  const bool joins = gap <= 1e-6 * length(skin.path);
  if (skin.path.size() < (joins ? 4 : 3))
    return make_error(e_path_short, "The path needs at least 2 points (3 if closed).",
                      "Insert points into the path first.");
  if (joins) join_ends(edit.skin, edit.lost);
  if (edit.skin.section_count() < 2)
    return make_error(e_few_sections, "Skinning needs at least two sections.", "Add a section first.");
  edit.skin.path.closed = true;
  if (edit.skin.second_rail) edit.skin.second_rail->closed = true;
  const double scale = joins ? 1 : double(skin.path.spans()) / skin.path.size();
  const Carrier carrier(skin, edit.skin);
  for (SkinSection& section : edit.skin.sections) {
    const double v = section.v * scale;
    carrier.carry(section, section.v, v);
    section.v = v;
  }
  return accepted(skin, std::move(edit));
}

}  // namespace

Result<SkinEdit> set_path_closed(const Skin& skin, bool closed) {
  if (skin.path.closed == closed) return accepted(skin, {skin, 0, {}, {}, {}});
  if (skin.path.spans() < 1) return no_such_point();
  if (closed) return close_path(skin);
  if (skin.section_count() < 2)
    return make_error(e_few_sections, "Skinning needs at least two sections.", "Add a section first.");
  SkinEdit edit{skin, 0, {}, {}, {}};
  const auto beyond = [&](const auto& entry) {
    if (entry.first != skin.sections.back().id || entry.second != skin.sections.front().id) return false;
    edit.lost.push_back(entry.id);
    return true;
  };
  std::erase_if(edit.skin.links, beyond);
  std::erase_if(edit.skin.merges, beyond);
  return cut_path(skin, std::move(edit));
}

Result<SkinEdit> trim_path(const Skin& skin) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  if (skin.path.closed || skin.section_count() < 2 || skin.path.spans() < 1)
    return accepted(skin, std::move(edit));
  return cut_path(skin, std::move(edit));
}

}  // namespace hariko
