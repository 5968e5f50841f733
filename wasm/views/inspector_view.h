#pragma once

#include "wasm/app/view_context.h"
#include "wasm/app/workspace.h"
#include "wasm/views/inspector/joint_page.h"
#include "wasm/views/layers/layers_page.h"
#include "wasm/views/operations/operations_page.h"
#include "wasm/views/problems_view.h"

namespace marey::app {

/// The panel on the right: the selected joint, the clip, operations, layers, the body, or the problems of the file.
class InspectorView {
 public:
  enum class Page { Joint, Clip, Edit, Layers, Body, Problems };

  void draw(ViewContext& context);
  void show(Page page) { page_ = page; }
  [[nodiscard]] const OperationForm& operation_form() const { return operations_.form(); }
  /// Registers a command for each operation, "operation.smooth", that opens its form; and those of the layers.
  void add_commands(CommandRegistry& registry, Workspace& workspace);

 private:
  void draw_tabs(ViewContext& context);
  struct Tab {
    Page page = Page::Joint;
    const char* id = "";
    std::string_view label;
  };
  void draw_tab(ViewContext& context, const Tab& tab, float padding);

  Page page_ = Page::Joint;
  JointPage joint_page_;
  OperationsPage operations_;
  LayersPage layers_;
  ProblemsView problems_;
};

}  // namespace marey::app
