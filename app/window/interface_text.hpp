#pragma once

// InterfaceText: loads the catalogue and the fonts that the settings, the document and the keyboard need.

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/window/gl_window.hpp"
#include "ui/editor/editor.hpp"
#include "ui/widgets/offers.hpp"

namespace hariko {

/// Catalogue and fonts of the interface.
class InterfaceText {
 public:
  /// Finds the languages that the editor offers, in the folder of catalogues.
  InterfaceText(const std::filesystem::path& catalogues, Editor& editor);

  /// Loads the catalogue of the language in the settings, and fonts for the characters of object names,
  /// offered files and typed text. Where a language cannot be loaded it sets the last one again and says why;
  /// the first time also of catalogues that cannot be offered. To be called before a frame.
  void update(Editor& editor, const Offers& offers, GlWindow& window);

 private:
  void choose(Editor& editor);
  void collect_names(const Editor& editor, const Offers& offers);

  std::vector<Message> problems_;      ///< faults of catalogues, not told yet
  std::string language_ = english_id;  ///< id of the language that `editor.language` holds
  std::set<char32_t> of_catalogue_, of_names_;
  std::uint64_t names_serial_ = ~std::uint64_t{0};
  std::size_t offered_ = 0;  ///< number of offered files when names were collected
};

}  // namespace hariko
