#pragma once

// The model part of a 3MF file: its objects as the XML text says. Internal to core/exchange.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/placement.hpp"

namespace hariko {

/// An object that is placed: by the build, or as a component of another one.
struct Placed3mf {
  std::uint64_t object = 0;
  std::string part;  ///< where it is, with a slash at its beginning; empty: the same part
  Placement placement;
  std::size_t line = 0;
};

struct Object3mf {
  std::string name;
  PolygonMesh mesh;                   ///< triangles, indices in range
  std::vector<Placed3mf> components;  ///< instead of a mesh
};

struct Model3mf {
  double metres_per_unit = 0.001;
  std::map<std::uint64_t, Object3mf> objects;
  std::vector<Placed3mf> build;
  std::size_t degenerate = 0;  ///< triangles that were left out
};

/// Reads the text piece by piece as it is unpacked.
class ModelParser3mf {
 public:
  /// `part` is what messages call it.
  ModelParser3mf(std::string part, const ReadLimits& limits);
  ~ModelParser3mf();
  /// False where the text is refused; `finish` then says why.
  bool feed(std::string_view piece);
  /// Ends the text. Errors: those of `read_3mf` about one part.
  Result<Model3mf> finish();

 private:
  class Handler;
  std::unique_ptr<Handler> handler_;
};

}  // namespace hariko
