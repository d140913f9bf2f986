#pragma once

// References: the pixels of the reference pictures that show, and of which files are not there. Filled by the
// application; a value that needs no window.

#include <map>
#include <memory>
#include <optional>

#include "core/base/ids.hpp"
#include "core/base/message.hpp"
#include "render/reference_image.hpp"

namespace hariko {

struct ReferenceView {
  std::shared_ptr<const ReferenceImage> image;  ///< null while it is decoded, where it is hidden, on an error
  std::optional<Message> error;                 ///< reason why there is none

  friend bool operator==(const ReferenceView& a, const ReferenceView& b) {
    return a.image == b.image && a.error.has_value() == b.error.has_value();
  }
};

struct References {
  std::map<ObjectId, ReferenceView> views;
  bool read_again = false;  ///< asks for the files to be looked at anew

  const ReferenceView* of(ObjectId id) const {
    const auto found = views.find(id);
    return found == views.end() ? nullptr : &found->second;
  }
};

}  // namespace hariko
