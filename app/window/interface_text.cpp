#include "app/window/interface_text.hpp"

#include <utility>

#include "core/base/text/sanitized_utf8.hpp"
#include "ui/base/fonts.hpp"

namespace hariko {

InterfaceText::InterfaceText(const std::filesystem::path& catalogues, Editor& editor) {
  LanguageFiles found = find_languages(catalogues);
  editor.languages = std::move(found.files);
  problems_ = std::move(found.problems);
}

void InterfaceText::choose(Editor& editor) {
  std::string& wanted = editor.settings.language;
  if (wanted == language_) return;
  const LanguageFile* file = find_language(editor.languages, wanted);
  if (wanted == english_id) {
    editor.language = {};
  } else if (!file) {
    const std::string text =
        fill(editor.language(translatable("There is no catalogue of the language \"{0}\" of the settings.")),
             {shortened(wanted, 40)});
    wanted = language_;
    return editor.notify(Notice::Kind::warning, text);
  } else if (!fonts_can_write(file->name)) {
    wanted = language_;
    return editor.warn(no_japanese_font);
  } else if (auto loaded = Language::load(file->path); loaded.ok()) {
    editor.language = std::move(loaded).value();
  } else {
    wanted = language_;
    return editor.notify(loaded.error());
  }
  language_ = wanted;
  of_catalogue_.clear();
  for (const char32_t point : editor.language.characters()) of_catalogue_.insert(point);
}

void InterfaceText::collect_names(const Editor& editor, const Offers& offers) {
  const std::size_t offered = offers.recent.size() + offers.recoveries.size();
  if (editor.history.serial() == names_serial_ && offered == offered_) return;
  names_serial_ = editor.history.serial(), offered_ = offered;
  const auto add = [&](std::string_view text) {
    for (const char32_t point : code_points(text))
      if (needs_japanese_font(point)) of_names_.insert(point);
  };
  add(editor.title());
  for (const auto& object : editor.document().objects) add(object->name);
  for (const SavedView& view : *editor.document().saved_views) add(view.name);
  for (const RecentFile& file : offers.recent) add(file.path.string());
  for (const RecoveryOffer& offer : offers.recoveries) add(offer.path.string());
}

void InterfaceText::update(Editor& editor, const Offers& offers, GlWindow& window) {
  for (const Message& problem : std::exchange(problems_, {})) editor.notify(problem);
  choose(editor);
  collect_names(editor, offers);
  of_names_.insert(editor.shown_characters().begin(), editor.shown_characters().end());
  for (const char32_t point : window.take_typed())
    if (needs_japanese_font(point)) of_names_.insert(point);
  FontRequest request;
  // Users with Japanese names type more of them: all common characters are loaded at once instead of a new
  // atlas for each. The interface itself needs a fifth of them, so its start does not wait for the others.
  request.japanese = !of_names_.empty();
  request.characters = of_catalogue_;
  request.characters.insert(of_names_.begin(), of_names_.end());
  // Languages are offered by their names in their own scripts.
  for (const LanguageFile& each : editor.languages)
    for (const char32_t point : code_points(each.name)) request.characters.insert(point);
  window.set_fonts(std::move(request));
}

}  // namespace hariko
