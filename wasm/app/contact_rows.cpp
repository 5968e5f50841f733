#include "wasm/app/contact_rows.h"

#include <algorithm>
#include <iterator>

namespace marey::app {

std::vector<ContactRow> make_contact_rows(const Skeleton& skeleton, const Contacts& contacts, std::span<const OwnContact> own) {
  std::vector<ContactRow> rows;
  const std::size_t count = contacts.points.size();
  for (std::size_t point = 0; point < count; ++point) {
    ContactRow row{contacts.points[point].node, node_label(skeleton, contacts.points[point].node), {}};
    std::vector<OwnContact> of_point;
    std::copy_if(own.begin(), own.end(), std::back_inserter(of_point), [&](const OwnContact& contact) { return contact.node == row.node; });
    const auto is_own = [&](FrameIndex frame) {
      return std::any_of(of_point.begin(), of_point.end(), [&](const OwnContact& contact) { return contact.first <= frame && frame <= contact.last; });
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
