#include "app/commands/document_input.hpp"

#include "app/commands/console.hpp"

namespace hariko {

std::optional<Document> read_document_or_report(const std::filesystem::path& file,
                                                const Construction& construction) {
  OpenedFile opened = open_file(file);
  for (const Message& message : opened.messages) report(file.string(), message);
  if (!opened.document) return std::nullopt;
  return with_construction(*std::move(opened.document), construction);
}

Document with_construction(Document document, const Construction& construction) {
  if (!construction.mode && !construction.round) return document;
  for (auto& object : document.objects) {
    if (!object->polyhedron()) continue;
    auto changed = std::make_shared<Object>(*object);
    auto& source = std::get<PolyhedronSource>(changed->source);
    source.mode = construction.mode.value_or(source.mode);
    source.round = source.round || construction.round;
    object = std::move(changed);
  }
  return document;
}

}  // namespace hariko
