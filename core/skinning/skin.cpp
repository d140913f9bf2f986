#include "core/skinning/skin.hpp"

#include <algorithm>

namespace hariko {

SubdivisionCurve SkinSection::curve() const {
  SubdivisionCurve out;
  out.closed = closed && points.size() > 1;
  for (const SectionPoint& p : points) {
    out.points.push_back(p.position);
    out.sharp.push_back(p.sharp);
  }
  return out;
}

int Skin::find_section(std::uint32_t id) const {
  for (int k = 0; k < section_count(); ++k)
    if (sections[std::size_t(k)].id == id) return k;
  return -1;
}

int find_point(const SkinSection& section, std::uint32_t id) {
  for (int i = 0; i < section.size(); ++i)
    if (section.points[std::size_t(i)].id == id) return i;
  return -1;
}

std::uint32_t Skin::free_point_id() const {
  std::uint32_t id = 0;
  for (const SkinSection& section : sections)
    for (const SectionPoint& p : section.points) id = std::max(id, p.id + 1);
  return id;
}

std::uint32_t Skin::free_section_id() const {
  std::uint32_t id = 0;
  for (const SkinSection& section : sections) id = std::max(id, section.id + 1);
  return id;
}

std::uint32_t Skin::free_link_id() const {
  std::uint32_t id = 0;
  for (const SkinLink& link : links) id = std::max(id, link.id + 1);
  for (const SkinMerge& merge : merges) id = std::max(id, merge.id + 1);
  return id;
}

}  // namespace hariko
