#include "core/cad/kernel/opencascade/step_model.hpp"

#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_UndefinedContent.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_GeometricRepresentationContext.hxx>
#include <StepGeom_GeometricRepresentationContextAndParametricRepresentationContext.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_ContextDependentOverRidingStyledItem.hxx>
#include <StepVisual_Invisibility.hxx>
#include <StepVisual_InvisibleItem.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopLoc_Location.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <string_view>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

namespace {

using Process = Handle(Transfer_TransientProcess);

/// Adds the shape that an entity has become, without its place.
void add_shape_of(const Process& process, const Handle(Standard_Transient) & entity,
                  TopTools_MapOfShape& to) {
  if (entity.IsNull()) return;
  const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
  if (!shape.IsNull()) to.Add(shape.Located(TopLoc_Location()));
}

/// Adds the shape of a styled item. Styles of a single usage, and items that place another representation,
/// say nothing about the shape elsewhere.
void add_styled(const Process& process, const Handle(StepVisual_StyledItem) & styled,
                TopTools_MapOfShape& to) {
  if (styled.IsNull() || styled->IsKind(STANDARD_TYPE(StepVisual_ContextDependentOverRidingStyledItem)))
    return;
  const Handle(StepRepr_RepresentationItem) item = styled->Item();
  if (item.IsNull() || item->IsKind(STANDARD_TYPE(StepRepr_MappedItem))) return;
  add_shape_of(process, item, to);
}

void add_hidden(const Process& process, const Handle(StepVisual_Invisibility) & hiding,
                TopTools_MapOfShape& to) {
  if (hiding.IsNull() || hiding->InvisibleItems().IsNull()) return;
  for (int k = 1; k <= hiding->NbInvisibleItems(); ++k) {
    const StepVisual_InvisibleItem item = hiding->InvisibleItemsValue(k);
    add_styled(process, item.StyledItem(), to);
    const Handle(StepVisual_PresentationLayerAssignment) layer = item.PresentationLayerAssignment();
    if (layer.IsNull() || layer->AssignedItems().IsNull()) continue;
    for (int n = 1; n <= layer->NbAssignedItems(); ++n) {
      const Handle(StepRepr_RepresentationItem) own = layer->AssignedItemsValue(n).RepresentationItem();
      if (const auto styled = Handle(StepVisual_StyledItem)::DownCast(own); !styled.IsNull())
        add_styled(process, styled, to);
      else if (!own.IsNull() && !own->IsKind(STANDARD_TYPE(StepRepr_MappedItem)))
        add_shape_of(process, own, to);
    }
  }
}

/// Whether an entity is a tessellated body that stands for itself. Versions of the kernel that do not know
/// the kind keep its parameters as they are; the last one refers to the exact body where there is one, too.
bool is_tessellated_body(const Handle(Standard_Transient) & entity) {
  const auto unknown = Handle(StepData_UndefinedEntity)::DownCast(entity);
  if (unknown.IsNull() || unknown->IsComplex()) return false;
  const std::string_view kind = unknown->StepType();
  if (kind != "TESSELLATED_SOLID" && kind != "TESSELLATED_SHELL") return false;
  const Handle(Interface_UndefinedContent) content = unknown->UndefinedContent();
  return content.IsNull() || content->NbParams() < 3 || !content->IsParamEntity(content->NbParams());
}

/// Whether the shapes of a representation have coordinates without a unit.
bool lacks_unit(const Handle(StepShape_ShapeRepresentation) & representation) {
  if (representation.IsNull() || representation->Items().IsNull()) return false;
  const Handle(StepRepr_RepresentationContext) context = representation->ContextOfItems();
  if (context.IsNull()) return true;
  return context->DynamicType() == STANDARD_TYPE(StepGeom_GeometricRepresentationContext) ||
         context->DynamicType() == STANDARD_TYPE(StepRepr_RepresentationContext);
}

std::string name_of_product(const Handle(StepShape_ShapeDefinitionRepresentation) & definition) {
  const Handle(StepRepr_PropertyDefinition) property = definition->Definition().PropertyDefinition();
  if (property.IsNull()) return {};
  const Handle(StepBasic_ProductDefinition) product = property->Definition().ProductDefinition();
  if (product.IsNull() || product->Formation().IsNull() || product->Formation()->OfProduct().IsNull())
    return {};
  const Handle(TCollection_HAsciiString) name = product->Formation()->OfProduct()->Name();
  return name.IsNull() ? std::string() : sanitized_utf8(name->ToCString(), 200);
}

Message tessellated_warning(std::size_t count, const std::string& names) {
  return make_warning(w_cad_tessellated,
                      "Tessellated bodies left out: " + std::to_string(count) + " (" +
                          (names.empty() ? std::string("without names") : names) +
                          "). This version of OpenCASCADE reads no bodies of triangles from STEP.",
                      "Export them as exact bodies (B-rep), or as 3MF or STL.");
}

}  // namespace

std::string product_with(STEPCAFControl_Reader& reader, const Handle(Standard_Transient) & entity) {
  const Interface_Graph& graph = reader.ChangeReader().WS()->Graph();
  constexpr std::size_t most = 1000;
  std::vector<Handle(Standard_Transient)> seen{entity};
  for (std::size_t k = 0; k < seen.size() && seen.size() < most; ++k) {
    Interface_EntityIterator users = graph.Sharings(seen[k]);
    for (users.Start(); users.More(); users.Next()) {
      const auto definition = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(users.Value());
      if (!definition.IsNull())
        if (std::string name = name_of_product(definition); !name.empty()) return name;
      if (std::find(seen.begin(), seen.end(), users.Value()) == seen.end()) seen.push_back(users.Value());
    }
  }
  return {};
}

ModelFacts facts_of_step(STEPCAFControl_Reader& reader) {
  ModelFacts out;
  const Handle(XSControl_WorkSession) session = reader.ChangeReader().WS();
  const Process process = session->TransferReader()->TransientProcess();
  const Handle(Interface_InterfaceModel) model = session->Model();
  if (process.IsNull() || model.IsNull()) return out;
  std::string names;
  constexpr std::size_t most_names = 5;
  bool without_unit = false;
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const Handle(Standard_Transient) entity = model->Value(k);
    add_hidden(process, Handle(StepVisual_Invisibility)::DownCast(entity), out.hidden);
    without_unit = without_unit || lacks_unit(Handle(StepShape_ShapeRepresentation)::DownCast(entity));
    if (!is_tessellated_body(entity)) continue;
    ++out.tessellated;
    if (out.tessellated > most_names + 1) continue;
    const std::string name = out.tessellated > most_names ? "…" : product_with(reader, entity);
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  }
  if (out.tessellated > 0) out.warnings.push_back(tessellated_warning(out.tessellated, names));
  if (without_unit)
    out.warnings.push_back(
        make_warning(w_cad_unit,
                     "The file does not say in which unit its lengths are: millimetres are "
                     "assumed.",
                     "Measure something whose size is known, and scale the objects if it is "
                     "wrong."));
  return out;
}

ModelFacts facts_of_iges(IGESCAFControl_Reader& reader) {
  ModelFacts out;
  const Handle(XSControl_WorkSession) session = reader.WS();
  const Process process = session->TransferReader()->TransientProcess();
  const Handle(Interface_InterfaceModel) model = session->Model();
  if (process.IsNull() || model.IsNull()) return out;
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(k));
    if (!entity.IsNull() && entity->BlankStatus() == 1) add_shape_of(process, entity, out.hidden);
  }
  return out;
}

}  // namespace hariko
