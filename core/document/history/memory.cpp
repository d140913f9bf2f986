#include "core/document/history/memory.hpp"

namespace hariko {
namespace {

/// Header of an allocation, control block of a shared pointer, rounding, in bytes.
constexpr std::size_t block_overhead = 48;

std::size_t bytes_of(const KeptMembers& kept) {
  std::size_t bytes = block_overhead + kept.capacity() * sizeof(KeptMember);
  for (const KeptMember& member : kept) bytes += member.name.capacity() + member.json.capacity();
  return bytes;
}

std::size_t bytes_of(const Shaping& shaping) {
  const auto map = [](const auto& entries) {
    return entries.empty() ? 0 : entries.size() * sizeof(*entries.begin()) + block_overhead;
  };
  std::size_t bytes = block_overhead + sizeof(Shaping) + map(shaping.alpha) + map(shaping.beta) +
                      map(shaping.crease) + map(shaping.tag) + map(shaping.pin) + map(shaping.form) +
                      map(shaping.kept_area);
  for (const auto& [vertex, pin] : shaping.pin)
    bytes += pin.vectors.capacity() * sizeof(Vector3) + block_overhead;
  for (const auto& [vertex, form] : shaping.form)
    bytes += form.edges.capacity() * sizeof(KeptForm::Edge) + block_overhead;
  return bytes;
}

std::size_t bytes_of(const Attachments& attachments) {
  return block_overhead + attachments.size() * sizeof(std::pair<EdgeId, Attachment>);
}

std::size_t bytes_of(const std::string& text) {
  return block_overhead + text.capacity();
}

std::size_t bytes_of(const PolygonMesh& mesh) {
  return block_overhead + sizeof(PolygonMesh) + mesh.positions.capacity() * sizeof(Vector3) +
         (mesh.face_offsets.capacity() + mesh.face_vertices.capacity()) * sizeof(Index);
}

std::size_t bytes_of(const PaperModel& paper) {
  const auto list = [](const auto& rows) { return block_overhead + rows.capacity() * sizeof(rows[0]); };
  return sizeof(PaperModel) + list(paper.objects) + list(paper.vertices) + list(paper.folds) +
         list(paper.cuts) + list(paper.own_folds) + list(paper.own_cuts) + list(paper.tabs) +
         list(paper.strips) + list(paper.places) + list(paper.strip_places) + bytes_of(paper.kept);
}

std::size_t bytes_of(const SavedViews& views) {
  std::size_t bytes = block_overhead + views.capacity() * sizeof(SavedView);
  for (const SavedView& view : views) bytes += bytes_of(view.name);
  return bytes;
}

std::size_t bytes_of(const Dimensions& dimensions) {
  std::size_t bytes = block_overhead + dimensions.capacity() * sizeof(Dimension);
  for (const Dimension& dimension : dimensions)
    bytes += block_overhead + dimension.anchors.capacity() * sizeof(Anchor);
  return bytes;
}

std::size_t bytes_of(const Groups& groups) {
  std::size_t bytes = block_overhead + groups.capacity() * sizeof(Group);
  for (const Group& group : groups) bytes += block_overhead + group.name.capacity();
  return bytes;
}

std::size_t bytes_of(const LiveCopies& copies) {
  std::size_t bytes = block_overhead + copies.capacity() * sizeof(CopyArray);
  for (const CopyArray& array : copies)
    if (const auto* list = std::get_if<ListOfCopies>(&array))
      bytes += block_overhead + list->places.capacity() * sizeof(Similarity);
  return bytes;
}

std::size_t bytes_of(const std::vector<BezierPatch>& patches) {
  std::size_t bytes = block_overhead + patches.capacity() * sizeof(BezierPatch);
  for (const BezierPatch& patch : patches)
    bytes += 2 * block_overhead + patch.points.capacity() * sizeof(Vector3) +
             patch.weights.capacity() * sizeof(double);
  return bytes;
}

std::size_t bytes_of(const EnvelopeInput& input) {
  std::size_t bytes = block_overhead + sizeof(EnvelopeInput) + input.solids.capacity() * sizeof(Solid);
  for (const Solid& solid : input.solids) bytes += solid.points.capacity() * sizeof(Vector3);
  return bytes;
}

std::size_t bytes_of(const Skin& skin) {
  std::size_t bytes = block_overhead + sizeof(Skin) + skin.path.points.capacity() * sizeof(Vector3);
  if (skin.second_rail) bytes += skin.second_rail->points.capacity() * sizeof(Vector3);
  for (const SkinSection& section : skin.sections)
    bytes += block_overhead + sizeof(SkinSection) + section.points.capacity() * sizeof(SectionPoint);
  for (const SkinLink& link : skin.links)
    bytes +=
        2 * block_overhead + sizeof(SkinLink) + (link.a.capacity() + link.b.capacity()) * sizeof(link.a[0]);
  for (const SkinMerge& merge : skin.merges)
    bytes += block_overhead + sizeof(SkinMerge) + merge.members.capacity() * sizeof(merge.members[0]);
  for (const auto& anchors : skin.smooth.anchors)
    bytes += block_overhead + anchors.capacity() * sizeof(double);
  return bytes;
}

std::size_t bytes_of(const Outline& outline) {
  std::size_t bytes = block_overhead + sizeof(Outline);
  for (const OutlineLoop& loop : outline.loops)
    bytes += 3 * block_overhead + sizeof(OutlineLoop) +
             (loop.points.capacity() + loop.normals.capacity()) * sizeof(Vector3) +
             loop.curvature.capacity() * sizeof(double);
  return bytes;
}

/// Bytes of the connectivity and its ids.
std::size_t bytes_of(const HalfEdgeMesh& mesh) {
  return 8 * block_overhead + sizeof(HalfEdgeMesh) +
         sizeof(Index) * (4 * std::size_t(mesh.half_edge_count()) + 3 * std::size_t(mesh.vertex_count()) +
                          2 * std::size_t(mesh.face_count()) + mesh.edge_count());
}

/// Calls visit(address, bytes) for each block of the polyhedron that other values may share. The chunks of
/// positions are not visible from outside, but a chunk ends where neighbours in the array are not neighbours
/// in memory.
template <class Visit>
void visit_polyhedron(const Polyhedron& polyhedron, Visit&& visit) {
  visit(polyhedron.shared_topology().get(), bytes_of(polyhedron.topology()));
  Index begin = 0;
  for (Index v = 1; v <= polyhedron.vertex_count(); ++v) {
    if (v < polyhedron.vertex_count() && &polyhedron.position(v) == &polyhedron.position(v - 1) + 1) continue;
    visit(&polyhedron.position(begin), (v - begin) * sizeof(Vector3) + 2 * block_overhead);
    begin = v;
  }
}

std::size_t chunk_table_bytes(const Polyhedron& polyhedron) {
  return (polyhedron.vertex_count() / 128 + 1) * sizeof(std::shared_ptr<void>) + block_overhead;
}

/// Calls visit(address, bytes) for each block of a source that other values may share.
template <class Visit>
struct BlockVisitor {
  const Visit& visit;

  template <class... T>
  void shared(const Shared<T>&... values) const {
    (visit(values.get(), bytes_of(*values)), ...);
  }
  void operator()(const PolyhedronSource& source) const {
    shared(source.kept, source.shaping, source.attachments);
    visit_polyhedron(source.polyhedron, visit);
  }
  void operator()(const MeshSource& source) const { shared(source.kept, source.mesh); }
  void operator()(const PatchSource& source) const {
    shared(source.kept);
    visit_polyhedron(source.net, visit);
  }
  void operator()(const BezierSource& source) const { shared(source.kept, source.patches); }
  void operator()(const SolidsSource& source) const { shared(source.kept, source.input); }
  void operator()(const SkinSource& source) const { shared(source.kept, source.skin); }
  void operator()(const OutlineSource& source) const { shared(source.kept, source.outline); }
  void operator()(const PictureSource& source) const { shared(source.kept, source.bytes); }
  void operator()(const UnknownSource& source) const { shared(source.json); }
};

template <class Visit>
void visit_object(const Object& object, const Visit& visit) {
  const BlockVisitor<Visit> blocks{visit};
  blocks.shared(object.kept, object.copies);
  std::visit(blocks, object.source);
}

std::size_t own_bytes(const Object& object) {
  std::size_t bytes = block_overhead + sizeof(Object) + object.name.capacity();
  if (const Polyhedron* cage = object.cage()) bytes += chunk_table_bytes(*cage);
  return bytes;
}

std::size_t own_bytes(const Document& document) {
  return block_overhead + sizeof(Document) + document.objects.size() * sizeof(document.objects[0]);
}

}  // namespace

bool SharedMemory::enter(const void* address, std::size_t bytes) {
  Block& block = blocks_[address];
  if (block.users++ > 0) return false;
  block.bytes = bytes;
  bytes_ += bytes;
  return true;
}

bool SharedMemory::leave(const void* address) {
  const auto found = blocks_.find(address);
  HARIKO_ASSERT(found != blocks_.end(), "memory that was never counted");
  if (--found->second.users > 0) return false;
  bytes_ -= found->second.bytes;
  blocks_.erase(found);
  return true;
}

void SharedMemory::add(const Document& document) {
  bytes_ += own_bytes(document);
  enter(document.kept.get(), bytes_of(*document.kept));
  enter(document.dimensions.get(), bytes_of(*document.dimensions));
  enter(document.saved_views.get(), bytes_of(*document.saved_views));
  enter(document.groups.get(), bytes_of(*document.groups));
  if (document.paper) enter(document.paper.get(), bytes_of(*document.paper));
  for (const auto& object : document.objects)
    if (enter(object.get(), own_bytes(*object)))
      visit_object(*object, [this](const void* address, std::size_t bytes) { enter(address, bytes); });
}

void SharedMemory::remove(const Document& document) {
  bytes_ -= own_bytes(document);
  leave(document.kept.get());
  leave(document.dimensions.get());
  leave(document.saved_views.get());
  leave(document.groups.get());
  if (document.paper) leave(document.paper.get());
  for (const auto& object : document.objects)
    if (leave(object.get()))
      visit_object(*object, [this](const void* address, std::size_t) { leave(address); });
}

}  // namespace hariko
