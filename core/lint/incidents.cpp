#include "core/lint/incidents.h"

#include <tuple>

namespace marey::lint {

std::vector<IncidentGroup> grouped(std::vector<Incident> incidents, int gap) {
  std::sort(incidents.begin(), incidents.end(), [](const Incident& a, const Incident& b) {
    return std::tuple(a.frames.first, a.channel) < std::tuple(b.frames.first, b.channel);
  });
  std::vector<IncidentGroup> groups;
  std::vector<ChannelIndex> channels;
  const auto close_group = [&] {
    if (groups.empty()) return;
    std::sort(channels.begin(), channels.end());
    groups.back().channels = static_cast<int>(std::unique(channels.begin(), channels.end()) - channels.begin());
    channels.clear();
  };
  FrameIndex last_first = -1;
  for (const Incident& incident : incidents) {
    if (groups.empty() || incident.frames.first > groups.back().frames.end() + gap) {
      close_group();
      groups.push_back({incident.frames, incident, 0, 0});
    }
    IncidentGroup& group = groups.back();
    group.frames.count = std::max(group.frames.end(), incident.frames.end()) - group.frames.first;
    if (incident.weight > group.worst.weight) group.worst = incident;
    if (group.times == 0 || incident.frames.first != last_first) ++group.times;
    last_first = incident.frames.first;
    channels.push_back(incident.channel);
  }
  close_group();
  return groups;
}

}  // namespace marey::lint
