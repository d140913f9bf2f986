#include "ui/view/command_scripts.hpp"

namespace hariko {

namespace {

std::vector<ArgumentSpec> arguments_to_transform(TransformKind kind) {
  std::vector<ArgumentSpec> out;
  if (kind == TransformKind::move)
    out.push_back(point_argument("by", "along the three axes", ArgumentUnit::length, {}));
  if (kind == TransformKind::rotate) {
    out.push_back(angle_argument("angle", "counter-clockwise, seen against the axis", {}));
    out.push_back(word_argument("axis", "about which it turns", {"x", "y", "z"}, "z"));
  }
  if (kind == TransformKind::scale) {
    constexpr double any = std::numeric_limits<double>::infinity();
    out.push_back(optional(number_argument("factor", "of all lengths; -1 mirrors", {}, -any, any)));
    out.push_back(
        optional(point_argument("factors", "along the three axes, instead of one", ArgumentUnit::none, {})));
  }
  if (kind != TransformKind::move)
    out.push_back(optional(
        point_argument("about", "the point that stays, instead of the pivot", ArgumentUnit::length, {})));
  out.push_back(on_off_argument("local", "along the axes of the active object", false));
  out.push_back(length_argument("soft_radius", "vertices as near as this follow in part", 0, 0));
  return out;
}

/// Target of the transformation; about a given point all parts have one pivot.
TransformTarget target_of_script(Editor& editor, bool one_pivot) {
  const PivotMode chosen = editor.transform.pivot;
  if (one_pivot) editor.transform.pivot = PivotMode::median;
  TransformTarget target = TransformTarget::of(editor);
  editor.transform.pivot = chosen;
  return target;
}

Transformation transformation_of(TransformKind kind, const Matrix3& frame, const Arguments& arguments) {
  Transformation out;
  if (kind == TransformKind::move) out.translation = frame * arguments.point("by");
  if (kind == TransformKind::rotate) {
    out.axis = frame.col(arguments.text("axis").front() - 'x');
    out.degrees = arguments.number("angle");
  }
  if (kind == TransformKind::scale) {
    out.frame = frame;
    out.factors = arguments.has("factors") ? arguments.point("factors")
                                           : Vector3(Vector3::Constant(arguments.number("factor")));
  }
  return out;
}

/// Sentence about arguments that do not go together; null where they do.
const char* contradiction(TransformKind kind, const TransformTarget& target, const Arguments& arguments) {
  if (kind == TransformKind::scale && arguments.has("factor") == arguments.has("factors"))
    return "One of \"factor\" and \"factors\" is needed.";
  if (!arguments.has("about")) return nullptr;
  if (arguments.number("soft_radius") > 0) return "\"about\" and \"soft_radius\" do not go together.";
  if (target.in_planes() && arguments.on("local"))
    return "Points of sections turn about the middle of their section along local axes: leave out \"about\".";
  return nullptr;
}

void transform_as_written(Editor& editor, TransformKind kind, const Arguments& arguments) {
  TransformTarget target = target_of_script(editor, arguments.has("about"));
  if (const char* wrong = contradiction(kind, target, arguments))
    return editor.notify(make_error(e_argument, wrong, "`hariko run --list` says what each command takes."));
  const bool local = arguments.on("local");
  Transformation transformation =
      transformation_of(kind, local ? target.local_frame() : Matrix3(Matrix3::Identity()), arguments);
  if (arguments.has("about")) {
    // The same turn about the pivot, and the way that it takes the pivot about the point.
    const Vector3 from_point = target.pivot() - arguments.point("about");
    transformation.translation = transformation.linear() * from_point - from_point;
  }
  if (arguments.number("soft_radius") > 0)
    target.follow(arguments.number("soft_radius"), editor.transform.soft.falloff);
  const char* verb = kind == TransformKind::move     ? "Move"
                     : kind == TransformKind::rotate ? "Rotate"
                                                     : "Scale";
  editor.commit(target.apply(editor.history.current(), transformation, local),
                std::string(verb) + " " + target.describe());
}

}  // namespace

ScriptUse transform_in_scripts(Editor& editor, TransformKind kind) {
  return {.arguments = arguments_to_transform(kind), .run = [&editor, kind](const Arguments& arguments) {
            transform_as_written(editor, kind, arguments);
          }};
}

}  // namespace hariko
