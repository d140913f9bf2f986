#pragma once

// Document: the designer's work, as a value. Ordered objects, each with one source.

#include <memory>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/document/dimension.hpp"
#include "core/document/display.hpp"
#include "core/document/group.hpp"
#include "core/document/history/shared.hpp"
#include "core/document/live_copies.hpp"
#include "core/document/making.hpp"
#include "core/document/paper_model.hpp"
#include "core/document/saved_view.hpp"
#include "core/document/similarity.hpp"
#include "core/document/source.hpp"

namespace hariko {

inline constexpr Code e_unknown_object{"E_UNKNOWN_OBJECT"};
inline constexpr Code e_name_empty{"E_NAME_EMPTY"};
inline constexpr Code e_name_invalid{"E_NAME_INVALID"};
inline constexpr Code e_too_many_objects{"E_TOO_MANY_OBJECTS"};

/// Unit of all lengths of a document.
enum class Unit : std::uint8_t { millimetre, centimetre, metre, inch };

/// Symbol of the unit: "mm", "cm", "m", "in".
std::string_view to_string(Unit unit);
/// Length of the unit in millimetres.
double millimetres_per(Unit unit);

/// Object: a named, placed source with its display. Invariant: the name is not blank, at most
/// `max_name_length` bytes of UTF-8 without control characters.
struct Object {
  ObjectId id;
  std::string name;
  bool visible = true;   ///< it is shown: its own switch is on, and that of all groups round it
  bool locked = false;   ///< shown, but edits of its shape, placement and existence are refused (E_LOCKED)
  Similarity transform;  ///< from object space to the document's space
  DisplaySettings display;
  Source source;
  Shared<KeptMembers> kept;
  GroupId group = {};  ///< group that it lies in; none: it lies in no group
  // Derived by `with_group_switches`, so that `visible` and `locked` are what counts everywhere: set where
  // the object is hidden or locked by a group round it alone, and by its own switch it would not be.
  bool hidden_by_group = false;
  bool locked_by_group = false;
  /// Further places at which the same source is shown, measured and written; in the object's own space, so
  /// that whatever moves, turns or scales the object takes them along.
  Shared<LiveCopies> copies = {};

  static constexpr std::size_t max_name_length = 256;

  bool visible_itself() const { return visible || hidden_by_group; }  ///< its own switch
  bool locked_itself() const { return locked && !locked_by_group; }   ///< its own switch

  const PolyhedronSource* polyhedron() const { return std::get_if<PolyhedronSource>(&source); }
  const MeshSource* mesh() const { return std::get_if<MeshSource>(&source); }
  const PatchSource* patches() const { return std::get_if<PatchSource>(&source); }
  const BezierSource* bezier() const { return std::get_if<BezierSource>(&source); }
  const SolidsSource* solids() const { return std::get_if<SolidsSource>(&source); }
  const SkinSource* skin() const { return std::get_if<SkinSource>(&source); }
  const OutlineSource* outline() const { return std::get_if<OutlineSource>(&source); }
  const PictureSource* picture() const { return std::get_if<PictureSource>(&source); }
  /// Selectable mesh of the object: its polyhedron, or the control net of its patches. Null otherwise.
  const Polyhedron* cage() const {
    if (const PolyhedronSource* own = polyhedron()) return &own->polyhedron;
    return patches() ? &patches()->net : nullptr;
  }
  /// Whether a smooth surface is made from the object.
  bool has_surface() const { return cage() || bezier() || solids() || skin() || outline(); }
  /// Live mirror that completes the object; null where it has none.
  const Mirror* live_mirror() const {
    const PolyhedronSource* own = polyhedron();
    return own && own->mirror ? &*own->mirror : nullptr;
  }
  /// Origin of the cage's positions.
  Vector3 cage_origin() const {
    if (const PolyhedronSource* own = polyhedron()) return own->origin;
    return patches() ? patches()->origin : Vector3(Vector3::Zero());
  }

  friend bool operator==(const Object&, const Object&) = default;
};

/// Coordinate system: right-handed, z up, the front view looks along +y. Invariants: object ids are unique
/// and below next_object_id; groups are as `Group` says, and every object's group exists; no pointer of an
/// object is null. A copy shares its objects; an edit replaces the object it changes. Equal pointers mean
/// equal objects.
struct Document {
  Unit unit = Unit::millimetre;
  std::vector<std::shared_ptr<const Object>> objects;
  ObjectId next_object_id{1};
  std::shared_ptr<const PaperModel> paper;  ///< null: there is no paper model
  Shared<Dimensions> dimensions;            ///< in the order in which they were made; ids are unique
  Shared<Groups> groups;                    ///< ascending ids
  Shared<SavedViews> saved_views;           ///< in the order in which they were saved; names are unique
  MakingSettings making;                    ///< limits of making, and what is compared
  Shared<KeptMembers> kept;

  static constexpr std::size_t max_objects = 100000;
  static constexpr std::size_t max_dimensions = 10000;
  static constexpr std::size_t max_views = 1000;

  /// Object with this id, or nullptr. O(objects).
  const Object* find(ObjectId id) const;
  std::shared_ptr<const Object> find_shared(ObjectId id) const;

  friend bool operator==(const Document& a, const Document& b);
};

/// Makes a new document with one polyhedron and all settings at their defaults. Errors: those of
/// `PolyhedronSource::from_mesh` and of `check_name`.
Result<Document> document_from_mesh(PolygonMesh mesh, std::string name);

/// Checks the name of an object. Errors: E_NAME_EMPTY, E_NAME_INVALID.
Result<Done> check_name(std::string_view name);

}  // namespace hariko
