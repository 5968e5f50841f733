#pragma once

#include "core/interchange/ascii_name.h"
#include "core/interchange/rig.h"

namespace marey {

/// Gives each joint a name of its own in the given letters, of at most 63 bytes. Letters are spelled as ascii_name()
/// has it; a name with others, or without any, is numbered: "Joint12", "Joint12_L". Repeated names get "_2", "_3" ...
/// Gives back the joints whose names changed.
[[nodiscard]] std::vector<ExportedName> give_plain_names(Rig& rig, NameLetters letters, ExportChanges& changes);

}  // namespace marey
