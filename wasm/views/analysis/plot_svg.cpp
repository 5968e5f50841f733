#include "wasm/views/analysis/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_row.h"
#include "wasm/views/graph/ticks.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {
namespace {

// In hundredths of an inch of print at 180 mm: text of 10 is 2.5 mm high.
constexpr double kWidth = 709.0;
constexpr double kRowHeight = 170.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 24.0;
constexpr double kTop = 26.0;
constexpr double kBottom = 26.0;
constexpr double kFooter = 26.0;
constexpr double kLegendLine = 14.0;
constexpr double kPrintWidth_mm = 180.0;
constexpr int kMostColumns = 1400;

const char* color_of(char component) {
  return component == 'x' ? "#c93a22" : component == 'y' ? "#0f8a5a" : component == 'z' ? "#1c6fd0" : "#1f6feb";
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else out += c;
  }
  return out;
}

std::string dash_style(std::size_t other) {
  std::string lengths;
  for (const float length : dashes_of(other)) lengths += fmt::format("{}{:g}", lengths.empty() ? "" : " ", 0.6f * length);
  return fmt::format(" stroke-width=\"0.9\" stroke-dasharray=\"{}\"", lengths);
}

/// The place of one plot and what its axes show.
struct Panel {
  double top = 0.0;
  FrameRange frames;
  double frame_time_s = 1.0;
  double low = -1.0;
  double high = 1.0;

  [[nodiscard]] double x_of(double frame) const {
    return kLeft + (frame - frames.first) / std::max(frames.count - 1, 1) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y_of(double value) const {
    return top + kTop + (high - value) / (high - low) * (kRowHeight - kTop - kBottom);
  }
};

class PictureWriter {
 public:
  std::string text;

  void add_plot(const Panel& panel, const AnalysisPlot& plot);
  void add_words(double x, double y, std::string_view anchor, std::string_view style, std::string_view words) {
    append("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, style, escaped(words));
  }
  template <class... Values>
  void append(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
  }

 private:
  void add_axes(const Panel& panel);
  void add_line(const Panel& panel, const PlotLine& line, std::string_view style);
  void add_points(const Panel& panel, const PlotLine& line, FrameRange column, bool& open);
};

void PictureWriter::add_axes(const Panel& panel) {
  const double bottom = panel.top + kRowHeight - kBottom;
  const Ticks values = make_ticks(panel.low, panel.high, (panel.high - panel.low) / 5.0);
  for (int i = 0; i < values.count; ++i) {
    const double y = panel.y_of(values.at(i));
    append("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#d5dae1\" stroke-width=\"0.7\"/>\n", kLeft, kWidth - kRight, y, y);
    add_words(kLeft - 6.0, y + 3.5, "end", "", tick_label(values.at(i), values.decimals));
  }
  const double first_s = panel.frames.first * panel.frame_time_s;
  const double last_s = (panel.frames.end() - 1) * panel.frame_time_s;
  const Ticks times = make_ticks(first_s, std::max(last_s, first_s + 1e-6), std::max(last_s - first_s, 1e-6) / 8.0);
  for (int i = 0; i < times.count; ++i) {
    const double x = panel.x_of(times.at(i) / panel.frame_time_s);
    append("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#5b6571\" stroke-width=\"0.7\"/>\n", x, x, bottom, bottom + 4.0);
    add_words(x, bottom + 15.0, "middle", "", tick_label(times.at(i), times.decimals));
  }
  add_words(kWidth - kRight, bottom + 24.0, "end", "", "time [s]");
  append("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#5b6571\" stroke-width=\"0.7\"/>\n", kLeft,
         panel.top + kTop, kWidth - kLeft - kRight, kRowHeight - kTop - kBottom);
}

// Of the frames of a column the first, the lowest, the highest and the last, in the order of time.
void PictureWriter::add_points(const Panel& panel, const PlotLine& line, FrameRange column, bool& open) {
  const auto begin = line.values.begin() + column.first;
  const auto [low, high] = std::minmax_element(begin, begin + column.count);
  FrameIndex frames[] = {column.first, static_cast<FrameIndex>(low - line.values.begin()),
                         static_cast<FrameIndex>(high - line.values.begin()), column.end() - 1};
  std::sort(std::begin(frames), std::end(frames));
  const auto end = std::unique(std::begin(frames), std::end(frames));
  for (const FrameIndex* frame = std::begin(frames); frame != end; ++frame) {
    const double value = line.values[idx(*frame)];
    if (std::isfinite(value)) append("{}{:.2f} {:.2f}", open ? "L" : "M", panel.x_of(*frame), panel.y_of(value));
    open = std::isfinite(value);
  }
}

void PictureWriter::add_line(const Panel& panel, const PlotLine& line, std::string_view style) {
  const int frames = std::min(panel.frames.count, size_of(line.values) - panel.frames.first);
  const int per_column = std::max(1, frames / kMostColumns);
  append("<path fill=\"none\" stroke-linejoin=\"round\"{} d=\"", style);
  bool open = false;
  for (int i = 0; i < frames; i += per_column) {
    add_points(panel, line, {panel.frames.first + i, std::min(per_column, frames - i)}, open);
  }
  text += "\"/>\n";
}

void PictureWriter::add_plot(const Panel& panel, const AnalysisPlot& plot) {
  add_words(kLeft, panel.top + 16.0, "start", " font-weight=\"600\" font-size=\"12\"", fmt::format("{}: {}", plot.title(), plot.whose()));
  add_axes(panel);
  append("<g clip-path=\"url(#plot{:.0f})\">\n", panel.top);
  for (const PlotLine& line : plot.raw) add_line(panel, line, " stroke=\"#9ba4b0\" stroke-width=\"0.8\"");
  for (std::size_t other = 0; other < plot.others.size(); ++other) {
    const std::string style = dash_style(other);
    for (const PlotLine& line : plot.others[other].lines) add_line(panel, line, fmt::format(" stroke=\"{}\"{}", color_of(line.component), style));
  }
  for (const PlotLine& line : plot.lines) add_line(panel, line, fmt::format(" stroke=\"{}\" stroke-width=\"1.4\"", color_of(line.component)));
  text += "</g>\n";
  double x = kWidth - kRight;
  for (auto line = plot.lines.rbegin(); line != plot.lines.rend(); ++line) {
    if (line->component == 0) continue;
    const char letter[] = {static_cast<char>(line->component - 'x' + 'X'), '\0'};
    add_words(x, panel.top + 16.0, "end", fmt::format(" font-weight=\"600\" fill=\"{}\"", color_of(line->component)), letter);
    x -= 16.0;
  }
}

ValueAxis fitted_axis(const AnalysisPlot& plot, FrameRange frames) {
  ValueRange range;
  const auto add = [&](const std::vector<PlotLine>& lines) {
    for (const PlotLine& line : lines) {
      const int end = std::min(frames.end(), size_of(line.values));
      for (FrameIndex frame = frames.first; frame < end; ++frame) range.add(line.values[idx(frame)]);
    }
  };
  add(plot.lines);
  for (const OtherLines& other : plot.others) add(other.lines);
  ValueAxis axis;
  if (!range.empty) axis.fit(range.low, range.high, 1e-3 + 1e-6 * std::max(std::abs(range.low), std::abs(range.high)));
  return axis;
}

double legend_height(const Session& session) {
  return session.others.empty() ? 0.0 : kLegendLine * static_cast<double>(session.others.size() + 1);
}

// Which clip has which kind of line, one below the other; how high it is.
double add_legend(PictureWriter& out, const Session& session, double top) {
  const auto add = [&](const std::string& style, const std::string& file_name) {
    out.append("<path fill=\"none\" stroke=\"#1b1f24\"{} d=\"M{:.1f} {:.1f}h36\"/>\n", style, kLeft, top + 8.0);
    out.add_words(kLeft + 44.0, top + 11.5, "start", "", ui::displayable(file_name));
    top += kLegendLine;
  };
  if (session.others.empty()) return 0.0;
  add(" stroke-width=\"1.4\"", session.document.file_name());
  for (std::size_t other = 0; other < session.others.size(); ++other) add(dash_style(other), session.others[other]->file_name);
  return legend_height(session);
}

}  // namespace

const ChosenBody* body_behind(const Analysis& analysis) {
  const std::span<const AnalysisPlot> plots = analysis.plots();
  const bool is_needed = std::any_of(plots.begin(), plots.end(), [](const AnalysisPlot& plot) { return plot.choice.quantity->needs_body; });
  return is_needed ? analysis.body() : nullptr;
}

std::string describe_origin(const Session& session, const Analysis& analysis) {
  const FrameRange range = session.playback.range();
  std::string text = fmt::format("Frames {} to {} of {}, {:g} s each; derivatives {}", range.first + 1, range.end(),
                                 ui::displayable(session.document.file_name()), session.document.motion().frame_time_s(),
                                 describe(analysis.derivation));
  if (const ChosenBody* body = body_behind(analysis)) text += fmt::format("; {:g} kg by {}", body->mass_kg, describe_source(*body));
  return text + fmt::format("; a unit is {:g} m", session.document.settings().metres_per_unit);
}

std::string write_plots_svg(const Session& session, const Analysis& analysis) {
  PictureWriter out;
  const double height = kRowHeight * static_cast<double>(analysis.plots().size()) + legend_height(session) + kFooter;
  out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} {}\" "
             "font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"10\" fill=\"#1b1f24\">\n",
             kPrintWidth_mm, kPrintWidth_mm * height / kWidth, kWidth, height);
  out.append("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", kWidth, height);
  double top = 0.0;
  for (const AnalysisPlot& plot : analysis.plots()) {
    const ValueAxis axis = fitted_axis(plot, session.playback.range());
    out.append("<clipPath id=\"plot{:.0f}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n", top, kLeft, top + kTop,
               kWidth - kLeft - kRight, kRowHeight - kTop - kBottom);
    out.add_plot({top, session.playback.range(), session.document.motion().frame_time_s(), axis.low, axis.high}, plot);
    top += kRowHeight;
  }
  top += add_legend(out, session, top);
  out.add_words(kLeft, top + 14.0, "start", " font-size=\"8\" fill=\"#5b6571\"", describe_origin(session, analysis));
  return out.text + "</svg>\n";
}

}  // namespace marey::app
