#pragma once

// WaistHandles: rings on the bridges between the solids of the active object, by which their waists are
// dragged.

#include <optional>
#include <vector>

#include "core/envelope/envelope_handles.hpp"
#include "ui/marks.hpp"
#include "ui/tools/handle_sight.hpp"
#include "ui/tools/tool.hpp"

namespace hariko {

/// Keeps where the rings are between frames: one for each pair of solids, where it can be seen and
/// moves most. With a selection only bridges of selected solids have rings. Bridges
/// whose curves stay where they are whatever the waist have none.
class WaistHandles {
 public:
  /// Looks at the present surface. Hidden when no solids are active, while the paper is shown, and where the
  /// network's own handles are.
  void update(const Editor& editor);
  /// The ring that is there.
  std::optional<std::size_t> hit(const Vector2& pixel) const;
  const EnvelopeBridge& bridge(std::size_t handle) const { return handles_[handle].bridge; }
  void draw(const ToolOverlay& overlay, std::optional<std::size_t> hot) const;
  /// Names the rings for tests: "waist.0-1" for the bridge of the solids 0 and 1.
  void mark(Marks& marks, const ToolOverlay& overlay) const;

  /// Design pixels round a ring's middle, that hit it.
  static constexpr double hit_radius = 9;

 private:
  struct Handle {
    EnvelopeBridge bridge;
    Vector2 at, way;  ///< pixels; the way for a factor that grows by one
  };
  std::vector<Handle> handles_;
  HandleSight sight_;
};

/// Draws the ring of a bridge, with arrows along the pixels in which it moves.
void draw_waist_ring(const ToolOverlay& overlay, const Vector2& at, const Vector2& way, bool hot);

/// The factor on the waist of a bridge follows the pointer along the way of its curve. For a press on a ring;
/// without a drag the two solids are selected.
std::unique_ptr<Tool> make_waist_tool(ObjectId object, const EnvelopeBridge& bridge);

}  // namespace hariko
