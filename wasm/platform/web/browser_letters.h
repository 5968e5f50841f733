#pragma once

struct ImFontLoader;
struct ImFontAtlas;

namespace marey::app {

/// Draws letters that no face of the page has (Chinese, Japanese, Korean, Thai ...) with the browser's fonts, each when
/// it is first shown. To be merged behind a face; see FontFiles. Lives as long as the program.
[[nodiscard]] const ImFontLoader& browser_letters();

/// Has every letter drawn again, since the browser has got a font that it lacked. Not within a frame.
void forget_drawn_letters(ImFontAtlas& atlas);

}  // namespace marey::app
