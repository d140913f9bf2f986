#pragma once

// Expansion: exact sums and products of doubles (Shewchuk 1997).

#include <cmath>
#include <vector>

namespace hariko {

/// Floating-point expansion: the exact sum of its terms, which do not overlap and ascend in magnitude. Exact
/// unless a product of two terms underflows (below 1e-308), that is, for inputs between 1e-60 and 1e60 in
/// magnitude, or zero.
class Expansion {
 public:
  Expansion() = default;

  /// Exact difference a - b.
  static Expansion difference(double a, double b) {
    Expansion out;
    const double sum = a - b, virtual_b = a - sum, virtual_a = sum + virtual_b;
    out.append((a - virtual_a) + (virtual_b - b));
    out.append(sum);
    return out;
  }
  /// Exact product a b.
  static Expansion product(double a, double b) {
    Expansion out;
    const double high = a * b;
    out.append(std::fma(a, b, -high));
    out.append(high);
    return out;
  }

  /// Sign of the value: -1, 0 or 1.
  int sign() const { return terms_.empty() ? 0 : (terms_.back() > 0 ? 1 : -1); }

  /// Adds a double exactly. O(number of terms).
  void add(double value) {
    std::vector<double> terms;
    terms.reserve(terms_.size() + 1);
    for (const double term : terms_) {
      const double sum = value + term, virtual_term = sum - value;
      const double error = (value - (sum - virtual_term)) + (term - virtual_term);
      if (error != 0) terms.push_back(error);
      value = sum;
    }
    if (value != 0) terms.push_back(value);
    terms_ = std::move(terms);
  }
  friend Expansion operator+(Expansion a, const Expansion& b) {
    for (const double term : b.terms_) a.add(term);
    return a;
  }
  friend Expansion operator-(Expansion a, const Expansion& b) {
    for (const double term : b.terms_) a.add(-term);
    return a;
  }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion out;
    for (const double x : a.terms_)
      for (const double y : b.terms_) {
        const double high = x * y;
        out.add(std::fma(x, y, -high));
        out.add(high);
      }
    return out;
  }

 private:
  void append(double term) {
    if (term != 0) terms_.push_back(term);
  }
  std::vector<double> terms_;
};

}  // namespace hariko
