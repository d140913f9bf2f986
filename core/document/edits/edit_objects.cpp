#include "core/document/edits/edit_objects.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "core/document/edits/edit_attachments.hpp"
#include "core/document/edits/edit_dimensions.hpp"
#include "core/document/edits/edit_groups.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/document/edits/edit_views.hpp"

namespace hariko {
namespace detail {

Message unknown_object(ObjectId id) {
  return make_error(e_unknown_object, "The document has no such object.", "Select an object of the document.",
                    element_of(id));
}

Message locked_object(const Object& object) {
  if (object.locked_by_group)
    return make_error(e_locked, "The object \"" + object.name + "\" is in a locked group.",
                      "Unlock the group first.", element_of(object.id));
  return make_error(e_locked, "The object \"" + object.name + "\" is locked.", "Unlock it first.",
                    element_of(object.id));
}

Result<Document> change_object(const Document& document, ObjectId id, bool unlocked_only,
                               const std::function<Result<Done>(Object&)>& change) {
  const Object* object = document.find(id);
  if (!object) return unknown_object(id);
  if (unlocked_only && object->locked) return locked_object(*object);
  Object changed = *object;
  if (const Result<Done> done = change(changed); !done) return done.error();
  // An unchanged object stays shared, so that the equality test of the history is fast.
  if (changed == *object) return document;
  return with_object(document, std::move(changed));
}

Document with_object(const Document& document, Object object) {
  Document changed = document;
  for (auto& shared : changed.objects)
    if (shared->id == object.id) {
      shared = std::make_shared<const Object>(std::move(object));
      break;
    }
  return changed;
}

std::string name_with(std::string name, std::string_view suffix) {
  if (name.size() + suffix.size() > Object::max_name_length) {
    std::size_t size = Object::max_name_length - suffix.size();
    while (size > 0 && (static_cast<unsigned char>(name[size]) & 0xc0) == 0x80) --size;
    name.resize(size);
  }
  return name.append(suffix);
}

Result<Similarity> checked_transform(const Similarity& transform) {
  const double norm = transform.rotation.norm();
  const bool finite =
      std::isfinite(norm) && std::isfinite(transform.scale) && transform.translation.allFinite();
  if (!finite || norm < 1e-9 || !(transform.scale >= Similarity::min_scale) ||
      transform.scale > Similarity::max_scale)
    return make_error(e_transform_invalid, "The object cannot be placed like this.",
                      "Use finite numbers, a rotation that is not zero, and a scale from 1e-9 to 1e9.");
  Similarity result = transform;
  // Stored numbers are returned unchanged: only a rotation that is clearly not a unit quaternion is
  // normalised.
  if (std::abs(norm - 1) > 1e-12) result.rotation.normalize();
  return result;
}

Result<Done> check_display(const DisplaySettings& display) {
  if (display.density < DisplaySettings::min_density || display.density > DisplaySettings::max_density)
    return make_error(e_display_invalid, "The display density is out of range.",
                      "Use a density from 1 to 64.");
  const CombSettings& combs = display.combs;
  if (combs.density < CombSettings::min_density || combs.density > CombSettings::max_density ||
      !(combs.scale >= CombSettings::min_scale && combs.scale <= CombSettings::max_scale))
    return make_error(e_display_invalid, "The density or the scale of the curvature combs is out of range.",
                      "Use a density from 4 to 128 and a scale from 1/64 to 64.");
  for (const MapRange& range : display.ranges)
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || !(range.low < range.high))
      return make_error(e_display_invalid, "The range of a map must begin below its end.",
                        "Type a lower end that is smaller than the upper end.");
  return Done{};
}

}  // namespace detail

namespace {

Message too_many_objects() {
  return make_error(e_too_many_objects, "The document has no room for more objects.",
                    "Delete objects first.");
}

bool has_room(const Document& document, std::size_t count) {
  return document.objects.size() + count <= Document::max_objects &&
         document.next_object_id.value <= no_index - count;
}

/// Applies `change` to these objects; those that it leaves as they are stay shared.
template <class Change>
Result<Document> with_each(const Document& document, std::span<const ObjectId> objects,
                           const Change& change) {
  const std::set<ObjectId> chosen(objects.begin(), objects.end());
  Document out = document;
  std::size_t found = 0;
  for (auto& object : out.objects) {
    if (!chosen.contains(object->id)) continue;
    ++found;
    Object changed = *object;
    change(changed);
    if (!(changed == *object)) object = std::make_shared<const Object>(std::move(changed));
  }
  for (const ObjectId id : chosen)
    if (found < chosen.size() && !document.find(id)) return detail::unknown_object(id);
  return out;
}

/// Appends dimensions of another document under new ids. Those that name an object which did not come along
/// stay behind. O(dimensions).
Result<Document> with_appended_dimensions(const Document& document, const Dimensions& others,
                                          const std::map<ObjectId, ObjectId>& renamed) {
  if (others.empty()) return document;
  Dimensions all = *document.dimensions;
  DimensionId next = next_dimension_id(all);
  for (Dimension dimension : others) {
    const bool complete =
        std::all_of(dimension.anchors.begin(), dimension.anchors.end(), [&](Anchor& anchor) {
          ObjectId* object = object_of(anchor);
          if (!object) return true;
          const auto found = renamed.find(*object);
          if (found == renamed.end()) return false;
          *object = found->second;
          return true;
        });
    if (!complete) continue;
    dimension.id = next;
    all.push_back(std::move(dimension));
    next = next.value < max_dimension_id ? DimensionId{next.value + 1} : next_dimension_id(all);
  }
  if (all.size() > Document::max_dimensions) return too_many_dimensions();
  Document result = document;
  result.dimensions = std::move(all);
  return result;
}

std::map<ObjectId, const Object*> by_id(const Document& document) {
  std::map<ObjectId, const Object*> out;
  for (const auto& object : document.objects) out.emplace(object->id, object.get());
  return out;
}

/// Names for new objects, none of them twice.
class FreeNames {
 public:
  explicit FreeNames(const Document& document) {
    for (const auto& object : document.objects) taken_.insert(object->name);
  }

  /// Finds the free name as `free_name` describes it, and takes it.
  std::string take(const std::string& name) {
    if (taken_.insert(name).second) return name;
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const bool numbered = digits < name.size() && digits > 1 && name[digits - 1] == ' ';
    const std::string base = numbered ? name.substr(0, digits - 1) : name;
    for (std::size_t& number = next_.try_emplace(base, 2).first->second;; ++number) {
      std::string candidate = detail::name_with(base, " " + std::to_string(number));
      if (taken_.insert(candidate).second) return candidate;
    }
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> next_;  ///< by base: lower numbers are taken
};

/// Appends groups of another document under new ids; returns the new id of each.
std::map<GroupId, GroupId> append_groups(Document& document, const Groups& others) {
  std::map<GroupId, GroupId> renamed{{GroupId{}, GroupId{}}};
  if (others.empty()) return renamed;
  Groups groups = *document.groups;
  for (Group group : others) {
    const GroupId id = next_group_id(groups);
    renamed[group.id] = id;
    group.id = id;
    groups.insert(std::ranges::lower_bound(groups, id, {}, &Group::id), std::move(group));
  }
  for (const Group& group : others)
    std::ranges::lower_bound(groups, renamed[group.id], {}, &Group::id)->parent = renamed[group.parent];
  document.groups = std::move(groups);
  return renamed;
}

/// Lets a copy of an object be unlocked: it leaves groups that lock it.
void unlock_copy(const Document& document, Object& copy) {
  copy.locked = copy.locked_by_group = false;
  copy.group = unlocked_group(document, copy.group);
  copy.visible = copy.visible_itself();
  copy.hidden_by_group = copy.visible && !is_visible(document, copy.group);
  copy.visible = copy.visible && !copy.hidden_by_group;
}

/// Objects of the document, each followed by its copies.
std::vector<std::shared_ptr<const Object>> with_copies(
    const Document& document, std::map<ObjectId, std::vector<std::shared_ptr<const Object>>>& copies) {
  std::vector<std::shared_ptr<const Object>> out;
  for (const auto& object : document.objects) {
    out.push_back(object);
    if (const auto found = copies.find(object->id); found != copies.end())
      std::move(found->second.begin(), found->second.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace

Result<Added> add_object(Document document, std::string name, Source source, const Similarity& transform,
                         const DisplaySettings& display) {
  if (!has_room(document, 1)) return too_many_objects();
  if (const auto checked = check_name(name); !checked) return checked.error();
  if (const auto checked = detail::check_display(display); !checked) return checked.error();
  const Result<Similarity> placed = detail::checked_transform(transform);
  if (!placed) return placed.error();
  const ObjectId id = document.next_object_id;
  Added added{std::move(document), id};
  added.document.objects.push_back(std::make_shared<const Object>(
      Object{added.id, std::move(name), true, false, *placed, display, std::move(source), {}}));
  ++added.document.next_object_id.value;
  return added;
}

Result<Document> append_document(const Document& document, const Document& other) {
  if (!has_room(document, other.objects.size())) return too_many_objects();
  Document result = document;
  std::map<ObjectId, ObjectId> renamed;
  for (const auto& object : other.objects) {
    renamed[object->id] = result.next_object_id;
    ++result.next_object_id.value;
  }
  const std::map<GroupId, GroupId> groups = append_groups(result, *other.groups);
  for (const auto& object : other.objects) {
    Object copy = *object;
    copy.id = renamed[object->id];
    copy.group = groups.at(object->group);
    if (auto* source = std::get_if<PolyhedronSource>(&copy.source); source && !source->attachments->empty()) {
      Attachments attachments;
      for (auto [edge, attachment] : *source->attachments) {
        const auto found = renamed.find(attachment.patch);
        // A join to an object that is not there joins nothing, and under no id could a file name it.
        if (found == renamed.end() && !attachment.frozen) continue;
        attachment.patch = found == renamed.end() ? ObjectId{} : found->second;
        attachments.set(edge, attachment);
      }
      source->attachments = std::move(attachments);
    }
    result.objects.push_back(std::make_shared<const Object>(std::move(copy)));
  }
  if (const auto room = check_packed_pictures(result); !room) return room.error();
  const Result<Document> measured = with_appended_dimensions(result, *other.dimensions, renamed);
  return measured ? append_views(*measured, *other.saved_views) : measured;
}

Result<Document> delete_objects(const Document& document, std::span<const ObjectId> objects) {
  const std::map<ObjectId, const Object*> known = by_id(document);
  for (const ObjectId id : objects) {
    const auto found = known.find(id);
    if (found == known.end()) return detail::unknown_object(id);
    if (found->second->locked) return detail::locked_object(*found->second);
  }
  const std::set<ObjectId> chosen(objects.begin(), objects.end());
  Document result = without_dimensions_of(document, objects);
  std::vector<std::shared_ptr<const Object>> gone;
  std::erase_if(result.objects, [&](const auto& object) {
    if (!chosen.contains(object->id)) return false;
    gone.push_back(object);
    return true;
  });
  for (auto& object : result.objects) {
    if (!object->polyhedron() || object->polyhedron()->attachments->empty()) continue;
    Object changed = *object;
    changed.source = frozen_source(*object, gone);
    if (!(changed == *object)) object = std::make_shared<const Object>(std::move(changed));
  }
  return without_empty_groups(result);
}

Result<AddedObjects> duplicate_objects(const Document& document, std::span<const ObjectId> objects,
                                       std::size_t copies, const ChangeCopy& change) {
  const std::map<ObjectId, const Object*> known = by_id(document);
  std::vector<const Object*> originals;
  std::set<ObjectId> given;
  for (const ObjectId id : objects) {
    const auto found = known.find(id);
    if (found == known.end()) return detail::unknown_object(id);
    if (given.insert(id).second) originals.push_back(found->second);
  }
  if (copies > Document::max_objects || !has_room(document, originals.size() * copies))
    return too_many_objects();
  AddedObjects added{document, {}};
  FreeNames names(document);
  std::map<ObjectId, std::vector<std::shared_ptr<const Object>>> made;
  for (const Object* original : originals) {
    Object copy = *original;
    unlock_copy(document, copy);
    if (copy.polyhedron()) copy.source = frozen_source(*original, document.objects);
    for (std::size_t number = 1; number <= copies; ++number) {
      copy.id = added.document.next_object_id;
      copy.name = names.take(original->name);
      Result<Object> changed = change ? change(copy, number) : Result<Object>(copy);
      if (!changed) {
        Message error = changed.error();
        error.element = element_of(original->id);
        return error;
      }
      made[original->id].push_back(std::make_shared<const Object>(std::move(changed).value()));
      added.ids.push_back(copy.id);
      ++added.document.next_object_id.value;
    }
  }
  added.document.objects = with_copies(document, made);
  if (const auto room = check_packed_pictures(added.document); !room) return room.error();
  return added;
}

Result<Added> duplicate_object(const Document& document, ObjectId object) {
  auto added = duplicate_objects(document, std::span(&object, 1));
  if (!added) return added.error();
  const ObjectId copy = added->ids.front();
  return Added{std::move(added).value().document, copy};
}

std::string free_name(const Document& document, const std::string& name) {
  return FreeNames(document).take(name);
}

Result<Document> rename_object(const Document& document, ObjectId object, std::string name) {
  return detail::change_object(document, object, false, [&](Object& changed) -> Result<Done> {
    if (const auto checked = check_name(name); !checked) return checked.error();
    changed.name = std::move(name);
    return Done{};
  });
}

Result<Document> set_visible(const Document& document, ObjectId object, bool visible) {
  return detail::change_object(document, object, false, [&](Object& changed) -> Result<Done> {
    const bool hidden = !is_visible(document, changed.group);
    changed.visible = visible && !hidden;
    changed.hidden_by_group = visible && hidden;
    return Done{};
  });
}

Result<Document> hide_objects(const Document& document, std::span<const ObjectId> objects) {
  return with_each(document, objects,
                   [](Object& changed) { changed.visible = changed.hidden_by_group = false; });
}

Result<Document> showing_only(const Document& document, std::span<const ObjectId> objects) {
  const std::set<ObjectId> shown(objects.begin(), objects.end());
  std::vector<ObjectId> present;
  Document out = document;
  for (auto& object : out.objects) {
    if (shown.contains(object->id)) {
      present.push_back(object->id);
    } else if (object->visible_itself()) {
      Object changed = *object;
      changed.visible = changed.hidden_by_group = false;
      object = std::make_shared<const Object>(std::move(changed));
    }
  }
  return show_objects(out, present);
}

Result<Document> lock_objects(const Document& document, std::span<const ObjectId> objects, bool locked) {
  return with_each(document, objects, [&](Object& changed) {
    const bool locks = is_locked(document, changed.group);
    changed.locked = locked || locks;
    changed.locked_by_group = !locked && locks;
  });
}

Result<Document> set_locked(const Document& document, ObjectId object, bool locked) {
  return lock_objects(document, std::span(&object, 1), locked);
}

Result<Document> set_transform(const Document& document, ObjectId object, const Similarity& transform) {
  return detail::change_object(document, object, true, [&](Object& changed) -> Result<Done> {
    const Result<Similarity> placed = detail::checked_transform(transform);
    if (!placed) return placed.error();
    changed.transform = *placed;
    return Done{};
  });
}

Result<Document> set_display(const Document& document, ObjectId object, const DisplaySettings& display) {
  return detail::change_object(document, object, false, [&](Object& changed) -> Result<Done> {
    if (const auto checked = detail::check_display(display); !checked) return checked.error();
    changed.display = display;
    return Done{};
  });
}

Document set_unit(const Document& document, Unit unit) {
  Document changed = document;
  changed.unit = unit;
  return changed;
}

Result<Document> set_source(const Document& document, ObjectId object, Source source) {
  return detail::change_object(document, object, true, [&](Object& changed) -> Result<Done> {
    changed.source = std::move(source);
    return Done{};
  });
}

}  // namespace hariko
