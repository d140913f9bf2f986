#pragma once

// Origin of solids, skins and outlines in files: read, and carried by the place of the object from then on.

#include "core/document/format/archive.hpp"

namespace hariko::detail {

/// Version since which these kinds have an origin; older files may keep an unknown member of that name.
inline constexpr int origin_since_version = 8;

/// Takes the member "origin", which the description of the object reads. Nothing is written: the object's
/// place has it.
template <class Archive>
void describe_origin(Archive& archive) {
  if (!archive.before(origin_since_version)) archive.known({"origin"});
}

}  // namespace hariko::detail
