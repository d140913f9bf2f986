#include "core/exchange/archive_3mf/read_3mf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/files/file_uri.hpp"
#include "core/exchange/archive_3mf/model_3mf.hpp"
#include "core/exchange/archive_3mf/xml_reader.hpp"
#include "core/exchange/archive_3mf/zip_reader.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/scene_collector.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr const char* usual_part = "3D/3dmodel.model";
constexpr const char* relationships_part = "_rels/.rels";
constexpr std::string_view model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr const char* remedy_plain = "Export the model as plain triangles.";
constexpr std::size_t max_nesting = 64, max_placements = 100'000;

/// Unit that a document can have: the file's own, or millimetres in place of other units.
double metres_of_document(double metres_per_unit) {
  constexpr std::array units{0.001, 0.01, 0.0254, 1.0};
  return std::find(units.begin(), units.end(), metres_per_unit) != units.end() ? metres_per_unit : 0.001;
}

std::string without_slash(std::string name) {
  if (name.starts_with('/')) name.erase(0, 1);
  return name;
}

/// Finds the model part by the relationships (Open Packaging Conventions).
class RelationshipTarget final : public XmlTarget {
 public:
  void start(std::string_view name, const XmlAttributes& attributes) override {
    const char *type = attributes.find("Type"), *target = attributes.find("Target");
    if (name.ends_with("|Relationship") && type && target && type == model_relationship && !part)
      part = without_slash(target);
  }
  std::optional<std::string> part;
};

/// Objects whose shape is incomplete or missing, as extensions that are not read hold the rest.
class UnreadShapes {
 public:
  /// Notes a placed object; `title` names it in messages.
  void note(const Object3mf& object, const std::string& title) {
    const bool missing = object.mesh.face_count() == 0 && object.components.empty();
    for (const std::string& extension : object.unread) {
      Objects& objects = extensions_[extension][missing ? 1 : 0];
      if (objects.count++ == 0) objects.first = title;
    }
  }
  std::vector<std::string> sentences() const {
    std::vector<std::string> out;
    for (const auto& [extension, objects] : extensions_)
      for (const bool missing : {true, false})
        if (const Objects& of = objects[missing ? 1 : 0]; of.count > 0)
          out.push_back(sentence(extension, of, missing));
    return out;
  }

 private:
  struct Objects {
    std::size_t count = 0;
    std::string first;
  };
  static std::string sentence(const std::string& extension, const Objects& objects, bool missing) {
    const std::string end = extension + ", which is not read.";
    if (objects.count == 1)
      return "The object " + objects.first +
             (missing ? " was left out: its shape is in the extension "
                      : " lacks a part of its shape: it is in the extension ") +
             end;
    return std::to_string(objects.count) + " objects, first " + objects.first +
           (missing ? ", were left out: their shapes are in the extension "
                    : ", lack parts of their shapes: they are in the extension ") +
           end;
  }
  std::map<std::string, std::array<Objects, 2>> extensions_;  ///< incomplete objects, and missing ones
};

/// Objects of the parts of a package.
class Package {
 public:
  Package(std::optional<ZipReader> zip, const ReadLimits& limits) : zip_(std::move(zip)), limits_(limits) {}

  /// Model of a part, read on first use.
  Result<const Model3mf*> model(const std::string& part) {
    if (const auto found = models_.find(part); found != models_.end()) return &found->second;
    if (!zip_) return make_error(e_parse, "The part " + quote(part) + " is missing.", remedy_correct);
    ModelParser3mf parser(part, limits_);
    const double size = static_cast<double>(zip_->size(part));
    double done = 0;
    const auto unpacked = zip_->unpack(part, [&](std::string_view piece) {
      done += static_cast<double>(piece.size());
      limits_.progress.report(size > 0 ? done / size : 0);
      return parser.feed(piece);
    });
    if (!unpacked) return unpacked.error();
    auto model = parser.finish();
    if (!model) return model.error();
    return put(part, std::move(model).value());
  }
  const Model3mf* put(const std::string& part, Model3mf model) {
    return &models_.insert_or_assign(part, std::move(model)).first->second;
  }

  /// Name of a part as the archive spells it: as written, with percent escapes decoded, or with blanks
  /// escaped; as written where there is none of them.
  std::string spelled(const std::string& name) const {
    if (!zip_ || zip_->has(name)) return name;
    if (const auto decoded = without_escapes(name); decoded && zip_->has(*decoded)) return *decoded;
    std::string escaped;
    for (const char c : name) escaped += c == ' ' ? std::string("%20") : std::string(1, c);
    return zip_->has(escaped) ? escaped : name;
  }

  /// Name of the root model part, which has the build.
  Result<std::string> root() {
    RelationshipTarget target;
    target.part = usual_part;
    if (zip_->has(relationships_part)) {
      target.part.reset();
      XmlReader xml(target, relationships_part, limits_);
      const auto unpacked =
          zip_->unpack(relationships_part, [&](std::string_view piece) { return xml.feed(piece); });
      if (!unpacked) return unpacked.error();
      if (const auto error = xml.finish()) return *error;
    }
    if (target.part) target.part = spelled(*target.part);
    if (target.part && zip_->has(*target.part)) return *target.part;
    return make_error(e_format_unknown, "This archive holds no model of 3MF.",
                      "Unpack it, and open the models that it holds.");
  }
  std::uint64_t unpacked() const { return zip_ ? zip_->unpacked() : 0; }
  const std::map<std::string, Model3mf>& models() const { return models_; }

 private:
  std::optional<ZipReader> zip_;
  const ReadLimits& limits_;
  std::map<std::string, Model3mf> models_;
};

class SceneReader {
 public:
  SceneReader(Package& package, std::uint64_t bytes, const ReadLimits& limits)
      : package_(package), collector_(limits) {
    collector_.add_bytes(bytes);
  }

  Result<ImportedScene> read(const std::string& root) {
    const auto model = package_.model(root);
    if (!model) return model.error();
    const double metres = metres_of_document((*model)->metres_per_unit);
    AffineMap units;
    if (metres != (*model)->metres_per_unit) units.linear *= (*model)->metres_per_unit / metres;
    metres_ = (*model)->metres_per_unit;
    for (const Placed3mf& item : placed_by(**model, root))
      if (auto error = place(item, root, units, "", 0)) return *error;
    for (const auto& [part, read] : package_.models()) collector_.note_degenerate(read.degenerate);
    tell_what_is_not_placed();
    const std::vector<std::string> unread = unread_.sentences();
    for (const std::string& sentence : unread)
      collector_.warn(make_warning(w_left_out, sentence, remedy_plain));
    auto scene = collector_.finish();
    if (!scene && scene.error().code == e_empty && !unread.empty())
      return make_error(e_empty, unread.front(), remedy_plain);
    if (scene) scene.value().metres_per_unit = metres;
    return scene;
  }

 private:
  using Key = std::pair<std::string, std::uint64_t>;  // a part, and the number of an object in it

  /// Items of the build or, without a build, all objects that are not components.
  std::vector<Placed3mf> placed_by(const Model3mf& model, const std::string& root) const {
    if (!model.build.empty()) return model.build;
    std::set<std::uint64_t> components;
    for (const auto& [id, object] : model.objects)
      for (const Placed3mf& component : object.components)
        if (part_of(component, root) == root) components.insert(component.object);
    std::vector<Placed3mf> out;
    for (const auto& [id, object] : model.objects)
      if (!components.contains(id)) out.push_back({id, {}, {}, 0});
    return out;
  }

  /// Name of the part with a placed object; `from`: the part that places it.
  std::string part_of(const Placed3mf& placed, const std::string& from) const {
    return placed.part.empty() ? from : package_.spelled(without_slash(placed.part));
  }

  /// Counts the objects with triangles that neither the build nor a component places.
  void tell_what_is_not_placed() {
    std::size_t count = 0;
    for (const auto& [part, model] : package_.models())
      for (const auto& [id, object] : model.objects)
        if (object.mesh.face_count() > 0 && !noted_.contains({part, id})) ++count;
    if (count > 0)
      collector_.warn(
          make_warning(w_left_out,
                       counted(count, " object of the file that its build does not place was left out.",
                               " objects of the file that its build does not place were left out."),
                       "Add them to the build in the program that wrote the file."));
  }

  static Message wrong(const Placed3mf& placed, const std::string& part, const std::string& sentence) {
    if (placed.line == 0) return make_error(e_parse, sentence, remedy_correct);
    return make_error(e_parse, "Line " + std::to_string(placed.line) + " of " + part + ": " + sentence,
                      remedy_correct, {Element::Kind::line, placed.line});
  }

  /// Places an object with its components. `above`: placement of the enclosing object; `name`: name of the
  /// nearest enclosing object that has one.
  std::optional<Message> place(const Placed3mf& placed, const std::string& from, const AffineMap& above,
                               const std::string& name, std::size_t depth) {
    const std::string part = part_of(placed, from);
    const auto model = package_.model(part);
    if (!model) return model.error();
    const auto found = (*model)->objects.find(placed.object);
    if (found == (*model)->objects.end())
      return wrong(placed, from, "There is no object " + std::to_string(placed.object) + ".");
    if ((*model)->metres_per_unit != metres_)
      return wrong(placed, from, "The part " + quote(part) + " has another unit.");
    const Key key{part, placed.object};
    if (on_the_way_.contains(key))
      return wrong(placed, from, "Object " + std::to_string(placed.object) + " is a component of itself.");
    if (depth == max_nesting) return wrong(placed, from, "Components are nested too deep.");
    if (++placements_ > max_placements)
      return make_error(e_limit,
                        "The file places more than " + std::to_string(max_placements) + " components.",
                        "Place fewer copies before importing it.");
    const Object3mf& object = found->second;
    const AffineMap placement = above.after(placed.placement);
    const std::string& own = object.name.empty() ? name : object.name;
    collector_.add_bytes(package_.unpacked() - std::exchange(counted_, package_.unpacked()));
    if (auto error = collector_.reserve(object.mesh.positions.size(), object.mesh.face_vertices.size()))
      return error;
    if (auto error = collector_.add(object.mesh, placement, own)) return error;
    if (noted_.insert(key).second)
      unread_.note(object, own.empty() ? std::to_string(placed.object) : quote(own));
    on_the_way_.insert(key);
    for (const Placed3mf& component : object.components)
      if (auto error = place(component, part, placement, own, depth + 1)) return error;
    on_the_way_.erase(key);
    return {};
  }

  Package& package_;
  SceneCollector collector_;
  double metres_ = 0.001;
  std::set<Key> on_the_way_, noted_;
  UnreadShapes unread_;
  std::size_t placements_ = 0;
  std::uint64_t counted_ = 0;
};

}  // namespace

bool looks_like_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

Result<ImportedScene> read_3mf(std::string_view bytes, const ReadLimits& limits) {
  if (bytes.empty()) return make_error(e_empty, "The file is empty.", "Export the file again.");
  if (!looks_like_zip(bytes))
    return make_error(e_format_unknown, "The file is no zip archive, as 3MF files are.",
                      "Check that the file is a model in 3MF format.");
  auto zip = ZipReader::open(bytes);
  if (!zip) return zip.error();
  Package package(std::move(zip).value(), limits);
  const auto root = package.root();
  if (!root) return root.error();
  return SceneReader(package, 0, limits).read(*root);
}

Result<ImportedScene> read_3mf_model(std::string_view text, const ReadLimits& limits) {
  ModelParser3mf parser(usual_part, limits);
  parser.feed(text);
  auto model = parser.finish();
  if (!model) return model.error();
  Package package({}, limits);
  package.put(usual_part, std::move(model).value());
  return SceneReader(package, text.size(), limits).read(usual_part);
}

}  // namespace hariko
