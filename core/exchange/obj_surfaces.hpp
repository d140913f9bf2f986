#pragma once

// Free forms of OBJ files: Bezier patches. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/named_patches.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

/// Reads the statements `cstype`, `deg`, `surf`, `parm` and `end`. Surfaces may name vertices that come
/// later.
class ObjSurfaces {
 public:
  static bool knows(std::string_view keyword);
  /// The rest of a statement. `vertices`: that were read so far. Errors: E_PARSE, E_LIMIT.
  std::optional<Message> read(std::string_view keyword, TextScanner& scanner, std::size_t vertices,
                              const std::string& object);

  /// Surfaces that are none of Bezier patches, and so were left out.
  std::size_t left_out() const { return left_out_; }
  bool empty() const { return surfaces_.empty(); }
  /// One object for each name, patches in their order. `weights`: one a vertex, 1 where the file says none.
  /// Errors: E_INDEX_RANGE, E_PARSE where the number of points does not fit, E_LIMIT, those of `check_patch`.
  Result<std::vector<NamedPatches>> patches(const std::vector<Vector3>& positions,
                                            const std::vector<double>& weights) const;

 private:
  struct Surface {
    std::string object;
    std::size_t line = 0;
    bool rational = false;
    int degree_u = 0, degree_v = 0;
    std::size_t knots_u = 2, knots_v = 2;
    std::vector<std::int64_t> vertices;  ///< from 0, maybe out of range
  };
  std::optional<Message> read_surface(TextScanner& scanner, std::size_t vertices, const std::string& object);

  bool bezier_ = false, rational_ = false;
  std::int64_t degree_u_ = 0, degree_v_ = 0;
  std::vector<Surface> surfaces_;
  bool open_ = false;  ///< the last surface has not ended
  std::size_t left_out_ = 0, corners_ = 0;
};

}  // namespace hariko
