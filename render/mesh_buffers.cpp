#include "render/mesh_buffers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/element_colors.hpp"

namespace hariko::gl {

namespace {

GLsizeiptr signed_size(std::size_t bytes) {
  return static_cast<GLsizeiptr>(bytes);
}

Buffer filled_buffer(GLenum target, std::size_t bytes, const void* data) {
  Buffer buffer = Buffer::make();
  glBindBuffer(target, buffer.name());
  glBufferData(target, signed_size(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

std::vector<std::vector<int>> neighbours_of(const GridPattern& pattern) {
  std::vector<std::vector<int>> out(static_cast<std::size_t>(pattern.point_count()));
  for (const auto& triangle : pattern.triangles())
    for (const int a : triangle)
      for (const int b : triangle)
        if (a != b) out[static_cast<std::size_t>(a)].push_back(b);
  return out;
}

/// Stands for infinite values: beyond every range, and still a number after interpolation.
constexpr float practically_infinite = 1e30F;

/// Map values of whole patches; undefined ones are filled in from their neighbours.
std::vector<MapPoint> map_points(std::span<const float> values,
                                 const std::vector<std::vector<int>>& neighbours) {
  std::vector<MapPoint> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      out[i] = {std::clamp(values[i], -practically_infinite, practically_infinite), 1};
      continue;
    }
    const std::size_t point = i % neighbours.size(), base = i - point;
    float sum = 0, count = 0;
    for (const int j : neighbours[point]) {
      const float value = values[base + static_cast<std::size_t>(j)];
      if (!std::isfinite(value)) continue;
      sum += value;
      count += 1;
    }
    out[i] = {count > 0 ? sum / count : 0, 0};
  }
  return out;
}

}  // namespace

void TexturedBuffer::allocate(std::size_t size, const void* data, GLenum format, GLenum usage) {
  if (!buffer) buffer = Buffer::make();
  bytes = size;
  glBindBuffer(GL_TEXTURE_BUFFER, buffer.name());
  // A buffer texture over an empty buffer is an error, so one texel always exists.
  glBufferData(GL_TEXTURE_BUFFER, signed_size(std::max<std::size_t>(size, 16)), nullptr, usage);
  if (size > 0 && data) glBufferSubData(GL_TEXTURE_BUFFER, 0, signed_size(size), data);
  if (!texture) texture = Texture::make();
  glBindTexture(GL_TEXTURE_BUFFER, texture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.name());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void TexturedBuffer::bind_texture(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, texture.name());
}

std::shared_ptr<const PatchIndices> IndexCache::get(const GridPattern& pattern, Index patch_count,
                                                    std::size_t& uploaded) {
  std::erase_if(entries_, [](const auto& entry) { return entry.second.expired(); });
  auto& entry = entries_[{pattern.domain, pattern.density, patch_count}];
  if (auto found = entry.lock()) return found;
  const auto triangles = pattern.triangles();
  std::vector<std::uint32_t> numbers;
  numbers.reserve(triangles.size() * 3 * patch_count);
  for (Index p = 0; p < patch_count; ++p) {
    const auto base = p * static_cast<Index>(pattern.point_count());
    for (const auto& triangle : triangles)
      for (const int corner : triangle) numbers.push_back(base + static_cast<Index>(corner));
  }
  auto indices = std::make_shared<PatchIndices>();
  // Not through the element array target, which would change the currently bound vertex array.
  indices->buffer =
      filled_buffer(GL_COPY_WRITE_BUFFER, numbers.size() * sizeof(std::uint32_t), numbers.data());
  indices->count = static_cast<GLsizei>(numbers.size());
  std::vector<float> places;
  for (const Vector2& parameter : pattern.parameters())
    for (int k = 0; k < 2; ++k) places.push_back(static_cast<float>(parameter[k] * pattern.density));
  indices->places.allocate(places.size() * sizeof(float), places.data(), GL_RG32F, GL_STATIC_DRAW);
  uploaded += numbers.size() * sizeof(std::uint32_t);
  entry = indices;
  return indices;
}

void set_up_line_instances(GLuint segments, GLuint values) {
  glBindBuffer(GL_ARRAY_BUFFER, segments);
  glEnableVertexAttribArray(0);
  glVertexAttribIPointer(0, 4, GL_UNSIGNED_INT, 4 * sizeof(std::uint32_t), nullptr);
  glVertexAttribDivisor(0, 1);
  if (values) {
    glBindBuffer(GL_ARRAY_BUFFER, values);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, 2 * sizeof(MapPoint), nullptr);
    glVertexAttribDivisor(1, 1);
  }
}

void LineInstances::upload(std::span<const CurveSegment> segments, std::span<const MapPoint> values,
                           std::size_t& uploaded) {
  count_ = static_cast<GLsizei>(segments.size());
  array_ = VertexArray::make();
  if (segments.empty()) return;
  glBindVertexArray(array_.name());
  segments_ = filled_buffer(GL_ARRAY_BUFFER, segments.size_bytes(), segments.data());
  values_ = values.empty() ? Buffer() : filled_buffer(GL_ARRAY_BUFFER, values.size_bytes(), values.data());
  set_up_line_instances(segments_.name(), values_.name());
  uploaded += segments.size_bytes() + values.size_bytes();
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

MeshBuffers::MeshBuffers(const DisplayMesh& mesh, IndexCache& indices, std::size_t& uploaded)
    : vertex_array_(VertexArray::make()),
      indices_(indices.get(mesh.pattern(), mesh.patch_count(), uploaded)) {
  const std::size_t count = mesh.vertex_count();
  vertices_.allocate(count * sizeof(DisplayVertex), nullptr, GL_R32F, GL_DYNAMIC_DRAW);
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.buffer.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayVertex), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayVertex),
                        byte_offset(offsetof(DisplayVertex, normal)));
  if (mesh.has_values()) {
    values_ = Buffer::make();
    glBindBuffer(GL_ARRAY_BUFFER, values_.name());
    glBufferData(GL_ARRAY_BUFFER, signed_size(count * sizeof(MapPoint)), nullptr, GL_DYNAMIC_DRAW);
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, sizeof(MapPoint), nullptr);
    neighbours_ = neighbours_of(mesh.pattern());
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_->buffer.name());
  glBindVertexArray(0);
  upload_curves(mesh, uploaded);
  update(mesh, uploaded);
}

void MeshBuffers::update(const DisplayMesh& mesh, std::size_t& uploaded) {
  const auto& chunks = mesh.chunks();
  const bool all = chunks_.size() != chunks.size();
  for (std::size_t begin = 0; begin < chunks.size();) {
    if (!all && chunks_[begin] == chunks[begin]) {
      ++begin;
      continue;
    }
    std::size_t end = begin + 1;
    while (end < chunks.size() && (all || chunks_[end] != chunks[end])) ++end;
    upload_run(mesh, begin, end, uploaded);
    begin = end;
  }
  chunks_ = chunks;
  // Refreshed meshes have lists of their own, but the curves of before: without values nothing is new.
  if (seam_values_->empty() && mesh.seam_values()->empty()) seam_values_ = mesh.seam_values();
  if (seam_values_ != mesh.seam_values()) upload_curves(mesh, uploaded);
}

/// Uploads chunks [begin, end).
void MeshBuffers::upload_run(const DisplayMesh& mesh, std::size_t begin, std::size_t end,
                             std::size_t& uploaded) {
  const std::size_t per_chunk = std::size_t(DisplayMesh::patches_per_chunk) * mesh.vertices_per_patch();
  for (std::size_t c = begin; c < end; ++c) {
    const DisplayMesh::Chunk& chunk = *mesh.chunks()[c];
    const std::size_t bytes = chunk.vertices.size() * sizeof(DisplayVertex);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.buffer.name());
    glBufferSubData(GL_ARRAY_BUFFER, signed_size(c * per_chunk * sizeof(DisplayVertex)), signed_size(bytes),
                    chunk.vertices.data());
    uploaded += bytes;
    if (!values_) continue;
    const std::vector<MapPoint> values = map_points(chunk.values, neighbours_);
    glBindBuffer(GL_ARRAY_BUFFER, values_.name());
    glBufferSubData(GL_ARRAY_BUFFER, signed_size(c * per_chunk * sizeof(MapPoint)),
                    signed_size(values.size() * sizeof(MapPoint)), values.data());
    uploaded += values.size() * sizeof(MapPoint);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void MeshBuffers::upload_curves(const DisplayMesh& mesh, std::size_t& uploaded) {
  seam_values_ = mesh.seam_values();
  const DisplayMesh::Curves& curves = *mesh.curves();
  has_curve_values_ = !seam_values_->empty();
  std::array<std::vector<MapPoint>, curve_kind_count> values;  // two for each segment
  if (has_curve_values_) {
    const std::size_t stride = static_cast<std::size_t>(mesh.pattern().density) + 1;
    for (std::size_t k = 0; k < curves.segments.size(); ++k) values[k].resize(curves.segments[k].size() * 2);
    for (const DisplayCurve& curve : curves.curves) {
      if (curve.seam == no_index || curve.segment_count + 1U != stride)
        continue;  // parts of sides carry no values
      for (std::size_t i = 0; i < curve.segment_count; ++i)
        for (std::size_t end = 0; end < 2; ++end) {
          const float value = (*seam_values_)[curve.seam * stride + i + end];
          const float other = (*seam_values_)[curve.seam * stride + i + 1 - end];
          MapPoint& to = values[std::size_t(curve.kind)][2 * (curve.first_segment + i) + end];
          // An undefined end of a segment takes the value of the other end: corners have no curvature of
          // their own.
          if (std::isfinite(value) || std::isfinite(other)) to = {std::isfinite(value) ? value : other, 1};
        }
    }
  }
  for (std::size_t k = 0; k < curves.segments.size(); ++k)
    curves_[k].upload(curves.segments[k], values[k], uploaded);
}

void MeshBuffers::set_patch_colors(std::vector<std::uint8_t> rgba, std::size_t& uploaded) {
  if (patch_colors_.buffer && rgba == color_bytes_) return;
  color_bytes_ = std::move(rgba);
  patch_colors_.allocate(color_bytes_.size(), color_bytes_.data(), GL_RGBA8, GL_DYNAMIC_DRAW);
  uploaded += color_bytes_.size();
}

PolyhedronBuffers::PolyhedronBuffers(const DisplayPolyhedron& polyhedron, std::size_t& uploaded)
    : point_count_(static_cast<GLsizei>(polyhedron.positions.size())) {
  const std::size_t bytes = polyhedron.positions.size() * sizeof(polyhedron.positions[0]);
  positions_.allocate(bytes, polyhedron.positions.data(), GL_R32F, GL_STATIC_DRAW);
  uploaded += bytes;
  std::array<std::vector<CurveSegment>, edge_kind_count> segments;
  std::array<std::vector<MapPoint>, edge_kind_count> values;
  has_edge_tensions_ =
      std::any_of(polyhedron.beta.begin(), polyhedron.beta.end(), [](float b) { return b != 1; });
  for (std::size_t e = 0; e < polyhedron.edges.size(); ++e) {
    const auto& [a, b] = polyhedron.edges[e];
    const auto kind = std::size_t(polyhedron.edge_kinds[e]);
    segments[kind].push_back({{a, a, b, b}});
    if (!has_edge_tensions_) continue;
    const float beta = polyhedron.beta[e];
    values[kind].insert(
        values[kind].end(), 2,
        {static_cast<float>(tension_fraction(beta_place(double(beta)))), beta != 1 ? 1.0F : 0.0F});
  }
  upload_point_colors(polyhedron, uploaded);
  for (std::size_t k = 0; k < segments.size(); ++k) edges_[k].upload(segments[k], values[k], uploaded);
}

void PolyhedronBuffers::upload_point_colors(const DisplayPolyhedron& polyhedron, std::size_t& uploaded) {
  has_point_tensions_ =
      std::any_of(polyhedron.alpha.begin(), polyhedron.alpha.end(), [](float a) { return a != 0; });
  if (!has_point_tensions_) return;
  std::vector<std::uint8_t> colors;
  colors.reserve(4 * polyhedron.alpha.size());
  for (const float alpha : polyhedron.alpha) {
    const Color color = tension_color(alpha_place(double(alpha)));
    for (const float part : {color.r, color.g, color.b, alpha != 0 ? 1.0F : 0.0F})
      colors.push_back(static_cast<std::uint8_t>(std::lround(255 * part)));
  }
  point_colors_.allocate(colors.size(), colors.data(), GL_RGBA8, GL_STATIC_DRAW);
  uploaded += colors.size();
}

MarkBuffers::MarkBuffers(const EdgeMarks& marks, std::size_t& uploaded) {
  for (std::size_t k = 0; k < marks.classes.size(); ++k) {
    const EdgeMarks::Class& from = marks.classes[k];
    std::vector<MapPoint> lengths;
    lengths.reserve(2 * from.lengths.size());
    for (const auto& [begin, end] : from.lengths) lengths.insert(lengths.end(), {{begin, 1}, {end, 1}});
    lines_[k].upload(from.segments, lengths, uploaded);
  }
}

CombBuffers::CombBuffers(const CombLines& combs, std::size_t& uploaded) {
  const std::size_t bytes = combs.teeth.size() * sizeof(combs.teeth[0]);
  teeth_.allocate(bytes, combs.teeth.data(), GL_R32F, GL_STREAM_DRAW);
  const auto stride = static_cast<Index>(combs.density + 1);
  std::vector<CurveSegment> teeth, envelope;
  teeth.reserve(combs.teeth.size());
  envelope.reserve(combs.teeth.size());
  for (Index i = 0; i < combs.teeth.size(); ++i) {
    const Index foot = 2 * i, tip = foot + 1, at = i % stride;
    teeth.push_back({{foot, foot, tip, tip}});
    if (at + 1 == stride) continue;
    envelope.push_back({{at > 0 ? tip - 2 : tip, tip, tip + 2, at + 2 < stride ? tip + 4 : tip + 2}});
  }
  uploaded += bytes;
  tooth_lines_.upload(teeth, {}, uploaded);
  envelope_.upload(envelope, {}, uploaded);
}

FacetLineBuffers::FacetLineBuffers(const FacetLines& lines, std::size_t& uploaded) {
  std::vector<CurveSegment> segments;
  segments.reserve(lines.edges.size());
  for (const auto& [a, b] : lines.edges) segments.push_back({{a, a, b, b}});
  const std::size_t bytes = lines.points.size() * sizeof(lines.points[0]);
  points_.allocate(bytes, lines.points.data(), GL_R32F, GL_STATIC_DRAW);
  uploaded += bytes;
  lines_.upload(segments, {}, uploaded);
}

SectionBuffers::SectionBuffers(const DisplayMesh& mesh, const LocalPlane& plane, std::size_t& uploaded) {
  const auto pieces = section_curve(mesh, plane);
  std::vector<CurveSegment> segments;
  segments.reserve(pieces.size());
  for (Index i = 0; i < pieces.size(); ++i) segments.push_back({{2 * i, 2 * i, 2 * i + 1, 2 * i + 1}});
  const std::size_t bytes = pieces.size() * sizeof(pieces[0]);
  points_.allocate(bytes, pieces.data(), GL_R32F, GL_STREAM_DRAW);
  uploaded += bytes;
  lines_.upload(segments, {}, uploaded);
}

}  // namespace hariko::gl
