#include "app/engines/reference_loader.hpp"

#include <set>
#include <system_error>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "render/reference_image.hpp"

namespace hariko {

namespace {

/// Decoded picture, or the reason why there is none; without `decode` only its existence is checked.
ReferenceView read_reference(const std::string& path, const Shared<std::string>& packed, bool decode,
                             const CancelToken& cancel) {
  ReferenceView view;
  std::string file;
  if (packed->empty()) {
    std::error_code unknown;
    if (std::filesystem::path(path).is_relative()) {
      view.error = make_error(
          e_file_open, "The picture " + sanitized_utf8(path) + " is named without the folder it lies in.",
          "Save the document, or find the picture again.");
      return view;
    }
    if (!decode && std::filesystem::is_regular_file(path, unknown)) return view;
    Result<std::string> read = read_file(path, largest_picture_file);
    if (!read) {
      view.error = read.error();
      return view;
    }
    file = std::move(read).value();
  }
  if (!decode) return view;
  auto image = decode_reference(packed->empty() ? file : *packed, cancel);
  if (image)
    view.image = std::make_shared<const ReferenceImage>(std::move(image).value());
  else
    view.error = image.error();
  return view;
}

}  // namespace

ReferenceLoader::ReferenceLoader(Editor& editor, std::function<void()> wake)
    : editor_(editor), lane_(std::move(wake)) {}

ReferenceLoader::Key ReferenceLoader::key_of(const PictureSource& source) {
  if (source.packed()) return {std::string(), source.bytes.get()};
  return {source.path, nullptr};
}

void ReferenceLoader::request(const Key& key, Entry& entry) {
  entry.job = next_++;
  lane_.submit(
      entry.job,
      [this, key, path = key.first, bytes = entry.bytes, job = entry.job,
       decode = entry.shown](const CancelToken& cancel) -> WorkLane::Publication {
        auto view = std::make_shared<const ReferenceView>(read_reference(path, bytes, decode, cancel));
        return [this, key, job, view] {
          const auto found = entries_.find(key);
          if (found == entries_.end() || found->second.job != job) return;
          found->second.view = *view;
        };
      },
      WorkLane::Running::finish);
}

void ReferenceLoader::sync() {
  if (std::exchange(document_, editor_.documents) != editor_.documents ||
      std::exchange(editor_.references.read_again, false)) {
    for (const auto& [key, entry] : entries_) lane_.cancel(entry.job);
    entries_.clear();
  }
  std::map<Key, bool> wanted;  // and whether it is shown
  const auto& objects = editor_.document().objects;
  for (const auto& object : objects) {
    const PictureSource* source = editor_.has_document ? object->picture() : nullptr;
    if (!source) continue;
    bool& shows = wanted[key_of(*source)];
    shows = shows || object->visible;
    const auto [place, fresh] = entries_.try_emplace(key_of(*source));
    if (fresh) place->second.bytes = source->bytes;
  }
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (wanted.contains(entry->first)) {
      ++entry;
      continue;
    }
    lane_.cancel(entry->second.job);
    entry = entries_.erase(entry);
  }
  for (const auto& [key, shows] : wanted) {
    Entry& entry = entries_.at(key);
    if (entry.job != 0 && entry.shown == shows) continue;
    if (entry.job != 0) lane_.cancel(entry.job);
    entry.shown = shows;
    entry.view.image.reset();
    if (shows || entry.job == 0) request(key, entry);
  }
  show();
  if (lane_.idle()) tell_missing();
}

void ReferenceLoader::show() {
  auto& views = editor_.references.views;
  std::set<ObjectId> seen;
  for (const auto& object : editor_.document().objects) {
    const PictureSource* source = editor_.has_document ? object->picture() : nullptr;
    if (!source) continue;
    seen.insert(object->id);
    views[object->id] = entries_.at(key_of(*source)).view;
    if (!object->visible) views[object->id].image.reset();
  }
  std::erase_if(views, [&](const auto& view) { return !seen.contains(view.first); });
}

void ReferenceLoader::tell_missing() {
  std::size_t count = 0;
  std::string names;
  constexpr std::size_t most_names = 3;
  for (auto& [key, entry] : entries_) {
    if (!entry.view.error || std::exchange(entry.told, true)) continue;
    ++count;
    if (count > most_names) continue;
    const std::string name = std::filesystem::path(key.first).filename().string();
    names += (count > 1 ? ", " : "") + sanitized_utf8(name.empty() ? std::string("?") : name);
  }
  if (count == 0) return;
  if (count > most_names) names += ", \u2026";
  editor_.warn({"Reference pictures that cannot be shown: {0} ({1})", {std::to_string(count), names}},
               "File > Reference pictures > Find missing pictures shows where they are.");
}

}  // namespace hariko
