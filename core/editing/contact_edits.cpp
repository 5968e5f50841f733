#include "core/editing/contact_edits.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/editing/clip_operations.h"

namespace marey {
namespace {

// What is left of contacts of a node beside some frames.
void clear_frames(std::vector<OwnContact>& contacts, NodeIndex node, FrameRange frames) {
  std::vector<OwnContact> left;
  for (const OwnContact& contact : contacts) {
    if (contact.node != node || contact.last < frames.first || contact.first >= frames.end()) {
      left.push_back(contact);
      continue;
    }
    if (contact.first < frames.first) left.push_back({node, contact.first, frames.first - 1, contact.touches});
    if (contact.last >= frames.end()) left.push_back({node, frames.end(), contact.last, contact.touches});
  }
  contacts = std::move(left);
}

void put_in_order(std::vector<OwnContact>& contacts) {
  std::sort(contacts.begin(), contacts.end(), [](const OwnContact& a, const OwnContact& b) {
    return std::pair(a.node, a.first) < std::pair(b.node, b.first);
  });
  std::vector<OwnContact> joined;
  for (const OwnContact& contact : contacts) {
    const bool goes_on = !joined.empty() && joined.back().node == contact.node && joined.back().touches == contact.touches &&
                         joined.back().last + 1 == contact.first;
    if (goes_on) joined.back().last = contact.last;
    else joined.push_back(contact);
  }
  contacts = std::move(joined);
}

/// Where the frames of a clip go.
class FrameMoves {
 public:
  FrameMoves(const Clip& clip, const FramesChange& change) : clip_(clip), change_(change) {
    for (int i = 0; i < size_of(change.file_frames); ++i) {
      if (change.file_frames[idx(i)] != kNewFrame) places_.emplace_back(change.file_frames[idx(i)], change.removed.first + i);
    }
    std::sort(places_.begin(), places_.end());
  }

  /// -1 where it goes out of the clip.
  [[nodiscard]] FrameIndex place_of(FrameIndex frame) const {
    if (frame < change_.removed.first) return frame;
    if (frame >= change_.removed.end()) return frame + size_of(change_.file_frames) - change_.removed.count;
    const FrameIndex file_frame = clip_.file_frames.empty() ? frame : clip_.file_frames[idx(frame)];
    const auto at = std::lower_bound(places_.begin(), places_.end(), std::pair(file_frame, 0));
    return at != places_.end() && at->first == file_frame ? at->second : -1;
  }

 private:
  const Clip& clip_;
  const FramesChange& change_;
  std::vector<std::pair<FrameIndex, FrameIndex>> places_;  // file frame, place in the clip to be
};

}  // namespace

Edit make_contact_edit(const Clip& clip, std::span<const NodeIndex> nodes, FrameRange frames, std::optional<bool> touches) {
  BodyChoice body = clip.body;
  for (const NodeIndex node : nodes) {
    clear_frames(body.contacts, node, frames);
    if (touches) body.contacts.push_back({node, frames.first, frames.end() - 1, *touches});
  }
  put_in_order(body.contacts);
  Edit edit = make_body_edit(clip, body);
  edit.name = !touches ? "Contacts as detected" : *touches ? "Contact" : "No contact";
  return edit;
}

Edit carry_contacts(const Clip& clip, Edit edit) {
  if (!edit.frames || edit.body || clip.body.contacts.empty()) return edit;
  const FrameMoves moves(clip, *edit.frames);
  BodyChoice body = clip.body;
  body.contacts.clear();
  for (const OwnContact& contact : clip.body.contacts) {
    FrameRange kept;
    for (FrameIndex frame = contact.first; frame <= contact.last; ++frame) {
      if (const FrameIndex place = moves.place_of(frame); place >= 0) kept = hull(kept, {place, 1});
    }
    if (kept.count > 0) body.contacts.push_back({contact.node, kept.first, kept.end() - 1, contact.touches});
  }
  put_in_order(body.contacts);
  if (!(body == clip.body)) edit.body = std::move(body);
  return edit;
}

}  // namespace marey
