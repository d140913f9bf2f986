#pragma once

// Small pictures of documents: what they show, and textures of them for the interface.

#include <imgui.h>

#include <filesystem>
#include <optional>

#include "core/base/cancellation.hpp"
#include "render/renderer.hpp"

namespace hariko {

/// Contents of the picture of a file: surfaces and what they are made from. Without objects when the file
/// cannot be read. For a worker.
Scene file_scene(const std::filesystem::path& path, const CancelToken& cancel);
/// The camera of such a picture, with a margin round the model.
Camera file_camera(const Scene& scene, PixelSize size);

/// Draws it; nothing when there is nothing to see. Uses the renderer's `thumbnail_picture`.
std::optional<Image> draw_picture(Renderer& renderer, const Scene& scene, PixelSize size);
/// Makes a texture that lives as long as the GL context, or until it is released.
ImTextureID upload_picture(const Image& image);
/// Frees a picture that nothing shows any more; null is fine.
void release_picture(ImTextureID picture);

}  // namespace hariko
