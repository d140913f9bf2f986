#pragma once

// 3MF files (core specification 1.3, and the production extension's references to other parts).

#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// True for zip archives.
bool looks_like_zip(std::string_view bytes);

/// Every mesh that an item of the build places, itself or by components, becomes a part, in its place; where
/// nothing is built, every object that is no component of another. In the file's unit where a document can
/// have it, otherwise in millimetres. Mirrored meshes keep their outside.
///
/// Errors: E_PARSE (lines counted in the part that is named), E_INDEX_RANGE, E_EMPTY, E_TRUNCATED where the
/// archive is not whole, E_LIMIT also where it unpacks to more than 100 times its size; E_FORMAT_UNKNOWN
/// where it has no model, or needs an extension that shapes depend on. Objects that are components of
/// themselves are E_PARSE. O(size).
Result<ImportedScene> read_3mf(std::string_view bytes, const ReadLimits& limits = {});

/// The same for the text of a model alone, without an archive round it.
Result<ImportedScene> read_3mf_model(std::string_view text, const ReadLimits& limits = {});

}  // namespace hariko
