#pragma once

#include <optional>
#include <span>

#include "core/editing/edit.h"

namespace marey {

/// Says of points (nodes without children) that they touch the floor in these frames, or do not; without a word what the motion
/// tells holds there again. Refused on applying if the clip has no such frames or nodes.
[[nodiscard]] Edit make_contact_edit(const Clip& clip, std::span<const NodeIndex> nodes, FrameRange frames, std::optional<bool> touches);

/// The edit with the contacts of the clip where it gives frames way to others: a contact keeps those of its frames that stay in
/// the clip, from the first to the last of them, wherever they move, with what comes between; of other times than before, a frame goes between those that stay. Without any
/// it goes, as do those of frames that were themselves made by an edit and are made anew.
/// Precondition: check_edit(clip, edit) is ok.
[[nodiscard]] Edit carry_contacts(const Clip& clip, Edit edit);

/// What is left of contacts when only these frames stay, counted from the first of them.
[[nodiscard]] std::vector<OwnContact> contacts_within(std::span<const OwnContact> contacts, FrameRange frames);

}  // namespace marey
