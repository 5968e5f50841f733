#include "core/lint/name_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/base/text_cursor.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

void add(FindingKind kind, JointIndex joint, int count, std::string message, LintReport& report) {
  report.findings.push_back({kind, joint, std::nullopt, std::nullopt, count, std::move(message)});
}

/// Joints that bear the same name, or one that differs in nothing but its case.
struct Namesakes {
  JointIndex first = 0;
  int joints = 0;
};

/// In the order of their first joints. Joints without a name are left out.
template <class Key>
std::vector<Namesakes> group_joints(const Skeleton& skeleton, Key key) {
  std::vector<Namesakes> groups;
  std::unordered_map<std::string, std::size_t> group_of;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.name(joint).empty()) continue;
    const auto [entry, is_new] = group_of.try_emplace(key(skeleton.name(joint)), groups.size());
    if (is_new) groups.push_back({joint, 0});
    ++groups[entry->second].joints;
  }
  return groups;
}

std::string in_lower_case(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), to_lower_ascii);
  return lower;
}

void add_duplicates(const Skeleton& skeleton, LintReport& report) {
  std::vector<std::string> names;
  int count = 0;
  JointIndex first = 0;
  for (const Namesakes& group : group_joints(skeleton, [](const std::string& name) { return name; })) {
    if (group.joints < 2) continue;
    if (names.empty()) first = group.first;
    names.push_back(fmt::format("{} ({})", lint::quoted(skeleton.name(group.first)), counted(group.joints, "joint")));
    count += group.joints;
  }
  if (names.empty()) return;
  const std::string_view verb = names.size() == 1 ? "is the name of more than one joint" : "are names of more than one joint each";
  add(FindingKind::DuplicateName, first, count, fmt::format("{} {}.", lint::listed(names), verb), report);
}

void add_case_twins(const Skeleton& skeleton, LintReport& report) {
  std::unordered_map<std::string, JointIndex> spelling_of;
  std::vector<std::string> pairs;
  JointIndex first = 0;
  for (const Namesakes& group : group_joints(skeleton, [](const std::string& name) { return name; })) {
    const std::string& name = skeleton.name(group.first);
    const auto [entry, is_new] = spelling_of.try_emplace(in_lower_case(name), group.first);
    if (is_new) continue;
    if (pairs.empty()) first = group.first;
    pairs.push_back(fmt::format("{} and {}", lint::quoted(skeleton.name(entry->second)), lint::quoted(name)));
  }
  if (pairs.empty()) return;
  add(FindingKind::NameDiffersInCase, first, size_of(pairs),
      fmt::format("{} differ only in upper and lower case.", lint::listed(pairs)), report);
}

template <class Wanted>
std::vector<NodeIndex> joints_named(const Skeleton& skeleton, Wanted wanted) {
  std::vector<NodeIndex> nodes;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (wanted(std::string_view(skeleton.name(joint)))) nodes.push_back(skeleton.node_of(joint));
  }
  return nodes;
}

bool has_blank(std::string_view name) { return std::any_of(name.begin(), name.end(), is_blank); }

bool has_non_ascii(std::string_view name) {
  return std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

}  // namespace

void add_name_findings(const Skeleton& skeleton, LintReport& report) {
  add_duplicates(skeleton, report);
  if (const auto nodes = joints_named(skeleton, [](std::string_view name) { return name.empty(); }); !nodes.empty()) {
    add(FindingKind::EmptyName, skeleton.node(nodes.front()).joint, size_of(nodes),
        fmt::format("{} without a name.", counted(size_of(nodes), "joint") + (nodes.size() == 1 ? " is" : " are")), report);
  }
  if (const auto nodes = joints_named(skeleton, has_blank); !nodes.empty()) {
    add(FindingKind::NameWithBlank, skeleton.node(nodes.front()).joint, size_of(nodes),
        fmt::format("{} with a blank in it: {}.", counted(size_of(nodes), "name"), lint::listed(skeleton, nodes)), report);
  }
  if (const auto nodes = joints_named(skeleton, has_non_ascii); !nodes.empty()) {
    add(FindingKind::NameNotAscii, skeleton.node(nodes.front()).joint, size_of(nodes),
        fmt::format("{} with letters beyond ASCII: {}.", counted(size_of(nodes), "name"), lint::listed(skeleton, nodes)),
        report);
  }
  add_case_twins(skeleton, report);
}

}  // namespace marey
