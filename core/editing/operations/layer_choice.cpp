#include "core/editing/operations/layer_choice.h"

#include <fmt/format.h>

#include "core/editing/key_edits.h"

namespace marey {
namespace {

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

}  // namespace

int find_layer(const LayerStack& stack, std::string_view name) {
  for (int layer = 0; layer < size_of(stack.layers); ++layer) {
    if (stack.layers[idx(layer)].name == name) return layer;
  }
  for (int layer = 0; layer < size_of(stack.layers); ++layer) {
    if (fmt::format("{}", layer + 1) == name) return layer;
  }
  return -1;
}

Result<int> choose_layer(const OperationCall& call) {
  const LayerStack& stack = call.clip.stack;
  const std::string& name = call.text("layer");
  if (stack.layers.empty()) return refusal("The clip has no layers. Add one first.");
  const int layer = name.empty() ? size_of(stack.layers) - 1 : find_layer(stack, name);
  if (layer < 0) return refusal(fmt::format("There is no layer \"{}\".", name));
  return layer;
}

Result<int> choose_keys(const OperationCall& call) {
  if (call.text("layer").empty()) return kOwnKeys;
  return choose_layer(call);
}

}  // namespace marey
