#pragma once

// ConversionJobs: skins and solids become polyhedra, off the main thread.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/jobs/background_work.hpp"
#include "core/base/result.hpp"

namespace hariko {

/// For the main thread.
class ConversionJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: told "converted" when a polyhedron is there.
  ConversionJobs(Editor& editor, BackgroundWork& work, Log log)
      : editor_(editor), work_(work), log_(std::move(log)) {}

  /// Makes a polyhedron of a skin or of solids as they are now; a conversion that is on its way is cancelled.
  /// One step at the end: the polyhedron comes and is chosen, what it was made of is hidden, and a notice
  /// says how far its surface is from that. An object that was changed meanwhile stays as it is, and a notice
  /// says so. Other kinds stay as they are.
  void convert(ObjectId object);

 private:
  struct Made {
    PolyhedronSource source;
    std::string note;  ///< English
    std::vector<Message> warnings;
  };
  using Work = std::function<Result<Made>(const CancelToken&, const Progress&)>;
  Work work_on(const std::shared_ptr<const Object>& object) const;
  void take(const Object& object, const Result<Made>& made);

  Editor& editor_;
  BackgroundWork& work_;
  Log log_;
  std::shared_ptr<const Job> converting_;
  int conversions_ = 0;  ///< asked for
};

}  // namespace hariko
