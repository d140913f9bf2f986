#include "core/document/edits/edit_pictures.hpp"

#include <cmath>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"

namespace hariko {

namespace {

Message no_picture(const Object& object) {
  return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not a reference picture.",
                    "Select a reference picture.", element_of(object.id));
}

/// Calls change(Object&, PictureSource&) -> Result<Done> on a copy, and checks the result.
template <class Change>
Result<Document> change_picture(const Document& document, ObjectId id, bool unlocked_only, Change&& change) {
  return detail::change_object(document, id, unlocked_only, [&](Object& object) -> Result<Done> {
    auto* picture = std::get_if<PictureSource>(&object.source);
    if (!picture) return no_picture(object);
    if (const Result<Done> done = change(object, *picture); !done) return done.error();
    return check_picture(*picture);
  });
}

template <class Change>
Document with_picture_paths(const Document& document, Change&& change) {
  Document out = document;
  for (auto& object : out.objects) {
    const PictureSource* picture = object->picture();
    if (!picture || picture->packed()) continue;
    std::string path = change(*picture);
    if (path == picture->path) continue;
    Object changed = *object;
    std::get<PictureSource>(changed.source).path = std::move(path);
    object = std::make_shared<const Object>(std::move(changed));
  }
  return out;
}

/// Whether a file can hold the path: names of folders may be other bytes than UTF-8.
bool is_storable(PictureSource picture, const std::string& path) {
  picture.path = path;
  return check_picture(picture).ok();
}

/// Path of a picture from a folder, as a file can hold it: if need be the picture's name alone.
std::string path_from(const std::filesystem::path& folder, const PictureSource& picture) {
  const std::filesystem::path path(picture.path);
  const std::filesystem::path relative =
      path.is_absolute() ? path.lexically_relative(folder) : std::filesystem::path();
  std::string out = (relative.empty() ? path : relative).generic_string();
  return is_storable(picture, out) ? out : path.filename().generic_string();
}

}  // namespace

Result<Added> add_picture(const Document& document, std::string name, PictureSource picture,
                          const Similarity& transform) {
  if (const auto checked = check_picture(picture); !checked) return checked.error();
  auto added = add_object(document, std::move(name), std::move(picture), transform);
  if (!added) return added;
  if (const auto checked = check_packed_pictures(added->document); !checked) return checked.error();
  return added;
}

Result<Document> set_picture_look(const Document& document, ObjectId id, const PictureLook& look) {
  return change_picture(document, id, false, [&](Object&, PictureSource& picture) -> Result<Done> {
    picture.look = look;
    return Done{};
  });
}

Result<Document> face_picture(const Document& document, ObjectId id, PictureSide side) {
  return change_picture(document, id, true, [&](Object& object, PictureSource& picture) -> Result<Done> {
    if (faced_side(object.transform.rotation) != side) object.transform.rotation = facing(side);
    if (picture.look.only_from) picture.look.only_from = side;
    return Done{};
  });
}

Result<Document> scale_picture(const Document& document, ObjectId id, const Vector3& a, const Vector3& b,
                               double length) {
  return change_picture(document, id, true, [&](Object& object, PictureSource&) -> Result<Done> {
    const double now = (b - a).norm();
    const double factor = length / now;
    if (!(now > 0) || !(length > 0) || !std::isfinite(factor) || !(factor > 0))
      return make_error(e_picture_invalid, "Two points at the same place have no distance to be set.",
                        "Click two points apart, and type a length above zero.", element_of(id));
    Similarity scaled = object.transform;
    scaled.scale *= factor;
    scaled.translation = a + factor * (scaled.translation - a);
    const auto placed = detail::checked_transform(scaled);
    if (!placed) return placed.error();
    object.transform = *placed;
    return Done{};
  });
}

Result<Document> set_picture_file(const Document& document, ObjectId id, const PictureFile& file) {
  auto changed = change_picture(document, id, false, [&](Object&, PictureSource& picture) -> Result<Done> {
    picture.path = file.path;
    picture.bytes = file.bytes;
    picture.columns = file.columns;
    picture.rows = file.rows;
    return Done{};
  });
  if (!changed) return changed;
  if (const auto checked = check_packed_pictures(*changed); !checked) return checked.error();
  return changed;
}

std::size_t packed_picture_bytes(const Document& document) {
  std::size_t bytes = 0;
  for (const auto& object : document.objects)
    if (const PictureSource* picture = object->picture()) bytes += picture->bytes->size();
  return bytes;
}

Result<Done> check_packed_pictures(const Document& document) {
  const std::size_t bytes = packed_picture_bytes(document);
  if (bytes <= max_packed_pictures) return Done{};
  constexpr std::size_t mebi = std::size_t(1) << 20;
  return make_error(e_pictures_too_large,
                    "The pictures in the document would have " + std::to_string((bytes + mebi - 1) / mebi) +
                        " MiB; it has room for " + std::to_string(max_packed_pictures / mebi) + ".",
                    "Keep large pictures linked: the document then names their files.");
}

Document with_relative_pictures(const Document& document, const std::filesystem::path& folder) {
  if (folder.empty() || folder.is_relative()) return document;
  return with_picture_paths(document,
                            [&](const PictureSource& picture) { return path_from(folder, picture); });
}

Document with_storable_pictures(const Document& document, const std::filesystem::path& folder) {
  return with_picture_paths(document, [&](const PictureSource& picture) {
    return is_storable(picture, picture.path) ? picture.path : path_from(folder, picture);
  });
}

Document with_absolute_pictures(const Document& document, const std::filesystem::path& folder) {
  if (folder.empty() || folder.is_relative()) return document;
  return with_picture_paths(document, [&](const PictureSource& picture) {
    const std::filesystem::path path(picture.path);
    return (path.is_absolute() ? path : (folder / path).lexically_normal()).generic_string();
  });
}

}  // namespace hariko
