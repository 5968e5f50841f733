#pragma once

#include <string>
#include <string_view>

namespace marey {

/// SHA-256 of bytes (FIPS 180-4) as 64 lower case hexadecimal digits, by which a table of results names the file that it
/// was made of.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace marey
