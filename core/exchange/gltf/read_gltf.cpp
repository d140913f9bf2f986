#include "core/exchange/gltf/read_gltf.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/exchange/gltf/gltf_buffers.hpp"
#include "core/exchange/gltf/gltf_container.hpp"
#include "core/exchange/gltf/gltf_fields.hpp"
#include "core/exchange/gltf/gltf_instances.hpp"
#include "core/exchange/gltf/gltf_scenes.hpp"
#include "core/exchange/gltf/gltf_skin.hpp"
#include "core/exchange/repair/point_welder.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/scene_collector.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

using Json = nlohmann::json;

constexpr double millimetres_per_metre = 1000;
constexpr const char* instancing = "EXT_mesh_gpu_instancing";

// Limit of JSON values: a value takes at least two characters, and in memory about fifty times its text.
constexpr std::size_t max_values = 5'000'000;
constexpr int max_depth = 64;

/// Prefixes of extensions that a file may require: they are read, or do not affect shapes. Quantised
/// positions are read like others.
constexpr std::array harmless_extensions{
    "KHR_materials_",  "KHR_texture_",    "EXT_texture_",     "MSFT_texture_",   "KHR_lights_",
    "EXT_lights_",     "KHR_xmp",         "KHR_animation_",   "KHR_audio",       "KHR_mesh_quantization",
    "KHR_node_hover",  "KHR_node_select", "EXT_mesh_feat",    "EXT_structural_", "EXT_instance_feat",
    "KHR_techniques_", "MSFT_packing_",   "ADOBE_materials_", "NV_materials_",   "CESIUM_primitive_outline",
    instancing};
/// Compressions that have an uncompressed fallback in files that do not require them.
constexpr std::array compressions{"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                  "KHR_meshopt_compression"};

template <class Names>
bool is_among(const Names& names, const std::string& extension) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* start) { return extension.starts_with(start); });
}

/// Map from the file's space (y up, metres) to the document's (z up, millimetres).
AffineMap from_file_space() {
  AffineMap out;
  out.linear << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  out.linear *= millimetres_per_metre;
  return out;
}

/// Triangles over the corners of a primitive; `mode` is one of the three triangle modes (section 3.7.2.1).
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
  GltfReader(std::string_view bytes, const ReadLimits& limits, const SidecarReader& beside)
      : bytes_(bytes), limits_(limits), beside_(beside), collector_(limits) {
    collector_.add_bytes(bytes.size());
  }

  Result<ImportedScene> read() {
    if (!parse()) return *fields_.error();
    if (!check_header()) return *fields_.error();
    scene_ = gltf_scene(root_, fields_);
    const std::vector<std::uint64_t> first = gltf_roots(root_, scene_, fields_);
    if (fields_.error()) return *fields_.error();
    for (const std::uint64_t node : first)
      if (!visit(node)) return *fields_.error();
    for (const std::uint64_t node : with_mesh_)
      if (!add_node(node)) return *fields_.error();
    if (size_of(root_, "nodes") == 0 && !add_meshes_alone()) return *fields_.error();
    tell_what_is_left_out();
    auto scene = collector_.finish();
    if (scene) scene.value().metres_per_unit = 1 / millimetres_per_metre;
    return scene;
  }

 private:
  struct Node {
    std::uint64_t number;
    AffineMap above;
  };

  // All return false, or a value that does not count, after noting an error.
  bool parse();
  bool check_header();

  bool visit(std::uint64_t root);
  AffineMap placement_of(const Json& node, const std::string& place);
  bool add_node(std::uint64_t number);
  bool add_meshes_alone();
  bool add_mesh(std::uint64_t number, const Json& node, const AffineMap& placement, const std::string& name);
  bool add_skinned(std::uint64_t mesh, const Json& node, std::uint64_t skin, const std::string& name);
  std::vector<double> weights_of(const Json& node, const Json& mesh, const std::string& place);
  PolygonMesh read_mesh(const Json& mesh, const std::string& place, const std::vector<double>& weights,
                        const GltfSkin* skin);
  bool has_rows(const Json& primitive, std::uint64_t accessor, const std::string& place);
  bool add_primitive(const Json& primitive, const std::string& place, const std::vector<double>& weights,
                     const GltfSkin* skin, PointWelder& welder, PolygonMesh& mesh);
  bool add_shape_keys(const Json& primitive, const std::string& place, const std::vector<double>& weights,
                      std::vector<Vector3>& points);
  bool add_triangles(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& points,
                     bool count_degenerate, PointWelder& welder, PolygonMesh& mesh);
  void tell_which_scene();
  void tell_what_is_left_out();

  std::string_view bytes_;
  const ReadLimits& limits_;
  const SidecarReader& beside_;
  SceneCollector collector_;
  GltfFields fields_;
  Json root_;
  GltfScene scene_;
  std::optional<GltfBuffers> buffers_;         ///< set once the description is parsed
  std::map<std::uint64_t, std::size_t> uses_;  ///< uses of each mesh without a skin
  std::map<std::uint64_t, PolygonMesh> kept_;  ///< meshes that will be used again
  std::map<std::uint64_t, AffineMap> places_;  ///< placements of the nodes that were reached
  std::vector<std::uint64_t> with_mesh_;       ///< reached nodes with a mesh, in order
  std::size_t left_out_ = 0;
  bool shape_keys_ = false;
};

bool GltfReader::parse() {
  const auto chunks = gltf_chunks(bytes_);
  if (!chunks) return fields_.fail(chunks.error());
  // Discards values beyond the limits of depth and number while the text is parsed.
  std::size_t values = 0;
  bool too_large = false;
  const auto keep = [&](int depth, Json::parse_event_t, Json&) {
    too_large = too_large || depth > max_depth || ++values > 2 * max_values;
    return !too_large;
  };
  try {
    root_ = Json::parse(chunks->json, keep);
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
  buffers_.emplace(root_, chunks->binary, fields_, collector_, beside_);
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
    if (!extension.is_string() || !is_among(harmless_extensions, extension.get<std::string>()))
      return fields_.fail(make_error(e_format_unknown,
                                     "The file needs the extension " +
                                         quote(extension.is_string() ? extension.get<std::string>() : "?") +
                                         ", which is not read.",
                                     "Export the model without compression and without that extension."));
  return true;
}

bool GltfReader::visit(std::uint64_t root) {
  std::vector<Node> waiting{{root, from_file_space()}};
  while (!waiting.empty()) {
    const Node at = waiting.back();
    waiting.pop_back();
    const std::string place = numbered("nodes", at.number);
    const Json* node = fields_.entry(root_, "nodes", at.number);
    if (!node) return false;
    if (places_.contains(at.number))
      return fields_.fail(place, "It is reached twice, or is its own ancestor.");
    const AffineMap placement = at.above.after(placement_of(*node, place));
    places_.emplace(at.number, placement);
    if (const auto mesh = fields_.whole(*node, "mesh", place)) {
      with_mesh_.push_back(at.number);
      if (!find(*node, "skin")) uses_[*mesh] += find(*node, "extensions") ? 2 : 1;  // instances use it again
    }
    std::vector<std::uint64_t> children = fields_.wholes(*node, "children", place);
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      waiting.push_back({*child, placement});
    if (fields_.error()) return false;
  }
  return true;
}

AffineMap GltfReader::placement_of(const Json& node, const std::string& place) {
  AffineMap out;
  const std::vector<double> matrix = fields_.reals(node, "matrix", 16, place);
  if (!matrix.empty()) {  // stored by columns
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

/// Adds the mesh of a reached node: once, deformed by a skin, or at all its instances.
bool GltfReader::add_node(std::uint64_t number) {
  const Json& node = root_["nodes"][number];
  const std::string place = numbered("nodes", number), name = text_of(node, "name");
  limits_.progress.report(double(number + 1) / double(size_of(root_, "nodes")));
  const auto mesh = fields_.whole(node, "mesh", place);
  if (!mesh) return false;
  const auto skin = fields_.whole(node, "skin", place);
  if (fields_.error()) return false;
  if (skin) return add_skinned(*mesh, node, *skin, name);
  const AffineMap& at = places_.at(number);
  const Json* extensions = find(node, "extensions");
  const Json* instances = extensions ? find(*extensions, instancing) : nullptr;
  if (!instances) return add_mesh(*mesh, node, at, name);
  const auto copies = gltf_instances(*instances, place, *buffers_, fields_, collector_);
  if (!copies) return false;
  for (const AffineMap& copy : *copies)
    if (!add_mesh(*mesh, node, at.after(copy), name)) return false;
  return true;
}

/// Adds the meshes of a file without nodes, which is a library of meshes: each once, where it is.
bool GltfReader::add_meshes_alone() {
  for (std::size_t mesh = 0; mesh < size_of(root_, "meshes"); ++mesh)
    if (!add_mesh(mesh, Json::object(), from_file_space(), "")) return false;
  return true;
}

bool GltfReader::add_mesh(std::uint64_t number, const Json& node, const AffineMap& placement,
                          const std::string& name) {
  const Json* mesh = fields_.entry(root_, "meshes", number);
  if (!mesh) return false;
  const std::string own = text_of(*mesh, "name");
  PolygonMesh polygons;
  const bool own_shape = find(node, "weights");  // weights of shape keys differ by node
  if (const auto kept = kept_.find(number); kept != kept_.end() && !own_shape) {
    polygons = kept->second;
    if (const auto error = collector_.reserve(polygons.positions.size(), polygons.face_vertices.size()))
      return fields_.fail(*error);
  } else {
    const std::string place = numbered("meshes", number);
    polygons = read_mesh(*mesh, place, weights_of(node, *mesh, place), nullptr);
    if (fields_.error()) return false;
    if (uses_[number] > 1 && !own_shape) kept_.emplace(number, polygons);
  }
  if (const auto error = collector_.add(std::move(polygons), placement, name.empty() ? own : name))
    return fields_.fail(*error);
  return true;
}

/// Adds a skinned mesh. Its joints place it; the placement of its node is ignored (section 3.7.3.3).
bool GltfReader::add_skinned(std::uint64_t number, const Json& node, std::uint64_t skin_number,
                             const std::string& name) {
  const Json* mesh = fields_.entry(root_, "meshes", number);
  const Json* skin = fields_.entry(root_, "skins", skin_number);
  if (!mesh || !skin) return false;
  const auto bones =
      gltf_skin(*skin, numbered("skins", skin_number), places_, *buffers_, fields_, collector_);
  if (!bones) return false;
  const std::string place = numbered("meshes", number);
  PolygonMesh polygons = read_mesh(*mesh, place, weights_of(node, *mesh, place), &*bones);
  if (fields_.error()) return false;
  if (bones->mirrors()) turn_over(polygons);
  if (const auto error =
          collector_.add(std::move(polygons), {}, name.empty() ? text_of(*mesh, "name") : name))
    return fields_.fail(*error);
  return true;
}

/// Weights of the shape keys at rest: the node's, else the mesh's.
std::vector<double> GltfReader::weights_of(const Json& node, const Json& mesh, const std::string& place) {
  const Json& owner = find(node, "weights") ? node : mesh;
  return fields_.reals(owner, "weights", size_of(owner, "weights"), place);
}

PolygonMesh GltfReader::read_mesh(const Json& mesh, const std::string& place,
                                  const std::vector<double>& weights, const GltfSkin* skin) {
  PolygonMesh out;
  const std::size_t count = size_of(mesh, "primitives");
  if (count == 0) fields_.fail(place, "\"primitives\" are missing.");
  PointWelder welder(0);
  for (std::size_t p = 0; p < count && !fields_.error(); ++p)
    add_primitive(mesh["primitives"][p], place + "." + numbered("primitives", p), weights, skin, welder, out);
  out.positions = welder.take_positions();
  return out;
}

/// Whether an accessor of a primitive has rows of numbers of its own, and not only in a compression.
bool GltfReader::has_rows(const Json& primitive, std::uint64_t accessor, const std::string& place) {
  const Json* rows = fields_.entry(root_, "accessors", accessor);
  if (!rows) return false;
  const Json* extensions = find(primitive, "extensions");
  if (!extensions || find(*rows, "bufferView") || find(*rows, "sparse")) return true;
  for (const char* name : compressions)
    if (find(*extensions, name))
      return fields_.fail(make_error(
          e_format_unknown,
          place + ": Its triangles are compressed by the extension " + quote(name) + ", which is not read.",
          "Export the model without compression."));
  return true;
}

bool GltfReader::add_primitive(const Json& primitive, const std::string& place,
                               const std::vector<double>& weights, const GltfSkin* skin, PointWelder& welder,
                               PolygonMesh& mesh) {
  const std::uint64_t mode = fields_.whole(primitive, "mode", place).value_or(4);
  if (mode > 6) fields_.fail(place, "\"mode\" is none of the format's.");
  const Json* attributes = find(primitive, "attributes");
  const auto position = attributes ? fields_.whole(*attributes, "POSITION", place) : std::nullopt;
  if (fields_.error()) return false;
  if (mode < 4 || !position) {  // extensions may supply positions instead
    ++left_out_;
    return true;
  }
  if (!has_rows(primitive, *position, place)) return false;
  const GltfAccessor points = buffers_->accessor(*position, "VEC3");
  std::optional<GltfAccessor> corners;
  if (const auto indices = fields_.whole(primitive, "indices", place)) {
    if (!has_rows(primitive, *indices, place)) return false;
    corners = buffers_->accessor(*indices, "SCALAR");
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
  auto positions = gltf_points(points);
  if (!positions) return fields_.fail(positions.error());
  std::vector<Vector3> placed = std::move(positions).value();
  if (!add_shape_keys(primitive, place, weights, placed)) return false;
  if (skin && !skin->bend(*attributes, place, *buffers_, fields_, placed)) return false;
  std::vector<Index> order;
  if (corners) {
    auto indices = gltf_indices(*corners, points.count);
    if (!indices) return fields_.fail(indices.error());
    order = std::move(indices).value();
  } else {
    order.resize(points.count);
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<Index>(v);
  }
  // Degenerate triangles of strips are deliberate and not counted.
  return add_triangles(triangles_of(order, mode), placed, mode == 4, welder, mesh);
}

bool GltfReader::add_shape_keys(const Json& primitive, const std::string& place,
                                const std::vector<double>& weights, std::vector<Vector3>& points) {
  const std::size_t count = size_of(primitive, "targets");
  shape_keys_ = shape_keys_ || count > 0;
  for (std::size_t k = 0; k < std::min(count, weights.size()); ++k) {
    if (weights[k] == 0) continue;
    const std::string here = place + "." + numbered("targets", k);
    const auto moves = fields_.whole(primitive["targets"][k], "POSITION", here);
    if (fields_.error()) return false;
    if (!moves) continue;  // the shape key changes normals only
    const GltfAccessor target = buffers_->accessor(*moves, "VEC3");
    if (!fields_.error() && target.count != points.size())
      fields_.fail(here, "It has another number of positions than the mesh.");
    if (fields_.error()) return false;
    if (const auto error = collector_.reserve(target.count, 0)) return fields_.fail(*error);
    const auto offsets = gltf_points(target);
    if (!offsets) return fields_.fail(offsets.error());
    for (std::size_t v = 0; v < points.size(); ++v) points[v] += weights[k] * (*offsets)[v];
  }
  return true;
}

bool GltfReader::add_triangles(const std::vector<std::array<Index, 3>>& triangles,
                               const std::vector<Vector3>& points, bool count_degenerate, PointWelder& welder,
                               PolygonMesh& mesh) {
  std::size_t degenerate = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 65536 == 0)
      if (const auto cancelled = collector_.reserve(0, 0)) return fields_.fail(*cancelled);
    Index at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = welder.add(points[triangles[t][k]]);
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0])
      ++degenerate;
    else
      mesh.add_face({at[0], at[1], at[2]});
  }
  if (count_degenerate) collector_.note_degenerate(degenerate);
  return true;
}

void GltfReader::tell_which_scene() {
  if (!scene_.instead) return;
  std::string sentence = "No object belongs to a scene of the file; all objects were opened.";
  if (scene_.number) {
    const std::string name = text_of(root_["scenes"][*scene_.number], "name");
    sentence = "No object belongs to the default scene of the file; scene " +
               (name.empty() ? std::to_string(*scene_.number + 1) : quote(name)) + " was opened instead.";
  }
  collector_.warn(make_warning(w_other_scene, sentence,
                               "Compare the objects with those in the program that wrote the file."));
}

void GltfReader::tell_what_is_left_out() {
  if (left_out_ > 0)
    collector_.warn(make_warning(
        w_left_out, left_out_ == 1 ? std::string("A set of points or lines was left out.")
                                   : std::to_string(left_out_) + " sets of points or lines were left out."));
  tell_which_scene();
  const GltfLeftOut objects = objects_left_out(root_, scene_);
  if (objects.in_others > 0)
    collector_.warn(make_warning(
        w_left_out,
        objects.in_others == 1
            ? std::string("An object of another scene of the file was left out.")
            : std::to_string(objects.in_others) + " objects of other scenes of the file were left out.",
        "Export the other scenes as files of their own."));
  if (objects.in_none > 0)
    collector_.warn(
        make_warning(w_left_out,
                     counted(objects.in_none, " object that belongs to no scene of the file was left out.",
                             " objects that belong to no scene of the file were left out."),
                     "Add them to the scene in the program that wrote the file."));
  if (shape_keys_ || size_of(root_, "animations") > 0)
    collector_.warn(make_warning(
        w_left_out, "Animations and shape keys were left out: the objects are as they stand in the file."));
  std::string names;
  for (std::size_t k = 0; k < size_of(root_, "extensionsUsed"); ++k) {
    const Json& extension = root_["extensionsUsed"][k];
    if (!extension.is_string()) continue;
    const auto name = extension.get<std::string>();
    if (is_among(harmless_extensions, name) || is_among(compressions, name)) continue;
    names += (names.empty() ? "" : ", ") + quote(name);
  }
  if (!names.empty())
    collector_.warn(make_warning(
        w_left_out, "The file uses what is not read, and shapes may depend on it: " + names + ".",
        "Compare the objects with those in the program that wrote the file."));
}

}  // namespace

Result<ImportedScene> read_gltf(std::string_view bytes, const ReadLimits& limits,
                                const SidecarReader& beside) {
  return GltfReader(bytes, limits, beside).read();
}

}  // namespace hariko
