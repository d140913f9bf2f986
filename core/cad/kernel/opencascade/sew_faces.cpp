#include "core/cad/kernel/opencascade/sew_faces.hpp"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace hariko {

namespace {

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum not_in = TopAbs_SHAPE) {
  std::size_t out = 0;
  for (TopExp_Explorer at(shape, kind, not_in); at.More(); at.Next()) ++out;
  return out;
}

TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound out;
  BRep_Builder builder;
  builder.MakeCompound(out);
  for (const TopoDS_Shape& shape : shapes) builder.Add(out, shape);
  return out;
}

/// Solid that looks outward, of a closed shell; other shapes unchanged.
TopoDS_Shape body_of(const TopoDS_Shape& shape) {
  if (shape.ShapeType() != TopAbs_SHELL || !BRep_Tool::IsClosed(shape)) return shape;
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, TopoDS::Shell(shape));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

struct Sewn {
  std::vector<TopoDS_Shape> bodies;  ///< bodies of several faces
  std::vector<TopoDS_Shape> alone;   ///< faces that meet no other
  /// Face that a given one has become, or itself.
  std::function<TopoDS_Shape(const TopoDS_Shape&)> made_of;
};

/// Sews a shape; nothing where it has no size to derive the tolerance from, or where the kernel fails.
std::optional<Sewn> sew(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  if (box.IsVoid() || box.IsOpen() || !(box.SquareExtent() > 0)) return {};
  const Handle(BRepBuilderAPI_Sewing) sewing =
      new BRepBuilderAPI_Sewing(sewing_tolerance * std::sqrt(box.SquareExtent()));
  sewing->Add(shape);
  sewing->Perform();
  const TopoDS_Shape& done = sewing->SewedShape();
  if (done.IsNull() || count(done, TopAbs_FACE) < count(shape, TopAbs_FACE)) return {};
  Sewn out;
  out.made_of = [sewing](const TopoDS_Shape& face) { return sewing->ModifiedSubShape(face); };
  for (TopExp_Explorer shell(done, TopAbs_SHELL); shell.More(); shell.Next())
    (count(shell.Current(), TopAbs_FACE) > 1 ? out.bodies : out.alone).push_back(body_of(shell.Current()));
  for (TopExp_Explorer face(done, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
    out.alone.push_back(face.Current());
  return out;
}

/// Whether a shape consists of several shells or faces that may have borders.
bool is_in_pieces(const TopoDS_Shape& shape) {
  return count(shape, TopAbs_SOLID) == 0 &&
         count(shape, TopAbs_SHELL) + count(shape, TopAbs_FACE, TopAbs_SHELL) > 1;
}

TopoDS_Shape whole(const TopoDS_Shape& shape) {
  const auto made = sew(shape);
  if (!made) return shape;
  std::vector<TopoDS_Shape> all = made->bodies;
  all.insert(all.end(), made->alone.begin(), made->alone.end());
  return all.size() == 1 ? all.front() : compound_of(all);
}

/// A name without the number at its end: "FACE (12)", "patch_3".
std::string_view stem(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789 ()_-.#:");
  return name.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Faces that are leaves of their own, with their origin.
class LooseFaces {
 public:
  void add(const CadLeaf& leaf) {
    shapes_.push_back(leaf.shape);
    colours_.push_back(leaf.colour);
    const std::string_view own = stem(leaf.name);
    if (shapes_.size() == 1) name_ = leaf.name;
    if (name_ == leaf.name) return;
    const std::string_view common = stem(name_);
    name_ = common == own ? std::string(own) : std::string();
  }

  std::vector<CadLeaf> take() const {
    std::vector<CadLeaf> out;
    if (shapes_.empty()) return out;
    const auto made = sew(compound_of(shapes_));
    if (!made) {
      const auto coloured = std::find_if(colours_.begin(), colours_.end(), [](const auto& c) { return c; });
      return {{compound_of(shapes_), name_, coloured == colours_.end() ? CadColour() : *coloured}};
    }
    for (const TopoDS_Shape& body : made->bodies) out.push_back({body, name_, colour_of(body, *made)});
    if (made->alone.empty()) return out;
    const TopoDS_Compound rest = compound_of(made->alone);
    out.push_back({rest, name_, colour_of(rest, *made)});
    return out;
  }

 private:
  /// Colour of the first of the given faces that the shape consists of and that has one.
  CadColour colour_of(const TopoDS_Shape& shape, const Sewn& made) const {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (!colours_[i]) continue;
      TopExp_Explorer face(shapes_[i], TopAbs_FACE);
      if (face.More() && faces.Contains(made.made_of(face.Current()))) return colours_[i];
    }
    return {};
  }

  std::vector<TopoDS_Shape> shapes_;
  std::vector<CadColour> colours_;  ///< one for each shape
  std::string name_;
};

}  // namespace

std::vector<CadLeaf> sewn(std::vector<CadLeaf> leaves, bool loose) {
  LooseFaces shown, hidden;
  std::vector<CadLeaf> out;
  std::optional<std::size_t> first;  // position of the loose faces
  for (CadLeaf& leaf : leaves) {
    if (loose && count(leaf.shape, TopAbs_FACE) == 1) {
      if (!first) first = out.size();
      (leaf.visible ? shown : hidden).add(leaf);
      continue;
    }
    if (is_in_pieces(leaf.shape)) leaf.shape = whole(leaf.shape);
    out.push_back(std::move(leaf));
  }
  std::vector<CadLeaf> made = shown.take();
  for (CadLeaf& leaf : hidden.take()) {
    leaf.visible = false;
    made.push_back(std::move(leaf));
  }
  out.insert(out.begin() + std::ptrdiff_t(first.value_or(0)), made.begin(), made.end());
  return out;
}

}  // namespace hariko
