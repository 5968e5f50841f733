#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/biomechanics/support.h"

namespace marey {

/// A moment at which what carries the body changes.
struct MotionEvent {
  enum class Kind : std::uint8_t { Touches, Leaves, FlightBegins, FlightEnds };
  FrameIndex frame = 0;        ///< the first of the new state
  Kind kind = Kind::Touches;
  NodeIndex node = kNoParent;  ///< of the point; kNoParent for flight, in which no point touches
  friend bool operator==(const MotionEvent&, const MotionEvent&) = default;
};

/// In the order of time. What holds from the first frame on is no event.
[[nodiscard]] std::vector<MotionEvent> find_events(const Contacts& contacts);

/// "LeftToe_end touches", "flight begins".
[[nodiscard]] std::string describe(const MotionEvent& event, const Skeleton& skeleton);

}  // namespace marey
