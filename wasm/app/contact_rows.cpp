#include "wasm/app/contact_rows.h"

#include <algorithm>

namespace marey::app {

std::vector<ContactRow> make_contact_rows(const Skeleton& skeleton, const Contacts& contacts, std::span<const OwnContact> own) {
  std::vector<ContactRow> rows;
  const std::size_t count = contacts.points.size();
  for (std::size_t point = 0; point < count; ++point) {
    ContactRow row{contacts.points[point].node, node_label(skeleton, contacts.points[point].node), {}};
    const auto is_own = [&](FrameIndex frame) {
      return std::any_of(own.begin(), own.end(), [&](const OwnContact& contact) {
        return contact.node == row.node && contact.first <= frame && frame <= contact.last;
      });
    };
    for (FrameIndex frame = 0; frame < size_of(contacts.down) / size_of(contacts.points); ++frame) {
      const ContactBar here{frame, frame, contacts.is_down(frame, point), is_own(frame)};
      if (!here.touches && !here.is_own) continue;
      ContactBar* const before = row.bars.empty() ? nullptr : &row.bars.back();
      const bool goes_on = before != nullptr && before->last + 1 == frame && before->touches == here.touches && before->is_own == here.is_own;
      if (goes_on) before->last = frame;
      else row.bars.push_back(here);
    }
    if (!row.bars.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace marey::app
