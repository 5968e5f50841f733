#include "core/biomechanics/motion_events.h"

namespace marey {

std::vector<MotionEvent> find_events(const Contacts& contacts) {
  std::vector<MotionEvent> events;
  const int frame_count = contacts.points.empty() ? 0 : size_of(contacts.down) / size_of(contacts.points);
  for (FrameIndex frame = 1; frame < frame_count; ++frame) {
    for (std::size_t point = 0; point < contacts.points.size(); ++point) {
      const bool is_down = contacts.is_down(frame, point);
      if (is_down == contacts.is_down(frame - 1, point)) continue;
      events.push_back({frame, is_down ? MotionEvent::Kind::Touches : MotionEvent::Kind::Leaves, contacts.points[point].node});
    }
    const bool any_down = contacts.any_down(frame);
    if (any_down == contacts.any_down(frame - 1)) continue;
    events.push_back({frame, any_down ? MotionEvent::Kind::FlightEnds : MotionEvent::Kind::FlightBegins, kNoParent});
  }
  return events;
}

std::string describe(const MotionEvent& event, const Skeleton& skeleton) {
  switch (event.kind) {
    case MotionEvent::Kind::Touches: return node_label(skeleton, event.node) + " touches";
    case MotionEvent::Kind::Leaves: return node_label(skeleton, event.node) + " leaves the ground";
    case MotionEvent::Kind::FlightBegins: return "flight begins";
    case MotionEvent::Kind::FlightEnds: return "flight ends";
  }
  return {};
}

}  // namespace marey
