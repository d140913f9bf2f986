#include "app/pictures/samples.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace hariko {

namespace fs = std::filesystem;

namespace {

struct Description {
  const char* stem;
  Beginning beginning;
  const char* title;
  const char* text;
};

/// Known samples, in display order.
constexpr Description descriptions[] = {
    {"car", Beginning::polyhedron, "Car body", "A body from a coarse cage"},
    {"fig2", Beginning::polyhedron, "Vase", "Three hexagon rings, closed"},
    {"cube", Beginning::polyhedron, "Cube", "Six quads become a rounded solid"},
    {"cube_crease", Beginning::polyhedron, "Creased cube", "Sharp edges among smooth ones"},
    {"fig2_open", Beginning::polyhedron, "Open vase", "The same without its top: a border"},
    {"fig5c", Beginning::polyhedron, "Vase with a flat lid", "Edge tension 10 flattens"},
    {"fig5d", Beginning::polyhedron, "Vase with a pointed rim", "Vertex tension 10 makes points"},
    {"torus", Beginning::polyhedron, "Torus", "Eight by four quads"},
    {"genus3", Beginning::polyhedron, "Three holes", "A closed shape of genus 3"},
    {"grid3", Beginning::polyhedron, "Open grid", "A free-form patch with borders"},
    {"wheel_arch", Beginning::polyhedron, "Wheel arch", "A hole between bicubic patches, closed smoothly"},
    {"concave", Beginning::polyhedron, "Concave faces", "What folds, and the warning for it"},
    {"concave_split", Beginning::polyhedron, "Concave, split", "The same with its concave faces decomposed"},
    {"knot", Beginning::polyhedron, "Knot", "A thousand faces, to see how fast everything follows"},

    {"solids_dryer", Beginning::solids, "Hair dryer", "Two solids, body and handle"},
    {"solids_bottle", Beginning::solids, "Bottle", "A body, a neck and a round mouth"},
    {"solids_camera", Beginning::solids, "Camera", "A box, a lens and a grip"},
    {"solids_car", Beginning::solids, "Car of two boxes", "A cabin on a body"},
    {"solids_one", Beginning::solids, "Box", "The surface round a single solid"},
    {"solids_l", Beginning::solids, "Two boxes, an L", "A surface that stays close to its solids"},
    {"solids_t", Beginning::solids, "Two boxes, a T", "A branch in the middle"},
    {"solids_u", Beginning::solids, "Three boxes, a U", "Two arms on a base"},
    {"solids_apart", Beginning::solids, "Two boxes apart", "A bridge between solids that do not touch"},
    {"solids_touching", Beginning::solids, "Two boxes that touch", "One face against the other"},
    {"solids_four", Beginning::solids, "Four solids", "One surface round solids of several kinds"},
    {"solids_ten", Beginning::solids, "Ten solids", "One surface round many"},

    {"skin_car_smooth", Beginning::sections, "Car, smooth skin",
     "Seven sections along a path, on a regular grid"},
    {"skin_car", Beginning::sections, "Car, pleated skin", "The same sections with their edges joined"},
    {"skin_smooth", Beginning::sections, "Smooth skin",
     "Two sections with few columns, placed where they matter"},
    {"skin_ridges", Beginning::sections, "Ridges by themselves", "Points matched by their places alone"},
    {"skin_joined", Beginning::sections, "Joined ridges", "Two lines say which ridge goes where"},
    {"skin_grouped", Beginning::sections, "Grouped ridges", "Curves round points that belong together"},
    {"skin_between", Beginning::sections, "Joined on a grid",
     "Features aligned without extraordinary vertices"},
    {"skin_merge_inside", Beginning::sections, "Merging ridges", "Two ridges become one on the way"},
    {"skin_merge_end", Beginning::sections, "Ridges that end in one",
     "Two ridges become one at the last section"},

    {"shell", Beginning::outline, "Shell", "A flat rim with tilted normals becomes a housing"},
    {"saddle", Beginning::outline, "Saddle", "A saddle over a round outline"},
    {"sphere_band", Beginning::outline, "Spherical band", "Two outlines, one surface between them"},
    {"sphere_holes", Beginning::outline, "Sphere with three holes", "Three outlines bound one surface"},
    {"sphere_cap", Beginning::outline, "Sphere cap",
     "An outline with normals and curvature: an exact sphere"},
    {"ellipsoid_cap", Beginning::outline, "Ellipsoid cap", "An outline with normals and curvature, filled"},
    {"paraboloid", Beginning::outline, "Paraboloid", "An outline that is not flat"},
    {"catenoid", Beginning::outline, "Catenoid", "A saddle everywhere, between two rings"},
};

/// Position of a sample among the descriptions; their number where it has none.
std::size_t place_of(const fs::path& path) {
  const auto found = std::find_if(std::begin(descriptions), std::end(descriptions),
                                  [stem = path.stem().string()](const auto& d) { return stem == d.stem; });
  return static_cast<std::size_t>(found - std::begin(descriptions));
}

Sample describe(const fs::path& path) {
  Sample sample;
  sample.path = path;
  if (const std::size_t place = place_of(path); place < std::size(descriptions)) {
    const Description& known = descriptions[place];
    sample.beginning = known.beginning;
    sample.title = known.title, sample.description = known.text;
    return sample;
  }
  std::string title = path.stem().string();
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  sample.title = std::move(title), sample.description = path.filename().string();
  return sample;
}

}  // namespace

std::vector<Sample> find_samples(const fs::path& assets) {
  std::vector<Sample> samples;
  std::error_code error;
  std::set<fs::path> paths;
  for (fs::directory_iterator it(assets / "samples", error), end; !error && it != end; it.increment(error))
    if (const auto extension = it->path().extension(); extension == ".hariko" || extension == ".obj")
      paths.insert(it->path());
  for (const fs::path& path : paths) {
    // A document made from a mesh of the same name represents both.
    if (path.extension() == ".obj" && paths.contains(fs::path(path).replace_extension(".hariko"))) continue;
    samples.push_back(describe(path));
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return place_of(a.path) < place_of(b.path); });
  return samples;
}

}  // namespace hariko
