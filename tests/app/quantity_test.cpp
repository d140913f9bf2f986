// Quantities: how numbers of the panels are written, read and changed.

#include "ui/base/quantity.hpp"

#include "tests/support/random.hpp"

namespace hariko {
namespace {

using ChangeKind = ValueChange::Kind;

TEST(Quantity, lengths_have_three_decimals_after_the_size_of_the_model) {
  EXPECT_EQ(format_quantity(length_quantity(Unit::millimetre, 2), 1.23456), "1.235 mm");
  EXPECT_EQ(format_quantity(length_quantity(Unit::centimetre, 250), 123.456), "123.5 cm");
  EXPECT_EQ(format_quantity(length_quantity(Unit::metre, 0.02), 0.0123456), "0.01235 m");
  EXPECT_EQ(format_quantity(length_quantity(Unit::inch, 9e6), 1234567.8), "1234568 in");
  EXPECT_EQ(format_quantity(length_quantity(Unit::millimetre, 0), 1.5), "1.5 mm") << "an empty model";
}

TEST(Quantity, measured_lengths_have_five_digits_after_their_own_first) {
  const auto text = [](double length) {
    return format_quantity(measured_length(Unit::millimetre, length), length);
  };
  EXPECT_EQ(text(100), "100 mm");
  EXPECT_EQ(text(123.456789), "123.457 mm");
  EXPECT_EQ(text(12.3456789), "12.3457 mm");
  EXPECT_EQ(text(-12.3456789), "-12.3457 mm");
  EXPECT_EQ(text(0.00123456789), "0.00123457 mm");
  EXPECT_EQ(text(0), "0 mm");
  EXPECT_EQ(text(99.99999999), "100 mm") << "noise of computing does not show";
  EXPECT_EQ(format_quantity(measured_area(Unit::centimetre, 2.5), 2.5), "2.5 cm\u00b2");
}

TEST(Quantity, writes_no_zeros_at_the_end_and_no_negative_zero) {
  const Quantity length = length_quantity(Unit::millimetre, 2);
  EXPECT_EQ(format_quantity(length, 3), "3 mm");
  EXPECT_EQ(format_quantity(length, 100), "100 mm");
  EXPECT_EQ(format_quantity(length, -0.0001), "0 mm");
  EXPECT_EQ(format_quantity(angle_quantity(), 45.04), "45\u00b0");
  EXPECT_EQ(format_quantity(angle_quantity(), -12.56), "-12.6\u00b0");
}

TEST(Quantity, reads_absolute_and_relative_changes) {
  const Quantity length = length_quantity(Unit::millimetre, 2);
  const auto read = [&](const char* text) { return parse_change(text, length).value(); };
  EXPECT_EQ(read("12"), (ValueChange{ChangeKind::set, 12}));
  EXPECT_EQ(read("-3"), (ValueChange{ChangeKind::set, -3}));
  EXPECT_EQ(read("2cm"), (ValueChange{ChangeKind::set, 20}));
  EXPECT_EQ(read("+3"), (ValueChange{ChangeKind::add, 3}));
  EXPECT_EQ(read("+=3"), (ValueChange{ChangeKind::add, 3}));
  EXPECT_EQ(read("-=3"), (ValueChange{ChangeKind::add, -3}));
  EXPECT_EQ(read("*2"), (ValueChange{ChangeKind::multiply, 2}));
  EXPECT_EQ(read("\u00d72"), (ValueChange{ChangeKind::multiply, 2}));
  EXPECT_EQ(read("/4"), (ValueChange{ChangeKind::multiply, 0.25}));
  EXPECT_EQ(read("/=4"), (ValueChange{ChangeKind::multiply, 0.25}));
  EXPECT_NEAR(read("1/4in").amount, 6.35, 1e-12);
}

TEST(Quantity, refuses_what_is_no_change) {
  const Quantity length = length_quantity(Unit::millimetre, 2);
  for (const char* text : {"", "abc", "1+", "/0", "*2mm", "2 bananas", "+"})
    EXPECT_FALSE(parse_change(text, length).ok()) << text;
}

TEST(Quantity, changes_keep_within_the_bounds) {
  Quantity quantity = plain_quantity(2, 0.1);
  quantity.low = 1;
  quantity.high = 10;
  EXPECT_EQ((ValueChange{ChangeKind::set, 50}).apply(quantity, 3), 10);
  EXPECT_EQ((ValueChange{ChangeKind::add, -50}).apply(quantity, 3), 1);
  EXPECT_EQ((ValueChange{ChangeKind::multiply, 2}).apply(quantity, 3), 6);
  quantity.whole = true;
  EXPECT_EQ((ValueChange{ChangeKind::multiply, 1.5}).apply(quantity, 3), 5);
}

TEST(Quantity, shift_is_ten_times_finer_and_control_ten_times_coarser) {
  const Quantity quantity = plain_quantity(2, 0.5);
  EXPECT_DOUBLE_EQ(stepped(quantity, 1, false, false).amount, 0.5);
  EXPECT_DOUBLE_EQ(stepped(quantity, 1, true, false).amount, 0.05);
  EXPECT_DOUBLE_EQ(stepped(quantity, 1, false, true).amount, 5);
  EXPECT_DOUBLE_EQ(stepped(quantity, -2, false, false).amount, -1);
  Quantity whole = plain_quantity(0, 1);
  whole.whole = true;
  EXPECT_EQ(stepped(whole, 1, true, false).amount, 1) << "a whole number has no tenth";
  Quantity factor = plain_quantity(2, 0.1);
  factor.multiplies = true;
  EXPECT_EQ(stepped(factor, 1, false, false).kind, ChangeKind::multiply);
  EXPECT_NEAR(stepped(factor, 3, false, false).amount * stepped(factor, -3, false, false).amount, 1, 1e-12);
}

TEST(Quantity, copied_values_come_back_bit_for_bit) {
  test::for_random(7301, 500, [](std::mt19937_64& rng) {
    const double value = (test::chance(rng, 0.5) ? 1 : -1) * test::log_uniform(rng, 1e-12, 1e12);
    for (const Quantity& quantity : {length_quantity(Unit::inch, 3), length_quantity(Unit::metre, 3),
                                     plain_quantity(2, 1), angle_quantity()}) {
      const auto back = parse_change(exact_text(quantity, value), quantity);
      ASSERT_TRUE(back.ok()) << exact_text(quantity, value);
      EXPECT_EQ(*back, (ValueChange{ChangeKind::set, value})) << exact_text(quantity, value);
    }
  });
}

}  // namespace
}  // namespace hariko
