#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/base/text_excerpt.h"
#include "core/text/character_set.h"

namespace marey {

// Findings quote bytes of the file in sentences that are ASCII. For people all of it is decoded, here and nowhere else.

/// The findings as valid UTF-8, what they quote read in `set`.
[[nodiscard]] Diagnostics readable(const Diagnostics& findings, CharacterSet set);

/// The error as valid UTF-8, what it quotes read in the set that is guessed from that.
[[nodiscard]] Error readable(Error error);

/// The excerpt as valid UTF-8, with `marked_byte` moved accordingly.
[[nodiscard]] TextExcerpt readable(const TextExcerpt& excerpt, CharacterSet set);

}  // namespace marey
