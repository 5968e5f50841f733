#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/editing/operation.h"
#include "wasm/app/view_context.h"
#include "wasm/views/operations/operation_job.h"
#include "wasm/views/operations/operation_target_choice.h"

namespace marey::app {

/// The form of one operation: what it works on, its parameters, and a preview that is the operation itself as a gesture:
/// each change of a value takes the former state back. Apply keeps it as one step of undo, Cancel takes it back.
class OperationForm {
 public:
  enum class Answer { Open, Applied, Cancelled };

  /// Fills the form for an operation; the preview comes with the next frame.
  void open(const Operation& operation, const Session& session);
  [[nodiscard]] bool is_open() const { return operation_ != nullptr; }
  [[nodiscard]] const Operation* operation() const { return operation_; }
  [[nodiscard]] const OperationValues& values() const { return values_; }
  [[nodiscard]] const OperationTarget& target() const { return target_; }
  /// Whether the clip holds the operation's outcome now.
  [[nodiscard]] bool is_previewed() const { return has_step_; }

  Answer draw(ViewContext& context);
  /// Takes the preview back and closes the form.
  void cancel(Session& session);
  /// Closes the form and leaves the clip alone, as it is another one.
  void forget() {
    operation_ = nullptr;
    job_.stop();
  }
  /// "Smooth 3 channels" and what there is to say of it, of the form last applied.
  [[nodiscard]] const std::vector<std::string>& report() const { return report_; }

 private:
  void follow_clip(ViewContext& context);
  /// The operation wants another clip, and none was chosen.
  [[nodiscard]] bool lacks_other() const;
  void take_other(const Session& session);
  void draw_parameters(ViewContext& context);
  void draw_parameter(ViewContext& context, const OperationParameter& parameter, std::size_t place);
  void draw_number(ViewContext& context, const OperationParameter& parameter, double& value);
  void draw_choice(ViewContext& context, const OperationParameter& parameter, double& value);
  void draw_file(ViewContext& context, const OperationParameter& parameter);
  void draw_blends(ViewContext& context);
  void draw_outcome(ViewContext& context);
  Answer draw_buttons(ViewContext& context);
  void take(ViewContext& context);
  template <class MakeOutcome>
  void apply_outcome(ViewContext& context, const MakeOutcome& make_outcome);
  Answer draw_job(ViewContext& context);
  Answer apply(ViewContext& context);
  void cancel_step(Session& session);

  const Operation* operation_ = nullptr;
  OperationValues values_;
  std::shared_ptr<const OtherClip> other_;  // what values_.other points to
  TargetKind kind_ = TargetKind::Clip;
  OperationTarget target_;
  int blend_in_ = 0;
  int blend_out_ = 0;
  double weight_ = 1.0;
  bool previews_ = true;
  bool changed_ = false;  // since the preview was made
  bool has_step_ = false;
  bool applies_when_done_ = false;
  OperationJob job_;
  GestureId gesture_ = 0;
  std::uint64_t sample_serial_ = 0;
  std::vector<std::string> notes_;
  std::string refusal_;
  std::vector<std::string> report_;
};

}  // namespace marey::app
