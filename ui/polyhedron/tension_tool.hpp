#pragma once

// TensionTool: changes the tensions of the selected vertices and edges by dragging to the side.

#include <map>
#include <memory>

#include "ui/editor/numeric_input.hpp"
#include "ui/view/tool.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

class TensionTool final : public ModalTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override;
  ToolState update(ToolContext& context, const PointerEvent& event) override;
  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override;
  void draw(const ToolContext& context, const ToolOverlay& overlay) const override;
  std::string hint(const Language& tr) const override;

  /// Design pixels that double a tension.
  static constexpr double doubling_pixels = 80;

 private:
  ToolState show(ToolContext& context);
  ToolState confirm(ToolContext& context);
  /// A tension after the drag or the typed number.
  double alpha(double before) const;
  double beta(double before) const;
  Result<Document> edited(const Document& document) const;

  std::map<ObjectId, std::map<VertexId, double>> alphas_;  ///< as they were
  std::map<ObjectId, std::map<EdgeId, double>> betas_;
  NumericInput input_;
  double way_ = 0;  ///< pixels to the right
};

/// Draws tensions beside their elements, on objects that show them: all where they are few, else those that
/// were changed, as many as have room.
std::unique_ptr<ViewLayer> make_tension_numbers();

}  // namespace hariko
