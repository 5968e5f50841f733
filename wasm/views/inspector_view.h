#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/inspector/joint_page.h"
#include "wasm/views/problems_view.h"

namespace marey::app {

/// The panel on the right: the selected joint, the clip, or the problems of the file.
class InspectorView {
 public:
  enum class Page { Joint, Clip, Problems };

  void draw(ViewContext& context);
  void show(Page page) { page_ = page; }

 private:
  void draw_tabs(ViewContext& context);
  void draw_tab(ViewContext& context, Page page, const char* id, std::string_view label);

  Page page_ = Page::Joint;
  JointPage joint_page_;
  ProblemsView problems_;
};

}  // namespace marey::app
