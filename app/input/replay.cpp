#include "app/input/replay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "core/base/files/file_io.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/document/format/format.hpp"

namespace hariko {

namespace {

using Json = nlohmann::json;
using Kind = InputEvent::Kind;
constexpr int replay_version = 1;

constexpr std::array kinds{std::pair{Kind::move, "move"},     std::pair{Kind::leave, "leave"},
                           std::pair{Kind::button, "button"}, std::pair{Kind::wheel, "wheel"},
                           std::pair{Kind::key, "key"},       std::pair{Kind::text, "text"},
                           std::pair{Kind::cap, "cap"},       std::pair{Kind::cap_button, "cap_button"},
                           std::pair{Kind::focus, "focus"},   std::pair{Kind::size, "size"},
                           std::pair{Kind::drop, "drop"},     std::pair{Kind::close, "close"}};

void write(JsonWriter& json, const InputEvent& event) {
  json.object([&] {
    for (const auto& [kind, name] : kinds)
      if (kind == event.kind) json.member("kind", name);
    switch (event.kind) {
      case Kind::move:
      case Kind::wheel:
      case Kind::size:
        json.member("x", event.x);
        json.member("y", event.y);
        break;
      case Kind::button:
        json.member("button", event.code);
        json.member("down", event.down);
        json.member("modifiers", event.modifiers);
        break;
      case Kind::key:
        json.member("key", event.code);
        if (event.meant != event.code) json.member("meant", event.meant);
        json.member("down", event.down);
        if (event.repeated) json.member("repeated", true);
        json.member("modifiers", event.modifiers);
        break;
      case Kind::text:
        json.member("character", event.code);
        break;
      case Kind::cap:
        json.list("cap", event.cap, [&](double part) { json.value(part); });
        json.member("seconds", event.seconds);
        break;
      case Kind::cap_button:
        json.member("button", event.code);
        json.member("down", event.down);
        break;
      case Kind::focus:
        json.member("down", event.down);
        break;
      case Kind::drop:
        json.list("paths", event.paths, [&](const auto& path) { json.value(path.string()); });
        break;
      default:
        break;
    }
  });
}

/// Line {"t": TIME, ...} with the members that `body` writes.
template <class Body>
std::string line_at(double time, Body&& body) {
  JsonWriter json;
  json.object([&] {
    json.member("t", time);
    body(json);
  });
  return json.take();
}

/// Event from JSON; throws the JSON library's exceptions, or a sentence.
InputEvent event_from(const Json& json) {
  InputEvent event;
  const std::string name = json.at("kind").get<std::string>();
  bool known = false;
  for (const auto& [kind, word] : kinds)
    if (name == word) {
      event.kind = kind;
      known = true;
    }
  if (!known) throw std::runtime_error("unknown kind \"" + name + "\"");
  event.x = json.value("x", 0.0);
  event.y = json.value("y", 0.0);
  if (!std::isfinite(event.x) || !std::isfinite(event.y)) throw std::runtime_error("a number is not finite");
  const bool pressed = event.kind == Kind::button || event.kind == Kind::cap_button;
  event.code = pressed                    ? json.at("button").get<int>()
               : event.kind == Kind::key  ? json.at("key").get<int>()
               : event.kind == Kind::text ? json.at("character").get<int>()
                                          : 0;
  if (event.kind == Kind::cap) {
    event.cap = json.at("cap").get<std::array<double, 6>>();
    event.seconds = json.at("seconds").get<double>();
    const bool finite = std::ranges::all_of(event.cap, [](double x) { return std::isfinite(x); });
    if (!finite || !std::isfinite(event.seconds)) throw std::runtime_error("a number is not finite");
  }
  event.meant = event.kind == Kind::key ? json.value("meant", event.code) : 0;
  event.down = json.value("down", false);
  event.repeated = json.value("repeated", false);
  event.modifiers = json.value("modifiers", 0);
  if (json.contains("paths"))
    for (const Json& path : json.at("paths")) event.paths.emplace_back(path.get<std::string>());
  return event;
}

void read_start(const Json& json, const std::filesystem::path& folder, ReplayStart& start) {
  const int version = json.at("hariko_replay").get<int>();
  if (version != replay_version)
    throw std::runtime_error("version " + std::to_string(version) + " is unknown");
  start.width = json.at("width").get<int>();
  start.height = json.at("height").get<int>();
  start.scale = json.value("scale", 1.0);
  if (!(start.scale >= 0.25 && start.scale <= 8)) throw std::runtime_error("the scale is out of range");
  if (json.contains("session")) {
    const Json& session = json.at("session");
    start.session = {session.at("document").get<std::string>(), session.value("name", std::string()),
                     session.value("dirty", false), session.at("settings").dump()};
  }
  for (const Json& file : json.at("files")) {
    const std::filesystem::path path(file.get<std::string>());
    start.files.push_back(path.is_absolute() ? path : (folder / path).lexically_normal());
  }
}

void read_line(const Json& json, Replay& replay) {
  ReplayStep step;
  step.time = json.at("t").get<double>();
  const double before = replay.steps.empty() ? 0 : replay.steps.back().time;
  if (!(step.time >= before)) throw std::runtime_error("times descend");
  if (json.contains("end")) {
    replay.document = json.at("end").at("document").get<std::string>();
    if (replay.document.empty()) throw std::runtime_error("the document is missing");
    replay.undo_steps = json.at("end").at("steps").get<std::size_t>();
    step.waits_for_idle = true;
  } else if (json.contains("idle")) {
    step.waits_for_idle = true;
  } else {
    for (const Json& event : json.at("events")) step.batch.push_back(event_from(event));
  }
  replay.steps.push_back(std::move(step));
}

}  // namespace

Result<Replay> Replay::read(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text.ok()) return text.error();
  Replay replay;
  std::istringstream lines(text.value());
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty()) continue;
    try {
      const Json json = Json::parse(line);
      if (number == 1)
        read_start(json, std::filesystem::absolute(path).parent_path(), replay.start);
      else if (!replay.document.empty())
        throw std::runtime_error("something follows the end");
      else
        read_line(json, replay);
    } catch (const std::exception& failure) {
      return make_error(e_replay_read,
                        path.string() + ", line " + std::to_string(number) + ": " + failure.what() + ".",
                        "Record the replay again.");
    }
  }
  if (replay.document.empty())
    return make_error(e_replay_read,
                      path.string() + " has no end: the program that recorded it did not end well.",
                      "Record the replay again.");
  return replay;
}

std::optional<std::string> other_document(const Replay& replay, const Document& document) {
  constexpr std::size_t hash_digits = 16;
  if (replay.document.size() == hash_digits) return {};
  const auto recorded = read_document(replay.document);
  if (!recorded) return "the recorded document cannot be read: " + recorded.error().text;
  std::istringstream wanted(write_document(recorded.value())), found(write_document(document));
  for (int number = 1;; ++number) {
    std::string one, other;
    const bool more = bool(std::getline(wanted, one)), more_found = bool(std::getline(found, other));
    if (!more && !more_found) return {};
    if (one != other)
      return "the document is another one. Its line " + std::to_string(number) + " is \"" + other +
             "\" instead of \"" + one + "\".";
  }
}

ReplayRecorder::ReplayRecorder(const std::filesystem::path& path, const ReplayStart& start, double now)
    : out_(path, std::ios::binary), start_(now) {
  const auto folder = std::filesystem::absolute(path).parent_path();
  JsonWriter json;
  json.object([&] {
    json.member("hariko_replay", replay_version);
    json.member("width", start.width);
    json.member("height", start.height);
    json.member("scale", start.scale);
    json.list("files", start.files, [&](const auto& file) {
      json.value(std::filesystem::absolute(file).lexically_relative(folder).generic_string());
    });
    if (!start.session) return;
    json.object("session", [&] {
      json.member("name", start.session->name);
      json.member("dirty", start.session->dirty);
      json.key("settings");
      json.raw(start.session->settings);
      json.member("document", start.session->document);
    });
  });
  out_ << json.take() << std::endl;
}

/// Time since the start, rounded to milliseconds: the order matters, not the digits. The frame in which a
/// recording starts is older than it, hence the maximum.
double ReplayRecorder::since_start(double now) const {
  return std::round(1000 * std::max(0.0, now - start_)) / 1000;
}

void ReplayRecorder::batch(double now, const std::vector<InputEvent>& events) {
  if (events.empty()) return;
  out_ << line_at(since_start(now), [&](JsonWriter& json) {
    json.list("events", events, [&](const InputEvent& event) { write(json, event); });
  }) << std::endl;
  marked_idle_ = false;
}

void ReplayRecorder::idle(double now) {
  if (marked_idle_) return;
  out_ << line_at(since_start(now), [](JsonWriter& json) { json.member("idle", true); }) << std::endl;
  marked_idle_ = true;
}

void ReplayRecorder::finish(double now, const Document& document, std::size_t undo_steps) {
  out_ << line_at(since_start(now), [&](JsonWriter& json) {
    json.object("end", [&] {
      json.member("document", write_document(document));
      json.member("steps", undo_steps);
    });
  }) << std::endl;
}

bool ReplayPlayer::all_played() const {
  return std::all_of(replay_.steps.begin() + static_cast<std::ptrdiff_t>(next_), replay_.steps.end(),
                     [](const ReplayStep& step) { return step.waits_for_idle; });
}

std::vector<InputEvent> ReplayPlayer::advance(double seconds, bool idle) {
  if (next_ == replay_.steps.size()) {
    finished_ = true;
    now_ += seconds;
    return {};
  }
  const ReplayStep& step = replay_.steps[next_];
  if (step.waits_for_idle) {
    now_ += seconds;
    waited_ += seconds;
    if (!idle) return {};
    delay_ = std::max(delay_, now_ - step.time);
    waited_ = 0;
    ++next_;
    return {};
  }
  if (skip_pauses_ && idle) now_ = std::max(now_, step.time + delay_);
  // The clock stops at the next step, however long the last frame took.
  now_ = std::min(now_ + seconds, std::max(now_, step.time + delay_));
  if (now_ < step.time + delay_) return {};
  ++next_;
  return step.batch;
}

}  // namespace hariko
