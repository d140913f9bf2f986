#pragma once

// Free-form surfaces of OBJ files, as Bezier patches. Internal to core/exchange.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/named_patches.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

/// Reader of the statements `cstype`, `deg`, `surf`, `curv`, `parm`, `trim`, `hole` and `end`, and of the
/// older `bzp`, `bsp`, `cdp` and `cdc`. Surfaces may refer to vertices that come later.
class ObjSurfaces {
 public:
  /// Whether a statement belongs to free forms.
  static bool knows(std::string_view keyword);
  /// Reads the rest of a statement. `vertices`: number of vertices read so far. Errors: E_PARSE, E_LIMIT.
  std::optional<Message> read(std::string_view keyword, TextScanner& scanner, std::size_t vertices,
                              const std::string& object);

  /// Warning about the surfaces that were left out because they are not Bezier patches; nothing where there
  /// are none.
  std::optional<Message> left_out() const;
  /// Adds W_LEFT_OUT where surfaces, trimming curves or curves were left out.
  void warn(std::vector<Message>& warnings) const;
  bool empty() const { return surfaces_.empty(); }
  /// Objects, one for each name, with their patches in order, each as far as the parameter range of its
  /// surface goes. `weights`: one for each vertex, 1 where the
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
    std::array<double, 4> range{};  ///< parameters of the ends: of u, then of v
    std::vector<double> knots_u,
        knots_v;  ///< parameters of the sides of patches; NaN where they are no numbers
    std::size_t columns() const { return std::max<std::size_t>(knots_u.size(), 2) - 1; }
    std::size_t rows() const { return std::max<std::size_t>(knots_v.size(), 2) - 1; }
    bool trimmed = false;
    std::vector<std::int64_t> vertices;  ///< counted from 0, possibly out of range
  };
  Surface surface_here(const TextScanner& scanner, const std::string& object) const;
  std::optional<Message> read_surface(TextScanner& scanner, std::size_t vertices, const std::string& object);
  std::optional<Message> read_points(TextScanner& scanner, std::size_t vertices, Surface out);
  static void add_patches(const Surface& surface, const std::vector<Vector3>& positions,
                          const std::vector<double>& weights, std::vector<BezierPatch>& out);

  bool bezier_ = false, rational_ = false;
  std::int64_t degree_u_ = 0, degree_v_ = 0;
  std::vector<Surface> surfaces_;
  bool open_ = false;  ///< the last surface has no `end` yet
  std::size_t left_out_ = 0, curves_ = 0, corners_ = 0;
};

}  // namespace hariko
