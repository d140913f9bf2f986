#include "core/exchange/read_gltf.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/exchange/gltf_accessor.hpp"
#include "core/exchange/gltf_container.hpp"
#include "core/exchange/gltf_fields.hpp"
#include "core/exchange/point_welder.hpp"
#include "core/exchange/remedies.hpp"
#include "core/exchange/scene_collector.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

using Json = nlohmann::json;

constexpr double millimetres_per_metre = 1000;

// A value takes at least two characters and about fifty times its text in memory.
constexpr std::size_t max_values = 5'000'000;
constexpr int max_depth = 64;

/// Extensions that a file may require and that no shape depends on, by how their names begin. Quantized
/// positions are read like others.
constexpr std::array harmless_extensions{"KHR_materials_", "KHR_texture_",   "EXT_texture_",
                                         "MSFT_texture_",  "KHR_lights_",    "EXT_lights_",
                                         "KHR_xmp",        "KHR_animation_", "KHR_mesh_quantization"};

bool is_harmless(const std::string& extension) {
  return std::any_of(harmless_extensions.begin(), harmless_extensions.end(),
                     [&](const char* start) { return extension.starts_with(start); });
}

/// The document's z is the file's y, and the file is in metres.
Placement from_file_space() {
  Placement out;
  out.linear << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  out.linear *= millimetres_per_metre;
  return out;
}

/// Triangles over the corners of a primitive; `mode` is one of the three that have any (section 3.7.2.1).
std::vector<std::array<Index, 3>> triangles_of(const std::vector<Index>& corners, std::uint64_t mode) {
  std::vector<std::array<Index, 3>> out;
  if (mode == 4) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      out.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return out;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (mode == 5)
      out.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    else
      out.push_back({corners[i + 1], corners[i + 2], corners[0]});
  }
  return out;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const ReadLimits& limits, const FileBeside& beside)
      : bytes_(bytes), limits_(limits), beside_(beside), collector_(limits) {
    collector_.add_bytes(bytes.size());
  }

  Result<ImportedScene> read() {
    if (!parse()) return *fields_.error();
    if (!check_header()) return *fields_.error();
    count_uses();
    const std::vector<std::uint64_t> first = roots();
    if (fields_.error()) return *fields_.error();
    for (const std::uint64_t node : first)
      if (!visit(node)) return *fields_.error();
    if (left_out_ > 0)
      collector_.warn(make_warning(
          w_left_out, left_out_ == 1
                          ? std::string("A set of points or lines was left out.")
                          : std::to_string(left_out_) + " sets of points or lines were left out."));
    if (posed_)
      collector_.warn(
          make_warning(w_left_out, "Poses and shape keys were left out: the objects are as they rest."));
    auto scene = collector_.finish();
    if (scene) scene.value().metres_per_unit = 1 / millimetres_per_metre;
    return scene;
  }

 private:
  struct Node {
    std::uint64_t number;
    Placement above;
  };

  // All give false, or a value that does not count, after noting why.
  bool parse();
  bool check_header();
  void count_uses();
  std::vector<std::uint64_t> roots();

  bool visit(std::uint64_t root);
  Placement placement_of(const Json& node, const std::string& place);
  bool add_mesh(std::uint64_t number, const Placement& placement, const std::string& name);
  PolygonMesh read_mesh(const Json& mesh, const std::string& place);
  bool add_primitive(const Json& primitive, const std::string& place, PointWelder& welder, PolygonMesh& mesh);

  GltfAccessor accessor(std::uint64_t number, const char* type);
  std::string_view view_bytes(std::uint64_t number, std::uint64_t& stride);
  std::string_view buffer_bytes(std::uint64_t number);
  const std::string* buffer_content(std::uint64_t number, Json& buffer, const std::string& place);

  std::string_view bytes_;
  const ReadLimits& limits_;
  const FileBeside& beside_;
  SceneCollector collector_;
  GltfFields fields_;
  GltfChunks chunks_;
  Json root_;
  std::map<std::uint64_t, std::string> inside_;  ///< buffers that were written as text
  std::map<std::string, std::string> files_;     ///< buffers beside, by their paths
  std::map<std::uint64_t, std::size_t> uses_;    ///< of meshes by nodes
  std::map<std::uint64_t, PolygonMesh> kept_;    ///< meshes that are used again
  std::set<std::uint64_t> visited_;
  std::size_t left_out_ = 0;
  bool posed_ = false;
};

bool GltfReader::parse() {
  const auto chunks = gltf_chunks(bytes_);
  if (!chunks) return fields_.fail(chunks.error());
  chunks_ = *chunks;
  // What is too deep or too much is not kept while the text is read.
  std::size_t values = 0;
  bool too_large = false;
  const auto keep = [&](int depth, Json::parse_event_t, Json&) {
    too_large = too_large || depth > max_depth || ++values > 2 * max_values;
    return !too_large;
  };
  try {
    root_ = Json::parse(chunks_.json, keep);
  } catch (const Json::parse_error& error) {
    return fields_.fail(make_error(
        e_parse,
        "Byte " + std::to_string(error.byte) + " of the description: This is not JSON, or it is cut off.",
        remedy_correct));
  } catch (const Json::exception&) {
    return fields_.fail(make_error(e_parse, "A number of the description is too large.", remedy_correct));
  }
  if (too_large)
    return fields_.fail(make_error(e_limit,
                                   "The description of the file is nested too deep or has too many values.",
                                   "Reduce the model before importing it."));
  if (!root_.is_object()) return fields_.fail("The description", "It should be an object.");
  return true;
}

bool GltfReader::check_header() {
  const Json* asset = find(root_, "asset");
  const std::string version = asset ? text_of(*asset, "version") : "";
  const std::string least = asset ? text_of(*asset, "minVersion") : "";
  if (!version.starts_with("2.") || (!least.empty() && least != "2.0"))
    return fields_.fail(make_error(e_format_unknown,
                                   version.empty()
                                       ? std::string("The file does not say which version of glTF it is.")
                                       : "This is version " + quote(least.empty() ? version : least) +
                                             " of glTF, and only version 2.0 is read.",
                                   "Export the model as glTF 2.0."));
  const Json* required = find(root_, "extensionsRequired");
  if (!required || !required->is_array()) return true;
  for (const Json& extension : *required)
    if (!extension.is_string() || !is_harmless(extension.get<std::string>()))
      return fields_.fail(make_error(e_format_unknown,
                                     "The file needs the extension " +
                                         quote(extension.is_string() ? extension.get<std::string>() : "?") +
                                         ", which is not read.",
                                     "Export the model without compression and without that extension."));
  return true;
}

void GltfReader::count_uses() {
  for (std::size_t n = 0; n < size_of(root_, "nodes"); ++n) {
    const Json* mesh = find(root_["nodes"][n], "mesh");
    if (mesh && mesh->is_number_unsigned()) ++uses_[mesh->get<std::uint64_t>()];
  }
}

/// Nodes of the default scene; where there are no scenes, those that are nobody's children.
std::vector<std::uint64_t> GltfReader::roots() {
  if (size_of(root_, "scenes") > 0) {
    const std::uint64_t number = fields_.whole(root_, "scene", "The description").value_or(0);
    const Json* scene = fields_.entry(root_, "scenes", number);
    return scene ? fields_.wholes(*scene, "nodes", numbered("scenes", number)) : std::vector<std::uint64_t>();
  }
  std::set<std::uint64_t> children;
  const std::size_t count = size_of(root_, "nodes");
  for (std::size_t n = 0; n < count; ++n)
    for (const std::uint64_t child : fields_.wholes(root_["nodes"][n], "children", numbered("nodes", n)))
      children.insert(child);
  std::vector<std::uint64_t> out;
  for (std::size_t n = 0; n < count; ++n)
    if (!children.contains(n)) out.push_back(n);
  return out;
}

bool GltfReader::visit(std::uint64_t root) {
  std::vector<Node> waiting{{root, from_file_space()}};
  while (!waiting.empty()) {
    const Node at = waiting.back();
    waiting.pop_back();
    const std::string place = numbered("nodes", at.number);
    const Json* node = fields_.entry(root_, "nodes", at.number);
    if (!node) return false;
    limits_.progress.report(static_cast<double>(visited_.size() + 1) /
                            static_cast<double>(size_of(root_, "nodes")));
    if (!visited_.insert(at.number).second)
      return fields_.fail(place, "It is reached twice, or is its own ancestor.");
    const Placement placement = at.above.after(placement_of(*node, place));
    if (const auto mesh = fields_.whole(*node, "mesh", place)) {
      posed_ = posed_ || find(*node, "skin");
      if (!add_mesh(*mesh, placement, text_of(*node, "name"))) return false;
    }
    std::vector<std::uint64_t> children = fields_.wholes(*node, "children", place);
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      waiting.push_back({*child, placement});
    if (fields_.error()) return false;
  }
  return true;
}

Placement GltfReader::placement_of(const Json& node, const std::string& place) {
  Placement out;
  const std::vector<double> matrix = fields_.reals(node, "matrix", 16, place);
  if (!matrix.empty()) {  // columns one after the other
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row)
        out.linear(row, column) = matrix[static_cast<std::size_t>(4 * column + row)];
    out.shift = {matrix[12], matrix[13], matrix[14]};
    return out;
  }
  if (const auto turn = fields_.reals(node, "rotation", 4, place); !turn.empty()) {
    const Eigen::Quaterniond rotation(turn[3], turn[0], turn[1], turn[2]);
    if (!(rotation.norm() > 1e-6)) fields_.fail(place, "\"rotation\" is no rotation.");
    out.linear = rotation.normalized().toRotationMatrix();
  }
  if (const auto scale = fields_.reals(node, "scale", 3, place); !scale.empty())
    out.linear *= Vector3(scale[0], scale[1], scale[2]).asDiagonal();
  if (const auto shift = fields_.reals(node, "translation", 3, place); !shift.empty())
    out.shift = {shift[0], shift[1], shift[2]};
  return out;
}

bool GltfReader::add_mesh(std::uint64_t number, const Placement& placement, const std::string& name) {
  const Json* mesh = fields_.entry(root_, "meshes", number);
  if (!mesh) return false;
  const std::string own = text_of(*mesh, "name");
  PolygonMesh polygons;
  if (const auto kept = kept_.find(number); kept != kept_.end()) {
    polygons = kept->second;
    if (const auto error = collector_.reserve(polygons.positions.size(), polygons.face_vertices.size()))
      return fields_.fail(*error);
  } else {
    polygons = read_mesh(*mesh, numbered("meshes", number));
    if (fields_.error()) return false;
    if (uses_[number] > 1) kept_.emplace(number, polygons);
  }
  if (const auto error = collector_.add(std::move(polygons), placement, name.empty() ? own : name))
    return fields_.fail(*error);
  return true;
}

PolygonMesh GltfReader::read_mesh(const Json& mesh, const std::string& place) {
  PolygonMesh out;
  const std::size_t count = size_of(mesh, "primitives");
  if (count == 0) fields_.fail(place, "\"primitives\" are missing.");
  PointWelder welder(0);
  for (std::size_t p = 0; p < count && !fields_.error(); ++p)
    add_primitive(mesh["primitives"][p], place + "." + numbered("primitives", p), welder, out);
  out.positions = welder.take_positions();
  return out;
}

bool GltfReader::add_primitive(const Json& primitive, const std::string& place, PointWelder& welder,
                               PolygonMesh& mesh) {
  const std::uint64_t mode = fields_.whole(primitive, "mode", place).value_or(4);
  if (mode > 6) fields_.fail(place, "\"mode\" is none of the format's.");
  const Json* attributes = find(primitive, "attributes");
  const auto position = attributes ? fields_.whole(*attributes, "POSITION", place) : std::nullopt;
  if (fields_.error()) return false;
  if (mode < 4 || !position) {  // the format lets extensions bring positions
    ++left_out_;
    return true;
  }
  posed_ = posed_ || find(primitive, "targets");
  const GltfAccessor points = accessor(*position, "VEC3");
  std::optional<GltfAccessor> corners;
  if (const auto indices = fields_.whole(primitive, "indices", place)) {
    corners = accessor(*indices, "SCALAR");
    const GltfComponent type = corners->component;
    if (type != GltfComponent::uint8 && type != GltfComponent::uint16 && type != GltfComponent::uint32)
      fields_.fail(corners->place, "Corners are unsigned whole numbers.");
  }
  if (points.component == GltfComponent::uint32)
    fields_.fail(points.place, "Positions are no 32-bit whole numbers.");
  if (fields_.error()) return false;
  const std::uint64_t corner_count = corners ? corners->count : points.count;
  if (const auto error = collector_.reserve(points.count, mode == 4 ? corner_count : 3 * corner_count))
    return fields_.fail(*error);
  const auto positions = gltf_points(points);
  if (!positions) return fields_.fail(positions.error());
  std::vector<Index> order;
  if (corners) {
    auto indices = gltf_indices(*corners, points.count);
    if (!indices) return fields_.fail(indices.error());
    order = std::move(indices).value();
  } else {
    order.resize(points.count);
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<Index>(v);
  }
  std::size_t degenerate = 0;
  const auto triangles = triangles_of(order, mode);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 65536 == 0)
      if (const auto cancelled = collector_.reserve(0, 0)) return fields_.fail(*cancelled);
    Index at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = welder.add((*positions)[triangles[t][k]]);
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0])
      ++degenerate;
    else
      mesh.add_face({at[0], at[1], at[2]});
  }
  collector_.note_degenerate(mode == 4 ? degenerate : 0);  // strips turn corners by such triangles
  return true;
}

GltfAccessor GltfReader::accessor(std::uint64_t number, const char* type) {
  GltfAccessor out;
  out.place = numbered("accessors", number);
  const Json* found = fields_.entry(root_, "accessors", number);
  if (!found) return out;
  if (find(*found, "sparse")) {
    fields_.fail(make_error(e_format_unknown, out.place + ": Sparse accessors are not read.",
                            "Export the model without shape keys, or as .glb from another program."));
    return out;
  }
  if (text_of(*found, "type") != type) fields_.fail(out.place, "Its type should be " + quote(type) + ".");
  const auto component = gltf_component(fields_.needed(*found, "componentType", out.place));
  if (!component) fields_.fail(out.place, "\"componentType\" is none of the format's.");
  out.component = component.value_or(GltfComponent::float32);
  out.count = fields_.needed(*found, "count", out.place);
  const Json* normalised = find(*found, "normalized");
  out.normalised = normalised && normalised->is_boolean() && normalised->get<bool>();
  const std::uint64_t view = fields_.needed(*found, "bufferView", out.place);
  const std::uint64_t offset = fields_.whole(*found, "byteOffset", out.place).value_or(0);
  if (fields_.error()) return out;
  out.bytes = view_bytes(view, out.stride);
  if (fields_.error()) return out;
  const std::size_t numbers = std::string_view(type) == "VEC3" ? 3 : 1;
  const std::size_t row = numbers * gltf_size(out.component);
  if (out.stride == 0) out.stride = row;
  if (out.stride < row) fields_.fail(out.place, "Its rows overlap.");
  out.bytes.remove_prefix(std::min<std::uint64_t>(offset, out.bytes.size()));
  if (const auto error = check_rows(out, numbers)) fields_.fail(*error);
  return out;
}

/// Sets `stride` to 0 where the file does not say it.
std::string_view GltfReader::view_bytes(std::uint64_t number, std::uint64_t& stride) {
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

std::string_view GltfReader::buffer_bytes(std::uint64_t number) {
  const std::string place = numbered("buffers", number);
  if (!fields_.entry(root_, "buffers", number)) return {};
  Json& buffer = root_["buffers"][number];
  const std::uint64_t length = fields_.needed(buffer, "byteLength", place);
  std::string_view bytes;
  if (find(buffer, "uri")) {
    const std::string* content = buffer_content(number, buffer, place);
    if (content) bytes = *content;
  } else if (number == 0 && chunks_.binary) {
    bytes = *chunks_.binary;
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

const std::string* GltfReader::buffer_content(std::uint64_t number, Json& buffer, const std::string& place) {
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
  if (*data) {
    uri.clear();  // it may be most of the file
    uri.shrink_to_fit();
    return &inside_.emplace(number, *std::move(data).value()).first->second;
  }
  const auto path = buffer_path(uri);
  if (!path) {
    fields_.fail(path.error());
    return nullptr;
  }
  if (const auto found = files_.find(*path); found != files_.end()) return &found->second;
  auto content = beside_ ? beside_(*path)
                         : Result<std::string>(make_error(
                               e_file_open, "The data of the file lie beside it, in " + quote(*path) + ".",
                               "Export the model as .glb."));
  if (!content) {
    fields_.fail(content.error());
    return nullptr;
  }
  collector_.add_bytes(content->size());
  return &files_.emplace(*path, std::move(content).value()).first->second;
}

}  // namespace

Result<ImportedScene> read_gltf(std::string_view bytes, const ReadLimits& limits, const FileBeside& beside) {
  return GltfReader(bytes, limits, beside).read();
}

}  // namespace hariko
