#include "core/cad/kernel/opencascade/cad_parts.hpp"

#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

namespace {

std::string name_of_label(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  std::string out(std::size_t(name->Get().LengthOfCString()) + 1, '\0');
  Standard_PCharacter at = out.data();
  name->Get().ToUTF8CString(at);
  out.resize(out.size() - 1);
  return sanitized_utf8(out, 200);
}

/// Whether a name is the place of a shape in the kernel's own tables ("=>[0:1:1:2]"), which it writes where a
/// shape has no name.
bool is_place_in_table(std::string_view name) {
  return name.starts_with("=>[") && name.ends_with("]");
}

/// Whether the name of a component's usage is meaningful: often it is empty, a number, or the STEP entity
/// that places the component, in the words of the standard or of a program.
bool usage_says_something(std::string_view usage) {
  if (is_place_in_table(usage)) return false;
  std::string plain(usage);
  for (char& letter : plain)
    letter = letter == '_' ? ' ' : letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter;
  std::string_view left = plain;
  for (const std::string_view kind :
       {"nauo", "next assembly usage occurrence", "next assembly relationship", "next assembly usage"})
    if (left.starts_with(kind)) left.remove_prefix(kind.size());
  return left.find_first_not_of(" -#.0123456789") != std::string_view::npos;
}

/// Whether the name of a product is one that somebody gave it; a number may be that of a part.
bool product_says_something(std::string_view product) {
  return !is_place_in_table(product) && !product.starts_with("Open CASCADE STEP translator") &&
         product.find_first_not_of(' ') != std::string_view::npos;
}

/// Names that a component has from the assemblies around it.
struct GivenNames {
  std::string usage;    ///< nearest usage that says something
  std::string product;  ///< nearest product that says something

  std::string best(const std::string& own) const {
    if (!usage.empty()) return usage;
    return product_says_something(own) || product.empty() ? own : product;
  }
};

TopoDS_Shape shapes_together(const std::vector<TopoDS_Shape>& shapes) {
  if (shapes.size() == 1) return shapes.front();
  TopoDS_Compound out;
  BRep_Builder builder;
  builder.MakeCompound(out);
  for (const TopoDS_Shape& shape : shapes) builder.Add(out, shape);
  return out;
}

std::size_t count_alone(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum not_in) {
  std::size_t out = 0;
  for (TopExp_Explorer at(shape, kind, not_in); at.More(); at.Next()) ++out;
  return out;
}

class PartCollector {
 public:
  PartCollector(const Handle(TDocStd_Document) & document, const TopTools_MapOfShape& hidden)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        hidden_(hidden) {}

  Result<CadParts> run() {
    TDF_LabelSequence labels;
    shapes_->GetFreeShapes(labels);
    for (int i = 1; i <= labels.Length(); ++i) add(labels.Value(i), {}, {}, {}, true, 0);
    if (too_many_)
      return make_error(e_limit, "The file has more than " + std::to_string(max_cad_parts) + " parts.",
                        "Export the assembly in several files.");
    return std::move(out_);
  }

 private:
  static constexpr int deepest = 100;

  /// Bodies of one colour and visibility.
  struct Group {
    CadColour colour;
    bool visible = true;
    std::vector<TopoDS_Shape> shapes;
  };

  CadColour colour_of(const TDF_Label& label) const {
    for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv})
      if (Quantity_Color colour; colours_->GetColor(label, kind, colour)) return as_bytes(colour);
    return {};
  }
  CadColour colour_of(const TopoDS_Shape& shape) const {
    for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (Quantity_Color colour; colours_->GetColor(shape, kind, colour)) return as_bytes(colour);
    return {};
  }
  static CadColour as_bytes(const Quantity_Color& colour) {
    double r = 0, g = 0, b = 0;
    colour.Values(r, g, b, Quantity_TOC_sRGB);
    const auto byte = [](double x) { return std::uint8_t(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
    return std::array{byte(r), byte(g), byte(b)};
  }
  /// Colour of the shape, else of its first solid, of its first shell, or of its first face, if one has any.
  CadColour inner_colour(const TopoDS_Shape& shape) const {
    if (const CadColour own = colour_of(shape)) return own;
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
      if (TopExp_Explorer at(shape, kind); at.More())
        if (const CadColour colour = colour_of(at.Current())) return colour;
    return {};
  }
  bool is_hidden(const TopoDS_Shape& shape) const {
    return hidden_.Contains(shape.Located(TopLoc_Location()));
  }

  /// Groups of a shape's solids, in the order in which they appear.
  std::vector<Group> groups_of_solids(const TopoDS_Shape& shape, const CadColour& given) const {
    std::vector<Group> out;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
      const CadColour colour = given ? given : inner_colour(solid.Current());
      const bool visible = !is_hidden(solid.Current());
      const auto known = std::find_if(out.begin(), out.end(), [&](const Group& group) {
        return group.colour == colour && group.visible == visible;
      });
      (known != out.end() ? *known : out.emplace_back(Group{colour, visible, {}}))
          .shapes.push_back(solid.Current());
    }
    return out;
  }
  /// Visible and hidden shells and faces of a shape that are in no solid.
  std::array<std::vector<TopoDS_Shape>, 2> loose_surfaces(const TopoDS_Shape& shape) const {
    std::array<std::vector<TopoDS_Shape>, 2> out;
    for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
      out[is_hidden(shell.Current()) ? 1 : 0].push_back(shell.Current());
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
      out[is_hidden(face.Current()) ? 1 : 0].push_back(face.Current());
    return out;
  }
  /// Groups of a shape's bodies; one with the whole shape where all have one colour and visibility.
  std::vector<Group> groups_of(const TopoDS_Shape& shape, const CadColour& given) const {
    std::vector<Group> out = groups_of_solids(shape, given);
    const auto surfaces = loose_surfaces(shape);
    const bool first = out.empty() ? surfaces[1].empty() : out.front().visible;
    if (out.size() < 2 && surfaces[first ? 1 : 0].empty())
      return {Group{given ? given : inner_colour(shape), first, {shape}}};
    for (const bool visible : {true, false})
      if (const auto& own = surfaces[visible ? 0 : 1]; !own.empty())
        out.push_back({given ? given : inner_colour(own.front()), visible, own});
    return out;
  }

  void add(const TDF_Label& label, const TopLoc_Location& place, const GivenNames& given,
           const CadColour& given_colour, bool visible, int depth) {
    if (depth > deepest || too_many_) return;
    const std::string own = name_of_label(label);
    const CadColour colour = given_colour ? given_colour : colour_of(label);
    visible = visible && colours_->IsVisible(label);
    TDF_Label referred;
    if (XCAFDoc_ShapeTool::IsReference(label) && XCAFDoc_ShapeTool::GetReferredShape(label, referred))
      return add(referred, place * XCAFDoc_ShapeTool::GetLocation(label),
                 {usage_says_something(own) ? own : given.usage, given.product}, colour, visible, depth + 1);
    if (!XCAFDoc_ShapeTool::IsAssembly(label))
      return add_shape(XCAFDoc_ShapeTool::GetShape(label), place, given.best(own), colour, visible);
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    const GivenNames names{components.Length() == 1 ? given.usage : std::string(),
                           product_says_something(own) ? own : given.product};
    for (int i = 1; i <= components.Length(); ++i)
      add(components.Value(i), place, names, colour, visible, depth + 1);
  }

  void add_shape(const TopoDS_Shape& shape, const TopLoc_Location& place, const std::string& name,
                 const CadColour& colour, bool visible) {
    if (shape.IsNull()) return;
    visible = visible && !is_hidden(shape);
    if (visible) {
      out_.curves +=
          count_alone(shape, TopAbs_WIRE, TopAbs_FACE) + count_alone(shape, TopAbs_EDGE, TopAbs_WIRE);
      out_.points += count_alone(shape, TopAbs_VERTEX, TopAbs_EDGE);
    }
    const std::vector<Group> groups = groups_of(shape, colour);
    too_many_ = out_.leaves.size() + groups.size() > max_cad_parts;
    if (too_many_) return;
    for (const Group& group : groups)
      out_.leaves.push_back(
          {shapes_together(group.shapes).Moved(place), name, group.colour, visible && group.visible});
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  const TopTools_MapOfShape& hidden_;
  CadParts out_;
  bool too_many_ = false;
};

}  // namespace

Result<CadParts> cad_parts(const Handle(TDocStd_Document) & document, const TopTools_MapOfShape& hidden) {
  return PartCollector(document, hidden).run();
}

}  // namespace hariko
