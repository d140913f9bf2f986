#pragma once

// Model parts of 3MF files, as their XML text describes them. Internal to core/exchange.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/affine_map.hpp"
#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Reference to an object, with its placement: an item of the build, or a component of another object.
struct Placed3mf {
  std::uint64_t object = 0;
  std::string part;  ///< part with the object, beginning with a slash; empty: the same part
  AffineMap placement;
  std::size_t line = 0;
};

/// Object of a model part: a mesh, or components.
struct Object3mf {
  std::string name;
  PolygonMesh mesh;                   ///< triangles, indices in range
  std::vector<Placed3mf> components;  ///< instead of a mesh
  std::set<std::string> unread;  ///< extensions, as messages name them, with content that shapes the object
};

/// Contents of a model part.
struct Model3mf {
  double metres_per_unit = 0.001;
  std::map<std::uint64_t, Object3mf> objects;
  std::vector<Placed3mf> build;
  std::size_t degenerate = 0;  ///< triangles that were left out
};

/// Parser of a model part, fed piece by piece while it is unpacked.
class ModelParser3mf {
 public:
  /// `part` names the text in messages.
  ModelParser3mf(std::string part, const ReadLimits& limits);
  ~ModelParser3mf();
  /// Parses the next piece; false where the text is refused, for the reason that `finish` returns.
  bool feed(std::string_view piece);
  /// Ends the text. Errors: those of `read_3mf` that concern one part.
  Result<Model3mf> finish();

 private:
  class Handler;
  std::unique_ptr<Handler> handler_;
};

}  // namespace hariko
