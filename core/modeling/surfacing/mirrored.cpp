#include "core/modeling/surfacing/mirrored.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/modeling/shaping_cleanup.hpp"
#include "core/network/kept_form.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

/// Reverses the corners of a face for its mirror image; the first corner stays.
template <class Corners>
void reverse_face(Corners& corners) {
  std::reverse(corners.begin() + 1, corners.end());
}

/// Mirror image of pinned tangents: the vectors that give the edges of the image vertex the images of their
/// tangents. Both fans have the same edges in opposite order, but may begin at different ones.
class TangentReflector {
 public:
  /// `image(v)`: the dense vertex of `to` that is the image of v.
  TangentReflector(const Polyhedron& from, const Shaping& from_shaping, const Polyhedron& to,
                   const Shaping& to_shaping, std::vector<Index> image, Axis axis)
      : from_(from.topology()), to_(to.topology()), image_(std::move(image)), axis_(axis) {
    auto from_frames = build_vertex_frames(from, from_shaping),
         to_frames = build_vertex_frames(to, to_shaping);
    if (!from_frames || !to_frames) return;  // the network will report the error
    from_frames_ = std::move(from_frames).value();
    to_frames_ = std::move(to_frames).value();
  }

  /// Vectors of the image's pin; nothing where the pin does not fit its vertex.
  std::optional<std::vector<Vector3>> operator()(Index v, std::span<const Vector3> basis) const {
    if (!from_frames_ || !to_frames_) return std::nullopt;
    const Index begin = from_frames_->basis_begin[v], count = from_frames_->basis_begin[v + 1] - begin;
    const Index w = image_[v], w_begin = to_frames_->basis_begin[w];
    if (basis.size() != count || to_frames_->basis_begin[w + 1] - w_begin != count) return std::nullopt;
    // Each edge gives one row: its coefficients in w's basis, and the image of its tangent.
    std::vector<Eigen::VectorXd> rows;
    std::vector<Vector3> tangents;
    const auto add = [&](Index h, bool at_origin) {
      const Index a = image_[from_.origin(h)], b = image_[from_.target(h)];
      const Index forward = to_.find_half_edge(a, b), backward = to_.find_half_edge(b, a);
      // End 2h is half-edge h at its origin.
      const Index end =
          forward != no_index ? 2 * forward + (at_origin ? 0 : 1) : 2 * backward + (at_origin ? 1 : 0);
      const TangentCoefficients& own = from_frames_->ends[2 * h + (at_origin ? 0 : 1)];
      const TangentCoefficients& other = to_frames_->ends[end];
      Eigen::VectorXd row = Eigen::VectorXd::Zero(count);
      Vector3 tangent = Vector3::Zero();
      for (std::size_t k = 0; k < 2; ++k) {
        if (own.basis[k] != no_index) tangent += own.c[k] * basis[own.basis[k] - begin];
        if (other.basis[k] != no_index) row[other.basis[k] - w_begin] += other.c[k];
      }
      rows.push_back(std::move(row));
      tangents.push_back(mirror_plane(axis_).image(tangent));
    };
    for (const FanEnd& each : fan_ends(from_, v)) add(each.end / 2, each.end % 2 == 0);
    Eigen::MatrixXd system(rows.size(), count), right(rows.size(), 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      system.row(static_cast<Eigen::Index>(i)) = rows[i];
      right.row(static_cast<Eigen::Index>(i)) = tangents[i];
    }
    const Eigen::MatrixXd solved = system.colPivHouseholderQr().solve(right);
    std::vector<Vector3> out;
    for (Index k = 0; k < count; ++k) out.push_back(solved.row(k));
    return out;
  }

 private:
  const HalfEdgeMesh &from_, &to_;
  std::vector<Index> image_;
  Axis axis_;
  std::optional<VertexFrames> from_frames_, to_frames_;
};

/// Mirror image of a pin by `reflector`; a pin that does not fit gets the images of its vectors, and the
/// network reports the error.
Pin reflected(const Pin& pin, Index v, const TangentReflector& reflector, Axis axis) {
  Pin out = pin;
  if (pin.kind == Pin::Kind::tangents)
    if (auto tangents = reflector(v, pin.vectors)) return {pin.kind, std::move(*tangents)};
  for (Vector3& vector : out.vectors) vector = mirror_plane(axis).image(vector);
  return out;
}

bool has_tangent_pins(const Shaping& shaping) {
  return std::any_of(shaping.pin.begin(), shaping.pin.end(),
                     [](const auto& entry) { return entry.second.kind == Pin::Kind::tangents; });
}

/// Builds the mirrored whole of one half.
class Whole {
 public:
  Whole(const PolyhedronSource& half, std::vector<char> seam)
      : half_(half), polyhedron_(half.polyhedron), axis_(half.mirror->axis), seam_(std::move(seam)) {
    Index next = polyhedron_.vertex_count();
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) image_.push_back(seam_[v] ? v : next++);
    count_ = next;
    origin_ = half.origin;
    origin_[index_of(axis_)] = 0;
  }

  Result<MirroredPolyhedron> make() const {
    std::vector<VertexId> vertex_ids(count_);
    std::vector<FaceId> face_ids(2 * std::size_t(polyhedron_.face_count()));
    auto aliases = std::make_shared<ElementAliases>();
    if (!number(vertex_ids, face_ids, *aliases))
      return make_error(e_too_many_elements, "The numbers for the mirrored half's elements are used up.",
                        "Export the object and import it again: that numbers its elements afresh.");
    PolygonMesh mesh;
    mesh.positions = positions();
    for (Index f = 0; f < polyhedron_.face_count(); ++f)
      mesh.add_face(polyhedron_.topology().face_vertices(f));
    for (Index f = 0; f < polyhedron_.face_count(); ++f) {
      std::vector<Index> corners;
      for (const Index v : polyhedron_.topology().face_vertices(f)) corners.push_back(image_[v]);
      reverse_face(corners);
      mesh.add_face(corners);
    }
    Result<Polyhedron> built = Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids));
    if (!built) return refusal(built.error(), *aliases);
    Shaping whole = shaping(*built);
    return MirroredPolyhedron{*std::move(built), std::move(whole), origin_, std::move(aliases), half_};
  }

  /// The whole at the present positions, with the connectivity of an earlier one.
  Result<MirroredPolyhedron> moved(const MirroredPolyhedron& previous) const {
    Result<Polyhedron> polyhedron =
        previous.polyhedron.with_positions(ascending_indices(count_), positions());
    if (!polyhedron) return polyhedron.error();
    Shaping whole = previous.half.shaping == half_.shaping ? previous.shaping : shaping(*polyhedron);
    return MirroredPolyhedron{*std::move(polyhedron), std::move(whole), origin_, previous.aliases, half_};
  }

 private:
  /// Positions relative to the whole's origin, which is zero along the axis.
  std::vector<Vector3> positions() const {
    const Eigen::Index axis = index_of(axis_);
    std::vector<Vector3> out(count_);
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) {
      Vector3 p = polyhedron_.position(v);
      p[axis] = seam_[v] ? 0 : half_.origin[axis] + p[axis];
      out[v] = p;
      if (!seam_[v]) out[image_[v]] = mirror_plane(axis_).image(p);
    }
    return out;
  }

  bool number(std::vector<VertexId>& vertex_ids, std::vector<FaceId>& face_ids,
              ElementAliases& aliases) const {
    const Index vertices = polyhedron_.vertex_count(), faces = polyhedron_.face_count();
    aliases.first_vertex = {polyhedron_.vertex_id(vertices - 1).value + 1};
    aliases.first_face = {polyhedron_.face_id(faces - 1).value + 1};
    if (no_index - aliases.first_vertex.value < count_ - vertices ||
        no_index - aliases.first_face.value < faces)
      return false;
    for (Index v = 0; v < vertices; ++v) {
      vertex_ids[v] = polyhedron_.vertex_id(v);
      if (seam_[v]) continue;
      vertex_ids[image_[v]] = {aliases.first_vertex.value + image_[v] - vertices};
      aliases.vertices.push_back(polyhedron_.vertex_id(v));
    }
    for (Index f = 0; f < faces; ++f) {
      face_ids[f] = polyhedron_.face_id(f);
      face_ids[faces + f] = {aliases.first_face.value + f};
      aliases.faces.push_back(polyhedron_.face_id(f));
    }
    return true;
  }

  Message refusal(const Message& error, const ElementAliases& aliases) const {
    if (error.code == e_nonfinite) return error;
    return make_error(
        e_mirror_nonmanifold,
        "The halves cannot be joined here: an edge in the mirror's plane would have more than "
        "two faces, or parts would touch in one vertex.",
        "Move the element off the plane, lower the weld distance, or delete faces in the plane.",
        aliases.original(error.element));
  }

  Shaping shaping(const Polyhedron& whole) const {
    const Shaping& half = *half_.shaping;
    const auto image = [&](VertexId id) {
      const Index v = polyhedron_.find(id);
      return v == no_index ? id : whole.vertex_id(image_[v]);
    };
    const auto image_of_edge = [&](EdgeId id) { return EdgeId::of(image(id.low), image(id.high)); };
    Shaping all = half;
    for (const auto& [id, value] : half.alpha) all.alpha.set(image(id), value);
    for (const auto& [id, value] : half.tag) all.tag.set(image(id), value);
    for (const auto& [id, value] : half.beta) all.beta.set(image_of_edge(id), value);
    for (const auto& [id, value] : half.crease) all.crease.set(image_of_edge(id), value);
    // Corners that the seam made smooth, and tangents of vertices that got more edges, are treated as after
    // any operation.
    Shaping out = detail::shaping_on(whole, all, polyhedron_, half);
    settle_pins(whole, out);
    settle_forms(whole, out);
    for (const auto& [id, area] : half.kept_area) {
      const Index f = polyhedron_.find(id);
      if (f == no_index) continue;
      out.kept_area.set(id, area);
      out.kept_area.set(whole.face_id(polyhedron_.face_count() + f), area);
    }
    return out;
  }

  void settle_pins(const Polyhedron& whole, Shaping& shaping) const {
    const Shaping& half = *half_.shaping;
    if (half.pin.empty()) return;
    std::optional<TangentReflector> reflector;
    if (has_tangent_pins(half)) reflector.emplace(polyhedron_, half, whole, shaping, image_, axis_);
    for (const auto& [id, pin] : half.pin) {
      const Index v = polyhedron_.find(id);
      if (v == no_index || polyhedron_.topology().outgoing(v) == no_index) continue;
      if (!seam_[v]) {
        const VertexId image = whole.vertex_id(image_[v]);
        if (pin.kind == Pin::Kind::normal)
          shaping.pin.set(image, {pin.kind, {mirror_plane(axis_).image(pin.vectors[0])}});
        else
          shaping.pin.set(image, hariko::reflected(pin, v, *reflector, axis_));
      } else if (const Pin* kept = shaping.pin.find(id); kept && kept->kind == Pin::Kind::normal) {
        shaping.pin.set(id, {Pin::Kind::normal, {own_image(kept->vectors[0])}});
      }
    }
  }

  /// Settles forms at the seam, where the edges of both halves count.
  void settle_forms(const Polyhedron& whole, Shaping& shaping) const {
    const auto image = [&](VertexId id) {
      const Index v = polyhedron_.find(id);
      return v == no_index ? id : whole.vertex_id(image_[v]);
    };
    for (const auto& [id, form] : half_.shaping->form) {
      const Index v = polyhedron_.find(id);
      if (v == no_index) continue;
      KeptForm other = reflected_form(form);
      for (KeptForm::Edge& edge : other.edges) edge.to = image(edge.to);
      if (!seam_[v]) {
        std::sort(other.edges.begin(), other.edges.end(),
                  [](const auto& a, const auto& b) { return a.to < b.to; });
        shaping.form.set(whole.vertex_id(image_[v]), std::move(other));
        shaping.form.set(id, form);
        continue;
      }
      KeptForm both = form;
      for (const KeptForm::Edge& edge : other.edges)
        if (!both.find(edge.to)) both.edges.push_back(edge);
      shaping.form.set(id, std::move(both));
    }
  }

  /// Nearest normal whose plane is its own image: within the mirror's plane, or perpendicular to it.
  Vector3 own_image(const Vector3& normal) const {
    Vector3 within = normal;
    within[index_of(axis_)] = 0;
    return within.norm() > 1e-6 * normal.norm() ? within : Vector3(Vector3::Unit(index_of(axis_)));
  }

  const PolyhedronSource& half_;
  const Polyhedron& polyhedron_;
  Axis axis_;
  std::vector<char> seam_;
  std::vector<Index> image_;  ///< per vertex of the half, its image in the whole
  Index count_ = 0;           ///< vertices of the whole
  Vector3 origin_;
};

/// Images of the frozen sides, whose half-edges run the other way round the reflected faces. Other edges are
/// released, as patches are not mirrored.
Attachments reflected_frozen(const Attachments& attachments, Axis axis) {
  Attachments out;
  for (const auto& [edge, attachment] : attachments) {
    if (!attachment.frozen) continue;
    Attachment image = attachment;
    for (auto* rows : {&image.frozen->curve, &image.frozen->row}) {
      for (Vector3& point : *rows) point = mirror_plane(axis).image(point);
      std::reverse(rows->begin(), rows->end());
    }
    out.set(edge, image);
  }
  return out;
}

/// Whether the connectivity of the whole is unchanged; it depends only on the half's connectivity, the axis
/// and the seam.
bool same_connectivity(const MirroredPolyhedron& previous, const PolyhedronSource& half,
                       const std::vector<char>& seam) {
  const PolyhedronSource& before = previous.half;
  return before.polyhedron.shared_topology() == half.polyhedron.shared_topology() &&
         before.mirror->axis == half.mirror->axis &&
         mirror_seam(before.polyhedron, before.origin, *before.mirror) == seam;
}

}  // namespace

Result<MirroredPolyhedron> mirrored(const PolyhedronSource& half, const MirroredPolyhedron* previous) {
  HARIKO_ASSERT(half.mirror.has_value(), "only an object with a live mirror has another half");
  std::vector<char> seam = mirror_seam(half.polyhedron, half.origin, *half.mirror);
  const bool keeps = previous && same_connectivity(*previous, half, seam);
  const Whole whole(half, std::move(seam));
  return keeps ? whole.moved(*previous) : whole.make();
}

Result<PolyhedronSource> baked(const PolyhedronSource& source) {
  if (!source.mirror) return source;
  Result<MirroredPolyhedron> whole = mirrored(source);
  if (!whole) return whole.error();
  PolyhedronSource out = source;
  out.mirror.reset();
  out.origin = whole->origin;
  out.polyhedron = whole->polyhedron;
  out.shaping = whole->shaping;
  return out;
}

Result<EditResult> apply_mirror(const PolyhedronSource& source) {
  if (!source.mirror)
    return make_error(e_wrong_selection, "The object has no live mirror.", "Turn the mirror on first.");
  Result<PolyhedronSource> whole = baked(source);
  if (!whole) return whole.error();
  EditResult out{std::move(whole).value(), {}};
  for (Index f = source.polyhedron.face_count(); f < out.source.polyhedron.face_count(); ++f)
    out.selection.faces.insert(out.source.polyhedron.face_id(f));
  return out;
}

EditResult mirror_object(const PolyhedronSource& source, Axis axis) {
  const Polyhedron& polyhedron = source.polyhedron;
  PolygonMesh mesh;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  std::vector<Index> image;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    mesh.positions.push_back(mirror_plane(axis).image(polyhedron.position(v)));
    vertex_ids.push_back(polyhedron.vertex_id(v));
    image.push_back(v);
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto old = polyhedron.topology().face_vertices(f);
    std::vector<Index> corners(old.begin(), old.end());
    reverse_face(corners);
    mesh.add_face(corners);
    face_ids.push_back(polyhedron.face_id(f));
  }
  EditResult out{source, {}};
  out.source.origin = mirror_plane(axis).image(source.origin);
  out.source.polyhedron = Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids)).value();
  out.source.attachments = reflected_frozen(*source.attachments, axis);
  if (!source.shaping->pin.empty() || !source.shaping->form.empty()) {
    Shaping shaping = *source.shaping;
    for (const auto& [id, form] : source.shaping->form) shaping.form.set(id, reflected_form(form));
    const TangentReflector reflector(polyhedron, *source.shaping, out.source.polyhedron, *source.shaping,
                                     std::move(image), axis);
    for (const auto& [id, pin] : source.shaping->pin)
      if (const Index v = polyhedron.find(id); v != no_index && polyhedron.topology().outgoing(v) != no_index)
        shaping.pin.set(id, reflected(pin, v, reflector, axis));
    out.source.shaping = std::move(shaping);
  }
  return out;
}

}  // namespace hariko
