#include "core/skeleton/body_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

namespace marey {
namespace {

struct SideWord {
  std::string_view text;
  BodySide side;
};

// Whole words, in lower case.
constexpr SideWord kWords[] = {
    {"l", BodySide::Left},       {"r", BodySide::Right},      {"left", BodySide::Left},   {"right", BodySide::Right},
    {"lft", BodySide::Left},     {"rgt", BodySide::Right},    {"lt", BodySide::Left},     {"rt", BodySide::Right},
    {"esq", BodySide::Left},     {"dir", BodySide::Right},    {"izq", BodySide::Left},    {"der", BodySide::Right},
    {"links", BodySide::Left},   {"rechts", BodySide::Right}, {"linke", BodySide::Left},  {"rechte", BodySide::Right},
    {"linker", BodySide::Left},  {"rechter", BodySide::Right}, {"linkes", BodySide::Left}, {"rechtes", BodySide::Right},
};

// Parts of words that mean a side wherever they stand. Letters outside of ASCII are not folded, hence both cases.
constexpr SideWord kStems[] = {
    {"esquerd", BodySide::Left}, {"direit", BodySide::Right}, {"izquierd", BodySide::Left}, {"derech", BodySide::Right},
    {"gauche", BodySide::Left},  {"droit", BodySide::Right},  {"sinistr", BodySide::Left},  {"destr", BodySide::Right},
    {"лев", BodySide::Left},     {"прав", BodySide::Right},   {"Лев", BodySide::Left},      {"Прав", BodySide::Right},
    {"ЛЕВ", BodySide::Left},     {"ПРАВ", BodySide::Right},   {"лів", BodySide::Left},      {"Лів", BodySide::Left},
    {"左", BodySide::Left},      {"右", BodySide::Right},     {"왼", BodySide::Left},       {"오른", BodySide::Right},
};

// What may follow an l or r that is written together with it, as in "lfemur" or "RHAND".
constexpr std::string_view kParts[] = {
    "ankle", "arm",  "ball",  "breast", "butt", "calf", "cheek", "clav",  "collar", "ear",   "elbow", "eye",
    "femur", "foot", "forearm", "hand", "heel", "hip",  "humer", "index", "knee",   "leg",   "little", "lowarm",
    "lowleg", "mid", "palm", "pinky", "radius", "ring", "scap",  "shin",  "shldr",  "shoulder", "thigh", "thumb",
    "tibia", "toe",  "uparm", "upleg", "upper", "lower", "wrist", "fing",
};

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}
constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// One past the word that begins at `start`: words end at other characters and where camel case begins a new one.
std::size_t find_word_end(std::string_view name, std::size_t start) {
  std::size_t end = start + 1;
  while (end < name.size() && is_letter(name[end])) {
    const bool hump = is_upper(name[end]) && is_lower(name[end - 1]);
    const bool last_capital = is_upper(name[end]) && end + 1 < name.size() && is_lower(name[end + 1]) &&
                              is_upper(name[end - 1]);
    if (hump || last_capital) break;
    ++end;
  }
  return end;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

constexpr BodySide side_of_letter(char letter) {
  return letter == 'l' ? BodySide::Left : letter == 'r' ? BodySide::Right : BodySide::Middle;
}

// "lfemur", "handr".
BodySide find_side_beside_part(std::string_view word) {
  if (word.size() < 4) return BodySide::Middle;
  for (const std::string_view part : kParts) {
    if (word.substr(1, part.size()) == part) return side_of_letter(word.front());
    if (word.substr(0, word.size() - 1) == part) return side_of_letter(word.back());
  }
  return BodySide::Middle;
}

BodySide find_side_of_word(std::string_view word) {
  for (const SideWord& known : kWords) {
    if (word == known.text) return known.side;
  }
  if (word == "upright" || word == "rear") return BodySide::Middle;
  if (word.starts_with("left") || word.ends_with("left")) return BodySide::Left;
  if (word.starts_with("right") || word.ends_with("right")) return BodySide::Right;
  return find_side_beside_part(word);
}

std::vector<BodySide> compute_sides_by_name(const Skeleton& skeleton) {
  std::vector<BodySide> sides;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    BodySide side = find_side_in_name(skeleton.name(joint));
    const JointIndex parent = skeleton.parent(joint);
    if (side == BodySide::Middle && parent != kNoParent) side = sides[idx(parent)];
    sides.push_back(side);
  }
  return sides;
}

std::vector<glm::dvec3> compute_rest_positions(const Skeleton& skeleton) {
  std::vector<glm::dvec3> positions;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    positions.push_back(skeleton.offset(joint) + (parent == kNoParent ? glm::dvec3(0.0) : positions[idx(parent)]));
  }
  return positions;
}

// Joints off the mirror plane through the first root, and whether nearly all of them have a twin behind the mirror.
bool is_mirrored(const std::vector<glm::dvec3>& positions, int axis, double tolerance) {
  int off_plane = 0;
  int with_twin = 0;
  for (const glm::dvec3& position : positions) {
    if (std::abs(position[axis] - positions[0][axis]) <= tolerance) continue;
    ++off_plane;
    glm::dvec3 twin = position;
    twin[axis] = 2.0 * positions[0][axis] - position[axis];
    with_twin += std::any_of(positions.begin(), positions.end(), [&](const glm::dvec3& other) {
      return glm::distance(other, twin) <= 2.0 * tolerance;
    });
  }
  return off_plane >= 4 && with_twin * 10 >= off_plane * 9;
}

std::vector<BodySide> compute_sides_by_place(const Skeleton& skeleton) {
  const std::vector<glm::dvec3> positions = compute_rest_positions(skeleton);
  const double tolerance = 0.005 * compute_stature(skeleton);
  std::vector<BodySide> sides(positions.size(), BodySide::Middle);
  for (const int axis : {0, 2}) {
    if (tolerance <= 0.0 || !is_mirrored(positions, axis, tolerance)) continue;
    const double to_left = axis == 0 ? 1.0 : -1.0;
    for (std::size_t joint = 0; joint < positions.size(); ++joint) {
      const double leftness = to_left * (positions[joint][axis] - positions[0][axis]);
      if (std::abs(leftness) > tolerance) sides[joint] = leftness > 0.0 ? BodySide::Left : BodySide::Right;
    }
    break;
  }
  return sides;
}

}  // namespace

BodySide find_side_in_name(std::string_view name) {
  for (const SideWord& stem : kStems) {
    if (lower_case(name).find(stem.text) != std::string::npos) return stem.side;
  }
  for (std::size_t start = 0; start < name.size();) {
    if (!is_letter(name[start])) {
      ++start;
      continue;
    }
    const std::size_t end = find_word_end(name, start);
    const bool vertebra = end == start + 1 && end < name.size() && is_digit(name[end]);
    if (!vertebra) {
      const BodySide side = find_side_of_word(lower_case(name.substr(start, end - start)));
      if (side != BodySide::Middle) return side;
    }
    start = end;
  }
  return BodySide::Middle;
}

std::vector<BodySide> compute_body_sides(const Skeleton& skeleton) {
  std::vector<BodySide> sides = compute_sides_by_name(skeleton);
  const bool named = std::any_of(sides.begin(), sides.end(), [](BodySide side) { return side != BodySide::Middle; });
  return named || sides.empty() ? sides : compute_sides_by_place(skeleton);
}

}  // namespace marey
