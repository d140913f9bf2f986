#include "core/modeling/surfacing/object_surfacer.hpp"

#include <algorithm>
#include <set>

#include "core/document/edits/edit_attachments.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/skinning/local_skin.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

/// Whether the patch's row of control points follows the polyhedron's surface.
bool patch_follows(const Attachment& attachment) {
  return !attachment.frozen && attachment.continuity != Continuity::g0 && attachment.adapts == Adapts::patch;
}

bool is_attached(const Object& polyhedron, ObjectId patches, bool only_followed) {
  const PolyhedronSource* source = polyhedron.polyhedron();
  if (!source) return false;
  for (const auto& [edge, attachment] : *source->attachments)
    if (!attachment.frozen && attachment.patch == patches && (!only_followed || patch_follows(attachment)))
      return true;
  return false;
}

bool same_input(const PolyhedronSurfaceInput& a, const PolyhedronSurfaceInput& b) {
  return a.polyhedron == b.polyhedron && a.shaping == b.shaping && a.mode == b.mode && a.origin == b.origin &&
         a.joins == b.joins && a.frames == b.frames;
}

/// Adds the mirror image of a join of the half to the whole: image faces follow the half's in order, and run
/// the other way round from the same corner.
void add_image(PolyhedronSurfaceInput& input, const Join& join, const Mirror& mirror, Index half_faces) {
  const HalfEdgeMesh& mesh = input.polyhedron.topology();
  const Index f = mesh.face(join.half_edge), n = mesh.side_count(f);
  const Index place = join.half_edge - mesh.face_begin(f);
  const auto reflected = [&](Vector3 point) {
    point[index_of(mirror.axis)] *= -1;
    return point;
  };
  Join image = join;
  image.half_edge = mesh.face_begin(f + half_faces) + (n - 1 - place);
  for (std::size_t i = 0; i < 4; ++i) {
    image.curve[i] = reflected(join.curve[3 - i]);
    image.row[i] = reflected(join.row[3 - i]);
  }
  input.joins.push_back(image);
}

class Neighbourhood {
 public:
  explicit Neighbourhood(const Document& document) : document_(document) {}

  void add_of(const Object& object) {
    if (object.patches()) add_of_patches(object);
    const PolyhedronSource* source = object.polyhedron();
    if (!source) return;
    for (const auto& [edge, attachment] : *source->attachments) {
      if (attachment.frozen) continue;
      const Object* patches = document_.find(attachment.patch);
      if (!patches) continue;
      found.insert(patches->id);
      if (!patch_follows(attachment)) add_of_patches(*patches);
    }
  }
  std::set<ObjectId> found;

 private:
  void add_of_patches(const Object& patches) {
    if (!expanded_.insert(patches.id).second) return;
    const auto& all = document_.objects;
    if (std::none_of(all.begin(), all.end(),
                     [&](const auto& object) { return is_attached(*object, patches.id, true); }))
      return;
    for (const auto& object : all) {
      if (!is_attached(*object, patches.id, false)) continue;
      found.insert(object->id);
      if (is_attached(*object, patches.id, true)) add_of(*object);
    }
  }
  const Document& document_;
  std::set<ObjectId> expanded_;
};

}  // namespace

ObjectPointers neighbours_of(const Document& document, ObjectId id) {
  const Object* object = document.find(id);
  if (!object || (!object->patches() && !object->polyhedron())) return {};
  if (object->polyhedron() && object->polyhedron()->attachments->empty()) return {};
  Neighbourhood neighbourhood(document);
  neighbourhood.add_of(*object);
  ObjectPointers out;
  for (const auto& other : document.objects)
    if (other->id != id && neighbourhood.found.contains(other->id)) out.push_back(other);
  return out;
}

/// Polyhedron that patches adapt to, with its last surface.
struct ObjectSurfacer::Helper {
  PolyhedronSurfacer surfacer;
  SurfaceInputCache cache;
  std::optional<PolyhedronSurfaceInput> made_from;
  Surface surface;
};

struct ObjectSurfacer::Adapted {
  BicubicNet net;
  std::vector<Message> warnings;
};

class ObjectSurfacer::Call {
 public:
  Call(ObjectSurfacer& owner, const Object& object, const ObjectPointers& neighbours,
       const CancelToken& cancel)
      : owner_(owner), cancel_(cancel) {
    objects_.push_back(&object);
    for (const auto& other : neighbours) objects_.push_back(other.get());
  }

  Result<PolyhedronSurfaceInput> input(const Object& object, Quality quality, SurfaceInputCache& cache);
  Result<Adapted> adapted(const Object& patches);

 private:
  const Object* find(ObjectId id) const {
    const auto found = std::find_if(objects_.begin(), objects_.end(),
                                    [&](const Object* object) { return object->id == id; });
    return found == objects_.end() ? nullptr : *found;
  }
  Result<FrozenSide> side(const Object& polyhedron, EdgeId edge, const Attachment& attachment);
  /// Surface of a polyhedron that patches adapt to, with the input it was made from.
  Result<const Helper*> surface_beyond(const Object& polyhedron);

  ObjectSurfacer& owner_;
  CancelToken cancel_;
  std::vector<const Object*> objects_;
  std::set<ObjectId> under_way_;
};

Result<FrozenSide> ObjectSurfacer::Call::side(const Object& polyhedron, EdgeId edge,
                                              const Attachment& attachment) {
  if (attachment.frozen) return *attachment.frozen;
  const Object* patches = find(attachment.patch);
  if (!patches || !patches->patches() || !has_side(*patches->patches(), attachment.side))
    return make_error(e_join_lost,
                      "The side that edge " + to_string(edge) + " is attached to does not exist.",
                      "Release the edge, or attach it to another side.", element_of(edge));
  if (patch_follows(attachment))
    return side_seen_from(polyhedron, *patches, patches->patches()->control_net(), attachment.side,
                          attachment.reversed);
  auto net = adapted(*patches);
  if (!net) return net.error();
  return side_seen_from(polyhedron, *patches, net->net, attachment.side, attachment.reversed);
}

Result<PolyhedronSurfaceInput> ObjectSurfacer::Call::input(const Object& object, Quality quality,
                                                           SurfaceInputCache& cache) {
  const PolyhedronSource& source = *object.polyhedron();
  Result<PolyhedronSurfaceInput> taken = surface_input(source, quality, &cache);
  if (!taken || source.attachments->empty()) return taken;
  PolyhedronSurfaceInput made = std::move(taken).value();
  if (!under_way_.insert(object.id).second)
    return make_error(e_attachment_cycle, "\"" + object.name + "\" is attached to what follows itself.",
                      "Release one of its edges.", element_of(object.id));
  const HalfEdgeMesh& mesh = made.polyhedron.topology();
  for (const auto& [edge, attachment] : *source.attachments) {
    const Index e = source.polyhedron.find(edge);
    if (e == no_index || !source.polyhedron.topology().is_border_edge(e)) continue;
    const Index h = made.polyhedron.find(edge);
    if (h == no_index || !mesh.is_border_edge(h))
      return make_error(e_join_seam, "Edge " + to_string(edge) + " lies in the plane of the mirror.",
                        "Release the edge, or move it out of the plane.", element_of(edge));
    auto seen = side(object, edge, attachment);
    if (!seen) return seen.error();
    Join join;
    join.half_edge = mesh.half_edge_of_edge(h);
    join.patch_follows = patch_follows(attachment);
    join.continuity = join.patch_follows ? Continuity::g0 : attachment.continuity;
    // The whole of a mirrored polyhedron has its own origin.
    const Vector3 shift = source.origin - made.origin;
    for (std::size_t i = 0; i < 4; ++i) {
      join.curve[i] = seen->curve[i] + shift;
      join.row[i] = seen->row[i] + shift;
    }
    made.joins.push_back(join);
    if (source.mirror) add_image(made, join, *source.mirror, made.polyhedron.face_count() / 2);
  }
  under_way_.erase(object.id);
  return made;
}

Result<const ObjectSurfacer::Helper*> ObjectSurfacer::Call::surface_beyond(const Object& polyhedron) {
  auto& slot = owner_.helpers_[polyhedron.id];
  if (!slot) slot = std::make_unique<Helper>();
  auto made = input(polyhedron, Quality::final, slot->cache);
  if (!made) return made.error();
  if (slot->made_from && same_input(*slot->made_from, *made)) return slot.get();
  auto surface = slot->surfacer.rebuild(*made, Quality::final, cancel_);
  if (!surface) return surface.error();
  slot->made_from = std::move(made).value();
  slot->surface = surface->surface;
  return slot.get();
}

Result<ObjectSurfacer::Adapted> ObjectSurfacer::Call::adapted(const Object& patches) {
  Adapted out{patches.patches()->control_net(), {}};
  std::vector<AdaptingSide> sides;
  std::vector<std::pair<const Object*, EdgeId>> owners;
  std::vector<NetSide> held;
  if (!under_way_.insert(patches.id).second)
    return make_error(e_attachment_cycle, "\"" + patches.name + "\" is attached to what follows itself.",
                      "Release one of its sides.", element_of(patches.id));
  for (const Object* object : objects_) {
    if (!is_attached(*object, patches.id, false)) continue;
    const bool followed = is_attached(*object, patches.id, true);
    Result<const Helper*> beyond = static_cast<const Helper*>(nullptr);
    if (followed) beyond = surface_beyond(*object);
    if (!beyond) {
      out.warnings.push_back(make_warning(
          w_join_refused,
          "The patches do not follow \"" + object->name + "\", which has no surface: " + beyond.error().text,
          beyond.error().remedy, element_of(object->id)));
    }
    const RelativePlace place = relative_place(*object, patches);
    const Polyhedron& polyhedron = object->polyhedron()->polyhedron;
    for (const auto& [edge, attachment] : *object->polyhedron()->attachments) {
      if (attachment.frozen || attachment.patch != patches.id ||
          !has_side(*patches.patches(), attachment.side))
        continue;
      const Index e = polyhedron.find(edge);
      if (e == no_index || !polyhedron.topology().is_border_edge(e)) continue;
      if (!patch_follows(attachment) || !beyond || !*beyond) {
        held.push_back(attachment.side);
        continue;
      }
      const Polyhedron& whole = (*beyond)->made_from->polyhedron;
      const Index h = whole.topology().half_edge_of_edge(whole.find(edge));
      CrossRow row = cross_row((*beyond)->surface.patches(), h, attachment.reversed);
      for (Vector3& vector : row) vector = place.linear * vector;
      sides.push_back({attachment.side, row});
      owners.emplace_back(object, edge);
    }
  }
  under_way_.erase(patches.id);
  if (sides.empty()) return out;
  AdaptedNet made = adapted_net(out.net, sides, held);
  out.net = std::move(made.net);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (made.kinked[k])
      out.warnings.push_back(make_warning(
          w_join_kink,
          "Beside the side attached to edge " + to_string(owners[k].second) + " of \"" +
              owners[k].first->name +
              "\" two patches that were smooth have a kink between them: both follow the surface.",
          "Use mode G2 for the surface, or let it adapt at one of the edges.", element_of(patches.id)));
    if (!made.adapted[k])
      out.warnings.push_back(make_warning(
          w_join_refused,
          "The side attached to edge " + to_string(owners[k].second) + " of \"" + owners[k].first->name +
              "\" cannot follow it: its control points are held by another edge.",
          "Join one of the edges by position only, or let the surface adapt.", element_of(patches.id)));
  }
  return out;
}

ObjectSurfacer::ObjectSurfacer() = default;
ObjectSurfacer::~ObjectSurfacer() = default;

Result<ObjectSurface> ObjectSurfacer::surface(const Object& object, const ObjectPointers& neighbours,
                                              Quality quality, const CancelToken& cancel) {
  if (const BezierSource* bezier = object.bezier()) {
    auto welded = weld_patches(bezier->origin, *bezier->patches);
    if (!welded) return welded.error();
    return whole(std::move(welded).value());
  }
  if (const SolidsSource* solids = object.solids()) return around(*solids, quality, cancel);
  if (const SkinSource* skin = object.skin()) return over(*skin, quality, cancel);
  if (const OutlineSource* outline = object.outline()) return inside(*outline, quality, cancel);
  Call call(*this, object, neighbours, cancel);
  if (object.patches()) {
    auto net = call.adapted(object);
    if (!net) return net.error();
    return whole(bicubic_surface(object.patches()->origin, std::move(net->net)), std::move(net->warnings));
  }
  auto input = call.input(object, quality, cache_);
  if (!input) return input.error();
  auto made = over(*input, quality, cancel);
  if (made && quality == Quality::drag && object.polyhedron()->preparation.automatic_tension != 0)
    made.value().provisional = true;
  return made;
}

ObjectSurface ObjectSurfacer::whole(Surface surface, std::vector<Message> warnings) {
  ++revision_;
  return {std::move(surface), std::move(warnings), {}, revision_, revision_, {}};
}

Result<ObjectSurface> ObjectSurfacer::over(const PolyhedronSurfaceInput& input, Quality quality,
                                           const CancelToken& cancel) {
  auto rebuilt = surfacer_.rebuild(input, quality, cancel);
  if (!rebuilt) return rebuilt.error();
  PolyhedronSurface& made = rebuilt.value();
  return ObjectSurface{std::move(made.surface), std::move(made.warnings), made.report,     made.revision,
                       made.base_revision,      std::move(made.changed),  made.provisional};
}

Result<ObjectSurface> ObjectSurfacer::around(const SolidsSource& source, Quality quality,
                                             const CancelToken& cancel) {
  auto made = enveloper_.rebuild(*source.input, quality, cancel);
  if (!made) return made.error();
  ObjectSurface out = whole(made->surface, made->warnings);
  out.details = std::make_shared<const EnvelopeSurface>(std::move(made).value());
  return out;
}

Result<ObjectSurface> ObjectSurfacer::over(const SkinSource& source, Quality quality,
                                           const CancelToken& cancel) {
  const LocalSkin local = local_skin(*source.skin);
  progress_.report(1);  // complete unless slow work begins
  SkinWork work;
  work.cancel = cancel;
  work.progress = progress_;
  work.moving = quality == Quality::drag;
  auto made = skinner_.surface(local.skin, local.origin, work);
  if (!made) return made.error();
  return whole(std::move(made->surface), std::move(made->result.warnings));
}

Result<ObjectSurface> ObjectSurfacer::inside(const OutlineSource& source, Quality quality,
                                             const CancelToken& cancel) {
  const auto points = control_points(*source.outline, gauss_options(source.settings), cancel);
  if (!points) return points.error();
  const auto made = outline_polyhedron(*points, source.settings.frames);
  if (!made) return made.error();
  PolyhedronSurfaceInput input{made->polyhedron, made->shaping,
                               source.settings.curvature_continuous ? Mode::g2 : Mode::fair, made->origin};
  input.frames = source.settings.frames;
  auto out = over(input, quality, cancel);
  if (out.ok()) {
    std::vector<Message>& warnings = out.value().warnings;
    warnings.insert(warnings.begin(), points->messages.begin(), points->messages.end());
  }
  return out;
}

Result<ObjectSurface> object_surface(const Document& document, const Object& object,
                                     const CancelToken& cancel) {
  return ObjectSurfacer().surface(object, neighbours_of(document, object.id), Quality::final, cancel);
}

}  // namespace hariko
