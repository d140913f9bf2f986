#pragma once

// GltfBuffers: buffers of a glTF file and the accessors that view them. Internal to core/exchange.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/exchange/gltf/gltf_accessor.hpp"
#include "core/exchange/gltf/gltf_fields.hpp"
#include "core/exchange/gltf/read_gltf.hpp"
#include "core/exchange/scene_collector.hpp"

namespace hariko {

/// Reader of buffers and accessors. Borrows all constructor arguments. Errors are noted in `fields`; results
/// after an error do not count.
class GltfBuffers {
 public:
  /// `binary`: the binary chunk of a .glb file.
  GltfBuffers(nlohmann::json& root, std::optional<std::string_view> binary, GltfFields& fields,
              SceneCollector& collector, const SidecarReader& beside)
      : root_(root), binary_(binary), fields_(fields), collector_(collector), beside_(beside) {}

  /// Accessor of a type: "SCALAR", "VEC3", "VEC4" or "MAT4". Its rows pass `check_rows`; sparse rows are
  /// filled in. Memory is counted by the collector.
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
  const SidecarReader& beside_;
  std::map<std::uint64_t, std::string> inside_;    ///< buffers embedded as text, by number
  std::map<std::string, std::string> files_;       ///< buffers in other files, by path
  std::map<std::uint64_t, std::string> complete_;  ///< filled-in rows of sparse accessors, by number
};

}  // namespace hariko
