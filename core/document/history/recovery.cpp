#include "core/document/history/recovery.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/files/file_uri.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/format/format.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view copy_begin = "copy-", copy_end = ".hariko";
constexpr const char* note_name = "recovery.json";
constexpr int note_version = 1;
constexpr std::uint64_t largest_note = 1 << 16;  // bytes

struct CopyFile {
  std::uint64_t generation = 0;
  fs::path path;
};

std::optional<std::uint64_t> generation_of(const std::string& name) {
  if (!name.starts_with(copy_begin) || !name.ends_with(copy_end)) return {};
  const char* first = name.data() + copy_begin.size();
  const char* last = name.data() + name.size() - copy_end.size();
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last) return {};
  return number;
}

/// Copies in the folder, latest first.
std::vector<CopyFile> copies_in(const fs::path& folder) {
  std::vector<CopyFile> copies;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (const auto generation = generation_of(it->path().filename().native()))
      copies.push_back({*generation, it->path()});
  std::sort(copies.begin(), copies.end(),
            [](const CopyFile& a, const CopyFile& b) { return a.generation > b.generation; });
  return copies;
}

fs::path copy_path(const fs::path& folder, std::uint64_t generation) {
  return folder / (std::string(copy_begin) + std::to_string(generation) + std::string(copy_end));
}

/// FNV-1a hash, to detect a copy that a failing disk has changed.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return sum;
}

/// Note of a folder with the checksum of the copy it was written for.
struct NotedCopy {
  RecoveryNote note;
  std::uint64_t generation = 0, bytes_sum = 0;
};

std::string text_of(const NotedCopy& noted) {
  JsonWriter json(2);
  json.object([&] {
    json.member("hariko_recovery", note_version);
    json.member("copy", noted.generation);
    json.member("checksum", noted.bytes_sum);
    json.member("written_at", noted.note.written_at);
    if (!noted.note.original.empty()) json.member("original", file_uri(noted.note.original));
    if (const auto& stamp = noted.note.original_stamp)
      json.object("original_stamp", [&] {
        json.member("size", stamp->size);
        json.member("modified", stamp->modified);
        json.member("device", stamp->device);
        json.member("inode", stamp->inode);
      });
  });
  return json.take() + "\n";
}

template <class Number>
Number number_in(const Json& json, const char* name) {
  const auto it = json.find(name);
  return it != json.end() && it->is_number_integer() ? it->get<Number>() : Number{};
}

std::optional<NotedCopy> read_note(const fs::path& folder) {
  const auto text = read_file(folder / note_name, largest_note);
  if (!text) return {};
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object() || number_in<int>(json, "hariko_recovery") != note_version) return {};
  NotedCopy noted;
  noted.generation = number_in<std::uint64_t>(json, "copy");
  noted.bytes_sum = number_in<std::uint64_t>(json, "checksum");
  noted.note.written_at = number_in<std::int64_t>(json, "written_at");
  if (const auto it = json.find("original"); it != json.end() && it->is_string())
    noted.note.original = path_of_uri(it->get<std::string>()).value_or(fs::path());
  if (const auto it = json.find("original_stamp"); it != json.end() && it->is_object())
    noted.note.original_stamp =
        FileStamp{number_in<std::uint64_t>(*it, "size"), number_in<std::int64_t>(*it, "modified"),
                  number_in<std::uint64_t>(*it, "device"), number_in<std::uint64_t>(*it, "inode")};
  return noted;
}

}  // namespace

Result<Done> write_recovery(const fs::path& folder, const Document& document, const RecoveryNote& note,
                            FileLayer& layer) {
  const std::vector<CopyFile> older = copies_in(folder);
  // No number is used twice, otherwise an old note could be taken for that of a new copy.
  const std::optional<NotedCopy> noted_before = read_note(folder);
  const std::uint64_t generation =
      1 + std::max(older.empty() ? 0 : older.front().generation, noted_before ? noted_before->generation : 0);
  const std::string text = write_document(with_storable_pictures(document, note.original.parent_path()));
  const auto write_note = [&, about = text_of({note, generation, checksum(text)})] {
    return write_file_atomic(folder / note_name, about, layer);
  };
  const auto write_copy = [&] { return write_file_atomic(copy_path(folder, generation), text, layer); };
  // The first note is written before its copy, because a copy without any note has no known original file.
  auto first = noted_before ? write_copy() : write_note();
  if (!first) return first;
  auto second = noted_before ? write_note() : write_copy();
  if (!second) return second;
  for (const CopyFile& copy : older)
    layer.remove(copy.path.native());  // a copy that cannot be removed is older and never read
  return Done{};
}

Result<RecoveryCopy> read_recovery(const fs::path& folder) {
  const std::optional<NotedCopy> noted = read_note(folder);
  const std::vector<CopyFile> copies = copies_in(folder);
  if (copies.empty())
    return make_error(e_no_recovery,
                      "There is nothing to recover in " + sanitized_utf8(folder.string()) + ".");
  std::string why;
  for (const CopyFile& copy : copies) {
    const auto text = read_file(copy.path, max_document_bytes);
    if (!text) {
      why = text.error().text;
      continue;
    }
    if (noted && noted->generation == copy.generation && noted->bytes_sum != checksum(*text)) {
      why = "its checksum is wrong";
      continue;
    }
    Result<Document> document = read_document(*text);
    if (document)
      return RecoveryCopy{std::move(document).value(), noted ? noted->note : RecoveryNote{}, copy.path};
    why = document.error().text;
  }
  return make_error(e_recovery_damaged,
                    "The recovery copy in " + sanitized_utf8(folder.string()) + " is damaged: " + why,
                    "Open the file that was saved last instead.");
}

bool has_recovery(const fs::path& folder) {
  return !copies_in(folder).empty();
}

std::optional<RecoveryNote> read_recovery_note(const fs::path& folder) {
  const auto noted = read_note(folder);
  if (!noted) return {};
  return noted->note;
}

Result<Done> remove_recovery(const fs::path& folder, FileLayer& layer) {
  std::vector<fs::path> files;
  for (CopyFile& copy : copies_in(folder)) files.push_back(std::move(copy.path));
  files.push_back(folder / note_name);
  for (const fs::path& file : files) {
    const int removed = layer.remove(file.native());
    if (removed < 0 && removed != -ENOENT)
      return make_error(e_file_write, "The recovery copy " + sanitized_utf8(file.string()) +
                                          " cannot be removed: " + std::generic_category().message(-removed) +
                                          ".");
  }
  return Done{};
}

}  // namespace hariko
