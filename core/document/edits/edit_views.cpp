#include "core/document/edits/edit_views.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hariko {

namespace {

Message unknown_view(std::string_view name) {
  return make_error(e_unknown_view, "There is no saved view called \"" + std::string(name) + "\".",
                    "Choose one of the saved views.");
}

Message view_name_taken(std::string_view name) {
  return make_error(e_view_name_taken, "Another saved view is called \"" + std::string(name) + "\".",
                    "Choose another name.");
}

Message too_many_views() {
  return make_error(e_too_many_views, "The document has no room for more saved views.",
                    "Delete saved views first.");
}

Document with_views(const Document& document, SavedViews views) {
  Document result = document;
  result.saved_views = std::move(views);
  return result;
}

/// Place of a view in the list; only for views that are there.
std::size_t place_of_view(const Document& document, const SavedView& view) {
  return static_cast<std::size_t>(&view - document.saved_views->data());
}

bool has_view_name(const SavedViews& views, std::string_view name) {
  return std::any_of(views.begin(), views.end(), [name](const SavedView& view) { return view.name == name; });
}

/// Name with the first number behind it that makes it unique; long names are cut, at the border of a
/// character.
std::string free_view_name(const SavedViews& views, const std::string& name) {
  constexpr std::size_t room = 8;  // for a blank and the number
  if (!has_view_name(views, name)) return name;
  std::string base = name.substr(0, Object::max_name_length - room);
  const auto inside = [&] { return (static_cast<unsigned char>(name[base.size()]) & 0xc0U) == 0x80U; };
  while (base.size() < name.size() && !base.empty() && inside()) base.pop_back();
  for (std::size_t number = 2;; ++number) {
    const std::string next = base + ' ' + std::to_string(number);
    if (!has_view_name(views, next)) return next;
  }
}

}  // namespace

const SavedView* find_view(const Document& document, std::string_view name) {
  const SavedViews& all = *document.saved_views;
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const SavedView& view) { return view.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Result<Document> add_view(const Document& document, const SavedView& view) {
  if (const auto checked = check_view(view); !checked) return checked.error();
  if (find_view(document, view.name)) return view_name_taken(view.name);
  if (document.saved_views->size() >= Document::max_views) return too_many_views();
  SavedViews longer = *document.saved_views;
  longer.push_back(view);
  return with_views(document, std::move(longer));
}

Result<Document> update_view(const Document& document, const SavedView& view) {
  if (const auto checked = check_view(view); !checked) return checked.error();
  const SavedView* found = find_view(document, view.name);
  if (!found) return unknown_view(view.name);
  if (*found == view) return document;
  SavedViews changed = *document.saved_views;
  changed[place_of_view(document, *found)] = view;
  return with_views(document, std::move(changed));
}

Result<Document> rename_view(const Document& document, std::string_view name, std::string_view next) {
  const SavedView* found = find_view(document, name);
  if (!found) return unknown_view(name);
  if (const auto checked = check_name(next); !checked) return checked.error();
  if (name == next) return document;
  if (find_view(document, next)) return view_name_taken(next);
  SavedViews changed = *document.saved_views;
  changed[place_of_view(document, *found)].name = next;
  return with_views(document, std::move(changed));
}

Result<Document> remove_view(const Document& document, std::string_view name) {
  const SavedView* found = find_view(document, name);
  if (!found) return unknown_view(name);
  SavedViews left = *document.saved_views;
  left.erase(left.begin() + static_cast<std::ptrdiff_t>(place_of_view(document, *found)));
  return with_views(document, std::move(left));
}

Result<Document> append_views(const Document& document, const SavedViews& views) {
  if (views.empty()) return document;
  SavedViews all = *document.saved_views;
  if (all.size() + views.size() > Document::max_views) return too_many_views();
  for (SavedView view : views) {
    view.name = free_view_name(all, view.name);
    all.push_back(std::move(view));
  }
  return with_views(document, std::move(all));
}

}  // namespace hariko
