#pragma once

// Parallel loops. The only place that uses the thread library.

#include <cstddef>
#include <functional>
#include <memory>

namespace hariko {

/// Calls body(begin, end) on disjoint ranges that cover [0, count). `grain` items are worth one task (about
/// 0.1 ms); loops of at most one grain run on the calling thread. Ranges depend on count and grain alone,
/// never on the number of threads, so a body that writes only its own items gives the same result on any
/// machine.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Sum of body(begin, end) over the same fixed ranges, added in a fixed order: bit-identical on any number of
/// threads.
double parallel_sum(std::size_t count, std::size_t grain,
                    const std::function<double(std::size_t begin, std::size_t end)>& body);

/// Limit of the number of threads: while it exists, loops of the whole process use at most `threads` threads
/// (1 = serial). For tests, and to leave a core to the user interface.
class ParallelLimit {
 public:
  explicit ParallelLimit(int threads);
  ~ParallelLimit();
  ParallelLimit(const ParallelLimit&) = delete;
  ParallelLimit& operator=(const ParallelLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace hariko
