#include "app/input/input_queue.hpp"

#include "tests/support/random.hpp"

namespace hariko {
namespace {

using Kind = InputEvent::Kind;

InputEvent move(double x, double y) {
  return {.kind = Kind::move, .x = x, .y = y};
}
InputEvent button(int code, bool down) {
  return {.kind = Kind::button, .code = code, .down = down};
}
InputEvent key(int code, bool down, int modifiers = 0) {
  return {.kind = Kind::key, .code = code, .meant = code, .down = down, .modifiers = modifiers};
}

TEST(InputQueue, AClickIsTwoFramesAtItsPlace) {
  InputQueue queue;
  queue.push(move(1, 1));
  queue.push(move(5, 6));
  queue.push(button(0, true));
  queue.push(button(0, false));
  queue.push(move(9, 9));
  EXPECT_EQ(queue.take(), (std::vector{move(5, 6), button(0, true)}));
  EXPECT_EQ(queue.take(), (std::vector{button(0, false)}));
  EXPECT_EQ(queue.take(), (std::vector{move(9, 9)}));
  EXPECT_TRUE(queue.take().empty());
}

TEST(InputQueue, ADragEndsWhereItWasLetGo) {
  InputQueue queue;
  queue.push(move(1, 1));
  queue.push(button(0, true));
  queue.push(move(5, 6));
  queue.push(move(9, 9));
  queue.push(button(0, false));
  EXPECT_EQ(queue.take(), (std::vector{move(1, 1), button(0, true)}));
  EXPECT_EQ(queue.take(), (std::vector{move(9, 9)}));
  EXPECT_EQ(queue.take(), (std::vector{button(0, false)}));
}

TEST(InputQueue, KeysWaitForAFieldThatOpensAndKeepTheirPlace) {
  InputQueue queue;
  queue.push(move(1, 1));
  queue.push(key('1', true));
  queue.push({.kind = Kind::text, .code = '1'});
  queue.push(button(0, true));
  EXPECT_EQ(queue.take(true), (std::vector{move(1, 1)}));
  EXPECT_TRUE(queue.take(true).empty());
  EXPECT_EQ(queue.take(), (std::vector{key('1', true), InputEvent{.kind = Kind::text, .code = '1'}}));
  EXPECT_EQ(queue.take(true), (std::vector{button(0, true)}));
}

TEST(InputQueue, AChordIsSeenWhileItsModifierIsDown) {
  InputQueue queue;
  queue.push(key(341, true));
  queue.push(key('A', true, 2));
  queue.push(key('A', false, 2));
  queue.push(key(341, false));
  std::vector<std::size_t> sizes;
  for (auto batch = queue.take(); !batch.empty(); batch = queue.take()) sizes.push_back(batch.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 1, 1}));
}

TEST(InputQueue, AModifierThatGoesUpAtOnceLeavesTheChordWhole) {
  // The release of Ctrl still carries Ctrl.
  InputQueue queue;
  queue.push(key(341, true));
  queue.push(key('A', true, 2));
  queue.push(key(341, false, 2));
  queue.push(key('A', false));
  EXPECT_EQ(queue.take(), (std::vector{key(341, true)}));
  EXPECT_EQ(queue.take(), (std::vector{key('A', true, 2)}));
  EXPECT_EQ(queue.take(), (std::vector{key(341, false, 2)}));
  EXPECT_EQ(queue.take(), (std::vector{key('A', false)}));
}

TEST(InputQueue, WordsAreTypedInOneFrame) {
  InputQueue queue;
  for (const char c : {'a', 'b', 'c'}) {
    queue.push(key(c, true));
    queue.push({.kind = Kind::text, .code = c});
  }
  EXPECT_EQ(queue.take().size(), 6U);
}

// Whatever comes in, everything but overtaken moves comes out, in order, and a batch taken apart and pushed
// again comes out as it was: that is what a replay does.
TEST(InputQueue, KeepsTheOrderAndBatchesAreStable) {
  test::for_random(20'301, 200, [](std::mt19937_64& rng) {
    InputQueue queue;
    std::vector<InputEvent> all;
    for (int i = 0; i < 60; ++i) {
      InputEvent event{.kind = static_cast<Kind>(test::uniform_int(rng, 0, 9))};
      event.code = test::uniform_int(rng, 0, 2);
      event.down = test::uniform_int(rng, 0, 1) == 1;
      event.modifiers = test::uniform_int(rng, 0, 1);
      all.push_back(event);
      queue.push(event);
    }
    std::vector<InputEvent> out;
    while (!queue.empty()) {
      const auto batch = queue.take();
      ASSERT_FALSE(batch.empty());
      InputQueue again;
      for (const InputEvent& event : batch) again.push(event);
      EXPECT_EQ(again.take(), batch);
      EXPECT_TRUE(again.empty());
      out.insert(out.end(), batch.begin(), batch.end());
    }
    const auto moves = [](const InputEvent& event) {
      return event.kind == Kind::move || event.kind == Kind::leave;
    };
    std::erase_if(all, moves);
    std::erase_if(out, moves);
    EXPECT_EQ(out, all);
  });
}

TEST(FrameClock, TwoClicksAreAsFarApartAsTheyCameHoweverSlowFramesAre) {
  InputQueue queue;
  const auto came = [&](double at, InputEvent event) {
    event.came_at = at;
    queue.push(event);
  };
  FrameClock clock;
  std::vector<double> presses;
  double seen = 0;
  const auto frame = [&](double now) {
    const auto batch = queue.take();
    const double step = clock.tick(clock.at(batch, now));
    EXPECT_GE(step, 0);
    seen += step;
    if (!batch.empty() && batch.back().kind == Kind::button && batch.back().down) presses.push_back(seen);
  };
  frame(1);
  came(1.5, button(0, true));
  frame(1.5);
  // All that came in the quarter of a second that the last frame took.
  came(1.75, button(0, false));
  came(1.75, button(0, true));
  came(1.75, button(0, false));
  frame(1.75);
  frame(2);
  frame(2.25);
  EXPECT_EQ(presses, (std::vector<double>{1.5, 1.75}));
  frame(2.5);
  EXPECT_EQ(seen, 2.5) << "without input it is the present";
}

}  // namespace
}  // namespace hariko
