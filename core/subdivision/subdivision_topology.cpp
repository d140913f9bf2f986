#include "core/subdivision/subdivision_topology.hpp"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/edge_key.hpp"

namespace hariko {

namespace osd = OpenSubdiv;

namespace {

constexpr std::size_t table_byte_limit = std::size_t(256) << 20;
constexpr std::size_t lanes = 4;

using OsdSurface = osd::Bfr::Surface<double>;

std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const ControlMesh& mesh) {
  using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
  std::vector<int> sizes, vertices(mesh.mesh.face_vertices.begin(), mesh.mesh.face_vertices.end());
  for (std::size_t f = 0; f < mesh.mesh.face_count(); ++f) sizes.push_back(int(mesh.mesh.face(f).size()));
  std::vector<int> crease_pairs, corners;
  std::vector<float> crease_weights, corner_weights;
  for (const auto& crease : mesh.creases) {
    crease_pairs.insert(crease_pairs.end(), {int(crease.a), int(crease.b)});
    crease_weights.push_back(float(crease.sharpness));
  }
  for (const auto& corner : mesh.corners) {
    corners.push_back(int(corner.vertex));
    corner_weights.push_back(float(corner.sharpness));
  }
  osd::Far::TopologyDescriptor descriptor;
  descriptor.numVertices = int(mesh.mesh.positions.size());
  descriptor.numFaces = int(sizes.size());
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = vertices.data();
  descriptor.numCreases = int(mesh.creases.size());
  descriptor.creaseVertexIndexPairs = crease_pairs.data();
  descriptor.creaseWeights = crease_weights.data();
  descriptor.numCorners = int(mesh.corners.size());
  descriptor.cornerVertexIndices = corners.data();
  descriptor.cornerWeights = corner_weights.data();
  // The default of the library, no interpolation, leaves boundary faces without a surface.
  osd::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(osd::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  Factory::Options factory(osd::Sdc::SCHEME_CATMARK, options);
  factory.validateFullTopology = true;
  return std::unique_ptr<osd::Far::TopologyRefiner>(Factory::Create(descriptor, factory));
}

}  // namespace

struct SubdivisionTopology::Evaluator {
  std::unique_ptr<osd::Far::TopologyRefiner> refiner;
  std::unique_ptr<osd::Bfr::RefinerSurfaceFactory<>> factory;
  std::vector<OsdSurface> surfaces;          ///< one per face
  std::vector<std::vector<Index>> controls;  ///< one list per face
};

Result<std::shared_ptr<const SubdivisionTopology>> SubdivisionTopology::make(const ControlMesh& mesh) {
  if (auto checked = check(mesh); !checked) return checked.error();
  std::shared_ptr<SubdivisionTopology> made(new SubdivisionTopology(mesh));
  const auto refused = make_error(e_control_mesh, "The control mesh is not a surface: OpenSubdiv refuses it.",
                                  "Change the sections or their correspondences.");
  Evaluator& evaluator = *made->evaluator_;
  evaluator.refiner = make_refiner(mesh);
  if (!evaluator.refiner) return refused;
  osd::Bfr::SurfaceFactory::Options options;
  options.SetApproxLevelSmooth(isolation).SetApproxLevelSharp(isolation);
  evaluator.factory = std::make_unique<osd::Bfr::RefinerSurfaceFactory<>>(*evaluator.refiner, options);
  const std::size_t faces = mesh.mesh.face_count();
  evaluator.surfaces.resize(faces);
  evaluator.controls.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    OsdSurface& surface = evaluator.surfaces[f];
    if (!evaluator.factory->InitVertexSurface(int(f), &surface)) return refused;
    std::vector<int> indices(std::size_t(surface.GetNumControlPoints()));
    surface.GetControlPointIndices(indices.data());
    evaluator.controls[f].assign(indices.begin(), indices.end());
  }
  made->add_patches();
  made->number_nodes();
  made->join_sides();
  made->classify_vertices();
  made->find_shapes();
  return std::shared_ptr<const SubdivisionTopology>(std::move(made));
}

SubdivisionTopology::SubdivisionTopology(ControlMesh mesh)
    : mesh_(std::move(mesh)), cut_(!mesh_.all_quads()), evaluator_(std::make_unique<Evaluator>()) {}

SubdivisionTopology::~SubdivisionTopology() = default;

void SubdivisionTopology::add_patches() {
  std::vector<Provenance> provenance;
  const PolygonMesh& mesh = mesh_.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    first_patch_.push_back(Index(patches_.size()));
    const int corners = cut_ ? int(face.size()) : 1;
    for (int c = 0; c < corners; ++c) {
      patches_.push_back({f, c});
      provenance.push_back({element_of(FaceId{f}), std::uint32_t(c)});
    }
    for (std::size_t i = 0; i < face.size(); ++i)
      half_edges_[{face[i], face[(i + 1) % face.size()]}] = {f, int(i)};
  }
  provenance_ = std::make_shared<const std::vector<Provenance>>(std::move(provenance));
}

std::span<const Index> SubdivisionTopology::controls(Index patch) const {
  return evaluator_->controls[patches_[patch].face];
}

Vector2 SubdivisionTopology::face_parameter(const Patch& patch, const Vector2& p) const {
  if (!cut_) return p;
  const OsdSurface& surface = evaluator_->surfaces[patch.face];
  const osd::Bfr::Parameterization parameterization = surface.GetParameterization();
  double uv[2];
  if (parameterization.HasSubFaces()) {
    const double st[2] = {p.x(), p.y()};
    parameterization.ConvertNormalizedSubFaceToCoord(patch.corner, st, uv);
    return {uv[0], uv[1]};
  }
  const Vector2 at = corner_parameter(Domain::square, patch.corner);
  const Vector2 next = corner_parameter(Domain::square, (patch.corner + 1) % 4);
  const Vector2 before = corner_parameter(Domain::square, (patch.corner + 3) % 4);
  return at + 0.5 * p.x() * (next - at) + 0.5 * p.y() * (before - at);
}

SubdivisionTopology::Weights SubdivisionTopology::weights(Index index, const Vector2& parameter,
                                                          Order order) const {
  const Patch& patch = patches_[index];
  const OsdSurface& surface = evaluator_->surfaces[patch.face];
  const std::size_t n = evaluator_->controls[patch.face].size();
  const Vector2 at = face_parameter(patch, parameter);
  const double uv[2] = {at.x(), at.y()};
  Weights w;
  for (auto* row : {&w.value, &w.ds, &w.dt}) row->resize(n);
  std::vector<double> du(n), dv(n), duu, duv, dvv;
  if (order == Order::second) {
    for (auto* row : {&duu, &duv, &dvv, &w.dss, &w.dst, &w.dtt}) row->resize(n);
    surface.EvaluateStencil(uv, w.value.data(), du.data(), dv.data(), duu.data(), duv.data(), dvv.data());
  } else {
    surface.EvaluateStencil(uv, w.value.data(), du.data(), dv.data());
  }
  // Derivatives by s and t as combinations of those by the face's u and v.
  Vector2 s(1, 0), t(0, 1);
  if (cut_) {
    s = {0.5, 0}, t = {0, 0.5};
    if (!surface.GetParameterization().HasSubFaces()) {
      const Vector2 corner = corner_parameter(Domain::square, patch.corner);
      s = 0.5 * (corner_parameter(Domain::square, (patch.corner + 1) % 4) - corner);
      t = 0.5 * (corner_parameter(Domain::square, (patch.corner + 3) % 4) - corner);
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    w.ds[k] = s.x() * du[k] + s.y() * dv[k];
    w.dt[k] = t.x() * du[k] + t.y() * dv[k];
    if (order != Order::second) continue;
    const auto mixed = [&](const Vector2& a, const Vector2& b) {
      return a.x() * b.x() * duu[k] + (a.x() * b.y() + a.y() * b.x()) * duv[k] + a.y() * b.y() * dvv[k];
    };
    w.dss[k] = mixed(s, s), w.dst[k] = mixed(s, t), w.dtt[k] = mixed(t, t);
  }
  return w;
}

std::shared_ptr<const StencilTable> SubdivisionTopology::table(Index patch, int density,
                                                               Derivatives which) const {
  const Index shape = patches_[patch].shape;
  const std::tuple key{shape, density, which};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = tables_.find(key); found != tables_.end()) return found->second;
  }
  const std::vector<Vector2> parameters = GridPattern{Domain::square, density}.parameters();
  auto table = std::make_shared<StencilTable>();
  table->blocks = (parameters.size() + lanes - 1) / lanes;
  table->controls = controls(patch).size();
  table->value.resize(table->blocks * table->controls * 3 * lanes);
  const bool first = which == Derivatives::first;
  for (std::size_t i = 0; i < table->blocks * lanes; ++i) {
    // The last block repeats the last point.
    const Weights w = weights(classes_[shape].patch, parameters[std::min(i, parameters.size() - 1)],
                              first ? Order::first : Order::second);
    const auto& a = first ? w.value : w.dss;
    const auto& b = first ? w.ds : w.dst;
    const auto& c = first ? w.dt : w.dtt;
    double* at = table->value.data() + (i / lanes) * table->controls * 3 * lanes + i % lanes;
    for (std::size_t k = 0; k < table->controls; ++k, at += 3 * lanes)
      at[0] = a[k], at[lanes] = b[k], at[2 * lanes] = c[k];
  }
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = table->value.size() * sizeof(double);
  if (table_bytes_ + bytes > table_byte_limit) return table;
  const auto [at, fresh] = tables_.try_emplace(key, std::move(table));
  if (fresh) table_bytes_ += bytes;
  return at->second;
}

/// Makes the nodes: of vertices, and where faces are cut of the middles of edges and the centres of faces.
void SubdivisionTopology::number_nodes() {
  const PolygonMesh& mesh = mesh_.mesh;
  vertex_nodes_.assign(mesh.positions.size(), no_index);
  std::unordered_map<std::uint64_t, Index> middle_node;
  std::vector<Index> nodes;
  const auto add_node = [&](Index& slot, Index vertex) {
    if (slot == no_index) {
      slot = Index(node_owners_.size());
      node_vertices_.push_back(vertex);
      node_owners_.push_back({Index(nodes.size() / 4), int(nodes.size() % 4)});
    }
    nodes.push_back(slot);
  };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size();
    Index centre = no_index;
    const auto middle = [&](std::size_t edge) {
      add_node(middle_node.try_emplace(edge_key(face[edge], face[(edge + 1) % n]), no_index).first->second,
               no_index);
    };
    for (std::size_t c = 0; c < n; ++c) {
      add_node(vertex_nodes_[face[c]], face[c]);
      if (!cut_) continue;
      middle(c);
      add_node(centre, no_index);
      middle((c + n - 1) % n);
    }
  }
  corner_nodes_ = std::make_shared<const std::vector<Index>>(std::move(nodes));
}

/// Makes seams, boundary and owners.
void SubdivisionTopology::join_sides() {
  const PolygonMesh& mesh = mesh_.mesh;
  std::unordered_map<std::uint64_t, double> crease;
  for (const auto& c : mesh_.creases) crease[edge_key(c.a, c.b)] = c.sharpness;
  std::vector<Seam> seams;
  std::vector<PatchSide> boundary;
  std::vector<Element> sources;
  owners_.resize(4 * patches_.size());
  const auto join = [&](PatchSide a, PatchSide b, Continuity intended, Element source) {
    Seam seam;
    seam.first = a, seam.second = b, seam.intended = intended, seam.source = source;
    seams.push_back(seam);
    const PatchSide low = std::min(a, b, [](const PatchSide& x, const PatchSide& y) {
      return std::pair(x.patch, x.side) < std::pair(y.patch, y.side);
    });
    owners_[4 * a.patch + a.side] = {low, !(a == low)};
    owners_[4 * b.patch + b.side] = {low, !(b == low)};
  };
  const auto side = [](Index patch, int s) { return PatchSide{patch, std::uint8_t(s)}; };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Index n = Index(face.size());
    for (Index c = 0; c < n; ++c) {
      if (cut_)
        join(side(first_patch_[f] + c, 1), side(first_patch_[f] + (c + 1) % n, 2),
             n == 4 ? Continuity::g2 : Continuity::g1, {});
      const Index a = face[c], b = face[(c + 1) % n];
      const Element source = element_of(EdgeId::of(VertexId{a}, VertexId{b}));
      const auto other = half_edges_.find({b, a});
      const auto own = edge_sides(a, b);
      if (other == half_edges_.end()) {
        for (const PatchSide& s : own) {
          owners_[4 * s.patch + s.side] = {s, false};
          boundary.push_back(s);
          sources.push_back(source);
        }
        continue;
      }
      if (a > b) continue;
      const auto found = crease.find(edge_key(a, b));
      const double sharpness = found == crease.end() ? 0 : found->second;
      const Continuity intended = sharpness >= infinitely_sharp ? Continuity::g0
                                  : sharpness > 0               ? Continuity::g1
                                                                : Continuity::g2;
      const auto theirs = edge_sides(b, a);
      for (std::size_t k = 0; k < own.size(); ++k) join(own[k], theirs[own.size() - 1 - k], intended, source);
    }
  }
  seams_ = std::make_shared<const std::vector<Seam>>(std::move(seams));
  boundary_sides_ = std::make_shared<const std::vector<PatchSide>>(std::move(boundary));
  boundary_sources_ = std::make_shared<const std::vector<Element>>(std::move(sources));
}

std::vector<PatchSide> SubdivisionTopology::edge_sides(Index a, Index b) const {
  const auto found = half_edges_.find({a, b});
  if (found == half_edges_.end()) return {};
  const auto [face, place] = found->second;
  if (!cut_) return {{face, std::uint8_t(place)}};
  const Index n = Index(mesh_.mesh.face(face).size());
  return {{first_patch_[face] + Index(place), 0}, {first_patch_[face] + (Index(place) + 1) % n, 3}};
}

/// Finds the corners where the second order is exact: regular vertices of the interior, of smooth boundaries
/// and of infinitely sharp creases with two quads on each side.
void SubdivisionTopology::classify_vertices() {
  const PolygonMesh& mesh = mesh_.mesh;
  struct Vertex {
    int faces = 0, boundary = 0, sharp = 0, semi_sharp = 0;
    bool quads = true, corner = false;
  };
  std::vector<Vertex> vertex(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (const Index v : mesh.face(f)) {
      ++vertex[v].faces;
      vertex[v].quads = vertex[v].quads && mesh.face(f).size() == 4;
    }
  for (const auto& [edge, place] : half_edges_)
    if (!half_edges_.contains({edge.second, edge.first}))
      ++vertex[edge.first].boundary, ++vertex[edge.second].boundary;
  for (const auto& crease : mesh_.creases)
    for (const Index v : {crease.a, crease.b})
      ++(crease.sharpness >= infinitely_sharp ? vertex[v].sharp : vertex[v].semi_sharp);
  for (const auto& corner : mesh_.corners) vertex[corner.vertex].corner = true;
  const auto regular = [&](const Vertex& v) {
    if (!v.quads || v.semi_sharp > 0) return false;
    if (v.boundary > 0) return v.sharp == 0 && (v.faces == 1 || (v.faces == 2 && !v.corner));
    return v.faces == 4 && !v.corner && v.sharp == 0;
  };
  std::vector<char> semi(patches_.size(), 0);
  second_order_.assign(4 * patches_.size(), CornerSecondOrder::exact);
  for (Index p = 0; p < patches_.size(); ++p)
    for (int c = 0; c < 4; ++c) {
      const Index v = node_vertices_[node(p, c)];
      const bool exact = v != no_index ? regular(vertex[v])
                         : c == 2      ? mesh.face(patches_[p].face).size() == 4
                                       : true;
      if (!exact) second_order_[4 * p + Index(c)] = CornerSecondOrder::undefined;
    }
}

/// Finds classes of patches with identical weights: patches with the same weights and derivatives at three
/// parameters in general position count as identical.
void SubdivisionTopology::find_shapes() {
  constexpr std::array<std::array<double, 2>, 3> probes{{{0.137, 0.291}, {0.611, 0.083}, {0.053, 0.871}}};
  std::vector<std::vector<double>> prints(patches_.size());
  parallel_for(patches_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (const auto& probe : probes) {
        const Weights w = weights(Index(p), {probe[0], probe[1]}, Order::first);
        for (const auto* row : {&w.value, &w.ds, &w.dt})
          prints[p].insert(prints[p].end(), row->begin(), row->end());
      }
  });
  std::map<std::vector<double>, Index> known;
  for (Index p = 0; p < patches_.size(); ++p) {
    const auto [at, fresh] = known.try_emplace(std::move(prints[p]), Index(classes_.size()));
    if (fresh) classes_.push_back({p, is_polynomial(p)});
    patches_[p].shape = at->second;
  }
}

/// Whether the patch is a bicubic polynomial: such a patch is determined by 4 x 4 values, and others differ
/// from their interpolant.
bool SubdivisionTopology::is_polynomial(Index patch) const {
  const auto lagrange = [](double x) {
    std::array<double, 4> out;
    for (int i = 0; i < 4; ++i) {
      out[std::size_t(i)] = 1;
      for (int j = 0; j < 4; ++j)
        if (j != i) out[std::size_t(i)] *= (3 * x - j) / (i - j);
    }
    return out;
  };
  const std::size_t n = controls(patch).size();
  std::array<std::vector<double>, 16> sample;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sample[std::size_t(4 * j + i)] = weights(patch, {i / 3.0, j / 3.0}, Order::first).value;
  for (const double s : {0.004, 0.13, 0.47, 0.71, 0.996})
    for (const double t : {0.003, 0.21, 0.55, 0.997}) {
      const auto a = lagrange(s), b = lagrange(t);
      const std::vector<double> exact = weights(patch, {s, t}, Order::first).value;
      for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (std::size_t c = 0; c < 16; ++c) sum += a[c % 4] * b[c / 4] * sample[c][k];
        if (std::abs(sum - exact[k]) > 1e-11) return false;
      }
    }
  return true;
}

}  // namespace hariko
