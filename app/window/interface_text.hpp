#pragma once

// InterfaceText: loads the catalogue and the fonts that the settings, the document and the keyboard need.

#include <filesystem>

#include "app/window/gl_window.hpp"
#include "ui/editor/editor.hpp"
#include "ui/widgets/offers.hpp"

namespace hariko {

/// Catalogue and fonts of the interface.
class InterfaceText {
 public:
  /// `catalogues`: folder with "ja.json".
  explicit InterfaceText(std::filesystem::path catalogues) : folder_(std::move(catalogues)) {}

  /// Loads the catalogue of the language in the settings, and fonts for the characters of object names,
  /// offered files and typed text. Where a language cannot be loaded it sets English again and says why. To
  /// be called before a frame.
  void update(Editor& editor, const Offers& offers, GlWindow& window);

 private:
  void choose(Editor& editor);
  void collect_names(const Editor& editor, const Offers& offers);

  std::filesystem::path folder_;
  LanguageId language_ = LanguageId::english;  ///< language that `editor.language` holds
  std::set<char32_t> of_catalogue_, of_names_;
  std::uint64_t names_serial_ = ~std::uint64_t{0};
  std::size_t offered_ = 0;  ///< number of offered files when names were collected
};

/// Name of a language's catalogue; empty for English, which needs none.
std::string catalogue_name(LanguageId language);

}  // namespace hariko
