#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace marey::app {

/// `value` with a fixed number of decimals; never "-0.0"; "–" when it is not finite.
[[nodiscard]] std::string displayed_number(double value, int decimals);

/// What a person typed: blanks around it, a decimal comma and a unit behind it ("12,5 °") are understood. Nothing if it
/// is no finite number.
[[nodiscard]] std::optional<double> read_typed_number(std::string_view text, std::string_view unit);

/// The shortest text that reads back as the same double, as the start of typing.
[[nodiscard]] std::string editable_number(double value);

}  // namespace marey::app
