#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/motion_events.h"
#include "core/biomechanics/quantity.h"
#include "core/document/session.h"
#include "wasm/app/analysis_plot.h"
#include "wasm/app/compared_clips.h"
#include "wasm/app/contact_rows.h"
#include "wasm/app/shown_arrows.h"

namespace marey::app {

/// How a clip is looked at as mechanics, and the numbers that come of it; computed anew only when something of it changes.
class Analysis {
 public:
  SupportKind support = SupportKind::Auto;
  Derivation derivation;
  bool shows_raw = true;    ///< beside smoothed lines
  /// The hull of the results with a cut-off a fifth lower and a quarter higher (or windows two frames shorter and longer;
  /// beside differences and the spline, with polynomials of degree 2 over 5 frames), with the other published table, and with a
  /// unit of length 2 % smaller and larger. Masses that were typed in stay.
  bool shows_bands = false;

  [[nodiscard]] const std::vector<PlotChoice>& choices() const { return choices_; }
  void set_choices(std::vector<PlotChoice> choices);
  /// Angle, angular velocity, angular acceleration and torque of the active joint.
  [[nodiscard]] static std::vector<PlotChoice> usual_choices();

  /// What the next frames show; call in each, and before numbers are handed out. While `dragging` samples of a clip that takes
  /// long, only the frames about the change are computed anew, and support, bands and raw curves stay; with splines all
  /// numbers stay. Returns whether something waits for the end of the drag. Without frames, and while the clip is still being
  /// read, there are no numbers.
  bool follow(const Session& session, std::uint64_t clip_serial, bool shows_plots, const ShownArrows& arrows, bool dragging);

  [[nodiscard]] std::span<const AnalysisPlot> plots() const { return plots_; }
  /// Grows with each new result.
  [[nodiscard]] std::uint64_t serial() const { return serial_; }
  /// Why there are no numbers; "" when there are.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// The body that masses come of; null where none could be found, and before the first follow_body().
  [[nodiscard]] const ChosenBody* body() const { return body_ ? &*body_ : nullptr; }
  /// Grows each time the body is found anew.
  [[nodiscard]] std::uint64_t body_serial() const { return body_serial_; }
  /// Why there is no body.
  [[nodiscard]] const std::string& body_problem() const { return body_problem_; }
  /// Finds the body of the clip, if it is not known yet.
  void follow_body(const Session& session, std::uint64_t clip_serial);
  /// What speaks for or against unit of length, frame time and floor, in sentences.
  [[nodiscard]] const std::vector<std::string>& judgement(const Session& session, std::uint64_t clip_serial);
  /// A column of the result, SI; empty where there is none.
  [[nodiscard]] std::span<const double> column(std::string_view quantity, NodeIndex node, char component) const;
  [[nodiscard]] double metres_per_unit() const { return metres_per_unit_; }
  /// Whether the numbers are those of this clip.
  [[nodiscard]] bool is_of(std::uint64_t clip_serial) const { return known_ && key_.clip_serial == clip_serial; }
  /// What touches the floor; empty where nothing that was asked for needs to know, and where the body does not stand on ground.
  [[nodiscard]] std::span<const ContactRow> contacts() const { return contacts_; }
  /// Whether the numbers are those of this clip as it is now.
  [[nodiscard]] bool is_of(std::uint64_t clip_serial, std::uint64_t revision) const { return is_of(clip_serial) && table_revision_ == revision; }
  /// When these contacts change, in the order of time.
  [[nodiscard]] std::span<const MotionEvent> events() const { return events_; }
  /// The whole result of what is plotted, SI.
  [[nodiscard]] const AnalysisTable& table() const { return table_; }

 private:
  /// All that the result follows from.
  struct Key {
    std::uint64_t clip_serial = 0;
    std::uint64_t revision = 0;
    std::uint64_t choices = 0;
    std::uint64_t others = 0;
    JointIndex joint = kNoParent;
    SupportKind support = SupportKind::Auto;
    Derivation derivation;
    bool shows_plots = false;
    bool shows_raw = false;
    bool shows_bands = false;
    ShownArrows arrows;
    friend bool operator==(const Key&, const Key&) = default;
  };
  void compute(const Session& session);
  void follow_drag(const Session& session);
  void take_lines();
  void take_contacts(const Clip& clip);
  void make_plots(const Session& session);
  static void find_asked(const Skeleton& skeleton, AnalysisPlot& plot);
  void add_raw(const Clip& clip, AnalysisRequest request);
  void add_bands(const Clip& clip, const AnalysisRequest& request);
  [[nodiscard]] std::vector<AnalysisRequest> variants_of(const Clip& clip, const AnalysisRequest& request) const;
  void clear();
  void add_arrows(AnalysisRequest& request) const;

  std::vector<PlotChoice> choices_ = usual_choices();
  std::uint64_t choices_serial_ = 0;
  Key key_;
  bool known_ = false;
  bool waits_ = false;              // for the end of a drag
  std::uint64_t table_revision_ = 0;  // of the samples that the table is of
  AnalysisRequest request_;         // what the table is the answer to
  int frame_count_ = 0;  // of the numbers
  std::vector<AnalysisPlot> plots_;
  ComparedClips compared_;
  AnalysisTable table_;
  std::vector<ContactRow> contacts_;
  std::vector<MotionEvent> events_;
  std::optional<ChosenBody> body_;
  std::uint64_t body_clip_serial_ = 0;
  std::uint64_t body_revision_ = 0;
  std::uint64_t body_serial_ = 0;
  bool knows_body_ = false;
  std::string body_problem_;
  std::vector<std::string> judgement_;
  Key judged_;
  std::vector<std::string> notes_;
  std::string problem_;
  double metres_per_unit_ = 0.01;
  std::uint64_t serial_ = 0;
};

}  // namespace marey::app
