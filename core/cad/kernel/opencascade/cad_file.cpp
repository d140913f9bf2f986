#include "core/cad/kernel/cad_file.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <sstream>

#include "core/cad/kernel/cad_letters.hpp"
#include "core/cad/kernel/opencascade/kernel.hpp"
#include "core/cad/kernel/opencascade/kernel_session.hpp"
#include "core/cad/kernel/opencascade/shape.hpp"

namespace hariko {

namespace {

const char* name_of(CadUnit unit) {
  switch (unit) {
    case CadUnit::centimetre:
      return "CM";
    case CadUnit::metre:
      return "M";
    case CadUnit::inch:
      return "INCH";
    default:
      return "MM";
  }
}

double millimetres_in(CadUnit unit) {
  switch (unit) {
    case CadUnit::centimetre:
      return 10;
    case CadUnit::metre:
      return 1000;
    case CadUnit::inch:
      return 25.4;
    default:
      return 1;
  }
}

void add(KernelDocument& document, const TopoDS_Shape& shape, const CadObject& object) {
  const TDF_Label main = document.handle()->Main();
  const TDF_Label label = XCAFDoc_DocumentTool::ShapeTool(main)->AddShape(shape, false);
  TDataStd_Name::Set(label, TCollection_ExtendedString(object.name.c_str(), true));
  const auto part = [&](std::size_t i) { return object.colour[i] / 255.0; };
  XCAFDoc_DocumentTool::ColorTool(main)->SetColor(
      label, Quantity_Color(part(0), part(1), part(2), Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
}

double largest_edge_tolerance(const TopoDS_Shape& shape) {
  double largest = 0;
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
  return largest;
}

constexpr const char* way_out_of_kernel_failure =
    "Look for faces without area and objects of extreme sizes or places, or hide objects one by one.";

Message not_written(const std::string& what) {
  return make_error(e_cad_kernel, "OpenCASCADE could not make the file: " + what + ".",
                    way_out_of_kernel_failure);
}

/// Shape of an object, with its counts and the kernel's verdict added to the report. E_CAD_KERNEL with the
/// object's name where the kernel fails.
Result<TopoDS_Shape> checked_shape(const CadObject& object, CadFileReport& report) {
  try {
    const TopoDS_Shape shape = shape_of(*object.model, report);
    report.valid = report.valid && BRepCheck_Analyzer(shape).IsValid();
    report.edge_tolerance = std::max(report.edge_tolerance, largest_edge_tolerance(shape));
    return shape;
  } catch (const Standard_Failure& failure) {
    return make_error(e_cad_kernel,
                      object.name + ": OpenCASCADE could not make a shape of this object: " +
                          failure.GetMessageString() + ".",
                      way_out_of_kernel_failure);
  }
}

Handle(TCollection_HAsciiString) text(const std::string& value) {
  return new TCollection_HAsciiString(value.c_str());
}

Result<std::string> step_text(const KernelDocument& document, const CadFileOptions& options) {
  Interface_Static::SetCVal("write.step.schema",
                            options.format == CadFormat::step_ap242 ? "AP242DIS" : "AP214IS");
  Interface_Static::SetCVal("write.step.unit", name_of(options.unit));
  STEPCAFControl_Writer writer;
  // The setting names the unit in the file; since OpenCASCADE 7.7 the numbers follow the model's own unit.
  writer.ChangeWriter().Model()->SetWriteLengthUnit(millimetres_in(options.unit));
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  if (!writer.Transfer(document.handle(), STEPControl_AsIs)) return not_written("nothing was transferred");
  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text("hariko"));
  header.SetTimeStamp(text(options.time));
  header.SetOriginatingSystem(text("Hariko"));
  header.Apply(model);
  const Handle(StepData_Protocol) protocol =
      Handle(StepData_Protocol)::DownCast(writer.ChangeWriter().WS()->Protocol());
  StepData_StepWriter lines(model);
  lines.SendModel(protocol);
  std::ostringstream stream;
  if (!lines.Print(stream)) return not_written("the text of the STEP file could not be made");
  return with_step_directives(std::move(stream).str());
}

Result<std::string> iges_text(const KernelDocument& document, const CadFileOptions& options) {
  Interface_Static::SetCVal("write.iges.unit", name_of(options.unit));
  Interface_Static::SetIVal("write.iges.brep.mode", 1);
  IGESCAFControl_Writer writer;
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  if (!writer.Transfer(document.handle())) return not_written("nothing was transferred");
  writer.ComputeModel();
  IGESData_GlobalSection global = writer.Model()->GlobalSection();
  std::string time;  // 20261122.120000
  for (const char c : options.time) {
    if (c < '0' || c > '9') continue;
    if (time.size() == 8) time += '.';
    time += c;
  }
  global.SetDate(text(time));
  global.SetLastChangeDate(text(time));
  global.SetFileName(text("hariko"));
  writer.Model()->SetGlobalSection(global);
  std::ostringstream stream;
  if (!writer.Write(stream)) return not_written("the text of the IGES file could not be made");
  return std::move(stream).str();
}

Result<CadFile> make(std::span<const CadObject> objects, const CadFileOptions& options,
                     const CancelToken& cancel, const Progress& progress) {
  CadFile out;
  out.report.valid = true;
  KernelDocument document;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
    const auto shape = checked_shape(objects[i], out.report);
    if (!shape.ok()) return shape.error();
    CadObject object = objects[i];
    if (options.format == CadFormat::iges) object.name = ascii_name(object.name);
    out.report.changed_names += object.name != objects[i].name;
    add(document, *shape, object);
    progress.report(0.5 * double(i + 1) / double(objects.size()));
  }
  if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  auto bytes =
      options.format == CadFormat::iges ? iges_text(document, options) : step_text(document, options);
  if (!bytes.ok()) return bytes.error();
  out.bytes = std::move(bytes).value();
  progress.report(1);
  return out;
}

}  // namespace

Result<CadFile> by_opencascade::make_cad_file(std::span<const CadObject> objects,
                                              const CadFileOptions& options, const CancelToken& cancel,
                                              const Progress& progress) {
  try {
    const KernelSession session;
    return make(objects, options, cancel, progress);
  } catch (const Standard_Failure& failure) {
    return not_written(failure.GetMessageString());
  }
}

}  // namespace hariko
