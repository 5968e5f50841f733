#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wasm/app/save_as.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// Asks what a copy is to be like, and says in what it will differ before it is made.
class SaveAsView {
 public:
  void draw(ViewContext& context, bool& open);

 private:
  void follow_clip(const ViewContext& context);
  void draw_form(ViewContext& context);
  void draw_numbers(ViewContext& context);
  void draw_frames(ViewContext& context);
  void draw_differences(ViewContext& context);
  bool draw_download(ViewContext& context);

  SaveAs wanted_;
  int first_ = 1;  ///< frames as people count them
  int last_ = 1;
  std::uint64_t clip_serial_ = 0;
  int frame_count_ = -1;
  /// What was told last, so that an export runs once for each choice.
  std::optional<SaveAs> described_;
  std::uint64_t described_revision_ = 0;
  std::vector<std::string> differences_;
};

}  // namespace marey::app
