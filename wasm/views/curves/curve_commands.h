#pragma once

#include "core/document/session.h"
#include "wasm/app/commands.h"
#include "wasm/app/time_window.h"
#include "wasm/app/view_options.h"
#include "wasm/views/curves/curves_state.h"

namespace marey::app {

/// What the commands of the curve editor work on. All of it outlives the registry.
struct CurveCommandTargets {
  Session& session;
  ViewOptions& options;
  TimeWindow& time;
  CurvesState& state;
};

/// Adds curve.fit, curve.fit_selection, curve.select_all, curve.select_none, curve.select, curve.smooth, curve.move,
/// curve.scale, curve.set_value, curve.falloff and curve.locate. Arguments: docs/page-api.md.
void add_curve_commands(CommandRegistry& registry, CurveCommandTargets targets);

}  // namespace marey::app
