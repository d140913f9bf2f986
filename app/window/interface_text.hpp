#pragma once

// InterfaceText: keeps the catalogue and the fonts at what the settings, the document and the keyboard ask
// for.

#include <filesystem>

#include "app/window/gl_window.hpp"
#include "ui/editor/editor.hpp"
#include "ui/widgets/offers.hpp"

namespace hariko {

class InterfaceText {
 public:
  /// `catalogues`: the folder with "ja.json".
  explicit InterfaceText(std::filesystem::path catalogues) : folder_(std::move(catalogues)) {}

  /// Before a frame. Loads the catalogue of the language that the settings name, and fonts for the characters
  /// of object names, of files that are offered and of what is typed. Where a language cannot be had it sets
  /// English again and says why.
  void update(Editor& editor, const Offers& offers, GlWindow& window);

 private:
  void choose(Editor& editor);
  void collect_names(const Editor& editor, const Offers& offers);

  std::filesystem::path folder_;
  LanguageId language_ = LanguageId::english;  ///< that `editor.language` holds
  std::set<char32_t> of_catalogue_, of_names_;
  std::uint64_t names_serial_ = ~std::uint64_t{0};
  std::size_t offered_ = 0;  ///< how many files were offered when names were collected
};

/// The name of a language's catalogue; empty for English, which needs none.
std::string catalogue_name(LanguageId language);

}  // namespace hariko
