#pragma once

// Edits: pure functions from a document to the next one. This header includes all of them.
//
// Parts that an edit does not name stay as they are. An edit without effect returns an equal document, which
// the history does not turn into a step. On an error nothing has changed. The cost is that of the changed
// part; everything else is shared with the given document.

#include "core/document/edits/edit_attachments.hpp"
#include "core/document/edits/edit_copies.hpp"
#include "core/document/edits/edit_dimensions.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_groups.hpp"
#include "core/document/edits/edit_making.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/edits/edit_paper.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/edits/edit_views.hpp"
