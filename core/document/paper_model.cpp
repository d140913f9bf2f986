#include "core/document/paper_model.hpp"

#include <tuple>

namespace hariko {

bool operator<(const PaperVertex& a, const PaperVertex& b) {
  const auto key = [](const PaperVertex& p) {
    return std::make_tuple(p.object.value, static_cast<int>(p.element.kind), p.element.id, p.side, p.u, p.v);
  };
  return key(a) < key(b);
}

}  // namespace hariko
