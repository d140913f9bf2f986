#include "app/jobs/reference_jobs.hpp"

#include <utility>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "render/reference_image.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/reference_pictures.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

std::string name_of_file(const fs::path& path) {
  return sanitized_utf8(path.filename().string());
}

fs::path normal_path(const fs::path& path) {
  std::error_code unknown;
  const fs::path absolute = fs::absolute(path, unknown);
  return (unknown ? path : absolute).lexically_normal();
}

/// Name for a picture's object: that of the file without its ending.
std::string object_name(const fs::path& path) {
  std::string name = sanitized_utf8(path.stem().string(), Object::max_name_length - 8);
  return check_name(name).ok() ? name : std::string(translatable("Picture"));
}

}  // namespace

ReferenceJobs::Read ReferenceJobs::read(const fs::path& path, bool keep_bytes) {
  Read out{normal_path(path)};
  Result<std::string> bytes = read_file(out.path, largest_picture_file);
  if (!bytes) {
    out.file = bytes.error();
    return out;
  }
  const Result<PixelSize> size = reference_size(*bytes);
  if (!size) {
    Message error = size.error();
    error.text = name_of_file(out.path) + ": " + error.text;
    out.file = error;
    return out;
  }
  PictureFile file{out.path.generic_string(), {}, std::uint32_t(size->width), std::uint32_t(size->height)};
  if (keep_bytes) file.bytes = std::move(bytes).value();
  out.file = std::move(file);
  return out;
}

void ReferenceJobs::add(const std::vector<fs::path>& files) {
  if (files.empty()) return;
  begin_document(editor_);
  work_.run(
      Phrase(translatable("Reading {0}"), {name_of_file(files.front())}),
      [files](const CancelToken&) {
        std::vector<Read> out;
        for (const fs::path& file : files) out.push_back(read(file, false));
        return out;
      },
      [this, camera = editor_.layout.active_view().goal(), view = editor_.viewport,
       documents = editor_.documents](const std::vector<Read>& read) {
        if (documents == editor_.documents) return take(read, camera, view);
        editor_.warn({"{0} was not added, as another document was opened meanwhile.",
                      {name_of_file(read.front().path)}});
      });
}

void ReferenceJobs::take(const std::vector<Read>& files, const Camera& camera, PixelSize view) {
  if (!editor_.has_document) return;
  if (editor_.history.in_gesture()) editor_.cancel_preview();
  Document document = editor_.history.current();
  std::vector<ObjectId> made;
  double right = 0;
  for (const Read& read : files) {
    if (!read.file) {
      editor_.notify(read.file.error());
      continue;
    }
    PicturePlace place = place_for_picture(camera, view, {int(read.file->columns), int(read.file->rows)});
    PictureSource source;
    source.path = read.file->path;
    source.columns = read.file->columns;
    source.rows = read.file->rows;
    source.width = place.width;
    source.look = place.look;
    constexpr double gap = 0.05;  // relative to the width
    if (!made.empty()) right += place.width / 2;
    place.transform.translation += right * (place.transform.rotation * Vector3::UnitX());
    right += place.width * (0.5 + gap);
    auto added = add_picture(document, free_name(document, object_name(read.path)), std::move(source),
                             place.transform);
    if (!added) {
      editor_.notify(added.error());
      continue;
    }
    document = std::move(added->document);
    made.push_back(added->id);
  }
  if (made.empty() || !editor_.commit(document, translatable("Add reference picture"))) return;
  editor_.mode = ElementMode::object;
  editor_.selection.clear_elements();
  editor_.selection.clear_objects();
  for (const ObjectId id : made) editor_.selection.select({id, element_of(id)}, Selection::How::add);
  editor_.selection.active = made.front();
  log_("picture_added", files.front().path);
}

void ReferenceJobs::take_files(const std::vector<std::pair<ObjectId, Read>>& files, const std::string& step,
                               const char* log) {
  if (editor_.history.in_gesture()) editor_.cancel_preview();
  Result<Document> result = editor_.history.current();
  for (const auto& [id, read] : files) {
    if (!result || !result->find(id)) continue;
    if (!read.file) return editor_.notify(read.file.error());
    result = set_picture_file(*result, id, *read.file);
  }
  if (editor_.commit(result, step)) log_(log, files.empty() ? fs::path() : files.front().second.path);
}

void ReferenceJobs::pack(const std::vector<ObjectId>& pictures) {
  std::vector<std::pair<ObjectId, fs::path>> wanted;
  for (const ObjectId id : pictures) {
    const Object* object = editor_.history.current().find(id);
    if (object && object->picture() && !object->picture()->packed())
      wanted.emplace_back(id, object->picture()->path);
  }
  if (wanted.empty()) return;
  work_.run(
      translatable("Packing pictures"),
      [wanted](const CancelToken&) {
        std::vector<std::pair<ObjectId, Read>> out;
        for (const auto& [id, path] : wanted) {
          out.emplace_back(id, read(path, true));
          // A packed picture has no folder: only the name is kept.
          if (Read& file = out.back().second; file.file) {
            PictureFile named = *file.file;
            named.path = file.path.filename().string();
            file.file = std::move(named);
          }
        }
        return out;
      },
      [this, documents = editor_.documents](const std::vector<std::pair<ObjectId, Read>>& read) {
        if (documents == editor_.documents) take_files(read, translatable("Pack picture"), "picture_packed");
      });
}

void ReferenceJobs::unpack(ObjectId picture, const fs::path& file) {
  const Object* object = editor_.history.current().find(picture);
  if (!object || !object->picture() || !object->picture()->packed()) return;
  work_.run(
      Phrase(translatable("Saving {0}"), {name_of_file(file)}),
      [path = normal_path(file), bytes = object->picture()->bytes](const CancelToken&) {
        if (auto written = write_file_atomic(path, *bytes); !written) return Read{path, written.error()};
        return read(path, false);
      },
      [this, picture, documents = editor_.documents](const Read& read) {
        if (documents == editor_.documents)
          take_files({{picture, read}}, translatable("Unpack picture"), "picture_unpacked");
      });
}

void ReferenceJobs::replace(ObjectId picture, const fs::path& file) {
  work_.run(
      Phrase(translatable("Reading {0}"), {name_of_file(file)}),
      [file](const CancelToken&) { return read(file, false); },
      [this, picture, documents = editor_.documents](const Read& read) {
        if (documents == editor_.documents)
          take_files({{picture, read}}, translatable("Choose another picture"), "picture_replaced");
      });
}

void ReferenceJobs::find(const fs::path& file) {
  std::vector<std::pair<ObjectId, fs::path>> wanted;
  for (const ObjectId id : missing_pictures(editor_)) {
    const PictureSource& source = *editor_.document().find(id)->picture();
    const fs::path old(source.path);
    const bool same = wanted.empty() || old == editor_.document().find(wanted.front().first)->picture()->path;
    if (!source.packed()) wanted.emplace_back(id, same ? file : file.parent_path() / old.filename());
  }
  if (wanted.empty()) return;
  work_.run(
      translatable("Looking for pictures"),
      [wanted](const CancelToken&) {
        std::vector<std::pair<ObjectId, Read>> out;
        for (const auto& [id, path] : wanted) {
          std::error_code unknown;
          // Errors are reported for the chosen file; the others may be elsewhere.
          if (!out.empty() && !fs::is_regular_file(path, unknown)) continue;
          out.emplace_back(id, read(path, false));
        }
        return out;
      },
      [this, documents = editor_.documents](const std::vector<std::pair<ObjectId, Read>>& read) {
        if (documents == editor_.documents)
          take_files(read, translatable("Find missing pictures"), "pictures_found");
      });
}

}  // namespace hariko
