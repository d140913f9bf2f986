#pragma once

// NetworkHandles: squares on the vertices and diamonds on the curves of the network round the active object's
// solids, by which they are pulled.

#include <optional>
#include <variant>
#include <vector>

#include "core/envelope/envelope_handles.hpp"
#include "ui/marks.hpp"
#include "ui/tools/handle_sight.hpp"
#include "ui/tools/tool.hpp"

namespace hariko {

using NetworkHandle = std::variant<EnvelopeVertex, EnvelopeCurve>;

/// Keeps where the handles are between frames: those of vertices and curves that can be seen. With a
/// selection only selected solids have handles.
class NetworkHandles {
 public:
  /// Looks at the present surface. None unless the designer asked for them, when no solids are active, while
  /// the paper is shown, and where there would be too many.
  void update(const Editor& editor);
  /// The handle that is there.
  std::optional<std::size_t> hit(const Vector2& pixel) const;
  const NetworkHandle& handle(std::size_t number) const { return handles_[number].handle; }
  void draw(const ToolOverlay& overlay, std::optional<std::size_t> hot) const;
  /// Names the handles for tests: "network.vertex.1-3" for vertex 3 of solid 1, "network.curve.1-3.2-0" for
  /// the curve from there to vertex 0 of solid 2; "1+2-77" stands in the valley between solids 1 and 2.
  void mark(Marks& marks, const ToolOverlay& overlay) const;

  /// In the picture; more would cover the model.
  static constexpr std::size_t most_handles = 400;
  /// Design pixels round a handle's middle, that hit it.
  static constexpr double hit_radius = 8;

 private:
  struct Shown {
    NetworkHandle handle;
    Vector2 at;    ///< pixels
    bool changed;  ///< by hand
  };
  std::vector<Shown> handles_;
  HandleSight sight_;
};

/// Draws a handle; `changed` ones are filled.
void draw_network_handle(const ToolOverlay& overlay, const Vector2& at, bool vertex, bool changed, bool hot);

/// Moves the vertex, or makes the curve fuller, as the pointer goes. For a press on a handle; a double click
/// puts it back to where the solids have it.
std::unique_ptr<Tool> make_network_tool(ObjectId object, const NetworkHandle& handle);

}  // namespace hariko
