#pragma once

// Thumbnails of documents: their scenes, pictures and textures for the interface.

#include <filesystem>
#include <optional>

#include "core/base/cancellation.hpp"
#include "render/renderer.hpp"

namespace hariko {

/// Scene of a file's thumbnail: surfaces and their sources. Without objects where the file cannot be read.
/// For a worker.
Scene file_scene(const std::filesystem::path& path, const CancelToken& cancel);
/// Camera of a thumbnail, with a margin round the model.
Camera file_camera(const Scene& scene, PixelSize size);

/// Draws a thumbnail; nothing where there is nothing to show. Uses the renderer's `thumbnail_picture`.
std::optional<Image> draw_picture(Renderer& renderer, const Scene& scene, PixelSize size);
/// Makes a texture that lives until it is released, or as long as the GL context. Returns its name.
unsigned upload_picture(const Image& image);
/// Frees the texture of a picture that is not shown any more; 0 is allowed.
void release_picture(unsigned texture);

}  // namespace hariko
