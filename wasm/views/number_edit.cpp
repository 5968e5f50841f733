#include "wasm/views/number_edit.h"

#include "wasm/app/faults.h"

namespace marey::app {

void apply_number_event(ViewContext& context, const ui::NumberResult& result, const History::MakeEdit& make_edit) {
  Session& session = context.session;
  Status status;
  switch (result.event) {
    case ui::NumberEvent::Live:
    case ui::NumberEvent::Committed:
      status = with_memory_for("this change", [&] { return session.apply_gesture(result.gesture, make_edit); });
      break;
    case ui::NumberEvent::Cancelled: session.cancel_gesture(result.gesture); break;
    case ui::NumberEvent::None: break;
  }
  if (!status) context.refusal = status.error().message;
}

}  // namespace marey::app
