#pragma once

#include <string>

namespace marey {

/// How a BVH text was written: learnt by the reader, used by the writer, so that a file saved without an edit comes
/// out byte for byte where its style is uniform. The defaults are the canonical form.
struct BvhStyle {};

}  // namespace marey
