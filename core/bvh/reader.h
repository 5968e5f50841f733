#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "core/bvh/limits.h"
#include "core/text/character_set.h"

namespace marey {

struct ReadOptions {
  /// Refuse what the 1999 text of the format does not allow instead of repairing it. The Error carries the place and
  /// the reason that the repair's diagnostic would have carried.
  bool strict = false;
  ReadLimits limits;
  /// What the bytes of the names stand for; without it, a guess.
  std::optional<CharacterSet> names_in = std::nullopt;
};

/// Reads a BVH file in one pass over its bytes. Tokens count, not lines; nesting costs no stack; no count is trusted.
/// Every repair and assumption is a diagnostic with its place; what no reader could make sense of is an Error.
[[nodiscard]] Result<BvhClip> read_bvh(std::string_view text, const ReadOptions& options = {});

}  // namespace marey
