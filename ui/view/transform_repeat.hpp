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

/// Lets the last step of the editor be repeated as this one.
void remember_transform(Editor& editor, const DoneTransform& done);

}  // namespace hariko
