#pragma once

// Random documents with every field set, for round trips and for histories.

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/document/document.hpp"
#include "core/document/edits/edit_copies.hpp"
#include "core/document/edits/edit_groups.hpp"
#include "tests/document/random_sources.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {

/// A number of any size a position may have, now and then one that is hard to print.
inline double any_number(std::mt19937_64& rng) {
  static constexpr std::array special{
      0.0,      -0.0, 1.0, -1.0, 0.1, 1e22, 1e23, 5e-324, 1e300, 1e-300, 1.0 / 3, 1e16, 123456789012345678.0,
      0.1 + 0.2};
  if (chance(rng, 0.2)) return special[rng() % special.size()];
  return uniform(rng, -1, 1) * std::exp(uniform(rng, -30, 30));
}

inline Vector3 any_vector(std::mt19937_64& rng) {
  const double x = any_number(rng), y = any_number(rng);
  return {x, y, any_number(rng)};
}

inline std::string any_name(std::mt19937_64& rng) {
  static const std::array<std::string, 7> parts{"Cup", "張り子", "\"quoted\"", "back\\slash",
                                                "a/b", "Größe",  "🏺"};
  std::string name = parts[rng() % parts.size()];
  while (chance(rng, 0.5)) name += " " + parts[rng() % parts.size()];
  return name;
}

inline KeptMembers any_kept(std::mt19937_64& rng) {
  if (chance(rng, 0.6)) return {};
  KeptMembers kept{{"later", "{\"deep\": [1,2 ,  {}], \"n\": 1.50e+1}"}};
  if (chance(rng, 0.5)) kept.push_back({"\"odd\" name\n", "[ -0, 12345678901234567890, null, \"\\u00e4\"]"});
  if (chance(rng, 0.5)) kept.push_back({"number", "1.0"});
  return kept;
}

inline PolygonMesh any_mesh(std::mt19937_64& rng) {
  switch (uniform_int(rng, 0, 4)) {
    case 0:
      return prism(uniform_int(rng, 3, 20));
    case 1:
      return torus(uniform_int(rng, 3, 8), uniform_int(rng, 3, 8));
    case 2:
      return grid(uniform_int(rng, 1, 12), uniform_int(rng, 1, 12));
    case 3:
      return genus_box(uniform_int(rng, 0, 3));
    default:
      return pyramid(uniform_int(rng, 3, 30));
  }
}

inline Shaping any_shaping(std::mt19937_64& rng, const Polyhedron& polyhedron) {
  Shaping shaping;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    const VertexId id = polyhedron.vertex_id(v);
    if (chance(rng, 0.2)) shaping.alpha.set(id, uniform(rng, 0, 1000));
    if (chance(rng, 0.1)) shaping.tag.set(id, chance(rng, 0.5) ? VertexTag::corner : VertexTag::smooth);
    if (chance(rng, 0.1)) shaping.pin.set(id, {Pin::Kind::normal, {random_vector(rng) + Vector3(0, 0, 2)}});
    if (chance(rng, 0.05)) shaping.pin.set(id, {Pin::Kind::tangents, {any_vector(rng), any_vector(rng)}});
    if (chance(rng, 0.05)) {
      KeptForm form;
      for (Index to = 0; to < polyhedron.vertex_count(); ++to)
        if (chance(rng, 0.2))
          form.edges.push_back({polyhedron.vertex_id(to), uniform(rng, -1, 1), uniform(rng, -1, 1),
                                random_vector(rng), uniform(rng, -1, 1), uniform(rng, 0, 1)});
      shaping.form.set(id, std::move(form));
    }
  }
  for (Index e = 0; e < polyhedron.edge_count(); ++e) {
    if (chance(rng, 0.2)) shaping.beta.set(polyhedron.edge_id(e), log_uniform(rng, 0.001, 1000));
    if (chance(rng, 0.1)) shaping.crease.set(polyhedron.edge_id(e), true);
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (chance(rng, 0.1)) shaping.kept_area.set(polyhedron.face_id(f), log_uniform(rng, 1e-6, 1e6));
  return shaping;
}

inline std::optional<Mirror> any_mirror(std::mt19937_64& rng) {
  if (chance(rng, 0.7)) return std::nullopt;
  return Mirror{static_cast<Axis>(uniform_int(rng, 0, 2)), std::abs(any_number(rng))};
}

inline Attachments any_attachments(std::mt19937_64& rng, const Polyhedron& polyhedron) {
  Attachments out;
  for (Index e = 0; e < polyhedron.edge_count(); ++e) {
    if (!chance(rng, 0.05)) continue;
    Attachment attachment;
    attachment.continuity = chance(rng, 0.5) ? Continuity::g0 : Continuity::g1;
    attachment.adapts = chance(rng, 0.5) ? Adapts::surface : Adapts::patch;
    if (chance(rng, 0.3)) {
      attachment.frozen.emplace();
      for (auto* rows : {&attachment.frozen->curve, &attachment.frozen->row})
        for (Vector3& point : *rows) point = any_vector(rng);
    } else {
      attachment.patch = {static_cast<std::uint32_t>(uniform_int(rng, 0, 9))};
      attachment.side = {static_cast<std::uint8_t>(uniform_int(rng, 0, 3)), Index(uniform_int(rng, 0, 5))};
      attachment.reversed = chance(rng, 0.5);
    }
    out.set(polyhedron.edge_id(e), attachment);
  }
  return out;
}

inline PatchSource any_patches(std::mt19937_64& rng) {
  BicubicNet net{Index(uniform_int(rng, 1, 3)), Index(uniform_int(rng, 1, 3)), {}};
  for (Index i = 0; i < net.width() * net.height(); ++i) net.points.push_back(any_vector(rng));
  PatchSource source = PatchSource::from_net(any_vector(rng), net).value();
  source.kept = any_kept(rng);
  return source;
}

/// A polyhedron whose ids have gaps, at any origin.
inline PolyhedronSource any_polyhedron(std::mt19937_64& rng) {
  PolygonMesh mesh = any_mesh(rng);
  for (Vector3& position : mesh.positions)
    if (chance(rng, 0.5)) position = any_vector(rng);
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  std::uint32_t id = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    vertex_ids.push_back({id += static_cast<std::uint32_t>(uniform_int(rng, 1, 3))});
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    face_ids.push_back({id += static_cast<std::uint32_t>(uniform_int(rng, 1, 1000))});
  Polyhedron polyhedron = Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids)).value();
  Shaping shaping = any_shaping(rng, polyhedron);
  Attachments attachments = any_attachments(rng, polyhedron);
  return {any_vector(rng),
          std::move(polyhedron),
          std::move(shaping),
          static_cast<Mode>(uniform_int(rng, 0, 3)),
          any_kept(rng),
          any_mirror(rng),
          {chance(rng, 0.3), chance(rng, 0.3), chance(rng, 0.3) ? uniform(rng, 0, 1) : 0},
          std::move(attachments),
          chance(rng, 0.5) ? Frames::metric : Frames::equal};
}

inline Source any_source(std::mt19937_64& rng) {
  if (chance(rng, 0.6)) return any_polyhedron(rng);
  if (chance(rng, 0.2)) return SolidsSource{any_solids(rng), any_kept(rng)};
  if (chance(rng, 0.2)) return SkinSource{any_skin(rng), any_kept(rng)};
  if (chance(rng, 0.2)) return OutlineSource{any_outline(rng), any_outline_settings(rng), any_kept(rng)};
  if (chance(rng, 0.2)) {
    PictureSource picture = any_picture(rng);
    picture.kept = any_kept(rng);
    return picture;
  }
  if (chance(rng, 0.4)) return any_patches(rng);
  if (chance(rng, 0.4)) {
    BezierSource source = any_bezier(rng);
    source.kept = any_kept(rng);
    return source;
  }
  if (chance(rng, 0.6)) return MeshSource{any_vector(rng), any_mesh(rng), any_kept(rng)};
  return UnknownSource{"envelope",
                       std::string("{ \"solids\":[1.0, 2e0,\n\n {\"r\": 1}], \"kind\":  \"envelope\" }")};
}

inline void any_lines(std::mt19937_64& rng, DisplaySettings& display) {
  if (chance(rng, 0.3)) return;
  display.material = static_cast<Material>(uniform_int(rng, 0, material_count - 1));
  display.points = chance(rng, 0.5);
  display.wire = static_cast<PatchWire>(uniform_int(rng, 0, 2));
  display.tensions = chance(rng, 0.5);
  display.marks = chance(rng, 0.5);
  display.combs.shown = chance(rng, 0.5);
  display.combs.density = uniform_int(rng, CombSettings::min_density, CombSettings::max_density);
  display.combs.scale = log_uniform(rng, CombSettings::min_scale, CombSettings::max_scale);
  for (MapRange& range : display.ranges) {
    if (chance(rng, 0.5)) continue;
    range.mode = static_cast<RangeMode>(uniform_int(rng, 0, 3));
    const double a = any_number(rng), b = any_number(rng);
    if (a != b) std::tie(range.low, range.high) = std::minmax(a, b);
  }
}

/// An array or more.
inline LiveCopies any_copies(std::mt19937_64& rng) {
  LiveCopies out{RowOfCopies{uniform_int(rng, 2, 9), random_vector(rng, 9) + Vector3(20, 0, 0)}};
  if (chance(rng, 0.5))
    out.push_back(RingOfCopies{uniform_int(rng, 2, 9), random_vector(rng, 9),
                               random_vector(rng) + Vector3(0, 0, 2), uniform(rng, 1, 360)});
  if (chance(rng, 0.3)) {
    ListOfCopies list{std::vector<Similarity>(static_cast<std::size_t>(uniform_int(rng, 1, 3)))};
    for (Similarity& place : list.places) place.translation = random_vector(rng, 9);
    out.push_back(std::move(list));
  }
  if (chance(rng, 0.3))
    out.push_back(MirrorOfCopies{random_vector(rng, 9), random_vector(rng) + Vector3(0, 0, 2)});
  return out;
}

inline Object any_object(std::mt19937_64& rng, ObjectId id) {
  Similarity transform;
  transform.rotation =
      Eigen::Quaterniond(uniform(rng, 0.1, 1), uniform(rng, -1), uniform(rng, -1), uniform(rng, -1))
          .normalized();
  transform.scale = log_uniform(rng, 1e-6, 1e6);
  transform.translation = any_vector(rng);
  DisplaySettings display;
  display.surface = chance(rng, 0.5);
  display.polyhedron = chance(rng, 0.5);
  display.network = chance(rng, 0.5);
  display.map = static_cast<SurfaceMap>(uniform_int(rng, 0, surface_map_count - 1));
  display.density = uniform_int(rng, 1, 64);
  const auto byte = [&] { return static_cast<std::uint8_t>(uniform_int(rng, 0, 255)); };
  display.colour = {byte(), byte(), byte()};
  any_lines(rng, display);
  std::string name = any_name(rng);
  const bool visible = chance(rng, 0.5), locked = chance(rng, 0.3);
  Object object{id, std::move(name), visible, locked, transform, display, any_source(rng), any_kept(rng)};
  if (chance(rng, 0.3) && can_have_copies(object)) object.copies = any_copies(rng);
  return object;
}

/// A paper model; what it names need not exist.
inline PaperModel any_paper(std::mt19937_64& rng) {
  PaperModel paper;
  paper.objects = {ObjectId{1}, ObjectId{static_cast<std::uint32_t>(uniform_int(rng, 2, 9))}};
  paper.of_polyhedra = chance(rng, 0.3);
  paper.distance = log_uniform(rng, 1e-6, 1e6);
  if (chance(rng, 0.5)) paper.normal_angle = uniform(rng, 0, 1.5);
  paper.settings.scale = log_uniform(rng, 1e-6, 1e6);
  paper.settings.page = {uniform(rng, 50, 500), uniform(rng, 50, 500)};
  paper.settings.margin = uniform(rng, 0, 20);
  paper.settings.gap = uniform(rng, 0, 9);
  paper.settings.tab_height = uniform(rng, 0, 9);
  paper.settings.least_tab = uniform(rng, 0, 9);
  paper.settings.strip_width = uniform(rng, 0, 9);
  paper.settings.flat_fold = uniform(rng, 0, 1);
  paper.settings.inside = chance(rng, 0.5);
  paper.settings.fold_angles = chance(rng, 0.5);
  if (chance(rng, 0.5)) paper.settings.merge_angle = uniform(rng, 0, 1);
  paper.goal = static_cast<CutGoal>(uniform_int(rng, 0, 2));
  paper.steps = rng() % 1'000'000'000'000;
  paper.kept = any_kept(rng);
  if (chance(rng, 0.3)) return paper;
  for (std::uint32_t i = 0; i < 8; ++i) {
    PaperVertex vertex{ObjectId{1}, {}, i, 0, 0};
    if (i > 2) vertex.element = {static_cast<Element::Kind>(1 + rng() % 4), i};
    if (i > 2) vertex.u = any_number(rng), vertex.v = any_number(rng);
    if (vertex.element.kind == Element::Kind::edge) vertex.element.id |= std::uint64_t{7} << 32;
    paper.vertices.push_back(vertex);
  }
  std::sort(paper.vertices.begin(), paper.vertices.end());
  for (auto* list : {&paper.folds, &paper.cuts, &paper.own_folds, &paper.own_cuts, &paper.strips})
    for (std::uint32_t i = 0; i < 7; ++i)
      if (chance(rng, 0.5)) list->push_back({i, 7});
  paper.tabs = {{3, 1}, {5, 6}};
  for (std::uint32_t i = 0; i < 3; ++i)
    paper.places.push_back({{i, i + 1, i + 3}, {i, uniform(rng, -9, 9), uniform(rng, -9, 9), uniform(rng)}});
  paper.strip_places.push_back({{2, 5}, {4, uniform(rng), uniform(rng), uniform(rng)}});
  return paper;
}

/// The element that an anchor names need not exist.
inline Anchor any_anchor(std::mt19937_64& rng, bool on_surface) {
  const ObjectId object{static_cast<std::uint32_t>(uniform_int(rng, 1, 9))};
  const auto id = [&] { return static_cast<std::uint32_t>(uniform_int(rng, 0, 40)); };
  switch (on_surface ? uniform_int(rng, 4, 5) : uniform_int(rng, 0, 5)) {
    case 0:
      return SpaceAnchor{any_vector(rng)};
    case 1:
      return ObjectAnchor{object, any_vector(rng), chance(rng, 0.5) ? std::optional(id()) : std::nullopt};
    case 2:
      return VertexAnchor{object, VertexId{id()}, chance(rng, 0.3)};
    case 3: {
      const std::uint32_t low = id();
      return EdgeAnchor{object, EdgeId::of({low}, {low + 1 + id()}), uniform(rng, 0, 1), chance(rng, 0.5)};
    }
    case 4: {
      const Element element = chance(rng, 0.7) ? element_of(FaceId{id()}) : element_of(EdgeId::of({3}, {8}));
      return PatchAnchor{object, element, id() + (chance(rng, 0.3) ? 65536U : 0U),
                         Vector2(uniform(rng, 0, 1), uniform(rng, 0, 1))};
    }
    default:
      return NearestAnchor{object, any_vector(rng)};
  }
}

inline Dimensions any_dimensions(std::mt19937_64& rng) {
  Dimensions out;
  for (std::uint32_t id = 0; chance(rng, 0.7) && id < 30;) {
    id += static_cast<std::uint32_t>(uniform_int(rng, 1, 3));
    Dimension dimension;
    dimension.id = {id};
    dimension.kind = static_cast<DimensionKind>(uniform_int(rng, 0, 2));
    for (std::size_t i = 0; i < anchor_count(dimension.kind); ++i)
      dimension.anchors.push_back(any_anchor(rng, dimension.kind == DimensionKind::radius));
    if (chance(rng, 0.5)) dimension.label = any_vector(rng);
    out.push_back(std::move(dimension));
  }
  return out;
}

inline SavedViews any_views(std::mt19937_64& rng) {
  SavedViews out(static_cast<std::size_t>(uniform_int(rng, 1, 4)));
  for (std::size_t i = 0; i < out.size(); ++i) {
    SavedView& view = out[i];
    view.name = "View " + std::to_string(i);
    view.target = any_vector(rng);
    view.orientation =
        Eigen::Quaterniond(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1), 1.1).normalized();
    view.distance = log_uniform(rng, 1e-6, 1e6);
    view.projection = static_cast<Projection>(uniform_int(rng, 0, 2));
    view.focal_length = uniform(rng, SavedView::least_focal_length, SavedView::greatest_focal_length);
  }
  return out;
}

inline MakingSettings any_making(std::mt19937_64& rng) {
  MakingSettings out;
  out.pull = Vector3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, 0.1, 1));
  out.draft = uniform(rng, 0, MakingSettings::max_draft);
  out.radius = log_uniform(rng, 1e-6, 1e6);
  out.thickness = log_uniform(rng, 1e-6, 1e6);
  if (chance(rng, 0.5)) out.reference.value = static_cast<std::uint32_t>(uniform_int(rng, 0, 9));
  return out;
}

/// Groups of some of the objects, with every field set; what is locked or too deep stays as it is.
inline Document with_any_groups(std::mt19937_64& rng, Document document) {
  for (int i = uniform_int(rng, 1, 4); i > 0; --i) {
    std::vector<ObjectId> objects;
    for (const auto& object : document.objects)
      if (chance(rng, 0.5)) objects.push_back(object->id);
    const auto made = make_group(document, objects, any_name(rng));
    if (!made) continue;
    document = set_group_visible(made->document, made->id, chance(rng, 0.5)).value();
    document = set_group_locked(document, made->id, chance(rng, 0.2)).value();
    if (chance(rng, 0.5)) document = set_group_colour(document, made->id, Colour{1, 20, 255}).value();
  }
  return document;
}

inline Document any_document(std::mt19937_64& rng) {
  Document document;
  document.unit = static_cast<Unit>(uniform_int(rng, 0, 3));
  const int count = uniform_int(rng, 0, 5);
  for (int i = 0; i < count; ++i) {
    document.objects.push_back(std::make_shared<const Object>(any_object(rng, document.next_object_id)));
    document.next_object_id.value += static_cast<std::uint32_t>(uniform_int(rng, 1, 3));
  }
  if (chance(rng, 0.3)) std::reverse(document.objects.begin(), document.objects.end());
  document.kept = any_kept(rng);
  if (chance(rng, 0.5)) document.dimensions = any_dimensions(rng);
  if (chance(rng, 0.3)) document.saved_views = any_views(rng);
  if (chance(rng, 0.3)) document.making = any_making(rng);
  if (chance(rng, 0.5)) document.paper = std::make_shared<const PaperModel>(any_paper(rng));
  if (chance(rng, 0.4)) return with_any_groups(rng, std::move(document));
  return document;
}

/// One cube named "Cube", id 1.
inline Document cube_document() {
  return document_from_mesh(cube(), "Cube").value();
}

inline constexpr ObjectId cube_id{1};

inline const PolyhedronSource& polyhedron_of(const Document& document, ObjectId id = cube_id) {
  return *document.find(id)->polyhedron();
}

}  // namespace hariko::test
