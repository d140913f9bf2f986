#pragma once

// Edits: pure functions from a document to the next one. All of them are here.
//
// What an edit does not name stays as it is. An edit that changes nothing gives an equal document, which the
// history does not turn into a step. On an error nothing happened. The cost is that of the part that changes,
// everything else is shared with the given document.

#include "core/document/edit_attachments.hpp"
#include "core/document/edit_elements.hpp"
#include "core/document/edit_objects.hpp"
#include "core/document/edit_paper.hpp"
#include "core/document/edit_pictures.hpp"
