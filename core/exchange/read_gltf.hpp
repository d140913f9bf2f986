#pragma once

// glTF 2.0 files, binary (.glb) or JSON (.gltf).

#include <functional>
#include <string>
#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// The bytes of a file beside the one that is read, named by a relative path that stays in its folder.
using FileBeside = std::function<Result<std::string>(const std::string& path)>;

/// Every node of the default scene (of all scenes, where none is) that has a mesh becomes a part, all
/// triangle primitives together, z up and in millimetres. Vertices of a mesh at the same place become one:
/// files have several where normals differ. Mirrored nodes keep their outside. Meshes with skins stand as
/// their joints carry them, and shape keys count with the weights that they have at rest. Instances
/// (EXT_mesh_gpu_instancing) are parts of their own. A warning tells of what has no triangles, of animations
/// and shape keys, which are left out, and of extensions that are used, but not read.
///
/// Errors: E_PARSE (the text names the place, as "accessors[3]"), E_TRUNCATED, E_INDEX_RANGE, E_EMPTY,
/// E_LIMIT; E_FORMAT_UNKNOWN for other versions, compressed geometry and other extensions that shapes depend
/// on; E_FILE_OPEN for buffers that are not in the folder. Nodes that are reached
/// twice, cycles among them, are E_PARSE. Expected time O(size).
Result<ImportedScene> read_gltf(std::string_view bytes, const ReadLimits& limits = {},
                                const FileBeside& beside = {});

}  // namespace hariko
