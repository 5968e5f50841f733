#include "wasm/app/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/biomechanics/analysis_update.h"
#include "core/biomechanics/plausibility.h"

namespace marey::app {
namespace {

/// From this many samples on, a drag goes on with the former numbers until it ends.
constexpr double kManySamples = 40'000.0;
constexpr double kUnitDoubt = 0.02;
constexpr int kLeastFramesToJudge = 5;

bool needs_body(std::span<const AnalysisPlot> plots) {
  return std::any_of(plots.begin(), plots.end(), [](const AnalysisPlot& plot) { return plot.choice.quantity->needs_body; });
}

std::vector<AskedQuantity> asked_by(std::span<const AnalysisPlot> plots) {
  std::vector<AskedQuantity> asked;
  for (const AnalysisPlot& plot : plots) {
    const bool is_new = std::none_of(asked.begin(), asked.end(), [&](const AskedQuantity& a) { return asks_the_same(a, plot.asked); });
    if (is_new && plot.problem.empty()) asked.push_back(plot.asked);
  }
  return asked;
}

std::vector<Derivation> neighbours_of(const Derivation& derivation) {
  std::vector<Derivation> neighbours(2, derivation);
  switch (derivation.kind) {
    case DerivationKind::Butterworth:
      neighbours[0].cutoff_hz *= 0.8;
      neighbours[1].cutoff_hz *= 1.25;
      return neighbours;
    case DerivationKind::SavitzkyGolay:
      neighbours[0].window = std::max(neighbours[0].window - 2, (derivation.degree + 1) | 1);
      neighbours[1].window += 2;
      return neighbours;
    case DerivationKind::Central:
    case DerivationKind::Gcv:
    case DerivationKind::Spline: break;
  }
  return {{.kind = DerivationKind::SavitzkyGolay, .window = 5, .degree = 2}};
}

}  // namespace

std::vector<PlotChoice> Analysis::usual_choices() {
  std::vector<PlotChoice> choices;
  for (const char* name : {"angle", "angular_velocity", "angular_acceleration", "torque"}) choices.push_back({find_quantity(name)});
  return choices;
}

void Analysis::set_choices(std::vector<PlotChoice> choices) {
  choices_ = std::move(choices);
  ++choices_serial_;
}

std::span<const double> Analysis::column(std::string_view quantity, NodeIndex node, char component) const {
  for (const AnalysisColumn& column : table_.columns) {
    if (column.asked.node == node && column.component == component && column.asked.quantity->name == quantity) return column.values;
  }
  return {};
}

void Analysis::add_arrows(AnalysisRequest& request) const {
  if (!key_.arrows.any()) return;
  if (key_.arrows.com && body_) request.quantities.emplace_back("com");
  constexpr std::array<std::string_view, kBodyArrowCount> kOfJoints = {"velocity", "acceleration", "force", "torque", "", ""};
  for (std::size_t i = 0; i < kOfJoints.size(); ++i) {
    const bool is_known = !kOfJoints[i].empty() && (body_ || !find_quantity(kOfJoints[i])->needs_body);
    if (key_.arrows.arrows[i] && is_known) request.quantities.push_back(fmt::format("{}:*", kOfJoints[i]));
  }
  if (!body_) return;
  if (key_.arrows.shows(BodyArrow::AngularMomentum)) request.quantities.insert(request.quantities.end(), {"com", "angular_momentum"});
  if (key_.arrows.shows(BodyArrow::Reaction)) request.quantities.insert(request.quantities.end(), {"reaction", "cop"});
}

// A plot that follows the selection comes to joints that its point or its frame do not go with.
void Analysis::find_asked(const Skeleton& skeleton, AnalysisPlot& plot) {
  if (!plot.problem.empty()) return;
  const bool has_point = plot.choice.quantity->owner == QuantityOwner::Point && plot.node != kNoParent && !skeleton.node(plot.node).is_end_site;
  Result<AskedQuantity> asked = ask_for(skeleton, *plot.choice.quantity, plot.node, has_point ? plot.choice.point_m : glm::dvec3(0.0), plot.choice.frame);
  if (asked) plot.asked = std::move(*asked);
  else plot.problem = asked.error().message;
}

void Analysis::make_plots(const Session& session) {
  const Skeleton& skeleton = session.document.skeleton();
  plots_.clear();
  for (const PlotChoice& choice : choices_) {
    AnalysisPlot plot;
    plot.choice = choice;
    plot.owner = "whole body";
    plot.unit = shown_unit(choice.quantity->unit);
    if (is_of_joint(*choice.quantity) || !choice.owner.empty()) {
      const bool follows = choice.owner.empty() && key_.joint != kNoParent;
      plot.node = follows ? skeleton.node_of(key_.joint) : find_owner(skeleton, *choice.quantity, choice.owner);
      if (plot.node == kNoParent) plot.problem = choice.owner + " is not in this figure";
      plot.owner = plot.node == kNoParent ? choice.owner : node_label(skeleton, plot.node);
    }
    find_asked(skeleton, plot);
    plots_.push_back(std::move(plot));
  }
}

void Analysis::add_raw(const Clip& clip, AnalysisRequest request) {
  request.derivation = {};
  const Result<AnalysisTable> raw = analyse(clip, request);
  if (!raw) return;
  for (AnalysisPlot& plot : plots_) {
    if (plot.choice.quantity->level != DerivativeLevel::Pose && plot.problem.empty()) plot.raw = lines_of(*raw, plot.asked);
  }
}

std::vector<AnalysisRequest> Analysis::variants_of(const Clip& clip, const AnalysisRequest& request) const {
  std::vector<AnalysisRequest> variants;
  for (const Derivation& other : neighbours_of(request.derivation)) {
    variants.push_back(request);
    variants.back().derivation = other;
  }
  const auto add_body = [&](std::optional<BodyTable> table, double metres_per_unit) {
    BodyChoice choice = clip.body;
    choice.table = table;
    if (table) choice.mass_kg = clip.body.mass_kg.value_or(usual_mass_kg(*body_->table));
    Result<ChosenBody> body = find_chosen_body(clip.skeleton, choice, metres_per_unit);
    if (!body) return;
    variants.push_back(request);
    variants.back().model = std::move(body->body.model);
  };
  const double unit = clip.settings.metres_per_unit;
  if (request.model && body_->table && body_->table != BodyTable::Rods) {
    add_body(body_->table == BodyTable::DeLevaMale ? BodyTable::DeLevaFemale : BodyTable::DeLevaMale, unit);
  }
  for (const double factor : {1.0 - kUnitDoubt, 1.0 + kUnitDoubt}) {
    if (request.model) {
      add_body(body_->table, unit * factor);
    } else {
      variants.push_back(request);
      variants.back().model.emplace().metres_per_unit = unit * factor;
    }
  }
  return variants;
}

void Analysis::add_bands(const Clip& clip, const AnalysisRequest& request) {
  for (AnalysisPlot& plot : plots_) {
    for (const PlotLine& line : plot.lines) plot.bands.push_back({line.component, line.values, line.values});
  }
  for (const AnalysisRequest& variant : variants_of(clip, request)) {
    const Result<AnalysisTable> table = analyse(clip, variant);
    if (!table) continue;
    for (AnalysisPlot& plot : plots_) {
      for (const PlotLine& line : lines_of(*table, plot.asked)) {
        const auto band = std::find_if(plot.bands.begin(), plot.bands.end(), [&](const PlotBand& b) { return b.component == line.component; });
        if (band != plot.bands.end()) widen(*band, line.values);
      }
    }
  }
}

void Analysis::follow_body(const Session& session, std::uint64_t clip_serial) {
  const std::uint64_t revision = session.document.revision();
  if (knows_body_ && body_clip_serial_ == clip_serial && body_revision_ == revision) return;
  knows_body_ = true;
  body_clip_serial_ = clip_serial;
  body_revision_ = revision;
  ++body_serial_;
  body_.reset();
  body_problem_.clear();
  Result<ChosenBody> body = find_chosen_body(session.document.clip());
  if (body) body_ = std::move(*body);
  else body_problem_ = body.error().message;
}

const std::vector<std::string>& Analysis::judgement(const Session& session, std::uint64_t clip_serial) {
  Key key;
  key.clip_serial = clip_serial;
  key.revision = session.document.revision();
  key.derivation = derivation;
  key.joint = 0;  // as made a key is of no joint: the first look is always another one
  if (key == judged_) return judgement_;
  judged_ = key;
  judgement_.clear();
  follow_body(session, clip_serial);
  if (!body_ || session.document.motion().frame_count() < kLeastFramesToJudge) return judgement_;
  const Clip& clip = session.document.clip();
  const Result<Plausibility> found = judge(clip, body_->body.model, derivation);
  judgement_ = found ? marey::describe(*found, clip.motion.frame_time_s()) : std::vector<std::string>{found.error().message};
  return judgement_;
}

void Analysis::compute(const Session& session) {
  const Clip& clip = session.document.clip();
  ++serial_;
  problem_.clear();
  notes_.clear();
  table_ = {};
  contacts_.clear();
  events_.clear();
  metres_per_unit_ = clip.settings.metres_per_unit;
  make_plots(session);
  const bool wants_body = key_.arrows.any() || needs_body(plots_);
  if (wants_body) follow_body(session, key_.clip_serial);
  if (wants_body && !body_) notes_.push_back(body_problem_);
  for (AnalysisPlot& plot : plots_) {
    if (plot.problem.empty() && plot.choice.quantity->needs_body && !body_) plot.problem = "has no masses: see Body";
  }
  AnalysisRequest request;
  request.support = support;
  request.derivation = derivation;
  request.contacts = clip.body.contacts;
  if (wants_body && body_) request.model = body_->body.model;
  if (key_.shows_plots) request.asked = asked_by(plots_);
  request_ = request;
  add_arrows(request_);
  Result<AnalysisTable> table = analyse(clip, request_);
  if (!table) {
    problem_ = table.error().message;
    return;
  }
  table_ = std::move(*table);
  take_contacts(clip);
  notes_.insert(notes_.end(), table_.notes.begin(), table_.notes.end());
  if (!key_.shows_plots) return;
  take_lines();
  if (key_.shows_raw) add_raw(clip, request);
  if (key_.shows_bands) add_bands(clip, request);
  compared_.add_to(plots_, session, request, wants_body && body_ ? &*body_ : nullptr, notes_);
}

void Analysis::take_contacts(const Clip& clip) {
  const Contacts* contacts = table_.contacts();
  if (contacts == nullptr) return;
  contacts_ = make_contact_rows(clip.skeleton, *contacts, clip.body.contacts);
  events_ = find_events(*contacts);
}

void Analysis::take_lines() {
  for (AnalysisPlot& plot : plots_) {
    if (plot.problem.empty()) plot.lines = lines_of(table_, plot.asked);
  }
}

void Analysis::follow_drag(const Session& session) {
  const std::uint64_t revision = session.document.revision();
  if (revision == table_revision_ || !problem_.empty() || !can_update_analysis(request_.derivation)) return;
  const FrameRange changed = session.document.history().changed_frames_since(table_revision_);
  const int channels = std::max(session.document.motion().channel_count(), 1);
  if (changed.count > kManySamples / channels) return;
  if (!update_analysis(session.document.clip(), request_, changed, table_)) return;
  table_revision_ = revision;
  ++serial_;
  if (key_.shows_plots) take_lines();
}

void Analysis::clear() {
  if (!known_ && plots_.empty()) return;
  ++serial_;
  known_ = false;
  plots_.clear();
  table_ = {};
  contacts_.clear();
  events_.clear();
  problem_.clear();
  notes_.clear();
}

bool Analysis::follow(const Session& session, std::uint64_t clip_serial, bool shows_plots, const ShownArrows& arrows, bool dragging) {
  const Motion& motion = session.document.motion();
  if ((!shows_plots && !arrows.any()) || motion.frame_count() == 0 || session.is_partial) {
    clear();
    return false;
  }
  const bool smooths = derivation.kind != DerivationKind::Central;
  const Key key{.clip_serial = clip_serial,
                .revision = session.document.revision(),
                .choices = choices_serial_,
                .others = shows_plots ? session.others_serial : 0,
                .joint = shows_plots ? find_plotted_joint(session) : kNoParent,
                .support = support,
                .derivation = derivation,
                .shows_plots = shows_plots,
                .shows_raw = shows_plots && shows_raw && smooths,
                .shows_bands = shows_plots && shows_bands,
                .arrows = arrows};
  if (known_ && !waits_ && key == key_) return false;
  const bool is_long = static_cast<double>(motion.samples().size()) > kManySamples;
  const bool is_as_before = known_ && key.clip_serial == key_.clip_serial && key.joint == key_.joint && key.choices == key_.choices &&
                            frame_count_ == motion.frame_count();
  if (dragging && is_long && is_as_before) {
    waits_ = true;
    follow_drag(session);
    return true;
  }
  // What throws for want of memory is tried again, not taken for a result.
  known_ = false;
  key_ = key;
  compute(session);
  table_revision_ = key.revision;
  frame_count_ = motion.frame_count();
  known_ = true;
  waits_ = false;
  return false;
}

}  // namespace marey::app
