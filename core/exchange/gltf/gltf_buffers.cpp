#include "core/exchange/gltf/gltf_buffers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/exchange/gltf/gltf_container.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

using Json = nlohmann::json;

namespace {

std::size_t numbers_of(std::string_view type) {
  return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

}  // namespace

GltfAccessor GltfBuffers::accessor(std::uint64_t number, std::string_view type) {
  GltfAccessor out;
  out.place = numbered("accessors", number);
  const Json* found = fields_.entry(root_, "accessors", number);
  if (!found) return out;
  if (text_of(*found, "type") != type) fields_.fail(out.place, "Its type should be " + quote(type) + ".");
  const auto component = gltf_component(fields_.needed(*found, "componentType", out.place));
  if (!component) fields_.fail(out.place, "\"componentType\" is none of the format's.");
  out.component = component.value_or(GltfComponent::float32);
  out.count = fields_.needed(*found, "count", out.place);
  const Json* normalised = find(*found, "normalized");
  out.normalised = normalised && normalised->is_boolean() && normalised->get<bool>();
  const std::size_t numbers = numbers_of(type), row = numbers * gltf_size(out.component);
  const Json* sparse = find(*found, "sparse");
  const auto complete = complete_.find(number);
  if (complete == complete_.end()) {
    const bool stored = find(*found, "bufferView");  // else all rows are zeros (section 3.6.2)
    if (fields_.error() || (stored && !read_rows(*found, numbers, out))) return out;
    if (stored && !sparse) return out;
    // Two calls, as the product may overflow.
    auto error = collector_.reserve(out.count, 0);
    if (!error) error = collector_.reserve(out.count * (numbers - 1), 0);
    if (error) {
      fields_.fail(*std::move(error));
      return out;
    }
    std::string rows(out.count * row, '\0');
    for (std::uint64_t k = 0; !out.bytes.empty() && k < out.count; ++k)
      out.bytes.copy(rows.data() + k * row, row, k * out.stride);
    if (sparse) fill_in(*sparse, out, row, rows);
    complete_.emplace(number, std::move(rows));
  }
  out.bytes = complete_.at(number);
  out.stride = row;
  return out;
}

bool GltfBuffers::read_rows(const Json& found, std::size_t numbers, GltfAccessor& out) {
  const std::uint64_t view = fields_.needed(found, "bufferView", out.place);
  const std::uint64_t offset = fields_.whole(found, "byteOffset", out.place).value_or(0);
  if (fields_.error()) return false;
  out.bytes = view_bytes(view, out.stride);
  if (fields_.error()) return false;
  const std::size_t row = numbers * gltf_size(out.component);
  if (out.stride == 0) out.stride = row;
  if (out.stride < row) return fields_.fail(out.place, "Its rows overlap.");
  out.bytes.remove_prefix(std::min<std::uint64_t>(offset, out.bytes.size()));
  if (const auto error = check_rows(out, numbers)) return fields_.fail(*error);
  return true;
}

/// Replaces rows, each of `row` bytes, by those of a sparse accessor (section 3.6.2.3).
void GltfBuffers::fill_in(const Json& sparse, const GltfAccessor& out, std::size_t row, std::string& whole) {
  const std::string place = out.place + ".sparse";
  const std::uint64_t count = fields_.needed(sparse, "count", place);
  const Json *indices = find(sparse, "indices"), *values = find(sparse, "values");
  if (!indices || !values) fields_.fail(place, "\"indices\" or \"values\" are missing.");
  if (fields_.error()) return;
  GltfAccessor numbers, rows;
  numbers.place = place + ".indices";
  rows.place = place + ".values";
  numbers.count = rows.count = count;
  const auto component = gltf_component(fields_.needed(*indices, "componentType", numbers.place));
  numbers.component = component.value_or(GltfComponent::float32);
  if (numbers.component != GltfComponent::uint8 && numbers.component != GltfComponent::uint16 &&
      numbers.component != GltfComponent::uint32)
    fields_.fail(numbers.place, "Numbers of rows are unsigned whole numbers.");
  rows.component = out.component;
  if (fields_.error() || !read_rows(*indices, 1, numbers) ||
      !read_rows(*values, row / gltf_size(out.component), rows))
    return;
  const auto places = gltf_indices(numbers, out.count);
  if (!places) {
    fields_.fail(places.error());
    return;
  }
  for (std::uint64_t k = 0; k < count; ++k)
    rows.bytes.copy(whole.data() + (*places)[k] * row, row, k * rows.stride);
}

/// Bytes of a buffer view. Sets `stride` to 0 where the file gives none.
std::string_view GltfBuffers::view_bytes(std::uint64_t number, std::uint64_t& stride) {
  const std::string place = numbered("bufferViews", number);
  const Json* view = fields_.entry(root_, "bufferViews", number);
  if (!view) return {};
  const std::uint64_t buffer = fields_.needed(*view, "buffer", place),
                      length = fields_.needed(*view, "byteLength", place);
  const std::uint64_t offset = fields_.whole(*view, "byteOffset", place).value_or(0);
  stride = fields_.whole(*view, "byteStride", place).value_or(0);
  if (stride > 65536) fields_.fail(place, "\"byteStride\" is too large.");
  if (fields_.error()) return {};
  const std::string_view bytes = buffer_bytes(buffer);
  if (fields_.error()) return {};
  if (offset <= bytes.size() && length <= bytes.size() - offset) return bytes.substr(offset, length);
  fields_.fail(make_error(
      e_truncated, place + ": It ends behind the " + std::to_string(bytes.size()) + " bytes of its buffer.",
      "The file was cut off: copy or export it again."));
  return {};
}

std::string_view GltfBuffers::buffer_bytes(std::uint64_t number) {
  const std::string place = numbered("buffers", number);
  if (!fields_.entry(root_, "buffers", number)) return {};
  Json& buffer = root_["buffers"][number];
  const std::uint64_t length = fields_.needed(buffer, "byteLength", place);
  std::string_view bytes;
  if (find(buffer, "uri")) {
    const std::string* content = buffer_content(number, buffer, place);
    if (content) bytes = *content;
  } else if (number == 0 && binary_) {
    bytes = *binary_;
  } else {
    fields_.fail(place, "It has no data.");
  }
  if (fields_.error()) return {};
  if (length <= bytes.size()) return bytes.substr(0, length);
  fields_.fail(make_error(e_truncated,
                          place + ": " + std::to_string(length) + " bytes are promised, but only " +
                              std::to_string(bytes.size()) + " are there.",
                          "The file was cut off: copy or export it again."));
  return {};
}

const std::string* GltfBuffers::buffer_content(std::uint64_t number, Json& buffer, const std::string& place) {
  if (const auto found = inside_.find(number); found != inside_.end()) return &found->second;
  if (!buffer["uri"].is_string()) {
    fields_.fail(place, "\"uri\" should be text.");
    return nullptr;
  }
  std::string& uri = buffer["uri"].get_ref<std::string&>();
  auto data = data_of_uri(uri);
  if (!data) {
    fields_.fail(data.error());
    return nullptr;
  }
  if (!*data) return file_content(uri);
  uri.clear();  // frees memory: it may be most of the file
  uri.shrink_to_fit();
  return &inside_.emplace(number, *std::move(data).value()).first->second;
}

const std::string* GltfBuffers::file_content(const std::string& uri) {
  const auto paths = buffer_paths(uri);
  if (!paths) {
    fields_.fail(paths.error());
    return nullptr;
  }
  std::optional<Message> error;
  for (const std::string& path : *paths) {
    if (const auto found = files_.find(path); found != files_.end()) return &found->second;
    auto content = beside_ ? beside_(path)
                           : Result<std::string>(make_error(
                                 e_file_open, "The data of the file lie beside it, in " + quote(path) + ".",
                                 "Export the model as .glb."));
    if (content) {
      collector_.add_bytes(content->size());
      return &files_.emplace(path, std::move(content).value()).first->second;
    }
    if (!error || error->code == e_file_open) error = content.error();
  }
  fields_.fail(*std::move(error));
  return nullptr;
}

}  // namespace hariko
