#include "app/commands/document_input.hpp"

#include "app/commands/console.hpp"

namespace hariko {

std::optional<Document> read_document_or_report(const std::filesystem::path& file) {
  OpenedFile opened = open_file(file);
  for (const Message& message : opened.messages) report(file.string(), message);
  return std::move(opened.document);
}

}  // namespace hariko
