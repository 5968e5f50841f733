#include "wasm/views/viewport/joint_labels.h"

#include <algorithm>
#include <cmath>

#include "core/base/stable_order.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kGap = 9.0f;
constexpr ImVec2 kPadding{4.0f, 1.0f};
constexpr ImVec2 kHoverPadding{8.0f, 4.0f};
constexpr std::size_t kLongestName = 28;  // bytes in the overlay; the hover label shows all

bool overlap(ImVec2 a, ImVec2 a_size, ImVec2 b, ImVec2 b_size) {
  return a.x < b.x + b_size.x && b.x < a.x + a_size.x && a.y < b.y + b_size.y && b.y < a.y + a_size.y;
}

std::string shortened(std::string text) {
  if (text.size() <= kLongestName) return text;
  std::size_t end = kLongestName;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "…";
}

void draw_hover_label(const ViewContext& context, const ViewportState& state, JointIndex joint) {
  const Skeleton& skeleton = context.session.document.skeleton();
  const auto place = state.view.project(state.figure.pose().world_positions[idx(skeleton.node_of(joint))]);
  if (!place) return;
  const std::string name = skeleton.name(joint);
  const std::string& text = name.empty() ? std::string("(no name)") : name;
  const float view_width = static_cast<float>(state.view.size().x);
  const float widest = std::max(view_width - 2.0f * kHoverPadding.x - 16.0f, 40.0f);
  const ImVec2 text_size = ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, widest);
  const ImVec2 size{text_size.x + 2.0f * kHoverPadding.x, text_size.y + 2.0f * kHoverPadding.y};
  const ImVec2 anchor = state.to_screen(*place);
  ImVec2 min{std::round(anchor.x + 12.0f), std::round(anchor.y - size.y - 8.0f)};
  min.x = std::clamp(min.x, state.corner.x + 8.0f, std::max(state.corner.x + view_width - size.x - 8.0f, state.corner.x + 8.0f));
  min.y = std::max(min.y, state.corner.y + 8.0f);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 max{min.x + size.x, min.y + size.y};
  draw_list.AddRectFilled({min.x, min.y + 1.0f}, {max.x, max.y + 2.0f}, IM_COL32(0, 0, 0, 60), 5.0f);
  draw_list.AddRectFilled(min, max, context.theme.raised, 4.0f);
  draw_list.AddRect(min, max, context.theme.line, 4.0f, 0, ui::device_pixel());
  draw_list.AddText(context.fonts.text, Fonts::kTextSize, {min.x + kHoverPadding.x, min.y + kHoverPadding.y},
                    context.theme.text, text.data(), text.data() + text.size(), widest);
}

}  // namespace

void place_labels(std::span<const LabelWish> wishes, ImVec2 low, ImVec2 high, float gap,
                  std::vector<LabelPlace>& places) {
  places.clear();
  for (int i = 0; i < size_of(wishes); ++i) {
    const auto& [anchor, size, left_first] = wishes[idx(i)];
    const float right = anchor.x + gap;
    const float left = anchor.x - gap - size.x;
    const ImVec2 offers[] = {{left_first ? left : right, anchor.y - 0.5f * size.y},
                             {left_first ? right : left, anchor.y - 0.5f * size.y},
                             {anchor.x - 0.5f * size.x, anchor.y - gap - size.y},
                             {anchor.x - 0.5f * size.x, anchor.y + gap}};
    const auto* free_place = std::find_if(std::begin(offers), std::end(offers), [&, size = size](ImVec2 offer) {
      if (offer.x < low.x || offer.y < low.y || offer.x + size.x > high.x || offer.y + size.y > high.y) return false;
      return std::none_of(places.begin(), places.end(), [&](const LabelPlace& place) {
        return overlap(offer, size, place.min, wishes[idx(place.wish)].size);
      });
    });
    if (free_place != std::end(offers)) places.push_back({i, {std::round(free_place->x), std::round(free_place->y)}});
  }
}

void JointLabels::update_names(const ViewContext& context, const ViewportState& state) {
  if (figure_serial_ == state.figure.figure_serial()) return;
  figure_serial_ = state.figure.figure_serial();
  const Skeleton& skeleton = context.session.document.skeleton();
  names_.clear();
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    std::string text = shortened(skeleton.name(joint));
    if (text.empty()) continue;
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    names_.push_back({joint, std::move(text), {size.x + 2.0f * kPadding.x, size.y + 2.0f * kPadding.y}});
  }
  // Joints with much of the body below them come first, fingers last.
  sort_stably(names_, [&](const Name& a, const Name& b) {
    return skeleton.subtree_end(a.joint) - a.joint > skeleton.subtree_end(b.joint) - b.joint;
  });
}

void JointLabels::draw_names(ViewContext& context, const ViewportState& state) {
  ImGui::PushFont(context.fonts.text, Fonts::kSmallSize);
  update_names(context, state);
  const Skeleton& skeleton = context.session.document.skeleton();
  const Selection& selection = context.session.selection;
  wishes_.clear();
  wishing_.clear();
  // Away from the body, so that the figure stays in sight.
  const auto middle = state.view.project(state.figure.pose_box().center());
  for (const bool selected : {true, false}) {
    for (int i = 0; i < size_of(names_); ++i) {
      const Name& name = names_[idx(i)];
      if (selection.contains(name.joint) != selected) continue;
      const auto place = state.view.project(state.figure.pose().world_positions[idx(skeleton.node_of(name.joint))]);
      if (!place) continue;
      wishes_.push_back({state.to_screen(*place), name.size, middle && place->x < middle->x});
      wishing_.push_back(i);
    }
  }
  const ImVec2 high{state.corner.x + static_cast<float>(state.view.size().x),
                    state.corner.y + static_cast<float>(state.view.size().y)};
  place_labels(wishes_, state.corner, high, kGap, places_);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  for (const LabelPlace& place : places_) {
    const Name& name = names_[idx(wishing_[idx(place.wish)])];
    const ImU32 color = selection.contains(name.joint) ? context.theme.selection : context.theme.text;
    draw_list.AddRectFilled(place.min, {place.min.x + name.size.x, place.min.y + name.size.y},
                            with_alpha(context.theme.panel, 0.72f), 3.0f);
    draw_list.AddText({place.min.x + kPadding.x, place.min.y + kPadding.y}, color, name.text.data(),
                      name.text.data() + name.text.size());
  }
  ImGui::PopFont();
}

void JointLabels::draw(ViewContext& context, const ViewportState& state) {
  if (context.options.show_names) draw_names(context, state);
  const JointIndex joint = context.hover.joint;
  if (joint >= 0 && joint < context.session.document.skeleton().joint_count() && state.drag == ViewDrag::None) {
    draw_hover_label(context, state, joint);
  }
}

}  // namespace marey::app
