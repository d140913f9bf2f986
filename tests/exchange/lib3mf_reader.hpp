#pragma once

// 3MF files by lib3mf: an independent reader, and a strict one.

#include <Model/COM/NMR_DLLInterfaces.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/vector.hpp"
#include "tests/support/leaks_of_library.hpp"

namespace hariko::test::lib3mf {

/// A handle of the library, given back at the end.
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (handle_) NMR::lib3mf_release(handle_);
  }
  NMR::PLib3MFBase** target() { return &handle_; }
  NMR::PLib3MFBase* get() const { return handle_; }

 private:
  NMR::PLib3MFBase* handle_ = nullptr;
};

struct Found {
  std::string name;
  bool model = false, valid = false, closed = false;
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;
};

struct FoundFile {
  DWORD unit = 0;
  std::vector<Found> objects;
};

inline Found read_object(NMR::PLib3MFBase* object) {
  Found found;
  ULONG length = 0;
  NMR::lib3mf_object_getnameutf8(object, nullptr, 0, &length);
  std::string name(length + 1, '\0');
  NMR::lib3mf_object_getnameutf8(object, name.data(), static_cast<ULONG>(name.size()), &length);
  found.name = name.substr(0, name.find('\0'));
  DWORD type = 0, vertices = 0, triangles = 0;
  BOOL valid = 0, closed = 0;
  NMR::lib3mf_object_gettype(object, &type);
  NMR::lib3mf_object_isvalidobject(object, &valid);
  NMR::lib3mf_meshobject_ismanifoldandoriented(object, &closed);
  found.model = type == NMR::MODELOBJECTTYPE_MODEL;
  found.valid = valid != 0;
  found.closed = closed != 0;
  NMR::lib3mf_meshobject_getvertexcount(object, &vertices);
  NMR::lib3mf_meshobject_gettrianglecount(object, &triangles);
  std::vector<NMR::MODELMESHVERTEX> points(vertices);
  std::vector<NMR::MODELMESHTRIANGLE> corners(triangles);
  NMR::lib3mf_meshobject_getvertices(object, points.data(), vertices, nullptr);
  NMR::lib3mf_meshobject_gettriangleindices(object, corners.data(), triangles, nullptr);
  for (const auto& p : points)
    found.positions.emplace_back(p.m_fPosition[0], p.m_fPosition[1], p.m_fPosition[2]);
  for (const auto& t : corners)
    found.triangles.push_back({t.m_nIndices[0], t.m_nIndices[1], t.m_nIndices[2]});
  return found;
}

inline FoundFile read_file(const std::filesystem::path& path) {
  FoundFile out;
  const LeaksOfLibrary leaks;  // a handle for every part that is read
  Handle model, reader, items;
  NMR::lib3mf_createmodel(model.target());
  NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.target());
  NMR::lib3mf_reader_setstrictmodeactive(reader.get(), 1);
  EXPECT_EQ(NMR::lib3mf_reader_readfromfileutf8(reader.get(), path.c_str()), 0);
  DWORD warnings = 0;
  NMR::lib3mf_reader_getwarningcount(reader.get(), &warnings);
  EXPECT_EQ(warnings, 0u);
  NMR::lib3mf_model_getunit(model.get(), &out.unit);
  NMR::lib3mf_model_getbuilditems(model.get(), items.target());
  BOOL more = 0;
  while (NMR::lib3mf_builditemiterator_movenext(items.get(), &more) == 0 && more != 0) {
    Handle item, object;
    NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.target());
    NMR::lib3mf_builditem_getobjectresource(item.get(), object.target());
    out.objects.push_back(read_object(object.get()));
  }
  return out;
}

}  // namespace hariko::test::lib3mf
