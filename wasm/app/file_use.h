#pragma once

namespace marey::app {

/// What a file is read for; web/src/file_use.ts has the same numbers.
enum class FileUse {
  Document,   ///< it takes the place of the open clip
  OtherClip,  ///< it stands beside it, as Session::others
  BodyModel,  ///< it gives the open clip masses
};

}  // namespace marey::app
