#pragma once

#include <span>
#include <string>
#include <string_view>

namespace marey {

/// Whether a name fits a pattern: '*' stands for any letters, '?' for one byte; the case of ASCII letters counts not.
[[nodiscard]] bool matches_pattern(std::string_view pattern, std::string_view name);

/// The name that is nearest to a word by letters to change, put in or leave out, whatever their case; "" where none is
/// near: more than a third of the word's letters, and more than one, would have to change.
[[nodiscard]] std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

/// " Did you mean 'sigma'?", "" without a near name.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string_view> names);

}  // namespace marey
