#pragma once

// Objects and groups of an OBJ file as parts. Internal to core/exchange.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Notes where objects and groups begin while faces are read.
class ObjParts {
 public:
  /// A statement `o` or `g`, before face number `face`.
  void begin_object(std::string_view name, std::size_t face);
  void begin_group(std::string_view name, std::size_t face);

  /// Name of the whole: of the first object, else the first group; printable.
  const std::string& first_name() const { return object_name_.empty() ? group_name_ : object_name_; }

  /// Name of what is read now: of the object, else the group.
  std::string current_name() const {
    return !objects_.empty() ? objects_.back().name : groups_.empty() ? std::string() : groups_.back().name;
  }

  /// The mesh taken apart: each object is a part, or each set of groups that meet in some place. One part
  /// alone keeps the mesh as it is, and so do more than `ImportedScene::max_parts`. O(corners log corners).
  std::vector<ImportedPart> split(PolygonMesh mesh, std::vector<std::array<Index, 2>> creases,
                                  std::vector<Index> corners) const;

 private:
  struct Run {
    std::size_t face = 0;  ///< the first
    std::string name;
  };
  std::vector<std::size_t> part_of_faces(const PolygonMesh& mesh, std::vector<std::string>& names) const;

  std::vector<Run> objects_, groups_;
  std::string object_name_, group_name_;
};

}  // namespace hariko
