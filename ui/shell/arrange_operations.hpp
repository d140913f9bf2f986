#pragma once

// Helpers of the commands that make copies of whole objects and let their numbers be changed right
// afterwards.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/modeling/objects/arrange.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/last_operation.hpp"

namespace hariko {

/// Menu of these commands.
std::string arrange_menu();

/// Makes an operation on these objects.
using MakeOfObjects = std::function<Result<MakeOperation>(const Editor&, std::vector<ObjectId>)>;
/// Says how a script does that with the objects that are chosen; empty: it cannot.
using WriteOfObjects = std::function<WriteOperation(const Editor&)>;

/// Begins an operation on the objects that are chosen then.
BeginOperation begin_on_chosen(const MakeOfObjects& make, const WriteOfObjects& write);

/// Makes a step of an operation on the objects that are chosen, and brings what it chooses into sight; or
/// says why not.
void run_on_chosen(Editor& editor, const char* label, std::vector<OperationNumber> numbers,
                   const MakeOfObjects& make, const WriteOfObjects& write);

/// Originals with their copies, all of them chosen: a row of a row makes a grid.
Result<OperationResult> all_chosen(const Result<AddedObjects>& added, const std::vector<ObjectId>& originals);

/// Originals with live copies, chosen as they were.
Result<OperationResult> chosen_with_live_copies(Result<Document> made,
                                                const std::vector<ObjectId>& originals);

/// Makes copies for a script, which names every number, and chooses them with their originals.
void make_copies(Editor& editor, const Result<AddedObjects>& added, std::vector<ObjectId> originals,
                 const char* step);
/// The same for live copies, which are chosen with their objects.
void make_live_copies(Editor& editor, const Result<Document>& made, const char* step);

/// Choice of copies that are objects, or live ones; usually objects. The last of the numbers of an array.
OperationNumber kind_of_copies();
bool wants_live_copies(std::span<const OperationNumber> numbers);
/// The same choice in scripts, on or off.
ArgumentSpec live_copies_argument();

OperationNumber count_of_places(int value);

/// Adds the command that places copies along a curve.
void add_curve_array_command(CommandHost& host);
/// Adds the commands that make objects of live copies and take them away.
void add_live_copy_commands(CommandHost& host);

}  // namespace hariko
