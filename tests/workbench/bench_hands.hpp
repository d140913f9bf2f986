#pragma once

// BenchHands: the fixture of tests with a workbench alone, without files and work in the background, and the
// hands that they share.

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {

inline Document box(const std::string& name = "Box") {
  return document_from_mesh(prism(4), name).value();
}

class BenchHands : public ::testing::Test {
 protected:
  explicit BenchHands(Document document = box(), ImVec2 size = {1280, 1000})
      : bench_(std::move(document), size) {}

  Editor& editor() { return bench_.editor(); }
  const std::map<std::string, Marks::Rect>& marks() { return bench_.workbench().marks().all(); }
  const std::vector<std::shared_ptr<const Object>>& objects() { return editor().document().objects; }
  std::string hint() { return bench_.workbench().viewport().hint(); }
  std::string notice() { return editor().notices().empty() ? std::string() : editor().notices().back().text; }
  /// Window pixels of a point of the document's space.
  Vector2 pixel(const Vector3& world) {
    const ImVec2 corner = bench_.workbench().viewport().rect().min;
    return Projector(editor().camera(), editor().viewport).project(world)->head<2>() +
           Vector2(double(corner.x), double(corner.y));
  }

  void frames(int count = 4) { bench_.frames(count); }
  void run(std::string_view id) {
    const auto outcome = bench_.workbench().commands().run(id);
    ASSERT_TRUE(outcome.ran) << id << ": " << outcome.reason;
    frames();
  }
  void press(std::initializer_list<const char*> keys) {
    for (const char* key : keys) bench_.key(key);
  }
  /// A key as the window gives it.
  void tap(std::string_view chord) {
    bench_.tap(chord);
    frames();
  }
  /// Clicks the thing that bears this mark.
  void click(const std::string& mark) {
    bench_.click(mark);
    frames();
  }
  void move_to(const Vector2& at) { bench_.move(at.x(), at.y()); }
  void click(const Vector2& at, int times = 1) {
    move_to(at);
    for (int i = 0; i < times; ++i) {
      bench_.press();
      bench_.release();
    }
  }
  /// A number into a field of the properties.
  void enter(const std::string& field, std::string_view text) {
    bench_.click("field." + field);
    bench_.frame();
    bench_.enter(text);
    frames(3);
  }
  /// An item of a list in the properties.
  void choose(const std::string& list, int number) {
    bench_.click("combo." + list);
    frames(3);
    bench_.click("choice." + list + "." + std::to_string(number));
    frames(3);
  }

  HeadlessWorkbench bench_;
};

}  // namespace hariko::test
