#include "app/commands/command_line/construction_command_line.hpp"

#include <CLI/CLI.hpp>
#include <limits>

#include "app/commands/command_line/checks.hpp"
#include "app/commands/console.hpp"
#include "core/document/words.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

constexpr Code w_option_ignored{"W_OPTION_IGNORED"};

}  // namespace

void ConstructionCommandLine::add_to(CLI::App& command) {
  command.add_option("--mode", mode_, "Construction of the surfaces, instead of the document's")
      ->check(CLI::IsMember(enum_word_list<Mode>()));
  command
      .add_option("--frames", frames_,
                  "Whether angles and lengths of polyhedra and outlines count in modes target, fair and g2")
      ->check(CLI::IsMember(enum_word_list<Frames>()));
  command
      .add_option("--merge-coplanar", merge_coplanar_,
                  "Whether triangles of polyhedra that lie in one plane are merged on the way to the surface")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--round", round_, "Does nothing: mode g2 is round by itself");
  outlines_.add_to(command);
  solids_.add_to(command);
  reading_.add_to(command);
}

Construction ConstructionCommandLine::construction() const {
  Construction out;
  out.mode = enum_value<Mode>(mode_);
  if (round_)
    report("", make_warning(w_option_ignored, "--round has no meaning any more: mode g2 is round by itself.",
                            "Leave the option out."));
  out.frames = enum_value<Frames>(frames_);
  if (!merge_coplanar_.empty()) out.merge_coplanar = merge_coplanar_ == "on";
  out.outlines = outlines_.construction();
  out.solids = solids_.construction();
  out.reading = reading_.reading();
  return out;
}

namespace {

/// Check that a word names a mode; that of a mode of older command lines is not listed.
CLI::Validator outline_mode_word() {
  const CLI::Validator listed = CLI::IsMember(enum_word_list<GaussMode>());
  const auto wrong = [listed](const std::string& word) {
    return word == replaced_outline_mode ? std::string() : listed(word);
  };
  return CLI::Validator(wrong, listed.get_description());
}

}  // namespace

void OutlineCommandLine::add_to(CLI::App& command) {
  const std::string group = "Outlines, instead of what the document says";
  command.add_option("--method", method_, "How the points inside are found")
      ->check(outline_mode_word())
      ->group(group);
  command.add_option("--sign", sign_, "Of the curvature where it is not given: positive bends to one side")
      ->check(CLI::IsMember(enum_word_list<CurvatureSign>()))
      ->group(group);
  command.add_option("--spacing", spacing_, "Of the points inside, in steps of the outline, 0.01 to 100")
      ->check(CLI::Range(OutlineSettings::smallest_radius, OutlineSettings::largest_radius))
      ->group(group);
  command.add_option("--count", count_, "At most so many points inside, 0 to 20000")
      ->check(CLI::Range(0U, unsigned{OutlineSettings::point_limit}))
      ->group(group);
  command
      .add_option("--gap", gap_,
                  "Largest distance between control points and tangent planes, in the document's unit")
      ->check(positive_number())
      ->group(group);
}

OutlineConstruction OutlineCommandLine::construction() const {
  OutlineConstruction out;
  out.method_replaced = method_ == replaced_outline_mode;
  out.method = out.method_replaced ? GaussMode::umbilic : enum_value<GaussMode>(method_);
  out.sign = enum_value<CurvatureSign>(sign_);
  out.radius = spacing_;
  if (count_) out.most_points = Index(*count_);
  out.gap = gap_;
  return out;
}

void SolidsCommandLine::add_to(CLI::App& command) {
  const std::string group = "Surfaces round solids, instead of what the document says";
  command.add_option("--surround", method_, "Method: ball, or network of curves")
      ->check(CLI::IsMember(enum_word_list<EnvelopeMethod>()))
      ->group(group);
  command
      .add_option("--ball-radius", ball_radius_,
                  "Of the ball that rolls over the solids, in the document's unit, or hull")
      ->check(CLI::IsMember({"hull"}) | positive_number())
      ->group(group);
  command.add_option("--rounding", rounding_, "Length; edges get a radius of 1.5 times this")
      ->check(positive_number())
      ->group(group);
  command
      .add_option("--on-faces", on_faces_,
                  "Flat faces lie on those of the solids, whose edges then stick out")
      ->check(CLI::IsMember({"on", "off"}))
      ->group(group);
  command.add_option("--finer-patches", finer_, "About twice as many patches, nearer to the shape")
      ->check(CLI::IsMember({"on", "off"}))
      ->group(group);
  command.add_option("--bridge-radius", bridge_radius_, "Of the ball between solids that a bridge joins")
      ->check(positive_number())
      ->group(group);
}

SolidsConstruction SolidsCommandLine::construction() const {
  SolidsConstruction out;
  out.method = enum_value<EnvelopeMethod>(method_);
  double radius = 0;
  if (ball_radius_ == "hull")
    out.ball_radius = std::numeric_limits<double>::infinity();
  else if (parse_real(ball_radius_, radius) == NumberStatus::ok)
    out.ball_radius = radius;
  out.rounding = rounding_;
  if (!on_faces_.empty()) out.on_faces = on_faces_ == "on";
  if (!finer_.empty()) out.finer_patches = finer_ == "on";
  out.bridge_radius = bridge_radius_;
  return out;
}

namespace {

constexpr const char* usual = "usual";

std::string wrong_tolerance(const std::string& text) {
  double value = 0;
  const bool good = text == usual || (parse_real(text, value) == NumberStatus::ok && value >= 0);
  return good ? std::string() : "should be a length that is not negative, but is " + text;
}

}  // namespace

void ReadingCommandLine::add_to(CLI::App& command) {
  const std::string group = "Meshes of other programs";
  command
      .add_option("--weld", weld_,
                  "Joins corners that are nearly at the same place: up to a distance in the file's numbers, "
                  "1e-6 of each mesh's size where none is given, but at most a tenth of its median edge "
                  "(equal ones are joined always)")
      ->type_name("[TOLERANCE]")
      ->expected(0, 1)
      ->default_str(usual)
      ->check(CLI::Validator(wrong_tolerance, "", "tolerance"))
      ->group(group);
  command.add_flag("--repair", repair_, "Changes meshes that make no polyhedron until they do")->group(group);
  command.add_flag("--reference", reference_, "Keeps meshes that make no polyhedron as facets")->group(group);
}

Reading ReadingCommandLine::reading() const {
  Reading out;
  out.repair = repair_;
  out.reference = reference_;
  out.join.near = weld_ != none;
  double distance = 0;
  if (out.join.near && weld_ != usual && parse_real(weld_, distance) == NumberStatus::ok)
    out.join.distance = distance;
  return out;
}

}  // namespace hariko
