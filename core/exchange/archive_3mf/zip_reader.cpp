#include "core/exchange/archive_3mf/zip_reader.hpp"

#include <zip.h>

#include <algorithm>
#include <vector>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

struct ZipReader::Archive {
  zip_t* zip = nullptr;
};

namespace {

constexpr std::uint64_t always_accepted = std::uint64_t{64} << 20, most_per_byte = 100;

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

Message damaged(const std::string& name) {
  return make_error(e_parse, "The part " + quote(name) + " cannot be unpacked.",
                    "Copy or export the file again, without a password.");
}

}  // namespace

void ZipReader::Close::operator()(Archive* archive) const {
  if (archive->zip) zip_discard(archive->zip);
  delete archive;
}

Result<ZipReader> ZipReader::open(std::string_view bytes) {
  ZipReader out;
  out.archive_.reset(new Archive);
  out.limit_ = always_accepted + most_per_byte * bytes.size();
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source) out.archive_->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (source && !out.archive_->zip) zip_source_free(source);
  zip_error_fini(&error);
  if (out.archive_->zip) return out;
  return make_error(e_truncated, "The file is no whole zip archive.",
                    "The file was cut off: copy or export it again.");
}

/// Index of a part, negative where there is none. Some programs write the folders of names with backslashes.
std::int64_t ZipReader::locate(const std::string& name) const {
  const std::int64_t found = zip_name_locate(archive_->zip, name.c_str(), ZIP_FL_NOCASE);
  if (found >= 0 || name.find('/') == std::string::npos) return found;
  std::string other = name;
  std::replace(other.begin(), other.end(), '/', '\\');
  return zip_name_locate(archive_->zip, other.c_str(), ZIP_FL_NOCASE);
}

bool ZipReader::has(const std::string& name) const {
  return locate(name) >= 0;
}

std::uint64_t ZipReader::size(const std::string& name) const {
  zip_stat_t status;
  const std::int64_t index = locate(name);
  const bool known = index >= 0 &&
                     zip_stat_index(archive_->zip, static_cast<zip_uint64_t>(index), 0, &status) == 0 &&
                     (status.valid & ZIP_STAT_SIZE) != 0;
  return known ? status.size : 0;
}

Result<Done> ZipReader::unpack(const std::string& name, const Sink& sink) {
  const std::int64_t index = locate(name);
  if (index < 0)
    return make_error(e_parse, "The part " + quote(name) + " is missing.",
                      "Correct the file, or export it again.");
  const std::unique_ptr<zip_file_t, CloseFile> file(
      zip_fopen_index(archive_->zip, static_cast<zip_uint64_t>(index), 0));
  if (!file) return damaged(name);
  std::vector<char> piece(65536);
  for (;;) {
    // The last read finds the end and verifies the checksum.
    const zip_int64_t count = zip_fread(file.get(), piece.data(), piece.size());
    if (count < 0) return damaged(name);
    if (count == 0) return Done{};
    unpacked_ += static_cast<std::uint64_t>(count);
    if (unpacked_ > limit_)
      return make_error(e_limit,
                        "The file grows to more than " + std::to_string(most_per_byte) +
                            " times its size when it is unpacked.",
                        "Export the model again, or as another format.");
    if (!sink({piece.data(), static_cast<std::size_t>(count)})) return Done{};
  }
}

}  // namespace hariko
