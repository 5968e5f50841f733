#include "core/biomechanics/body_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace marey {
namespace {

/// What a word says before the tree is looked at.
enum class Word { None, Trunk, Head, Shoulder, UpperArm, Arm, Forearm, Hand, Hip, Thigh, Leg, Shank, Foot, Arms, Legs };

struct Spelling {
  std::string_view text;
  Word word;
};

// Of a name in lower case, without prefix, blanks, marks and digits, once its side is taken off. Longer ones first where one
// holds the other.
constexpr auto kSpellings = std::to_array<Spelling>({
    {"arms", Word::Arms}, {"legs", Word::Legs}, {"body", Word::Trunk}, {"hips", Word::Trunk}, {"pelvis", Word::Trunk},
    {"root", Word::Trunk}, {"spine", Word::Trunk}, {"chest", Word::Trunk}, {"lowerback", Word::Trunk}, {"torso", Word::Trunk},
    {"trunk", Word::Trunk}, {"trunkcomp", Word::Trunk}, {"abdomen", Word::Trunk}, {"waist", Word::Trunk}, {"thorax", Word::Trunk},
    {"upperchest", Word::Trunk}, {"tospine", Word::Trunk}, {"lowerspine", Word::Trunk}, {"middlespine", Word::Trunk},
    {"upperspine", Word::Trunk}, {"upperback", Word::Trunk}, {"neck", Word::Head}, {"head", Word::Head},
    {"headcomp", Word::Head}, {"shoulder", Word::Shoulder}, {"shldr", Word::UpperArm}, {"upperarm", Word::UpperArm},
    {"uparm", Word::UpperArm}, {"humerus", Word::UpperArm}, {"arm", Word::Arm}, {"elbow", Word::Forearm}, {"forearm", Word::Forearm},
    {"lowerarm", Word::Forearm}, {"lowarm", Word::Forearm}, {"radius", Word::Forearm}, {"wrist", Word::Hand}, {"hand", Word::Hand},
    {"hip", Word::Hip}, {"thigh", Word::Thigh}, {"upleg", Word::Thigh}, {"upperleg", Word::Thigh}, {"femur", Word::Thigh},
    {"leg", Word::Leg}, {"knee", Word::Shank}, {"shin", Word::Shank}, {"shank", Word::Shank}, {"calf", Word::Shank},
    {"lowleg", Word::Shank}, {"lowerleg", Word::Shank}, {"tibia", Word::Shank}, {"ankle", Word::Foot}, {"foot", Word::Foot}});

/// Small letters alone, behind the last colon and without the words of programs.
std::string plain(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::string letters;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') letters += c;
  }
  for (const std::string_view prefix : {"character", "model", "mixamorig", "bip"}) {
    if (letters.starts_with(prefix) && letters.size() > prefix.size()) letters.erase(0, prefix.size());
  }
  return letters;
}

Word word_of(std::string_view letters) {
  const auto found = std::find_if(kSpellings.begin(), kSpellings.end(), [&](const Spelling& s) { return s.text == letters; });
  return found == kSpellings.end() ? Word::None : found->word;
}

Word find_word(std::string_view name, BodySide side) {
  std::string letters = plain(name);
  if (const Word word = word_of(letters); word != Word::None) return word;
  const auto without = [&](std::string_view mark) {
    if (letters.size() <= mark.size()) return Word::None;
    const std::string_view text = letters;
    Word word = text.starts_with(mark) ? word_of(text.substr(mark.size())) : Word::None;
    if (word == Word::None && text.ends_with(mark)) word = word_of(text.substr(0, text.size() - mark.size()));
    return word;
  };
  if (side == BodySide::Middle) return Word::None;
  for (const std::string_view mark : side == BodySide::Left ? std::array<std::string_view, 2>{"left", "l"}
                                                            : std::array<std::string_view, 2>{"right", "r"}) {
    if (const Word word = without(mark); word != Word::None) return word;
  }
  return Word::None;
}

class PartFinder {
 public:
  explicit PartFinder(const Skeleton& skeleton) : skeleton_(skeleton) {
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      words_.push_back(find_word(skeleton.name(joint), find_side_in_name(skeleton.name(joint))));
    }
  }

  [[nodiscard]] std::optional<NamedPart> part_of(JointIndex joint) const {
    const BodySide side = find_side_in_name(skeleton_.name(joint));
    const Word word = words_[idx(joint)];
    if (word == Word::Arms) return NamedPart{BodyPart::UpperArm, BodySide::Middle, true};
    if (word == Word::Legs) return NamedPart{BodyPart::Thigh, BodySide::Middle, true};
    if (side == BodySide::Middle) {
      if (word == Word::Trunk || (word == Word::Hip && skeleton_.parent(joint) == kNoParent)) return NamedPart{BodyPart::Trunk, side};
      return word == Word::Head ? std::optional(NamedPart{BodyPart::Head, side}) : std::nullopt;
    }
    const std::optional<BodyPart> part = limb_of(joint, word);
    return part ? std::optional(NamedPart{*part, side}) : std::nullopt;
  }

 private:
  [[nodiscard]] bool has_child(JointIndex joint, std::initializer_list<Word> words) const {
    for (JointIndex child = joint + 1; child < skeleton_.subtree_end(joint); ++child) {
      if (skeleton_.parent(child) == joint && std::find(words.begin(), words.end(), words_[idx(child)]) != words.end()) return true;
    }
    return false;
  }

  [[nodiscard]] bool has_ancestor(JointIndex joint, std::initializer_list<Word> words) const {
    for (joint = skeleton_.parent(joint); joint != kNoParent; joint = skeleton_.parent(joint)) {
      if (std::find(words.begin(), words.end(), words_[idx(joint)]) != words.end()) return true;
    }
    return false;
  }

  [[nodiscard]] std::optional<BodyPart> limb_of(JointIndex joint, Word word) const {
    switch (word) {
      case Word::Shoulder:
        if (has_child(joint, {Word::Forearm})) return BodyPart::UpperArm;
        return std::nullopt;
      case Word::UpperArm:
      case Word::Arm: return BodyPart::UpperArm;
      case Word::Forearm: return BodyPart::Forearm;
      case Word::Hand: return BodyPart::Hand;
      case Word::Hip:
        if (has_child(joint, {Word::Shank, Word::Leg})) return BodyPart::Thigh;
        return std::nullopt;
      case Word::Thigh: return BodyPart::Thigh;
      case Word::Leg: return has_ancestor(joint, {Word::Thigh, Word::Hip}) ? BodyPart::Shank : BodyPart::Thigh;
      case Word::Shank: return BodyPart::Shank;
      case Word::Foot: return BodyPart::Foot;
      default: return std::nullopt;
    }
  }

  const Skeleton& skeleton_;
  std::vector<Word> words_;
};

}  // namespace

std::vector<std::optional<NamedPart>> find_named_parts(const Skeleton& skeleton) {
  const PartFinder finder(skeleton);
  std::vector<std::optional<NamedPart>> parts;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) parts.push_back(finder.part_of(joint));
  return parts;
}

std::vector<std::optional<NamedPart>> find_named_parts(const Skeleton& skeleton, std::span<const OwnPart> own) {
  std::vector<std::optional<NamedPart>> named = find_named_parts(skeleton);
  for (const OwnPart& said : own) {
    if (!said.part || *said.part == BodyPart::Trunk) continue;
    for (std::optional<NamedPart>& other : named) {
      if (other && other->part == *said.part && other->side == said.side) other.reset();
    }
  }
  for (const OwnPart& said : own) {
    if (said.joint < 0 || said.joint >= skeleton.joint_count()) continue;
    const bool is_limb = said.part && *said.part != BodyPart::Trunk && *said.part != BodyPart::Head;
    named[idx(said.joint)] = said.part ? std::optional(NamedPart{*said.part, is_limb ? said.side : BodySide::Middle,
                                                                 is_limb && said.side == BodySide::Middle})
                                       : std::nullopt;
  }
  return named;
}

}  // namespace marey
