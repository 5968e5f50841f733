#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/biomechanics/support.h"

namespace marey::app {

/// Frames in which a point touches the floor, or in which people say that it does not.
struct ContactBar {
  FrameIndex first = 0;
  FrameIndex last = 0;  ///< belongs to it
  bool touches = true;
  bool is_own = false;  ///< people's word, not that of the motion
  friend bool operator==(const ContactBar&, const ContactBar&) = default;
};

/// A point of the body over the clip.
struct ContactRow {
  NodeIndex node = 0;
  std::string name;  ///< node_label()
  std::vector<ContactBar> bars;  ///< rising, apart
};

/// The points that touch the floor in some frame or of which people have said something, in the order of the figure.
[[nodiscard]] std::vector<ContactRow> make_contact_rows(const Skeleton& skeleton, const Contacts& contacts, std::span<const OwnContact> own);

}  // namespace marey::app
