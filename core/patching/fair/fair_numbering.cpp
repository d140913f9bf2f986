#include "core/patching/fair/fair_numbering.hpp"

namespace hariko {

FairNumbering::FairNumbering(std::shared_ptr<const HalfEdgeMesh> of, const PatchConstants& constants,
                             std::vector<bool> given)
    : mesh(std::move(of)),
      side_origin(mesh->half_edge_count()),
      side_target(mesh->half_edge_count()),
      side_scale(mesh->half_edge_count(), 1.0),
      given_side(std::move(given)) {
  std::size_t local = 0;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const std::size_t sides = mesh->side_count(f);
    face_begin.push_back(count);
    local_begin.push_back(local);
    count += 3 + 2 * sides;
    local += 3 + 4 * sides;
  }
  local_begin.push_back(local);
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const Index h = mesh->half_edge_of_edge(e), twin = mesh->twin(h);
    side_origin[h] = count;
    side_target[h] = count + 1;
    count += 2;
    if (twin == no_index) continue;
    if (constants.smooth[h]) {
      // The condition is a_own G_own + a_other G_other = R: z moves the points within its null space.
      side_origin[twin] = side_target[h];
      side_target[twin] = side_origin[h];
      side_scale[h] = constants.own[twin];
      side_scale[twin] = -constants.own[h];
    } else {
      side_origin[twin] = count;
      side_target[twin] = count + 1;
      count += 2;
    }
  }
}

std::size_t FairNumbering::local_side(Index h) const {
  const Index f = mesh->face(h);
  return 3 + 2 * std::size_t(mesh->side_count(f)) + 2 * std::size_t(h - mesh->face_begin(f));
}

void FairNumbering::gather(Index face, const FairField& x, bool scaled, double* local) const {
  const std::size_t n = mesh->side_count(face), size = 3 + 4 * n, first = face_begin[face];
  const auto put = [&](std::size_t at, double scale, const Vector3& value) {
    for (std::size_t c = 0; c < 3; ++c) local[c * size + at] = scale * value[Eigen::Index(c)];
  };
  for (std::size_t i = 0; i < 3 + 2 * n; ++i) put(i, 1, x[first + i]);
  for (std::size_t j = 0; j < n; ++j) {
    const Index h = mesh->face_begin(face) + Index(j);
    const double scale = scaled ? side_scale[h] : 1.0;
    put(3 + 2 * n + 2 * j, scale, x[side_origin[h]]);
    put(4 + 2 * n + 2 * j, scale, x[side_target[h]]);
  }
}

void FairNumbering::scatter_interior(Index face, const double* local, FairField& y) const {
  const std::size_t n = mesh->side_count(face), size = 3 + 4 * n;
  for (std::size_t i = 0; i < 3 + 2 * n; ++i)
    y[face_begin[face] + i] = Vector3(local[i], local[size + i], local[2 * size + i]);
}

}  // namespace hariko
