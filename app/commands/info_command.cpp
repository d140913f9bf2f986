#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/object_info.hpp"

namespace hariko {

int run_info(const InfoArguments& arguments) {
  Stopwatch watch;
  OpenedFile input = open_file(arguments.file);
  if (input.document) input.document = with_construction(*std::move(input.document), arguments.construction);
  std::optional<Document> against;
  if (arguments.against) {
    against = read_document_or_report(*arguments.against, arguments.construction);
    if (!against) return exit_failed;
  }
  const double reading = watch.lap();
  std::vector<ObjectInfo> objects;
  if (input.document)
    for (const auto& object : input.document->objects)
      objects.push_back(inspect(*input.document, *object, against ? &*against : nullptr));
  else if (input.broken_mesh)
    objects.push_back(inspect_broken(input));

  // What concerns the file as a whole stands with its one object; with several, or none, it goes to the error
  // stream.
  if (objects.size() == 1)
    objects[0].messages.insert(objects[0].messages.begin(), input.messages.begin(), input.messages.end());
  else
    for (const Message& message : input.messages) report(arguments.file.string(), message);
  for (ObjectInfo& object : objects)
    object.milliseconds.insert(object.milliseconds.begin(), {"read", reading});

  const bool nothing = !input.document && !input.broken_mesh;
  if (!nothing || arguments.json)
    if (!print(arguments.json ? info_json(objects) : info_text(objects))) return exit_failed;
  const bool failed = nothing || std::any_of(objects.begin(), objects.end(),
                                             [](const ObjectInfo& object) { return object.failed(); });
  return failed ? exit_failed : exit_fine;
}

}  // namespace hariko
