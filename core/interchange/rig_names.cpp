#include "core/interchange/rig_names.h"

#include <fmt/format.h>

#include <unordered_set>

#include "core/base/counted.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

constexpr std::size_t kLongestName = 63;  // Blender's bones; Second Life reads 79

std::string plain_name(const std::string& name, JointIndex joint, NameLetters letters) {
  bool is_complete = true;
  std::string plain = ascii_name(name, letters, is_complete);
  if (plain.find_first_not_of('_') == std::string::npos) plain.clear();
  if (!is_complete || plain.empty()) {
    const bool is_apart = plain.empty() || plain.front() == '_';
    plain = fmt::format("Joint{}{}{}", joint + 1, is_apart ? "" : "_", plain);
  }
  return plain.substr(0, kLongestName);
}

std::string unique_name(const std::string& name, std::unordered_set<std::string>& taken) {
  std::string unique = name;
  for (int number = 2; !taken.insert(unique).second; ++number) {
    const std::string suffix = fmt::format("_{}", number);
    unique = name.substr(0, kLongestName - suffix.size()) + suffix;
  }
  return unique;
}

}  // namespace

std::vector<ExportedName> give_plain_names(Rig& rig, NameLetters letters, ExportChanges& changes) {
  std::vector<ExportedName> names;
  std::vector<std::string> examples;
  std::unordered_set<std::string> taken;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    std::string& name = rig.joints[idx(joint)].name;
    std::string plain = unique_name(plain_name(name, joint, letters), taken);
    if (plain == name) continue;
    examples.push_back(fmt::format("{} to {}", lint::quoted(name), lint::quoted(plain)));
    names.push_back({joint, std::exchange(name, plain), plain});
  }
  if (!names.empty()) {
    changes.push_back({ExportChangeKind::NamesChanged, true, size_of(names),
                       fmt::format("{}: {}.", counted(size_of(names), "name") + (names.size() == 1 ? " changes" : " change"),
                                   lint::listed(examples))});
  }
  return names;
}

}  // namespace marey
