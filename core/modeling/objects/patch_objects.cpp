#include "core/modeling/objects/patch_objects.hpp"

#include <algorithm>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_groups.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

Result<Source> single_source(const Vector3& origin, const BezierPatch& patch) {
  if (is_editable(patch)) {
    auto made = PatchSource::from_net(origin, BicubicNet{1, 1, patch.points});
    return made ? Result<Source>(std::move(made).value()) : made.error();
  }
  auto made = BezierSource::from_patches(origin, {patch});
  return made ? Result<Source>(std::move(made).value()) : made.error();
}

/// Patches of either kind of patch object, relative to the object's own origin.
std::vector<BezierPatch> patches_of(const Object& object) {
  if (const BezierSource* bezier = object.bezier()) return *bezier->patches;
  const BicubicNet net = object.patches()->control_net();
  std::vector<BezierPatch> out;
  for (Index patch = 0; patch < net.patch_count(); ++patch) {
    BezierPatch& single = out.emplace_back();
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) single.points.push_back(net.points[net.index(patch, i, j)]);
  }
  return out;
}

/// Moves the objects `made`, which lie in no group, to the place of the object `old`, and removes all of
/// `gone`.
Result<Document> replaced(const Document& document, ObjectId old, std::span<const ObjectId> made,
                          std::span<const ObjectId> gone) {
  const std::vector<Member> rows(made.begin(), made.end());
  const auto ordered = move_members(document, rows, {document.find(old)->group, old});
  if (!ordered) return ordered.error();
  return delete_objects(*ordered, gone);
}

}  // namespace

bool is_editable(const BezierPatch& patch) {
  return patch.degree_s == 3 && patch.degree_t == 3 && !patch.rational();
}

Result<SeparatedPatches> separate_patches(const Document& document, ObjectId id) {
  const Object* object = document.find(id);
  if (!object) return detail::unknown_object(id);
  if (object->locked) return detail::locked_object(*object);
  const BezierSource* bezier = object->bezier();
  if (!bezier || bezier->patches->size() < 2)
    return make_error(e_wrong_kind, "The object \"" + object->name + "\" has no patches to take apart.",
                      "Select an object of several welded patches.", element_of(id));
  const auto welded = weld_patches(bezier->origin, *bezier->patches);
  if (!welded) return welded.error();
  const auto& patches = static_cast<const BezierPatchSet&>(welded->patches());
  Document parts;
  for (Index k = 0; k < patches.patch_count(); ++k) {
    auto source = single_source(bezier->origin, patches.patch(k));
    if (!source) return source.error();
    Object part = *object;
    part.id = ObjectId{k + 1};
    part.name = detail::name_with(object->name, " " + std::to_string(k + 1));
    part.source = std::move(source).value();
    part.visible = part.visible_itself();
    part.hidden_by_group = false;
    part.group = {};
    parts.objects.push_back(std::make_shared<const Object>(std::move(part)));
  }
  const auto appended = append_document(document, parts);
  if (!appended) return appended.error();
  SeparatedPatches out;
  for (auto added = appended->objects.end() - std::ptrdiff_t(parts.objects.size());
       added != appended->objects.end(); ++added)
    out.objects.push_back((*added)->id);
  auto done = replaced(*appended, id, out.objects, std::span(&id, 1));
  if (!done) return done.error();
  out.document = std::move(done).value();
  return out;
}

Result<WeldedPatches> weld_patch_objects(const Document& document, std::span<const ObjectId> objects) {
  std::vector<ObjectId> all;
  for (const ObjectId id : objects)
    if (std::find(all.begin(), all.end(), id) == all.end()) all.push_back(id);
  if (all.size() < 2)
    return make_error(e_wrong_selection, "There are no two objects to weld.",
                      "Select two or more objects of patches.");
  const Object* base = nullptr;
  std::vector<BezierPatch> patches;
  for (const ObjectId id : all) {
    const Object* object = document.find(id);
    if (!object) return detail::unknown_object(id);
    if (object->locked) return detail::locked_object(*object);
    if (!object->patches() && !object->bezier())
      return make_error(e_wrong_kind, "The object \"" + object->name + "\" is not made of patches.",
                        "Select objects of patches only.", element_of(id));
    if (!base) base = object;
    const Similarity to = base->transform.inverse();
    const Vector3 origin = object->patches() ? object->patches()->origin : object->bezier()->origin;
    for (const Similarity& from : places_of(*object))
      for (BezierPatch& patch : patches_of(*object)) {
        // Points in the first object's own space; objects with the same placement keep their coordinates
        // exactly.
        for (Vector3& point : patch.points)
          point = from == base->transform ? Vector3(origin + point) : to.apply(from.apply(origin + point));
        // Keeps the outside of a mirror image.
        if (from.mirrors()) patch = flipped(patch);
        patches.push_back(std::move(patch));
      }
  }
  auto source = BezierSource::from_patches(std::move(patches));
  if (!source) return source.error();
  auto added =
      add_object(document, base->name, Source(std::move(source).value()), base->transform, base->display);
  if (!added) return added.error();
  const ObjectId made = added->id;
  auto done = replaced(added->document, all[0], std::span(&made, 1), all);
  if (!done) return done.error();
  return WeldedPatches{std::move(done).value(), made};
}

}  // namespace hariko
