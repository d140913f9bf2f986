#pragma once

// Mirror images of sources of every kind.

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Whether the source has a mirror image as a source. Pictures do not, as their pixels would have to be
/// turned; nor do sources of an unknown kind.
bool can_be_mirrored(const Object& object);

/// Source of the object, which `can_be_mirrored`, reflected in the plane through the zero of its own space
/// perpendicular to an axis. Coordinates change their sign and nothing else, so that the image of the image
/// is the source again (angles of solids to rounding). Surfaces and facets stay oriented outward; live
/// mirrors, planes of symmetry, tensions, pins and frozen sides of attachments are reflected along. Edges
/// that are attached to patches are released, as the patches stay where they are. Errors: E_NONFINITE and
/// those of the sources, for points that are out of range. O(points).
Result<Source> mirrored_source(const Object& object, Axis axis);

}  // namespace hariko
