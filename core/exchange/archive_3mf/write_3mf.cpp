#include <zip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.hpp"
#include "core/exchange/mesh_name.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/exchange/write_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {
namespace {

struct WrittenUnit {
  double metres;
  const char* name;
};
constexpr std::array units{WrittenUnit{1e-6, "micron"},     WrittenUnit{1e-3, "millimeter"},
                           WrittenUnit{1e-2, "centimeter"}, WrittenUnit{0.0254, "inch"},
                           WrittenUnit{0.3048, "foot"},     WrittenUnit{1, "meter"}};

constexpr const char* content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr const char* relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

std::string in_attribute(std::string_view name) {
  std::string out;
  for (const char c : name_for_file(name)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string hexadecimal(const MeshColour& colour) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string out = "#";
  for (const std::uint8_t channel : colour) {
    out += digits[channel >> 4];
    out += digits[channel & 15];
  }
  return out;
}

using Triangles = std::vector<std::array<Index, 3>>;

/// Whether every edge is used once in each direction.
bool is_closed(const Triangles& triangles) {
  std::vector<std::pair<Index, Index>> forward, backward;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      forward.emplace_back(t[i], t[(i + 1) % 3]);
      backward.emplace_back(t[(i + 1) % 3], t[i]);
    }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  return forward == backward && std::adjacent_find(forward.begin(), forward.end()) == forward.end();
}

class ModelText {
 public:
  explicit ModelText(double metres_per_unit) {
    const auto* unit = std::find_if(units.begin(), units.end(), [&](const WrittenUnit& u) {
      return std::abs(metres_per_unit - u.metres) <= 1e-12 * u.metres;
    });
    if (unit == units.end()) {
      unit = &units[1];
      factor_ = metres_per_unit / unit->metres;
    }
    out_ = std::string("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"") + unit->name +
           "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
           "<metadata name=\"Application\">Hariko</metadata>\n<resources>\n";
  }

  void add(const std::string& name, const MeshColour& colour, const Vector3& origin,
           const std::vector<Vector3>& positions, Triangles triangles) {
    std::erase_if(triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    if (triangles.empty()) return;
    const std::string material = std::to_string(++last_id_), object = std::to_string(++last_id_);
    out_ += "<basematerials id=\"" + material + "\"><base name=\"" + in_attribute(name) +
            "\" displaycolor=\"" + hexadecimal(colour) + "\"/></basematerials>\n<object id=\"" + object +
            "\" name=\"" + in_attribute(name) + "\" type=\"" + (is_closed(triangles) ? "model" : "surface") +
            "\" pid=\"" + material + "\" pindex=\"0\"><mesh>\n<vertices>\n";
    for (const Vector3& position : positions) append(origin + position);
    out_ += "</vertices>\n<triangles>\n";
    for (const auto& triangle : triangles) append(triangle);
    out_ += "</triangles>\n</mesh></object>\n";
    build_ += "<item objectid=\"" + object + "\"/>\n";
  }

  std::string take() { return std::move(out_) + "</resources>\n<build>\n" + build_ + "</build>\n</model>\n"; }

 private:
  void append(const Vector3& p) {
    constexpr std::array names{"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (int axis = 0; axis < 3; ++axis) {
      out_ += names[static_cast<std::size_t>(axis)];
      append_real(out_, factor_ * p[axis]);
    }
    out_ += "\"/>\n";
  }
  void append(const std::array<Index, 3>& triangle) {
    constexpr std::array names{"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    for (std::size_t i = 0; i < 3; ++i) {
      out_ += names[i];
      append_integer(out_, triangle[i]);
    }
    out_ += "\"/>\n";
  }

  double factor_ = 1;
  std::size_t last_id_ = 0;
  std::string out_, build_;
};

struct DropSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DropArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};

/// Adds a part to the archive, dated to the format's first day, so that equal parts give equal bytes.
bool add_part(zip_t* archive, const char* name, std::string_view text) {
  zip_source_t* part = zip_source_buffer(archive, text.data(), text.size(), 0);
  if (!part) return false;
  const zip_int64_t index = zip_file_add(archive, name, part, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(part);
    return false;
  }
  const auto number = static_cast<zip_uint64_t>(index);
  return zip_file_set_dostime(archive, number, 0, 33, 0) == 0 &&
         zip_set_file_compression(archive, number, ZIP_CM_DEFLATE, 6) == 0;
}

Result<std::string> packed(const std::string& model) {
  const auto failed = [] {
    return make_error(e_limit, "The 3MF file cannot be packed.", "Choose a larger tolerance.");
  };
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, DropSource> target(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!target) return failed();
  std::unique_ptr<zip_t, DropArchive> archive(zip_open_from_source(target.get(), ZIP_TRUNCATE, &error));
  if (!archive) return failed();
  zip_source_keep(target.get());  // closing the archive releases it
  if (!add_part(archive.get(), "[Content_Types].xml", content_types) ||
      !add_part(archive.get(), "_rels/.rels", relationships) ||
      !add_part(archive.get(), "3D/3dmodel.model", model))
    return failed();
  if (zip_close(archive.get()) != 0) return failed();
  static_cast<void>(archive.release());
  if (zip_source_open(target.get()) != 0) return failed();
  zip_stat_t status;
  std::string out;
  if (zip_source_stat(target.get(), &status) == 0 && (status.valid & ZIP_STAT_SIZE) != 0) {
    out.resize(status.size);
    if (zip_source_read(target.get(), out.data(), out.size()) != static_cast<zip_int64_t>(out.size()))
      out.clear();
  }
  zip_source_close(target.get());
  if (out.empty()) return failed();
  return out;
}

}  // namespace

Result<std::string> write_3mf(std::span<const NamedTriangles> meshes, double metres_per_unit) {
  ModelText model(metres_per_unit);
  for (const NamedTriangles& named : meshes)
    model.add(named.name, named.colour, named.mesh->origin, named.mesh->positions, named.mesh->triangles);
  return packed(model.take());
}

Result<std::string> write_3mf(std::span<const NamedPolygons> meshes, double metres_per_unit) {
  ModelText model(metres_per_unit);
  for (const NamedPolygons& named : meshes)
    model.add(named.name, named.colour, Vector3::Zero(), named.mesh->positions,
              triangulate(*named.mesh).triangles);
  return packed(model.take());
}

}  // namespace hariko
