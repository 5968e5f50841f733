#pragma once

#include <imgui.h>

#include <cstdint>

#include "wasm/render/curve_batch.h"
#include "wasm/render/web/gl_objects.h"

namespace marey::app::gl {

/// Draws batches of curves amid ImGui's own drawing. One is started at a time: that of the page's context.
class CurvePass {
 public:
  CurvePass() = default;
  ~CurvePass();
  CurvePass(const CurvePass&) = delete;
  CurvePass& operator=(const CurvePass&) = delete;

  Status start();
  /// `clip`: as in ImDrawCmd. Uploads the batch when it is another one than the last.
  void draw(const CurveBatch& batch, const ImVec4& clip);

  /// The one that is started; nullptr for none.
  [[nodiscard]] static CurvePass* started();

 private:
  void upload(const CurveBatch& batch);

  Program program_;
  GLint to_clip_ = -1;
  GLint options_ = -1;
  VertexArray array_;
  StreamBuffer places_;
  const CurveBatch* uploaded_ = nullptr;
  std::uint64_t uploaded_serial_ = 0;
};

}  // namespace marey::app::gl
