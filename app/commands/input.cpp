#include "app/commands/input.hpp"

#include <algorithm>

#include "app/commands/console.hpp"
#include "core/base/printable.hpp"
#include "core/document/file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

void read_mesh_input(const std::filesystem::path& file, Input& input) {
  auto imported = read_mesh_file(file);
  if (!imported.ok()) {
    input.messages.push_back(imported.error());
    return;
  }
  input.messages = imported->warnings;
  if (const std::string own = printable(imported->name, Object::max_name_length); check_name(own).ok())
    input.name = own;
  PolygonMesh mesh = std::move(imported).value().mesh;
  auto document = document_from_mesh(mesh, input.name);
  if (document.ok()) {
    input.document = std::move(document).value();
    return;
  }
  // The first error stopped the conversion; the designer wants to know all of them.
  for (Message& message : validate(mesh))
    if (message.severity == Severity::error) input.messages.push_back(std::move(message));
  const auto same = [&](const Message& message) { return message.code == document.error().code; };
  if (std::none_of(input.messages.begin(), input.messages.end(), same))
    input.messages.push_back(document.error());
  input.broken_mesh = std::move(mesh);
}

}  // namespace

Input read_input(const std::filesystem::path& file) {
  Stopwatch watch;
  Input input;
  input.name = printable(file.stem().string(), Object::max_name_length);
  if (!check_name(input.name).ok()) input.name = "mesh";
  if (format_of_extension(file)) {
    read_mesh_input(file, input);
  } else {
    auto document = load_document(file);
    if (document.ok())
      input.document = std::move(document).value();
    else
      input.messages.push_back(document.error());
  }
  input.milliseconds = watch.lap();
  return input;
}

std::optional<Document> read_document_or_report(const std::filesystem::path& file) {
  Input input = read_input(file);
  for (const Message& message : input.messages) report(file.string(), message);
  return std::move(input.document);
}

}  // namespace hariko
