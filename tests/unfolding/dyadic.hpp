#pragma once

// Dyadic: exact numbers m 2^e of any size, closed under +, - and *. Every finite double is one. Written for
// tests: it shares nothing with the program's own exact arithmetic.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hariko::test {

class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(double value) {  // NOLINT: implicit on purpose
    if (value == 0) return;
    negative_ = value < 0;
    int exponent = 0;
    auto bits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(value), &exponent), 53));
    exponent_ = exponent - 53;
    for (; bits; bits >>= 32) digits_.push_back(static_cast<std::uint32_t>(bits));
  }

  /// -1, 0 or 1.
  int sign() const { return digits_.empty() ? 0 : (negative_ ? -1 : 1); }
  Dyadic operator-() const {
    Dyadic out = *this;
    out.negative_ = !negative_;
    return out;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.digits_.empty()) return b;
    if (b.digits_.empty()) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    const Digits x = shifted(a, exponent), y = shifted(b, exponent);
    Dyadic out;
    out.exponent_ = exponent;
    if (a.negative_ == b.negative_) {
      out.negative_ = a.negative_;
      out.digits_ = sum(x, y);
    } else if (const bool first = !less(x, y); true) {
      out.negative_ = first ? a.negative_ : b.negative_;
      out.digits_ = first ? difference(x, y) : difference(y, x);
    }
    return out;
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic out;
    if (a.digits_.empty() || b.digits_.empty()) return out;
    out.negative_ = a.negative_ != b.negative_;
    out.exponent_ = a.exponent_ + b.exponent_;
    out.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t k = 0; k < b.digits_.size(); ++k) {
        carry += std::uint64_t{a.digits_[i]} * b.digits_[k] + out.digits_[i + k];
        out.digits_[i + k] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      out.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
    }
    trim(out.digits_);
    return out;
  }

 private:
  using Digits = std::vector<std::uint32_t>;  ///< lowest first, no zeros on top

  static void trim(Digits& digits) {
    while (!digits.empty() && digits.back() == 0) digits.pop_back();
  }
  static Digits shifted(const Dyadic& value, int exponent) {
    const int bits = value.exponent_ - exponent;
    Digits out(static_cast<std::size_t>(bits / 32), 0);
    std::uint64_t carry = 0;
    for (const std::uint32_t digit : value.digits_) {
      carry |= std::uint64_t{digit} << (bits % 32);
      out.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    out.push_back(static_cast<std::uint32_t>(carry));
    trim(out);
    return out;
  }
  static bool less(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }
  static Digits sum(const Digits& a, const Digits& b) {
    Digits out;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry; ++i) {
      carry += std::uint64_t{i < a.size() ? a[i] : 0} + (i < b.size() ? b[i] : 0);
      out.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    trim(out);
    return out;
  }
  static Digits difference(const Digits& a, const Digits& b) {  // a >= b
    Digits out;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::int64_t digit = std::int64_t{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
      borrow = digit < 0;
      if (borrow) digit += std::int64_t{1} << 32;
      out.push_back(static_cast<std::uint32_t>(digit));
    }
    trim(out);
    return out;
  }

  bool negative_ = false;
  int exponent_ = 0;
  Digits digits_;
};

}  // namespace hariko::test
