#pragma once

namespace marey::app {

/// A value that goes from 0 to 1 and back in 120 ms, quick at first and slow at the end.
class Transition {
 public:
  /// `target` is where it is to go, `elapsed_s` the time since the last call. With `at_once` it jumps. Returns true
  /// while it moves.
  bool advance(bool target, double elapsed_s, bool at_once);

  /// Eased, 0..1.
  [[nodiscard]] float share() const;

 private:
  double progress_ = 0.0;
  bool started_ = false;
};

}  // namespace marey::app
