#pragma once

#include <algorithm>
#include <vector>

#include "core/base/stable_order.h"
#include "core/lint/lint.h"

namespace marey::lint {

/// Something that happens to one channel.
struct Incident {
  FrameRange frames;
  ChannelIndex channel = 0;
  double size = 0.0;    ///< degrees or file units
  double weight = 0.0;  ///< for comparing incidents of angles with those of lengths
};

/// Incidents at about the same time. `channels` and `times` count different channels and different first frames.
struct IncidentGroup {
  FrameRange frames;
  Incident worst;
  int channels = 0;
  int times = 0;
};

/// Puts incidents together that begin at most `gap` frames behind the end of the ones before. In order of time.
[[nodiscard]] std::vector<IncidentGroup> grouped(std::vector<Incident> incidents, int gap);

/// Keeps the `most` items of greatest weight in their order, the first ones among equals; how many were left out.
template <class Item, class Weight>
int keep_worst(std::vector<Item>& items, int most, Weight weight) {
  const int surplus = size_of(items) - std::max(most, 1);
  if (surplus <= 0) return 0;
  std::vector<int> order = stable_order(size_of(items), [&](int a, int b) { return weight(items[idx(a)]) > weight(items[idx(b)]); });
  order.resize(items.size() - idx(surplus));
  std::sort(order.begin(), order.end());
  std::vector<Item> kept;
  kept.reserve(order.size());
  for (const int i : order) kept.push_back(std::move(items[idx(i)]));
  items = std::move(kept);
  return surplus;
}

}  // namespace marey::lint
