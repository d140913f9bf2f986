#pragma once

// Reader of glTF 2.0 files, binary (.glb) or JSON (.gltf).

#include <functional>
#include <string>
#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Loader of a file beside the one that is read, by a relative path that stays in its folder.
using SidecarReader = std::function<Result<std::string>(const std::string& path)>;

/// The default scene of the file has no objects, so another one was read.
inline constexpr Code w_other_scene{"W_OTHER_SCENE"};

/// Reads a glTF file. Every node with a mesh in the default scene (where it has none, in the first scene that
/// has some; without scenes, every node with a mesh; without nodes, every mesh) becomes a part: all its
/// triangle primitives together, z up and in millimetres. Vertices of a mesh at equal positions are joined,
/// as files split them where normals differ. Mirrored nodes keep their outside. Skinned meshes are deformed
/// by the joints at rest; shape keys (morph targets) are applied with their weights at rest. Instances
/// (EXT_mesh_gpu_instancing) are separate parts. Warnings list what is left out: objects of other scenes and
/// of none, primitives without triangles, animations and shape keys; and extensions that are used but not
/// read.
///
/// Errors: E_PARSE (the text names the place, as "accessors[3]"; also for nodes that are reached twice,
/// cycles among them), E_TRUNCATED, E_INDEX_RANGE, E_EMPTY, E_LIMIT, E_FORMAT_UNKNOWN for other versions,
/// compressed geometry and other required extensions that affect shapes, E_FILE_OPEN for buffers outside the
/// folder. Expected time O(size).
Result<ImportedScene> read_gltf(std::string_view bytes, const ReadLimits& limits = {},
                                const SidecarReader& beside = {});

}  // namespace hariko
