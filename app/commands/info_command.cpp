#include <optional>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/object_info.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

/// Describes the objects one after the other; text is printed as soon as an object is done.
class Describer {
 public:
  Describer(const InfoArguments& arguments, const OpenedFile& input, double reading)
      : arguments_(arguments), input_(input), reading_(reading) {
    const std::size_t count = input.document ? input.document->objects.size() : input.broken_mesh ? 1 : 0;
    alone_ = count == 1;
  }

  /// Describes all objects; false where the output cannot be written.
  bool describe_all(const Document* against) {
    if (!alone_) report(arguments_.file.string(), input_.messages);
    if (!input_.document) return !input_.broken_mesh || take(inspect_broken(input_));
    std::size_t number = 0;
    for (const auto& object : input_.document->objects) {
      const std::string place =
          alone_ ? ""
                 : std::to_string(++number) + "/" + std::to_string(input_.document->objects.size()) + " ";
      // Prints the counts immediately, while the rest is measured.
      const std::string head = arguments_.json ? "" : info_head(inspect_at_once(*object));
      if (!head.empty() && !print((objects_.empty() ? "" : "\n") + head)) return false;
      std::optional<ObjectInfo> info;
      {
        const ProgressLine line(place + sanitized_utf8(object->name, 60) + ": measuring");
        info = inspect(*input_.document, *object, against);
      }
      if (!take(*std::move(info), head)) return false;
    }
    return true;
  }
  bool failed() const { return failed_; }
  const std::vector<ObjectInfo>& objects() const { return objects_; }

 private:
  /// Adds or prints an object. `head`: part of its text that was printed already.
  bool take(ObjectInfo info, const std::string& head = {}) {
    // Messages about the whole file belong to its only object; with several objects, or none, they go to the
    // error stream.
    if (alone_) info.messages.insert(info.messages.begin(), input_.messages.begin(), input_.messages.end());
    info.milliseconds.insert(info.milliseconds.begin(), {"read", reading_});
    failed_ = failed_ || info.failed();
    std::string text = arguments_.json ? std::string() : info_text({info});
    if (!head.empty() && text.starts_with(head)) text.erase(0, head.size());
    objects_.push_back(std::move(info));
    return arguments_.json || print(text);
  }

  const InfoArguments& arguments_;
  const OpenedFile& input_;
  double reading_;
  bool alone_ = false, failed_ = false;
  std::vector<ObjectInfo> objects_;
};

}  // namespace

int run_info(const InfoArguments& arguments) {
  Stopwatch watch;
  OpenedFile input = open_as_asked(arguments.file, arguments.construction.reading);
  // Every object names its own parts that are inside out.
  std::erase_if(input.messages, [](const Message& message) { return message.code == w_inside_out; });
  if (input.document) input.document = with_construction(*std::move(input.document), arguments.construction);
  std::optional<Document> against;
  if (arguments.against) {
    against = read_document_or_report(*arguments.against, arguments.construction);
    if (!against) return exit_failed;
  }
  Describer describer(arguments, input, watch.lap());
  if (!describer.describe_all(against ? &*against : nullptr)) return exit_failed;
  const bool nothing = !input.document && !input.broken_mesh;
  const std::vector<GroupInfo> groups =
      input.document ? inspect_groups(*input.document) : std::vector<GroupInfo>();
  const std::vector<DimensionInfo> dimensions =
      input.document ? inspect_dimensions(*input.document) : std::vector<DimensionInfo>();
  if (arguments.json ? !print(info_json(describer.objects(), groups, dimensions))
                     : !nothing && describer.objects().empty() && !print(info_text({})))
    return exit_failed;
  if (!arguments.json && !groups.empty() && !print("\n" + groups_text(groups))) return exit_failed;
  if (!arguments.json && !dimensions.empty() &&
      !print("\n" + dimensions_text(dimensions, input.document->unit)))
    return exit_failed;
  return nothing || describer.failed() ? exit_failed : exit_fine;
}

}  // namespace hariko
