// Headers that most of the core includes beyond those of libraries: meshes, surfaces and what they are made
// of. A file includes what it needs all the same.
#include <charconv>
#include <numeric>
#include <stdexcept>
#include <variant>
#include "cmake/precompiled.hpp"
#include "core/base/parallel.hpp"
#include "core/base/result.hpp"
#include "core/geometry/triangle.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/bicubic_patch.hpp"
#include "core/surface/surface.hpp"
