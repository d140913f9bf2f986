#pragma once

// Samples: the documents that come with the program, and their pictures on the start page.

#include <filesystem>
#include <optional>
#include <vector>

#include "render/renderer.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

/// Documents in the samples folder, in the order of their names; titles come from the names.
std::vector<Sample> find_samples(const std::filesystem::path& assets);

/// What a picture of a sample is drawn from; null members when the sample cannot be read. For a worker.
Scene sample_scene(const std::filesystem::path& path, const CancelToken& cancel);

/// Draws it; nothing when there is nothing to see. Uses the renderer's `thumbnail_picture`.
std::optional<Image> draw_picture(Renderer& renderer, const Scene& scene, PixelSize size);
/// Makes a texture that lives as long as the GL context.
ImTextureID upload_picture(const Image& image);
/// Frees a picture that nothing shows any more; null is fine.
void release_picture(ImTextureID picture);
/// Both, in the size of the start page's cards; null when there is nothing to see.
ImTextureID sample_picture(Renderer& renderer, const Scene& scene);

}  // namespace hariko
