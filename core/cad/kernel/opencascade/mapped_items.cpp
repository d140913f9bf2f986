#include "core/cad/kernel/opencascade/mapped_items.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeBinder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Trsf.hxx>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/cad/kernel/opencascade/step_model.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

namespace {

/// Least deviation of a scale from 1 that counts; smaller ones are rounding in the file.
constexpr double least_scaling = 1e-9;

std::optional<gp_XYZ> vector_of(const Handle(StepGeom_Direction) & direction) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return {};
  return gp_XYZ(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                direction->DirectionRatiosValue(3));
}

/// Whether the axes of an operator, all of them given, are left-handed.
bool mirrors(const StepGeom_CartesianTransformationOperator3d& target) {
  const auto x = vector_of(target.Axis1()), y = vector_of(target.Axis2()), z = vector_of(target.Axis3());
  return x && y && z && x->Crossed(*y).Dot(*z) < 0;
}

double scale_of(const StepGeom_CartesianTransformationOperator3d& target) {
  return target.HasScale() && target.Scale() > 0 && std::isfinite(target.Scale()) ? target.Scale() : 1;
}

/// Mapped item that scales or mirrors.
struct TransformedItem {
  Handle(StepRepr_MappedItem) item;
  double scale = 1;
  bool mirrored = false;
  TopoDS_Shape shape = {};  ///< null as long as it is not known
  bool unused = false;      ///< in no shape of a product

  Handle(StepRepr_Representation) content() const { return item->MappingSource()->MappedRepresentation(); }
  bool unknown() const { return shape.IsNull() && !unused; }
};

class MappedItems {
 public:
  explicit MappedItems(STEPCAFControl_Reader& reader)
      : reader_(reader),
        session_(reader.ChangeReader().WS()),
        process_(session_->TransferReader()->TransientProcess()) {
    find();
  }

  std::vector<Message> run() {
    for (std::size_t level = 0; level < most_levels && transform_level(); ++level) {
    }
    if (transferred_) bind_known();
    std::vector<Message> out;
    for (const TransformedItem& own : items_)
      if (own.unknown()) out.push_back(not_placed(own));
    return out;
  }

 private:
  static constexpr std::size_t most_levels = 20;

  void find() {
    const Handle(Interface_InterfaceModel) model = session_->Model();
    if (model.IsNull()) return;
    for (int k = 1; k <= model->NbEntities(); ++k) {
      if (const auto styled = Handle(StepVisual_StyledItem)::DownCast(model->Value(k));
          !styled.IsNull() && !styled->Item().IsNull())
        styles_.push_back(styled->Item());
      const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(k));
      if (item.IsNull() || item->MappingSource().IsNull()) continue;
      const Handle(StepRepr_Representation) content = item->MappingSource()->MappedRepresentation();
      if (content.IsNull()) continue;
      ++uses_[content.get()];
      const auto target = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(item->MappingTarget());
      if (target.IsNull()) continue;
      const double scale = scale_of(*target);
      const bool mirrored = mirrors(*target);
      if (mirrored || std::abs(scale - 1) > least_scaling) items_.push_back({item, scale, mirrored});
    }
  }

  /// Whether a representation contains, at any depth, an item whose right shape is not known yet.
  bool has_unknown(const Handle(StepRepr_Representation) & content, int depth = 0) const {
    if (content.IsNull() || content->Items().IsNull()) return false;
    if (depth > int(most_levels)) return true;
    for (int k = 1; k <= content->NbItems(); ++k) {
      const auto inner = Handle(StepRepr_MappedItem)::DownCast(content->ItemsValue(k));
      if (inner.IsNull() || inner->MappingSource().IsNull()) continue;
      const bool unknown = std::any_of(items_.begin(), items_.end(), [&](const TransformedItem& own) {
        return own.item == inner && own.unknown();
      });
      if (unknown || has_unknown(inner->MappingSource()->MappedRepresentation(), depth + 1)) return true;
    }
    return false;
  }

  /// Forgets what has been transferred except for the right shapes.
  void bind_known() {
    session_->TransferReader()->Clear(1);
    process_->Clear();
    for (const TransformedItem& own : items_)
      if (!own.shape.IsNull()) process_->Bind(own.item, new TransferBRep_ShapeBinder(own.shape));
    for (const auto& [entity, shape] : styled_) process_->Bind(entity, new TransferBRep_ShapeBinder(shape));
  }

  /// Finds the right shapes of items that contain no others with unknown ones; false where there are none.
  bool transform_level() {
    std::vector<TransformedItem*> ready;
    for (TransformedItem& own : items_)
      if (own.unknown() && !has_unknown(own.content())) ready.push_back(&own);
    if (ready.empty()) return false;
    if (transferred_) bind_known();
    transferred_ = true;
    reader_.ChangeReader().TransferRoots();
    bool any = false;
    for (TransformedItem* own : ready) {
      own->shape = transformed(*own);
      any = any || !own->unknown();
    }
    return any;
  }

  /// Right shape of an item that has been transferred; null where the kernel failed.
  TopoDS_Shape transformed(TransformedItem& own) {
    const TopoDS_Shape content = TransferBRep::ShapeResult(process_, own.content());
    const TopoDS_Shape placed = TransferBRep::ShapeResult(process_, own.item);
    own.unused = placed.IsNull();
    if (content.IsNull() || placed.IsNull() || !placed.IsPartner(content)) return {};
    try {
      const TopLoc_Location place = placed.Location() * content.Location().Inverted();
      const gp_Trsf rigid = place.Transformation();
      gp_Trsf missing;
      missing.SetValues(own.scale, 0, 0, 0, 0, own.mirrored ? -own.scale : own.scale, 0, 0, 0, 0, own.scale,
                        0);
      BRepBuilderAPI_Transform done(placed, rigid * missing * rigid.Inverted(), true);
      if (!done.IsDone()) return {};
      // A shape that is placed several times keeps its styles in the other places.
      if (uses_[own.content().get()] == 1) take_styles(placed, place, done);
      return done.Shape();
    } catch (const Standard_Failure&) {
      return {};
    }
  }

  /// Takes along the shapes of styled entities, so that they keep colours and visibility. Places are equal
  /// where they are the same in the kernel's tables, not where their numbers are.
  void take_styles(const TopoDS_Shape& placed, const TopLoc_Location& place, BRepBuilderAPI_Transform& done) {
    TopTools_IndexedMapOfShape inside;
    TopExp::MapShapes(placed, inside);
    for (const Handle(StepRepr_RepresentationItem) & item : styles_) {
      const TopoDS_Shape before = TransferBRep::ShapeResult(process_, item);
      if (before.IsNull()) continue;
      const TopoDS_Shape there = before.Moved(place);
      if (inside.Contains(there)) styled_.emplace_back(item, done.ModifiedShape(there));
    }
  }

  Message not_placed(const TransformedItem& own) {
    const std::string name = product_with(reader_, own.item);
    const std::string what = own.mirrored && own.scale != 1 ? "scaled and mirrored"
                             : own.mirrored                 ? "mirrored"
                                                            : "scaled";
    return make_warning(w_cad_placed,
                        (name.empty() ? std::string("A part") : "Part " + name) + " is " + what +
                            " by its place in the file; here it is not.",
                        "Scale or mirror it here, or export it with the place applied to it.");
  }

  STEPCAFControl_Reader& reader_;
  Handle(XSControl_WorkSession) session_;
  Handle(Transfer_TransientProcess) process_;
  std::vector<TransformedItem> items_;
  std::map<const Standard_Transient*, int> uses_;            ///< mapped items by representation
  std::vector<Handle(StepRepr_RepresentationItem)> styles_;  ///< styled entities
  std::vector<std::pair<Handle(Standard_Transient), TopoDS_Shape>> styled_;  ///< those of transformed shapes
  bool transferred_ = false;
};

}  // namespace

std::vector<Message> transform_mapped_items(STEPCAFControl_Reader& reader) {
  return MappedItems(reader).run();
}

}  // namespace hariko
