#pragma once

// Free-form surfaces of OBJ files, as Bezier patches. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/named_patches.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

/// Reader of the statements `cstype`, `deg`, `surf`, `parm` and `end`. Surfaces may refer to vertices that
/// come later.
class ObjSurfaces {
 public:
  /// Whether a statement belongs to free forms.
  static bool knows(std::string_view keyword);
  /// Reads the rest of a statement. `vertices`: number of vertices read so far. Errors: E_PARSE, E_LIMIT.
  std::optional<Message> read(std::string_view keyword, TextScanner& scanner, std::size_t vertices,
                              const std::string& object);

  /// Number of surfaces that were left out because they are not Bezier patches.
  std::size_t left_out() const { return left_out_; }
  bool empty() const { return surfaces_.empty(); }
  /// Objects, one for each name, with their patches in order. `weights`: one for each vertex, 1 where the
  /// file gives none. Errors: E_INDEX_RANGE, E_PARSE where the number of points is wrong, E_LIMIT, those of
  /// `check_patch`. O(points).
  Result<std::vector<NamedPatches>> patches(const std::vector<Vector3>& positions,
                                            const std::vector<double>& weights) const;

 private:
  struct Surface {
    std::string object;
    std::size_t line = 0;
    bool rational = false;
    int degree_u = 0, degree_v = 0;
    std::size_t knots_u = 2, knots_v = 2;
    std::vector<std::int64_t> vertices;  ///< counted from 0, possibly out of range
  };
  std::optional<Message> read_surface(TextScanner& scanner, std::size_t vertices, const std::string& object);

  bool bezier_ = false, rational_ = false;
  std::int64_t degree_u_ = 0, degree_v_ = 0;
  std::vector<Surface> surfaces_;
  bool open_ = false;  ///< the last surface has no `end` yet
  std::size_t left_out_ = 0, corners_ = 0;
};

}  // namespace hariko
