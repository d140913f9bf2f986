// Replaces operator new of this test program by one that counts: each block is preceded by its size. In a
// file of its own, so that compilers do not see through it.

#include "tests/polyhedron/counting_new.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> live = 0;
constexpr std::size_t header = alignof(std::max_align_t);
}  // namespace

std::size_t hariko::live_bytes() {
  return live;
}

// The sanitizers' own form does not call the one below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* block = std::malloc(size + header);
  if (!block) return nullptr;
  *static_cast<std::size_t*>(block) = size;
  live += size;
  return static_cast<char*>(block) + header;
}

void* operator new(std::size_t size) {
  void* block = operator new(size, std::nothrow);
  if (!block) throw std::bad_alloc();
  return block;
}

void operator delete(void* pointer) noexcept {
  if (!pointer) return;
  void* block = static_cast<char*>(pointer) - header;
  live -= *static_cast<std::size_t*>(block);
  std::free(block);
}

void operator delete(void* pointer, std::size_t) noexcept {
  operator delete(pointer);
}
