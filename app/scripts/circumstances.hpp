#pragma once

// Circumstances: what the result of a command depends on beside its arguments and the document, and the steps
// of a script that bring it about.

#include <vector>

#include "ui/editor/editor.hpp"

namespace hariko {

struct Circumstances {
  Selection selection;
  ElementMode mode = ElementMode::object;
  PivotMode pivot = PivotMode::median;
  Falloff falloff = Falloff::smooth;
  bool local_edit = false, refine_on_surface = true;
};

Circumstances circumstances_of(const Editor& editor);
void set_circumstances(Editor& editor, const Circumstances& circumstances);

/// Steps that choose what is selected in `to`, in its mode; none where `from` has the same. Objects are
/// named, so that of two with one name both are chosen.
std::vector<WrittenCommand> steps_to_select(const Document& document, const Circumstances& from,
                                            const Circumstances& to);
/// Steps that set all else as in `to`; none where `from` has the same.
std::vector<WrittenCommand> steps_to_set(const Circumstances& from, const Circumstances& to);

/// Texts that name elements in scripts.
std::string script_name(VertexId id);
std::string script_name(EdgeId id);
std::string script_name(FaceId id);

}  // namespace hariko
