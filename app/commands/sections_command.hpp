#pragma once

// Command `sections`. Internal to app/commands.

#include "app/commands/commands.hpp"
#include "core/drawing/section_set.hpp"

namespace hariko {

/// Arguments of `hariko sections`.
struct SectionsArguments {
  std::filesystem::path file, out;       ///< `out`: *.svg or *.dxf
  Vector3 direction = Vector3::UnitX();  ///< not zero
  std::optional<double> first, spacing;  ///< document's unit; missing ones spread the planes over the model
  int count = 7;
  SectionCombs combs;
  std::vector<std::string> only;  ///< names of objects; empty: all visible objects
  bool json = false;
  Construction construction;
};
/// Writes the curves in which planes cut a document's surfaces and reference facets.
int run_sections(const SectionsArguments& arguments);

}  // namespace hariko
