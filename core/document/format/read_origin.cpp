#include "core/document/format/read_origin.hpp"

#include "core/document/format/read_text.hpp"

namespace hariko {

Result<Vector3> read_origin(std::string_view text) {
  return detail::read_text<Vector3>(text, [](detail::ReadArchive& archive, Vector3& origin) {
    archive.changed("origin", origin, Vector3::Zero());
  });
}

}  // namespace hariko
