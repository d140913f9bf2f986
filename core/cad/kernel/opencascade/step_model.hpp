#pragma once

// Contents of STEP and IGES models that the kernel does not transfer: hidden shapes, tessellated bodies,
// missing units. Private to this folder.

#include <IGESCAFControl_Reader.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Transient.hxx>
#include <TopTools_MapOfShape.hxx>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Contents of a model beside its shapes.
struct ModelFacts {
  TopTools_MapOfShape hidden;     ///< shapes, without their places, that the file hides
  std::vector<Message> warnings;  ///< W_CAD_TESSELLATED, W_CAD_UNIT
  std::size_t tessellated = 0;    ///< tessellated bodies that the kernel left out
};

/// Facts of a model that has been transferred. O(size).
ModelFacts facts_of_step(STEPCAFControl_Reader& reader);
ModelFacts facts_of_iges(IGESCAFControl_Reader& reader);

/// Name of the first product whose shape contains an entity of a STEP model, printable; empty where there is
/// none or it has no name. O(users of the entity).
std::string product_with(STEPCAFControl_Reader& reader, const Handle(Standard_Transient) & entity);

}  // namespace hariko
