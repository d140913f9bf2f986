#include "core/exchange/gltf/gltf_container.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "core/base/files/file_uri.hpp"
#include "core/base/text/base64.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

// Constants of the glTF 2.0 specification, section 4 (GLB).
constexpr std::string_view magic = "glTF";

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

Message truncated(std::size_t size, const std::string& where) {
  return make_error(e_truncated, "Byte " + std::to_string(size) + ": The file ends inside " + where + ".",
                    remedy_cut);
}

}  // namespace

bool looks_like_glb(std::string_view bytes) {
  return bytes.starts_with(magic);
}

bool looks_like_gltf_text(std::string_view bytes) {
  constexpr std::string_view blanks = " \t\r\n", mark = "\xEF\xBB\xBF", member = "\"asset\"";
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
  const auto next = [&](std::size_t from) {
    const std::size_t at = bytes.find_first_not_of(blanks, from);
    return at == std::string_view::npos ? bytes.size() : at;
  };
  const auto is = [&](std::size_t at, char c) { return at < bytes.size() && bytes[at] == c; };
  if (!is(next(0), '{')) return false;
  for (std::size_t at = bytes.find(member); at != std::string_view::npos; at = bytes.find(member, at + 1)) {
    const std::size_t colon = next(at + member.size());
    if (is(colon, ':') && is(next(colon + 1), '{')) return true;
  }
  return false;
}

Result<GltfChunks> gltf_chunks(std::string_view bytes) {
  if (bytes.empty()) return make_error(e_empty, "The file is empty.", "Export the file again.");
  if (!looks_like_glb(bytes)) return GltfChunks{bytes, {}};
  if (bytes.size() < glb_header_size + glb_chunk_header_size) return truncated(bytes.size(), "its header");
  if (const std::uint32_t version = word_at(bytes, 4); version != 2)
    return make_error(e_format_unknown,
                      "This is version " + std::to_string(version) + " of glTF, and only version 2 is read.",
                      "Export the model as glTF 2.0.");
  const std::uint32_t length = word_at(bytes, 8);
  if (length > bytes.size())
    return make_error(e_truncated,
                      "Byte " + std::to_string(bytes.size()) + ": The header promises " +
                          std::to_string(length) + " bytes.",
                      remedy_cut);
  std::string_view rest = bytes.substr(0, length);
  if (rest.size() < glb_header_size + glb_chunk_header_size)
    return make_error(e_parse, "Byte 8: The length of the file is too small.", remedy_correct);
  rest.remove_prefix(glb_header_size);
  GltfChunks chunks;
  bool first = true;
  while (rest.size() >= glb_chunk_header_size) {
    const std::uint32_t size = word_at(rest, 0), kind = word_at(rest, 4);
    if (first != (kind == json_chunk))
      return make_error(e_parse, "The first part of the file, and no other, must be its description in JSON.",
                        remedy_correct);
    rest.remove_prefix(glb_chunk_header_size);
    if (size > rest.size()) return truncated(bytes.size(), first ? "its description" : "its binary data");
    if (first) chunks.json = rest.substr(0, size);
    if (kind == binary_chunk && !chunks.binary) chunks.binary = rest.substr(0, size);
    rest.remove_prefix(size);
    first = false;
  }
  return chunks;
}

Result<std::optional<std::string>> data_of_uri(std::string_view uri) {
  if (!uri.starts_with("data:")) return std::optional<std::string>();
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
    return make_error(e_parse, "A buffer inside the file is not written in base64.", remedy_correct);
  // Some programs escape what base64 and URIs both use.
  std::string_view text = uri.substr(comma + 1);
  const auto plain = text.find('%') == std::string_view::npos ? std::nullopt : without_escapes(text);
  if (plain) text = *plain;
  Base64Bytes data = from_base64(text);
  if (data.wrong)
    return make_error(e_parse,
                      "A buffer inside the file is no base64 text: character " +
                          std::to_string(*data.wrong + 1) + " is " + quote(text.substr(*data.wrong, 1)) + ".",
                      remedy_correct);
  return std::optional(std::move(data.bytes));
}

Result<std::vector<std::string>> buffer_paths(std::string_view uri) {
  // Some programs write names without encoding them: "10%.bin" is not a valid URI, and "a%20b.bin" may be a
  // file's name. Others write folders with backslashes, which no URI has.
  std::vector<std::string> out;
  const auto decoded = without_escapes(uri);
  std::string slashes = decoded.value_or(std::string(uri));
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  for (const auto& text : {decoded, std::optional(std::string(uri)), std::optional(slashes)}) {
    const std::filesystem::path path = std::filesystem::path(text.value_or("")).lexically_normal();
    // A scheme has at least two letters (one letter is a drive) and comes before any slash.
    const std::size_t colon = uri.find(':');
    const bool elsewhere = colon != std::string_view::npos && colon >= 2 && uri.find('/') > colon;
    if (path.empty() || text->find('\0') != std::string::npos || elsewhere || path.is_absolute() ||
        *path.begin() == ".." || !path.has_filename() || path == ".")
      continue;
    if (std::find(out.begin(), out.end(), path.native()) == out.end()) out.push_back(path.native());
  }
  if (out.empty())
    return make_error(e_file_open,
                      "The data of the file lie at " + quote(uri) + ", which is not in its folder.",
                      "Put all parts in one folder, or export the model as .glb.");
  return out;
}

}  // namespace hariko
