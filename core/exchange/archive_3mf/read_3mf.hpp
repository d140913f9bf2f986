#pragma once

// Reader of 3MF files (core specification 1.3, and references to other parts of the production extension).

#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Whether the bytes begin as a zip archive.
bool looks_like_zip(std::string_view bytes);

/// Reads a 3MF archive. Every mesh that an item of the build places, directly or through components, becomes
/// a part, in its place; without a build, every object that is not a component of another. Lengths are in the
/// file's unit where a document can have it, otherwise in millimetres. Mirrored meshes keep their outside.
/// Warnings count objects, placed ones, that extensions shape which are not read (beams, slices). Names of
/// parts are found with percent escapes and without.
///
/// Errors: E_PARSE (with the line in the named part; also for objects that are components of themselves),
/// E_INDEX_RANGE, E_EMPTY, E_TRUNCATED where the archive is incomplete, E_LIMIT, also where it unpacks to
/// more than 100 times its size, E_FORMAT_UNKNOWN where it has no model or requires an extension that affects
/// shapes. O(size).
Result<ImportedScene> read_3mf(std::string_view bytes, const ReadLimits& limits = {});

/// Reads the text of a single model part, without an archive.
Result<ImportedScene> read_3mf_model(std::string_view text, const ReadLimits& limits = {});

}  // namespace hariko
