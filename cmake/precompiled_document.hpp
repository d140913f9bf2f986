// Headers that most files about documents include: reading them is a third of the work on such a file. A file
// includes what it needs all the same.
#include <condition_variable>
#include <stop_token>
#include <thread>
#include "cmake/precompiled_core.hpp"
#include "core/document/document.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/exchange/imported_scene.hpp"
