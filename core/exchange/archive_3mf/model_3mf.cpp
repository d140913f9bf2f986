#include "core/exchange/archive_3mf/model_3mf.hpp"

#include <algorithm>
#include <array>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/archive_3mf/xml_reader.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr std::size_t max_objects = 1'000'000;

constexpr std::string_view core_namespace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view production_namespace =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view slice_namespace = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";
/// Namespaces of extensions that files may require: they are read, or do not affect shapes.
constexpr std::array<std::string_view, 4> known_namespaces{
    core_namespace, production_namespace, "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

struct LengthUnit {
  std::string_view name;
  double metres;
};
constexpr std::array length_units{LengthUnit{"micron", 1e-6},     LengthUnit{"millimeter", 1e-3},
                                  LengthUnit{"centimeter", 1e-2}, LengthUnit{"inch", 0.0254},
                                  LengthUnit{"foot", 0.3048},     LengthUnit{"meter", 1}};

/// Elements that are read; all others are `other`, with their content.
enum class Tag {
  document,
  model,
  resources,
  object,
  mesh,
  vertices,
  triangles,
  components,
  build,
  leaf,
  other
};

struct Child {
  Tag parent;
  std::string_view name;
  Tag tag;
};
constexpr std::array children{
    Child{Tag::document, "model", Tag::model},      Child{Tag::model, "resources", Tag::resources},
    Child{Tag::model, "build", Tag::build},         Child{Tag::resources, "object", Tag::object},
    Child{Tag::object, "mesh", Tag::mesh},          Child{Tag::object, "components", Tag::components},
    Child{Tag::mesh, "vertices", Tag::vertices},    Child{Tag::mesh, "triangles", Tag::triangles},
    Child{Tag::vertices, "vertex", Tag::leaf},      Child{Tag::triangles, "triangle", Tag::leaf},
    Child{Tag::components, "component", Tag::leaf}, Child{Tag::build, "item", Tag::leaf}};

Tag tag_in(Tag parent, std::string_view name) {
  if (!name.starts_with(core_namespace) || name.size() <= core_namespace.size()) return Tag::other;
  name.remove_prefix(core_namespace.size() + 1);
  for (const Child& child : children)
    if (child.parent == parent && child.name == name) return child.tag;
  return Tag::other;
}

/// Name of an extension by its URI (http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02 gives
/// "beamlattice"): the word before the date.
std::string extension_name(const std::string& uri) {
  std::string_view rest = uri;
  for (;;) {
    const std::size_t slash = rest.rfind('/');
    if (slash == std::string_view::npos || slash + 1 == rest.size()) return quote(uri);
    const std::string_view word = rest.substr(slash + 1);
    if (word.find_first_not_of("0123456789") != std::string_view::npos)
      return quote(word) + " (" + shortened(uri, 200) + ")";
    rest = rest.substr(0, slash);
  }
}

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  std::vector<std::string_view> out;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    out.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(blanks, end);
  }
  return out;
}

}  // namespace

class ModelParser3mf::Handler final : public XmlTarget {
 public:
  Handler(std::string part, const ReadLimits& limits)
      : limits_(limits), xml_(*this, std::move(part), limits) {}

  bool feed(std::string_view piece) { return xml_.feed(piece); }
  Result<Model3mf> finish() {
    auto error = xml_.finish();
    if (!error && !model_found_) {
      xml_.refuse(e_format_unknown, "Here is no model of the core specification of 3MF.");
      error = xml_.finish();
    }
    return error ? Result<Model3mf>(*std::move(error)) : std::move(model_);
  }

  void declare(std::string_view prefix, std::string_view uri) override {
    if (stack_.size() == 1) prefixes_[std::string(prefix)] = uri;  // declared at the root
  }
  void start(std::string_view name, const XmlAttributes& attributes) override {
    const Tag parent = stack_.back(), tag = tag_in(parent, name);
    stack_.push_back(tag);
    if (parent == Tag::object || parent == Tag::mesh) note_extension(name);
    if (tag == Tag::model) return start_model(attributes);
    if (tag == Tag::object) return start_object(attributes);
    if (tag != Tag::leaf) return;
    if (parent == Tag::vertices) return add_vertex(attributes);
    if (parent == Tag::triangles) return add_triangle(attributes);
    if (const auto placed = placed_by(attributes))
      (parent == Tag::build ? model_.build : object_->components).push_back(*placed);
  }
  void end() override {
    const Tag tag = stack_.back();
    stack_.pop_back();
    if (tag != Tag::object || !object_ || !slices_) return;
    // Slices beside a whole mesh only repeat it.
    const bool alone = object_->mesh.face_count() == 0 && object_->components.empty();
    if (alone || coarse_) object_->unread.insert(extension_name(std::string(slice_namespace)));
  }

 private:
  void start_model(const XmlAttributes& attributes) {
    model_found_ = true;
    if (const char* unit = attributes.find("unit")) {
      const auto found = std::find_if(length_units.begin(), length_units.end(),
                                      [&](const LengthUnit& u) { return u.name == unit; });
      if (found == length_units.end()) return xml_.refuse(e_parse, quote(unit) + " is no unit of 3MF.");
      model_.metres_per_unit = found->metres;
    }
    const char* required = attributes.find("requiredextensions");
    for (const std::string_view prefix : words_of(required ? required : "")) {
      const auto uri = prefixes_.find(std::string(prefix));
      const bool known = uri != prefixes_.end() && std::find(known_namespaces.begin(), known_namespaces.end(),
                                                             uri->second) != known_namespaces.end();
      if (!known)
        return xml_.refuse(e_format_unknown,
                           "The model needs the extension " +
                               extension_name(uri == prefixes_.end() ? std::string(prefix) : uri->second) +
                               ", which is not read.",
                           "Export the model as plain triangles.");
    }
  }

  std::optional<std::uint64_t> number(const XmlAttributes& attributes, const char* name) {
    const char* text = attributes.find(name);
    std::int64_t value = 0;
    const NumberStatus status = text ? parse_integer(text, value) : NumberStatus::malformed;
    if (status == NumberStatus::ok && value >= 0) return static_cast<std::uint64_t>(value);
    xml_.refuse(e_parse, text ? quote(name) + " should be a whole number, but is " + quote(text) + "."
                              : quote(name) + " is missing.");
    return {};
  }

  /// Notes an element of an extension that may add to the shape of the present object.
  void note_extension(std::string_view name) {
    const std::size_t end = name.rfind(XmlReader::separator);
    if (end == std::string_view::npos || !object_) return;
    const std::string_view uri = name.substr(0, end);
    const bool alternatives = uri.starts_with("http://schemas.microsoft.com/3dmanufacturing/production/");
    if (!alternatives &&
        std::find(known_namespaces.begin(), known_namespaces.end(), uri) == known_namespaces.end())
      object_->unread.insert(extension_name(std::string(uri)));
  }

  void start_object(const XmlAttributes& attributes) {
    const auto id = number(attributes, "id");
    if (!id) return;
    if (model_.objects.size() == max_objects)
      return xml_.refuse(e_limit, "There are too many objects.", remedy_reduce);
    const auto [at, added] = model_.objects.try_emplace(*id);
    if (!added) return xml_.refuse(e_parse, "Object " + std::to_string(*id) + " is there twice.");
    object_ = &at->second;
    if (const char* name = attributes.find("name")) object_->name = sanitized_utf8(name, 200);
    slices_ = attributes.find(slice_stack_) != nullptr;
    const char* resolution = attributes.find(slice_resolution_);
    coarse_ = resolution && std::string_view(resolution) == "lowres";
  }

  void add_vertex(const XmlAttributes& attributes) {
    PolygonMesh& mesh = object_->mesh;
    Vector3 point;
    for (int axis = 0; axis < 3; ++axis) {
      constexpr std::array<const char*, 3> names{"x", "y", "z"};
      const char* text = attributes.find(names[static_cast<std::size_t>(axis)]);
      if (text && parse_real(text, point[axis]) == NumberStatus::ok) continue;
      return xml_.refuse(e_parse,
                         std::string("The coordinate ") + names[static_cast<std::size_t>(axis)] +
                             (text ? " should be a number, but is " + quote(text) + "." : " is missing."));
    }
    if (++vertices_ > limits_.vertices)
      return xml_.refuse(e_limit, "There are more than " + std::to_string(limits_.vertices) + " vertices.",
                         remedy_reduce);
    mesh.positions.push_back(point);
  }

  void add_triangle(const XmlAttributes& attributes) {
    PolygonMesh& mesh = object_->mesh;
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      constexpr std::array<const char*, 3> names{"v1", "v2", "v3"};
      const auto vertex = number(attributes, names[k]);
      if (!vertex) return;
      if (*vertex >= mesh.positions.size())
        return xml_.refuse(e_index_range, "The triangle names vertex " + std::to_string(*vertex) +
                                              ", but the mesh has " + std::to_string(mesh.positions.size()) +
                                              " vertices, counted from 0.");
      corners[k] = static_cast<Index>(*vertex);
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      ++model_.degenerate;
      return;
    }
    corners_ += 3;
    if (corners_ > limits_.corners)
      return xml_.refuse(e_limit,
                         "The triangles have more than " + std::to_string(limits_.corners) + " corners.",
                         remedy_reduce);
    mesh.add_face(corners);
  }

  std::optional<Placed3mf> placed_by(const XmlAttributes& attributes) {
    Placed3mf out;
    out.line = xml_.line();
    const auto object = number(attributes, "objectid");
    if (!object) return {};
    out.object = *object;
    if (const char* part = attributes.find(production_path_)) out.part = part;
    const char* transform = attributes.find("transform");
    if (!transform) return out;
    // Rows of a 4 by 3 matrix that multiplies row vectors.
    const auto words = words_of(transform);
    std::array<double, 12> values{};
    bool good = words.size() == values.size();
    for (std::size_t k = 0; good && k < values.size(); ++k)
      good = parse_real(words[k], values[k]) == NumberStatus::ok;
    if (!good) {
      xml_.refuse(e_parse, "A transform is twelve numbers.");
      return {};
    }
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        out.placement.linear(column, row) = values[static_cast<std::size_t>(3 * row + column)];
    out.placement.shift = {values[9], values[10], values[11]};
    return out;
  }

  const ReadLimits& limits_;
  XmlReader xml_;
  Model3mf model_;
  bool model_found_ = false;
  Object3mf* object_ = nullptr;  ///< object that began last
  bool slices_ = false;          ///< it has slices
  bool coarse_ = false;          ///< its mesh is a coarse one, and its slices are exact
  std::vector<Tag> stack_{Tag::document};
  std::map<std::string, std::string> prefixes_;
  const std::string production_path_ = std::string(production_namespace) + XmlReader::separator + "path";
  const std::string slice_stack_ = std::string(slice_namespace) + XmlReader::separator + "slicestackid";
  const std::string slice_resolution_ =
      std::string(slice_namespace) + XmlReader::separator + "meshresolution";
  std::size_t vertices_ = 0, corners_ = 0;
};

ModelParser3mf::ModelParser3mf(std::string part, const ReadLimits& limits)
    : handler_(std::make_unique<Handler>(std::move(part), limits)) {}
ModelParser3mf::~ModelParser3mf() = default;

bool ModelParser3mf::feed(std::string_view piece) {
  return handler_->feed(piece);
}
Result<Model3mf> ModelParser3mf::finish() {
  return handler_->finish();
}

}  // namespace hariko
