#pragma once

namespace marey::app {

/// What a file is read for.
enum class FileUse {
  Document,   ///< it takes the place of the open clip
  OtherClip,  ///< it stands beside it, as Session::other
  BodyModel,  ///< it gives the open clip masses
};

}  // namespace marey::app
