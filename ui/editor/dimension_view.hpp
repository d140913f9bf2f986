#pragma once

// DimensionView: the dimensions of the shown document with their values, and the one that is chosen.

#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.hpp"
#include "core/modeling/measuring/measured_dimension.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

class DisplayMesh;
class Editor;

/// The surfaces that are ready, for measuring on them. The editor must outlive the function.
SurfaceOf ready_surfaces(const Editor& editor);

struct ShownDimension {
  Dimension dimension;
  std::optional<MeasuredDimension> measured;  ///< nothing: what it measures is gone, or its surface is
  bool visible = true;                        ///< every object that it measures is shown
};

class DimensionView {
 public:
  /// Takes up the dimensions of the shown document, and measures anew those whose objects or surfaces are
  /// others than before. O(objects) while there are dimensions.
  void update(const Editor& editor);
  /// In the order of the document.
  const std::vector<ShownDimension>& all() const { return all_; }

  /// Chooses a dimension until another one is chosen, or the selection is another.
  void choose(const Editor& editor, DimensionId id);
  void choose_none() { chosen_.reset(); }
  /// The chosen one; nothing where the document has it no more.
  std::optional<DimensionId> chosen(const Editor& editor) const;

 private:
  /// An object that dimensions name, as it was when they were measured.
  struct Known {
    std::shared_ptr<const Object> object;
    std::shared_ptr<const DisplayMesh> mesh;
    friend bool operator==(const Known&, const Known&) = default;
  };
  struct Chosen {
    DimensionId id;
    Selection selection;  ///< state when it was chosen
    ElementMode mode = ElementMode::vertex;
  };
  void take_up(const Shared<Dimensions>& dimensions);

  Shared<Dimensions> dimensions_;
  std::vector<ShownDimension> all_;
  std::vector<ObjectId> named_;  ///< ascending
  std::vector<Known> known_;     ///< those that are named
  std::optional<Chosen> chosen_;
};

}  // namespace hariko
