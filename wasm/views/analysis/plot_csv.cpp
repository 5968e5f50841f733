#include <fmt/format.h>

#include <algorithm>

#include "core/base/sha256.h"
#include "core/table/csv.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_svg.h"

namespace marey::app {
namespace {

bool is_plotted(const Analysis& analysis, const AnalysisColumn& column) {
  const std::span<const AnalysisPlot> plots = analysis.plots();
  return std::any_of(plots.begin(), plots.end(), [&](const AnalysisPlot& plot) {
    return plot.problem.empty() && asks_the_same(plot.asked, column.asked);
  });
}

}  // namespace

std::string write_plots_csv(const Session& session, const Analysis& analysis, std::string_view file_bytes) {
  const Document& document = session.document;
  const FrameRange range = session.playback.range();
  std::string text = fmt::format("# file: {}\n# sha256: {}\n# frames: {} to {}, {} s each\n# derivative: {}\n# support: {}\n# metres per unit: {}\n",
                                 ui::displayable(document.file_name()), sha256_hex(file_bytes), range.first + 1, range.end(),
                                 document.motion().frame_time_s(), describe(analysis.derivation),
                                 support_name(analysis.support), document.settings().metres_per_unit);
  if (const ChosenBody* body = body_behind(analysis)) text += fmt::format("# body: {}, {} kg\n", describe_source(*body), body->mass_kg);
  const std::vector<OwnContact>& contacts = document.clip().body.contacts;
  if (!contacts.empty() && !analysis.contacts().empty()) text += fmt::format("# contacts: {} set by hand\n", contacts.size());
  for (const std::string& note : analysis.notes()) text += fmt::format("# {}\n", note);
  for (const MotionEvent& event : analysis.events()) {
    text += fmt::format("# event: {:.6g} s, {}\n", event.frame * document.motion().frame_time_s(), describe(event, document.skeleton()));
  }
  std::vector<NumberColumn> columns;
  for (const AnalysisColumn& column : analysis.table().columns) {
    const bool is_new = std::none_of(columns.begin(), columns.end(), [&](const NumberColumn& c) { return c.name == column.name; });
    if (is_new && is_plotted(analysis, column)) columns.push_back({column.name, column.values});
  }
  append_columns_header(columns, text);
  append_columns(columns, document.motion().frame_time_s(), range, text);
  return text;
}

}  // namespace marey::app
