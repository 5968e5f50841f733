#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/chosen_body.h"
#include "core/document/session.h"
#include "wasm/app/analysis_plot.h"

namespace marey::app {

/// The lines of the clips beside the open one. They are computed anew only when something changes that they follow from, which the
/// samples of the open clip are not.
class ComparedClips {
 public:
  /// Adds lines to plots, as far as the other figures have what is plotted, and what there is to know to `notes`. `request` is that
  /// of the open clip, `body` its body, null for none. The lines hold until the next call.
  void add_to(std::vector<AnalysisPlot>& plots, const Session& session, const AnalysisRequest& request, const ChosenBody* body,
              std::vector<std::string>& notes);

 private:
  /// What the lines of a clip follow from, and they.
  struct Answer {
    std::shared_ptr<const OtherClip> other;
    BodyModel model;
    SupportKind support = SupportKind::Auto;
    Derivation derivation;
    std::vector<AskedQuantity> asked;     ///< of each plot; without a quantity where the figure has none such
    std::vector<std::vector<PlotLine>> lines;  ///< of each plot, at the clip's own frames
    std::vector<std::string> notes;
  };
  [[nodiscard]] static bool is_same(const Answer& a, const Answer& b);
  static void compute(Answer& answer, const AnalysisRequest& request);

  std::vector<Answer> answers_;
};

}  // namespace marey::app
