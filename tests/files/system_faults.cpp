#include "tests/files/system_faults.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <set>

namespace hariko::test {

namespace {

struct State {
  std::string folder;
  int failing = 0, error = 0, calls = 0;
  std::size_t piece = 1;
  std::set<int> descriptors;
  std::vector<std::string> exposed;

  bool inside(const char* path) const { return std::string(path).starts_with(folder); }
  bool fails() {
    if (calls++ != failing) return false;
    errno = error;
    return true;
  }
};
/// The functions below have no other way to know of it.
State* state = nullptr;

template <class Function>
Function* system_call(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

void note_exposed(const char* path) {
  if (!std::filesystem::path(path).filename().string().starts_with(".hariko-"))
    state->exposed.push_back(path);
}

int open_by(const char* name, const char* path, int flags, mode_t mode) {
  const auto next = system_call<int(const char*, int, ...)>(name);
  const bool writing = (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) != 0;
  if (!state || !state->inside(path) || (!writing && (flags & O_DIRECTORY) == 0))
    return next(path, flags, mode);
  if (writing) note_exposed(path);
  if (state->fails()) return -1;
  const int out = next(path, flags, mode);
  if (out >= 0) state->descriptors.insert(out);
  return out;
}

std::FILE* fopen_by(const char* name, const char* path, const char* mode) {
  if (state && state->inside(path) && std::strpbrk(mode, "wa+")) note_exposed(path);
  return system_call<std::FILE*(const char*, const char*)>(name)(path, mode);
}

bool watched(int descriptor) {
  return state && state->descriptors.contains(descriptor);
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

SystemFaults::SystemFaults(const std::filesystem::path& folder, int failing, int error_number,
                           std::size_t piece) {
  state = new State;
  state->folder = folder.native();
  state->failing = failing;
  state->error = error_number;
  state->piece = std::max<std::size_t>(piece, 1);
}
SystemFaults::~SystemFaults() {
  delete state;
  state = nullptr;
}
int SystemFaults::calls() const {
  return state->calls;
}
const std::vector<std::string>& SystemFaults::exposed() const {
  return state->exposed;
}

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_by("open", path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_by("open64", path, flags, mode);
}
std::FILE* fopen(const char* path, const char* mode) {
  return fopen_by("fopen", path, mode);
}
std::FILE* fopen64(const char* path, const char* mode) {
  return fopen_by("fopen64", path, mode);
}
ssize_t write(int descriptor, const void* data, size_t size) {
  const auto next = system_call<ssize_t(int, const void*, size_t)>("write");
  if (!watched(descriptor)) return next(descriptor, data, size);
  return state->fails() ? -1 : next(descriptor, data, std::min(size, state->piece));
}
int fchmod(int descriptor, mode_t mode) noexcept {
  if (watched(descriptor) && state->fails()) return -1;
  return system_call<int(int, mode_t)>("fchmod")(descriptor, mode);
}
int fsync(int descriptor) {
  if (watched(descriptor) && state->fails()) return -1;
  return system_call<int(int)>("fsync")(descriptor);
}
int close(int descriptor) {
  const int result = system_call<int(int)>("close")(descriptor);  // a failing close has closed nevertheless
  if (!watched(descriptor)) return result;
  state->descriptors.erase(descriptor);
  return state->fails() ? -1 : result;
}
int rename(const char* from, const char* to) noexcept {
  if (state && state->inside(to) && state->fails()) return -1;
  return system_call<int(const char*, const char*)>("rename")(from, to);
}
int unlink(const char* path) noexcept {
  if (state && state->inside(path) && state->fails()) return -1;
  return system_call<int(const char*)>("unlink")(path);
}

}  // extern "C"

}  // namespace hariko::test
