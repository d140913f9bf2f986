#pragma once

// The inputs of tests/skinning/data, and the options under which their golden values were made.

#include <gtest/gtest.h>

#include <string>

#include "core/base/files/file_io.hpp"
#include "core/document/format/read_skin.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {

inline std::string data_text(const std::string& name) {
  auto text = read_file(test::source_folder() + "/tests/skinning/data/" + name, std::size_t(1) << 24);
  EXPECT_TRUE(text.ok()) << name;
  return text.ok() ? *text : std::string();
}

/// Closed sections begin where they were drawn: the golden values were made so.
inline Skin skin_input(const std::string& name) {
  auto read = read_skin_layout(data_text(name + ".json"));
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : to_string(read.error()));
  if (!read.ok()) return {};
  Skin skin = std::move(read).value();
  for (SkinSection& section : skin.sections) section.start_chosen = section.closed;
  return skin;
}

/// pleat_paper, pleat_quads, pleat_exact, pleat_fair200, pleat_caps, smooth_N_R_params_blend.
inline void set_options(Skin& skin, const std::string& configuration) {
  std::vector<std::string> words{""};
  for (const char c : configuration) {
    if (c == '_')
      words.emplace_back();
    else
      words.back() += c;
  }
  if (words[0] == "pleat") {
    skin.method = SkinMethod::pleat;
    PleatOptions& pleat = skin.pleat;
    pleat.rows = words[1] == "paper" ? RowPlacement::path : RowPlacement::even;
    pleat.quad_fans = words[1] != "paper";
    pleat.collars = words[1] == "exact" || words[1] == "fair200";
    pleat.fit = words[1] == "exact"     ? SectionFit::local
                : words[1] == "fair200" ? SectionFit::fair
                                        : SectionFit::none;
    if (words[1] == "caps") skin.caps = Caps::flat;
    return;
  }
  skin.method = SkinMethod::smooth;
  std::size_t at = 1;
  if (words[1] == "anchored") {
    // The two ridges of each section.
    skin.method = SkinMethod::anchored;
    skin.links.clear();
    skin.smooth.anchors = {{2.0 / 8, 3.0 / 6}, {6.0 / 8, 4.0 / 6}};
    skin.smooth.parameters = ColumnParameters::uniform;
    at = 2;
  }
  skin.smooth.columns = std::stoi(words[at]);
  skin.smooth.rows = std::stoi(words[at + 1]);
  if (words.size() < at + 4) return;
  const std::string& parameters = words[at + 2];
  skin.smooth.parameters = parameters == "uniform"  ? ColumnParameters::uniform
                           : parameters == "shared" ? ColumnParameters::shared
                                                    : ColumnParameters::per_section;
  skin.smooth.blend = words[at + 3] == "linear" ? Blend::linear : Blend::natural;
}

}  // namespace hariko::test
