#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/editing/operation.h"
#include "core/kinematics/forward_kinematics.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {

/// A small body that walks along +z and turns: Hips (positions, YXZ), Spine (ZXY), Head (a hinge, X), arms (XYZ) and legs
/// (ZXY) with hinged knees, mirrored in x. 30 frames a second. The same for the same number of frames.
[[nodiscard]] Clip make_figure(int frame_count);

/// The same body with random angles of any size, whole turns apart and across gimbal lock.
[[nodiscard]] Clip make_wild_figure(Random& random, int frame_count);

/// A parameter and its number, or its choice.
struct Given {
  std::string_view name;
  double number = 0.0;
};

/// The values of an operation with some of them given.
[[nodiscard]] OperationValues values_of(const Operation& operation, std::initializer_list<Given> given,
                                        const Clip* other = nullptr);

/// Where a choice stands among the choices of a parameter.
[[nodiscard]] double choice_of(std::string_view operation, std::string_view parameter, std::string_view choice);

/// The outcome of an operation, which must be none that is refused.
[[nodiscard]] OperationOutcome outcome_of(const Clip& clip, std::string_view operation, const OperationTarget& target,
                                          std::initializer_list<Given> given = {}, const Clip* other = nullptr);

/// The clip after an operation on all of it, or on a target.
[[nodiscard]] Clip after(const Clip& clip, std::string_view operation, std::initializer_list<Given> given = {});
[[nodiscard]] Clip after(const Clip& clip, std::string_view operation, const OperationTarget& target,
                         std::initializer_list<Given> given = {});

/// Any values that the table allows.
[[nodiscard]] OperationValues make_random_values(Random& random, const Operation& operation, const Clip* other);
[[nodiscard]] OperationTarget make_random_target(Random& random, const Clip& clip);

/// World positions of all nodes, frame by frame.
[[nodiscard]] std::vector<double> positions_of(const Clip& clip);

/// Largest difference between two lists of one length.
[[nodiscard]] double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace marey::test
