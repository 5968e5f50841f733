#include "wasm/render/curve_batch.h"

namespace marey::app {

void add_curve_batch(ImDrawList& list, const CurveBatch& batch) {
  list.AddCallback([](const ImDrawList*, const ImDrawCmd*) {}, const_cast<CurveBatch*>(&batch));
}

}  // namespace marey::app
