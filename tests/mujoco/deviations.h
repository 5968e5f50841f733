#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace marey::test {

/// How far apart two lists of vectors or numbers are: the largest difference by the largest size, so that a small one among
/// large ones, which has their rounding, counts as these do.
class Spread {
 public:
  void add(const glm::dvec3& a, const glm::dvec3& b);
  void add(double a, double b) { add(glm::dvec3(a, 0.0, 0.0), glm::dvec3(b, 0.0, 0.0)); }
  /// Something else that the difference is small or large beside.
  void widen(double size);
  /// The difference itself where all is 0; not a number once something was not.
  [[nodiscard]] double relative() const { return size_ > 0.0 ? difference_ / size_ : difference_; }

 private:
  double difference_ = 0.0;
  double size_ = 0.0;
};

/// The largest relative deviations of some quantities over many cases.
class Deviations {
 public:
  struct Entry {
    std::string quantity;
    double largest = 0.0;
    int worst_case = 0;
  };

  void add(const std::string& quantity, double deviation, int which_case);
  void add(const std::string& quantity, const Spread& spread, int which_case) { add(quantity, spread.relative(), which_case); }

  /// In the order in which the quantities came.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// 0 for a quantity that never came.
  [[nodiscard]] double largest(std::string_view quantity) const;
  /// "force 1.2e-15, torque 2.3e-15".
  [[nodiscard]] std::string describe() const;

 private:
  [[nodiscard]] std::vector<Entry>::const_iterator find(std::string_view quantity) const;

  std::vector<Entry> entries_;
};

/// Prints a line of what deviated from MuJoCo how far at most.
void report(std::string_view what, const Deviations& deviations);

/// The test fails where a deviation is above `most` or not a number, and names quantity and case.
void expect_at_most(const Deviations& deviations, double most);

}  // namespace marey::test
