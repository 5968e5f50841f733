#pragma once

#include <string>
#include <string_view>

#include "core/base/text_cursor.h"

namespace marey {

/// What stands behind ROOT, JOINT or End Site: the rest of the line up to a brace; the cursor moves behind it. Blanks at
/// its end belong to it where the line ends, not before a brace. In Shift-JIS and GBK a brace can be the second byte of
/// a letter (ボ is 83 7B): it ends the name only if a word of the format follows.
[[nodiscard]] std::string_view take_joint_name(TextCursor& cursor);

/// `name` so that take_joint_name() gives it back: '_' for braces outside of letters, line ends and NUL. Blanks at its
/// front are left out.
[[nodiscard]] std::string printable_joint_name(std::string_view name);

}  // namespace marey
