#include "core/cad/kernel/opencascade/scene_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "core/base/files/file_io.hpp"

namespace hariko {

namespace {

/// Codes that a scene can carry. They are constants of the program, so that a name suffices to find each
/// again.
constexpr std::array known_codes{e_cad_read,   e_limit,      e_cancelled,    e_file_open,
                                 e_file_read,  w_cad_faces,  w_cad_patches,  w_cad_mark,
                                 w_cad_behind, w_cad_counts, w_cad_letters,  w_cad_mixed,
                                 w_cad_unit,   w_cad_placed, w_cad_left_out, w_cad_tessellated};

class Writer {
 public:
  template <class T>
  void value(const T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    out_.append(reinterpret_cast<const char*>(&x), sizeof x);
  }
  template <class T>
  void list(const std::vector<T>& all) {
    value(all.size());
    out_.append(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T));
  }
  void text(const std::string& x) {
    value(x.size());
    out_ += x;
  }
  void message(const Message& x) {
    value(x.severity);
    text(std::string(x.code.name));
    text(x.text);
    text(x.remedy);
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  T value() {
    T out;
    std::memcpy(&out, taken(sizeof out).data(), sizeof out);
    return out;
  }
  template <class T>
  std::vector<T> list() {
    std::vector<T> out(value<std::size_t>());
    const std::string_view bytes = taken(out.size() * sizeof(T));
    if (!out.empty()) std::memcpy(static_cast<void*>(out.data()), bytes.data(), bytes.size());
    return out;
  }
  std::string text() {
    const auto size = value<std::size_t>();
    return std::string(taken(size));
  }
  Message message() {
    Message out;
    out.severity = value<Severity>();
    const std::string name = text();
    const auto code = std::find_if(known_codes.begin(), known_codes.end(),
                                   [&](const Code& known) { return known.name == name; });
    HARIKO_ASSERT(code != known_codes.end(), "a code that is not in the list");
    out.code = *code;
    out.text = text();
    out.remedy = text();
    return out;
  }

 private:
  std::string_view taken(std::size_t size) {
    HARIKO_ASSERT(size <= left_.size(), "bytes are missing");
    const std::string_view out = left_.substr(0, size);
    left_.remove_prefix(size);
    return out;
  }
  std::string_view left_;
};

void write(Writer& out, const std::vector<BezierPatch>& patches) {
  out.value(patches.size());
  for (const BezierPatch& patch : patches) {
    out.value(patch.degree_s);
    out.value(patch.degree_t);
    out.list(patch.points);
    out.list(patch.weights);
  }
}

std::vector<BezierPatch> patches_in(Reader& in) {
  std::vector<BezierPatch> out;
  for (auto left = in.value<std::size_t>(); left > 0; --left) {
    BezierPatch& patch = out.emplace_back();
    patch.degree_s = in.value<int>();
    patch.degree_t = in.value<int>();
    patch.points = in.list<Vector3>();
    patch.weights = in.list<double>();
  }
  return out;
}

}  // namespace

std::string bytes_of(const Result<CadScene>& scene) {
  Writer out;
  out.value(scene.ok());
  if (!scene.ok()) {
    out.message(scene.error());
    return out.take();
  }
  out.value(scene->warnings.size());
  for (const Message& warning : scene->warnings) out.message(warning);
  out.value(scene->parts.size());
  for (const CadPart& part : scene->parts) {
    out.text(part.name);
    out.value(part.visible);
    out.value(part.colour.has_value());
    out.value(part.colour.value_or(std::array<std::uint8_t, 3>{}));
    write(out, part.patches);
    write(out, part.also_exact);
    out.list(part.mesh.positions);
    out.list(part.mesh.face_offsets);
    out.list(part.mesh.face_vertices);
  }
  return out.take();
}

Result<CadScene> scene_of(std::string_view bytes) {
  Reader in(bytes);
  if (!in.value<bool>()) return in.message();
  CadScene out;
  for (auto left = in.value<std::size_t>(); left > 0; --left) out.warnings.push_back(in.message());
  for (auto parts = in.value<std::size_t>(); parts > 0; --parts) {
    CadPart part;
    part.name = in.text();
    part.visible = in.value<bool>();
    const bool coloured = in.value<bool>();
    const auto colour = in.value<std::array<std::uint8_t, 3>>();
    if (coloured) part.colour = colour;
    part.patches = patches_in(in);
    part.also_exact = patches_in(in);
    part.mesh.positions = in.list<Vector3>();
    part.mesh.face_offsets = in.list<Index>();
    part.mesh.face_vertices = in.list<Index>();
    out.parts.push_back(std::move(part));
  }
  return out;
}

}  // namespace hariko
