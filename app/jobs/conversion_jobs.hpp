#pragma once

// ConversionJobs: conversion of skins and solids to polyhedra, off the main thread.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/jobs/background_work.hpp"
#include "core/base/result.hpp"

namespace hariko {

/// Conversions for the main thread.
class ConversionJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: receives "converted" when a polyhedron is added.
  ConversionJobs(Editor& editor, BackgroundWork& work, Log log)
      : editor_(editor), work_(work), log_(std::move(log)) {}

  /// Converts a skin or solids, as they are now, to a polyhedron; a running conversion is cancelled. It ends
  /// in one undoable step: the polyhedron is added and selected, its source is hidden, and a notice gives the
  /// deviation of its surface from the source's. An object that changed meanwhile stays as it is, and a
  /// notice says so. Other kinds of objects are ignored.
  void convert(ObjectId object);

 private:
  struct Made {
    PolyhedronSource source;
    std::string note;  ///< in English
    std::vector<Message> warnings;
  };
  using Work = std::function<Result<Made>(const CancelToken&, const Progress&)>;
  Work work_on(const std::shared_ptr<const Object>& object) const;
  void take(const Object& object, const Result<Made>& made);

  Editor& editor_;
  BackgroundWork& work_;
  Log log_;
  std::shared_ptr<const Job> converting_;
  int conversions_ = 0;  ///< number of requested conversions
};

}  // namespace hariko
