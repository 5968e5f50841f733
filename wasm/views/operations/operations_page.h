#pragma once

#include <cstdint>
#include <string>

#include "wasm/app/view_context.h"
#include "wasm/views/operations/operation_form.h"

namespace marey::app {

/// The page of the inspector with all operations, and the form of the one that was chosen.
class OperationsPage {
 public:
  void draw(ViewContext& context);
  /// Opens the form of an operation; the preview of another one is taken back.
  void open(const Operation& operation, Session& session, std::uint64_t clip_serial);
  /// Takes a preview back, as another page is looked at.
  void leave(Session& session) { form_.cancel(session); }
  [[nodiscard]] const OperationForm& form() const { return form_; }

 private:
  void draw_list(ViewContext& context);
  void draw_row(ViewContext& context, const Operation& operation);
  void draw_report(ViewContext& context) const;

  OperationForm form_;
  std::string search_;
  std::uint64_t clip_serial_ = 0;
};

}  // namespace marey::app
