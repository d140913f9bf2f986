#pragma once

// Division of an OBJ file into parts by its objects and groups. Internal to core/exchange.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Records where objects and groups begin while faces are read.
class ObjParts {
 public:
  /// Records a statement `o` before face number `face`.
  void begin_object(std::string_view name, std::size_t face);
  /// Records a statement `g` before face number `face`.
  void begin_group(std::string_view name, std::size_t face);

  /// Name for the whole file: the first object's, else the first group's; printable.
  const std::string& first_name() const { return object_name_.empty() ? group_name_ : object_name_; }

  /// Name of the present object, else of the present group.
  std::string current_name() const {
    return !objects_.empty() ? objects_.back().name : groups_.empty() ? std::string() : groups_.back().name;
  }

  /// Adds W_NAME_LETTERS where letters of names are in an old encoding.
  void warn(std::vector<Message>& warnings) const;

  /// Splits the mesh: each object is a part or, where there is none, each set of groups that touch. A single
  /// part keeps the mesh unchanged, and so do more than `ImportedScene::max_parts`, whose number is then in
  /// `joined`; but with `only_used` a single part, too, has only the vertices of its faces. O(corners log
  /// corners).
  std::vector<ImportedPart> split(PolygonMesh mesh, std::vector<std::array<Index, 2>> creases,
                                  std::vector<Index> corners, bool only_used, std::size_t& joined) const;

 private:
  struct Run {
    std::size_t face = 0;  ///< first face
    std::string name;
  };
  std::vector<std::size_t> part_of_faces(const PolygonMesh& mesh, std::vector<std::string>& names) const;

  std::string shown_name(std::string_view name);

  std::vector<Run> objects_, groups_;
  std::size_t old_letters_ = 0;  ///< bytes of names that are not UTF-8
  bool japanese_ = false;        ///< some of them were read as Shift-JIS
  std::string object_name_, group_name_;
};

}  // namespace hariko
