#include "render/display_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

using Chunk = DisplayMesh::Chunk;
using Curves = DisplayMesh::Curves;

constexpr std::size_t chunk_grain = 2;

/// Buffers for the evaluation of up to a chunk's patches.
struct Scratch {
  std::vector<Vector3> positions, normals;
};

/// Evaluates `patches`, all of the chunk that begins with patch `first`.
void fill_chunk(const Surface& surface, const GridPattern& pattern, const std::vector<Vector2>& parameters,
                const MapFunction& map, std::span<const Index> patches, Index first, Chunk& chunk,
                Scratch& scratch) {
  const auto n = static_cast<std::size_t>(pattern.point_count());
  scratch.positions.resize(n * patches.size());
  scratch.normals.resize(n * patches.size());
  surface.patches().evaluate_grid(patches, pattern, scratch.positions, scratch.normals);
  const auto as_floats = [](const Vector3& v) {
    return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()),
                                static_cast<float>(v.z())};
  };
  for (std::size_t k = 0; k < patches.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) {
      Vector3 normal = scratch.normals[k * n + i];
      // The fast evaluation gives no normal where derivatives are parallel; the surface then derives one from
      // the node's tangent plane.
      if (!(normal.squaredNorm() > 0.25)) normal = surface.normal(patches[k], parameters[i]);
      chunk.vertices[(patches[k] - first) * n + i] = {as_floats(scratch.positions[k * n + i]),
                                                      as_floats(normal)};
    }
  if (map) {
    std::vector<float> values(n * patches.size());
    map(surface, patches, pattern, values);
    for (std::size_t k = 0; k < patches.size(); ++k)
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(k * n), n,
                  chunk.values.begin() + static_cast<std::ptrdiff_t>((patches[k] - first) * n));
  }
  chunk.box.setEmpty();
  for (const DisplayVertex& vertex : chunk.vertices)
    chunk.box.extend(
        Vector3(double(vertex.position[0]), double(vertex.position[1]), double(vertex.position[2])));
}

/// Mesh vertices of the part of a side between two fractions; whole intervals only.
std::vector<Index> side_vertices(const GridPattern& pattern, const PatchSide& at, double begin, double end) {
  const std::vector<int> side = pattern.side(at.side);
  const Index base = at.patch * static_cast<Index>(pattern.point_count());
  const double low = std::min(begin, end) * pattern.density, high = std::max(begin, end) * pattern.density;
  const int first = std::clamp(static_cast<int>(std::lround(low)), 0, pattern.density);
  const int last = std::clamp(static_cast<int>(std::lround(high)), 0, pattern.density);
  std::vector<Index> out;
  for (int i = first; i <= last; ++i)
    out.push_back(base + static_cast<Index>(side[static_cast<std::size_t>(i)]));
  return out;
}

void add_curve(Curves& curves, CurveKind kind, const Element& source, Index seam,
               const std::vector<Index>& points) {
  auto& segments = curves.segments[static_cast<std::size_t>(kind)];
  DisplayCurve curve{kind, static_cast<Index>(segments.size()), 0, source, seam};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Index previous = points[i > 0 ? i - 1 : 0], next = points[std::min(i + 2, points.size() - 1)];
    segments.push_back({{previous, points[i], points[i + 1], next}});
  }
  curve.segment_count = static_cast<Index>(segments.size()) - curve.first_segment;
  curves.curves.push_back(curve);
}

std::shared_ptr<const Curves> make_curves(const Surface& surface, const GridPattern& pattern) {
  auto curves = std::make_shared<Curves>();
  const auto& seams = surface.seams();
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const Seam& seam = seams[s];
    CurveKind kind = CurveKind::network;
    if (seam.intended == Continuity::g0)
      kind = CurveKind::crease;
    else if (seam.source.kind == Element::Kind::none)
      kind = CurveKind::split;
    add_curve(*curves, kind, seam.source, static_cast<Index>(s),
              side_vertices(pattern, seam.first, seam.first_begin, seam.first_end));
  }
  for (std::size_t b = 0; b < surface.boundary_sides().size(); ++b)
    add_curve(*curves, CurveKind::boundary, surface.boundary_sources()[b], no_index,
              side_vertices(pattern, surface.boundary_sides()[b], 0, 1));
  return curves;
}

}  // namespace

int display_density(Index patch_count, Domain domain, double triangle_budget) {
  const double per_cell = domain == Domain::triangle ? 1 : 2;
  const double density = std::sqrt(triangle_budget / (per_cell * std::max<double>(patch_count, 1)));
  return std::clamp(static_cast<int>(density), 3, 32);
}

std::shared_ptr<const DisplayMesh> DisplayMesh::build(const Surface& surface, const DisplayOptions& options,
                                                      const CancelToken& cancel) {
  HARIKO_ASSERT(options.density >= 1, "a density is at least 1");
  std::shared_ptr<DisplayMesh> mesh(new DisplayMesh);
  mesh->origin_ = surface.origin();
  mesh->options_ = options;
  mesh->patch_count_ = surface.patch_count();
  mesh->curves_ = std::make_shared<Curves>();
  mesh->seam_values_ = std::make_shared<std::vector<float>>();
  mesh->provenance_ = std::make_shared<std::vector<Provenance>>();
  if (mesh->patch_count_ == 0) return mesh;
  mesh->provenance_ = std::make_shared<std::vector<Provenance>>(surface.provenance());
  mesh->pattern_ = {surface.domain(), options.density};
  const GridPattern& pattern = mesh->pattern_;
  const std::vector<Vector2> parameters = pattern.parameters();
  const auto n = static_cast<std::size_t>(pattern.point_count());
  const std::size_t chunk_count = (mesh->patch_count_ + patches_per_chunk - 1) / patches_per_chunk;
  mesh->chunks_.resize(chunk_count);
  parallel_for(chunk_count, chunk_grain, [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t c = begin; c < end && !cancel.cancelled(); ++c) {
      const Index first = static_cast<Index>(c) * patches_per_chunk;
      std::vector<Index> patches(std::min(patches_per_chunk, mesh->patch_count_ - first));
      std::iota(patches.begin(), patches.end(), first);
      auto chunk = std::make_shared<Chunk>();
      chunk->vertices.resize(n * patches.size());
      if (options.map) chunk->values.resize(n * patches.size());
      fill_chunk(surface, pattern, parameters, options.map, patches, first, *chunk, scratch);
      mesh->chunks_[c] = std::move(chunk);
    }
  });
  if (cancel.cancelled()) return nullptr;
  for (const auto& chunk : mesh->chunks_) mesh->box_.extend(chunk->box);
  mesh->curves_ = make_curves(surface, pattern);
  if (options.edge_map) {
    const std::size_t stride = static_cast<std::size_t>(options.density) + 1;
    auto values = std::make_shared<std::vector<float>>(surface.seams().size() * stride);
    parallel_for(surface.seams().size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
        options.edge_map(surface, static_cast<Index>(s), options.density,
                         std::span<float>(values->data() + s * stride, stride));
    });
    mesh->seam_values_ = std::move(values);
  }
  return mesh;
}

std::shared_ptr<const DisplayMesh> DisplayMesh::refreshed(const Surface& surface,
                                                          std::span<const Index> changed) const {
  HARIKO_ASSERT(surface.patch_count() == patch_count_ && surface.origin() == origin_,
                "a refreshed mesh keeps its patches and origin");
  std::shared_ptr<DisplayMesh> mesh(new DisplayMesh(*this));
  if (!changed.empty()) mesh->seam_values_ = std::make_shared<std::vector<float>>();
  std::vector<Index> sorted(changed.begin(), changed.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  HARIKO_ASSERT(sorted.empty() || sorted.back() < patch_count_, "patch out of range");
  std::vector<std::span<const Index>> groups;  // one for each affected chunk
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t j = i;
    while (j < sorted.size() && sorted[j] / patches_per_chunk == sorted[i] / patches_per_chunk) ++j;
    groups.push_back(std::span<const Index>(sorted).subspan(i, j - i));
    i = j;
  }
  const std::vector<Vector2> parameters = pattern_.parameters();
  parallel_for(groups.size(), chunk_grain, [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t g = begin; g < end; ++g) {
      const Index c = groups[g].front() / patches_per_chunk;
      auto chunk = std::make_shared<Chunk>(*chunks_[c]);
      fill_chunk(surface, pattern_, parameters, options_.map, groups[g], c * patches_per_chunk, *chunk,
                 scratch);
      mesh->chunks_[c] = std::move(chunk);
    }
  });
  mesh->box_.setEmpty();
  for (const auto& chunk : mesh->chunks_) mesh->box_.extend(chunk->box);
  return mesh;
}

std::size_t DisplayMesh::triangle_count() const {
  const auto n = static_cast<std::size_t>(pattern_.density);
  return std::size_t(patch_count_) * n * n * (pattern_.domain == Domain::triangle ? 1 : 2);
}

const DisplayVertex& DisplayMesh::vertex(std::size_t number) const {
  HARIKO_ASSERT(number < vertex_count(), "vertex out of range");
  const std::size_t per_chunk = std::size_t(patches_per_chunk) * vertices_per_patch();
  return chunks_[number / per_chunk]->vertices[number % per_chunk];
}

float DisplayMesh::value(std::size_t number) const {
  if (!has_values()) return std::numeric_limits<float>::quiet_NaN();
  HARIKO_ASSERT(number < vertex_count(), "vertex out of range");
  const std::size_t per_chunk = std::size_t(patches_per_chunk) * vertices_per_patch();
  return chunks_[number / per_chunk]->values[number % per_chunk];
}

std::vector<float> DisplayMesh::defined_values() const {
  std::vector<float> out;
  for (const auto& chunk : chunks_)
    for (const float value : chunk->values)
      if (std::isfinite(value)) out.push_back(value);
  return out;
}

std::vector<float> DisplayMesh::defined_seam_values() const {
  std::vector<float> out;
  for (const float value : *seam_values_)
    if (std::isfinite(value)) out.push_back(value);
  return out;
}

}  // namespace hariko
