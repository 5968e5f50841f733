#include "core/editing/contact_edits.h"

#include <algorithm>
#include <iterator>
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

/// Where the frames of a clip go. Of other times than before, a frame goes between the places of those that stay.
class FrameMoves {
 public:
  FrameMoves(const Clip& clip, const FramesChange& change) : clip_(clip), change_(change) {
    for (int i = 0; i < size_of(change.file_frames); ++i) {
      if (change.file_frames[idx(i)] != kNewFrame) places_.emplace_back(change.file_frames[idx(i)], change.removed.first + i);
    }
    std::sort(places_.begin(), places_.end());
    for (FrameIndex frame = change.removed.first; frame < change.removed.end(); ++frame) {
      if (const FrameIndex place = known_place(frame); place >= 0) stays_.emplace_back(frame, place);
    }
  }

  /// -1 where it goes out of the clip.
  [[nodiscard]] FrameIndex place_of(FrameIndex frame) const {
    if (frame < change_.removed.first) return frame;
    if (frame >= change_.removed.end()) return frame + size_of(change_.file_frames) - change_.removed.count;
    const auto behind = std::lower_bound(stays_.begin(), stays_.end(), std::pair(frame, 0));
    if (behind != stays_.end() && behind->first == frame) return behind->second;
    if (behind == stays_.begin() || behind == stays_.end()) return -1;
    const auto& [before_frame, before_place] = *std::prev(behind);
    const int places = behind->second - before_place;
    const bool is_taken_out = places <= 1 && file_frame(frame) != kNewFrame;
    return is_taken_out ? -1 : before_place + (frame - before_frame) * places / (behind->first - before_frame);
  }

 private:
  [[nodiscard]] FrameIndex file_frame(FrameIndex frame) const { return clip_.file_frames.empty() ? frame : clip_.file_frames[idx(frame)]; }

  [[nodiscard]] FrameIndex known_place(FrameIndex frame) const {
    const FrameIndex wanted = file_frame(frame);
    const auto at = std::lower_bound(places_.begin(), places_.end(), std::pair(wanted, 0));
    return wanted != kNewFrame && at != places_.end() && at->first == wanted ? at->second : -1;
  }

  const Clip& clip_;
  const FramesChange& change_;
  std::vector<std::pair<FrameIndex, FrameIndex>> places_;  // file frame, place in the clip to be
  std::vector<std::pair<FrameIndex, FrameIndex>> stays_;   // frame, place in the clip to be, rising
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

std::vector<OwnContact> contacts_within(std::span<const OwnContact> contacts, FrameRange frames) {
  std::vector<OwnContact> kept;
  for (const OwnContact& contact : contacts) {
    const FrameIndex first = std::max(contact.first, frames.first);
    const FrameIndex last = std::min(contact.last, frames.end() - 1);
    if (first <= last) kept.push_back({contact.node, first - frames.first, last - frames.first, contact.touches});
  }
  return kept;
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
