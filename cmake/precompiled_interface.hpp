// What nearly every file of the interface includes, ours too: reading these headers is two thirds of the work on such a
// file. A file includes what it needs all the same.
#include "cmake/precompiled.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/view/tool.hpp"
