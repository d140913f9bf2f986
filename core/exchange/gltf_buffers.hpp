#pragma once

// GltfBuffers: the buffers of a glTF file, and the accessors that look into them. Internal to core/exchange.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/exchange/gltf_accessor.hpp"
#include "core/exchange/gltf_fields.hpp"
#include "core/exchange/read_gltf.hpp"
#include "core/exchange/scene_collector.hpp"

namespace hariko {

/// Borrows all that it is made of. What is wrong is noted in `fields`; what is given then does not count.
class GltfBuffers {
 public:
  /// `binary`: the binary chunk of a .glb file.
  GltfBuffers(nlohmann::json& root, std::optional<std::string_view> binary, GltfFields& fields,
              SceneCollector& collector, const FileBeside& beside)
      : root_(root), binary_(binary), fields_(fields), collector_(collector), beside_(beside) {}

  /// Rows of a type: "SCALAR", "VEC3", "VEC4" or "MAT4". All rows are there. Sparse ones are filled in.
  GltfAccessor accessor(std::uint64_t number, std::string_view type);

 private:
  bool read_rows(const nlohmann::json& found, std::size_t numbers, GltfAccessor& out);
  void fill_in(const nlohmann::json& sparse, const GltfAccessor& out, std::size_t row, std::string& whole);
  std::string_view view_bytes(std::uint64_t number, std::uint64_t& stride);
  std::string_view buffer_bytes(std::uint64_t number);
  const std::string* buffer_content(std::uint64_t number, nlohmann::json& buffer, const std::string& place);
  const std::string* file_content(const std::string& uri);

  nlohmann::json& root_;
  std::optional<std::string_view> binary_;
  GltfFields& fields_;
  SceneCollector& collector_;
  const FileBeside& beside_;
  std::map<std::uint64_t, std::string> inside_;    ///< buffers that were written as text
  std::map<std::string, std::string> files_;       ///< buffers beside, by their paths
  std::map<std::uint64_t, std::string> complete_;  ///< rows of sparse accessors
};

}  // namespace hariko
