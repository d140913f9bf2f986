#pragma once

// Edits of saved views.

#include <string>
#include <string_view>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_unknown_view{"E_UNKNOWN_VIEW"};
inline constexpr Code e_view_name_taken{"E_VIEW_NAME_TAKEN"};
inline constexpr Code e_too_many_views{"E_TOO_MANY_VIEWS"};

/// Saved view with this name; null where there is none. O(views).
const SavedView* find_view(const Document& document, std::string_view name);

/// Appends a view. Errors: those of `check_view`, E_VIEW_NAME_TAKEN, E_TOO_MANY_VIEWS.
Result<Document> add_view(const Document& document, const SavedView& view);

/// Replaces the view of the same name, which keeps its place. Errors: those of `check_view`, E_UNKNOWN_VIEW.
Result<Document> update_view(const Document& document, const SavedView& view);

/// Gives a view another name. Errors: E_UNKNOWN_VIEW, E_NAME_EMPTY, E_NAME_INVALID, E_VIEW_NAME_TAKEN.
Result<Document> rename_view(const Document& document, std::string_view name, std::string_view next);

/// Takes a view out of the document. Errors: E_UNKNOWN_VIEW.
Result<Document> remove_view(const Document& document, std::string_view name);

/// Appends views of another document; those whose name is taken get a number behind it. Errors:
/// E_TOO_MANY_VIEWS. O(views squared).
Result<Document> append_views(const Document& document, const SavedViews& views);

}  // namespace hariko
