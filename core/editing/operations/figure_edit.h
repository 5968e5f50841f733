#pragma once

#include <string>
#include <vector>

#include "core/editing/figure_draft.h"
#include "core/editing/operation.h"

namespace marey {

/// Whether the points of the figure may move, so that people are told by how much.
enum class Points : std::uint8_t { Stay, MayMove };

/// The edit that gives the clip the drafted figure.
[[nodiscard]] Result<OperationOutcome> make_figure_edit(const OperationCall& call, FigureDraft draft, std::vector<std::string> notes,
                                                        Points points = Points::Stay);

/// Whether a joint below the roots has position channels.
[[nodiscard]] bool has_own_positions(const Skeleton& skeleton, JointIndex joint);

}  // namespace marey
