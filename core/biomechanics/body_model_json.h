#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"
#include "core/biomechanics/body_model.h"

namespace marey {

/// The masses of a figure:
///   {"metres_per_unit": 0.055, "gravity": [0, -9.81, 0],
///    "segments": [{"joint": "Arms", "mass_kg": 7, "com_m": [0, 0.275, 0], "inertia_kgm2": [xx, yy, zz, xy, xz, yz]}, ...]}
/// Unit and gravity may be missing, and so may an inertia, which is 0 then. Of joints of one name the first is meant. Error
/// InvalidArgument, which names segment and entry.
[[nodiscard]] Result<BodyModel> read_body_model(const nlohmann::json& json, const Skeleton& skeleton);

/// The same as text, a line a segment, to the last bit. Refused with InvalidArgument where a joint with mass has the name of one
/// before it, for which it would be taken.
[[nodiscard]] Result<std::string> write_body_model(const BodyModel& model, const Skeleton& skeleton);

}  // namespace marey
