#pragma once

#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "tests/fuzz/target.h"

namespace marey::test {

/// What a refusal has to tell: a whole sentence in UTF-8, a place in the text or none.
[[nodiscard]] Harm find_harm_in_refusal(const Error& error, std::string_view text);

/// What every clip promises: as many channels in figure and motion, finite numbers, parents first, names and findings
/// that can be shown.
[[nodiscard]] Harm find_harm_in_clip(const BvhClip& clip, std::string_view text);

/// Whether both have the same tree: joints, end sites, parents, kinds of channels. Names do not count.
[[nodiscard]] bool same_tree(const Skeleton& a, const Skeleton& b);

}  // namespace marey::test
