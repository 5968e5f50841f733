#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/bvh/report.h"

namespace marey {

/// `text` with a blank for each byte of the blanks that are not ASCII (no-break, ideographic, zero-width, a byte order
/// mark that is not at `begin`), so that places stay the same; empty if there are none. Within names and comments they
/// stay. The first one is reported. text[0] is the byte `text_begin` of the file.
[[nodiscard]] std::string with_plain_blanks(std::string_view text, std::size_t begin, Report& report,
                                            std::size_t text_begin = 0);

}  // namespace marey
