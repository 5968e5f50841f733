#pragma once

#include <utility>

namespace marey {

/// Calls `at_exit` when its scope is left, by an exception too, unless it is dismissed before. What it calls must not
/// fail.
template <class AtExit>
class ScopeExit {
 public:
  explicit ScopeExit(AtExit at_exit) : at_exit_(std::move(at_exit)) {}
  ~ScopeExit() {
    if (armed_) at_exit_();
  }
  ScopeExit(const ScopeExit&) = delete;
  ScopeExit& operator=(const ScopeExit&) = delete;

  void dismiss() { armed_ = false; }

 private:
  AtExit at_exit_;
  bool armed_ = true;
};

}  // namespace marey
