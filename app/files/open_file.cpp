#include "app/files/open_file.hpp"

#include <algorithm>

#include "core/base/printable.hpp"
#include "core/document/file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

void open_mesh(const std::filesystem::path& file, OpenedFile& opened) {
  auto imported = read_mesh_file(file);
  if (!imported.ok()) {
    opened.messages.push_back(imported.error());
    return;
  }
  opened.messages = imported->warnings;
  if (const std::string own = printable(imported->name, Object::max_name_length); check_name(own).ok())
    opened.name = own;
  PolygonMesh mesh = std::move(imported).value().mesh;
  auto document = document_from_mesh(mesh, opened.name);
  if (document.ok()) {
    opened.document = std::move(document).value();
    return;
  }
  // The first error stopped the conversion; the designer wants to know all of them.
  for (Message& message : validate(mesh))
    if (message.severity == Severity::error) opened.messages.push_back(std::move(message));
  const auto same = [&](const Message& message) { return message.code == document.error().code; };
  if (std::none_of(opened.messages.begin(), opened.messages.end(), same))
    opened.messages.push_back(document.error());
  opened.broken_mesh = std::move(mesh);
}

}  // namespace

const Message* OpenedFile::error() const {
  const auto found = std::find_if(messages.begin(), messages.end(),
                                  [](const Message& message) { return message.severity == Severity::error; });
  return found == messages.end() ? nullptr : &*found;
}

OpenedFile open_file(const std::filesystem::path& file) {
  OpenedFile opened;
  opened.name = printable(file.stem().string(), Object::max_name_length);
  if (!check_name(opened.name).ok()) opened.name = "mesh";
  if (format_of_extension(file)) {
    open_mesh(file, opened);
    return opened;
  }
  opened.native = true;
  auto document = load_document(file);
  if (document.ok())
    opened.document = std::move(document).value();
  else
    opened.messages.push_back(document.error());
  return opened;
}

}  // namespace hariko
