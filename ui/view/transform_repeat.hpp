#pragma once

// Repeating of moves, rotations and scalings on what is selected then.

#include "ui/view/transform_target.hpp"

namespace hariko {

/// A step that a transform tool has made.
struct DoneTransform {
  std::string verb;                    ///< "Move": its label begins with it
  Matrix3 axes = Matrix3::Identity();  ///< the local axes then
  Transformation transformation;
  bool local = false;  ///< it was made along the local axes, and is repeated along those of what is selected
};

/// Steps of a script that transform what is selected like this, softly where the editor does; empty where
/// scripts have no words for it, such as a turn about the direction of the view.
std::vector<WrittenCommand> written_transform(const Editor& editor, const DoneTransform& done);

/// Lets the last step of the editor be repeated as this one, and written in a script.
void remember_transform(Editor& editor, const DoneTransform& done);

}  // namespace hariko
