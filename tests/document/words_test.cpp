// Words of enumerations lead there and back.

#include "core/document/words.hpp"

#include <gtest/gtest.h>

#include <array>

namespace hariko {
namespace {

template <class Enum>
void expect_there_and_back(Enum last) {
  ASSERT_EQ(enum_words<Enum>.size(), static_cast<std::size_t>(last) + 1);
  for (const std::string_view word : enum_words<Enum>) {
    const auto value = enum_value<Enum>(word);
    ASSERT_TRUE(value) << word;
    EXPECT_EQ(enum_word(*value), word);
  }
  EXPECT_FALSE(enum_value<Enum>("none of these"));
  EXPECT_FALSE(enum_value<Enum>(""));
}

TEST(Words, LeadThereAndBack) {
  expect_there_and_back(Mode::g2);
  expect_there_and_back(SurfaceMap::deviation);
  expect_there_and_back(Continuity::g1);
  expect_there_and_back(Element::Kind::object);
  EXPECT_EQ(enum_word(FrameMode::rotation_minimising), "rmf");
  EXPECT_EQ(enum_word(ColumnParameters::per_section), "per-section");
  EXPECT_EQ(enum_value<EnvelopeMethod>("network"), EnvelopeMethod::network);
  EXPECT_EQ(enum_value<Unit>("in"), Unit::inch);
  EXPECT_EQ(enum_values<Unit>(), (std::array{Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch}));
}

}  // namespace
}  // namespace hariko
