#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace marey {

/// Programs that read BVH strictly, or read it otherwise than Marey does. `docs/export-targets.md` tells of each.
enum class ExportTarget : std::uint8_t {
  Strict,
  Blender,
  Three,
  BvhView,
  Pybvh,
  MotionBuilder,
  SecondLife,
};

inline constexpr int kExportTargetCount = static_cast<int>(ExportTarget::SecondLife) + 1;

/// What a program may ask of a file. Everything exported also has what all programs like: no channels but positions and
/// rotations, positions before rotations, End Sites without names, at least one frame, numbers without exponents.
enum class Requirement : std::uint8_t {
  OneRoot,
  RootPositions,
  PositionsOfRootOnly,
  WholePositions,
  PositionsAddToOffset,
  NoRootOffset,
  ThreeRotations,
  ThreeRotationsOrNone,
  RotationOrderZxy,
  AsciiNames,
  WordNames,
  EndSites,
  NoInnerEndSites,
  ReferencePose,
};

inline constexpr int kRequirementCount = static_cast<int>(Requirement::ReferencePose) + 1;

/// What is fixed about a requirement.
struct RequirementTraits {
  Requirement requirement{};
  std::string_view id;        ///< for programs, e.g. "positions_of_root_only"; it never changes its meaning
  std::string_view sentence;  ///< what an exported file has, for people
};

[[nodiscard]] const RequirementTraits& traits_of(Requirement requirement);

/// One thing that a target asks for.
struct TargetNeed {
  Requirement requirement{};
  std::string_view reason;  ///< what the program does otherwise: a sentence
};

/// What is fixed about a target.
struct TargetTraits {
  ExportTarget target{};
  std::string_view id;        ///< for programs, e.g. "blender"; it never changes its meaning
  std::string_view name;      ///< for people
  std::string_view audience;  ///< whom the file is for: a sentence
  std::string_view source;    ///< where the needs are known from
  std::string_view remark;    ///< what no export can give: sentences, or empty
  std::span<const TargetNeed> needs;

  [[nodiscard]] bool asks_for(Requirement requirement) const;
};

[[nodiscard]] const TargetTraits& traits_of(ExportTarget target);

/// All targets, in the order of the enumeration.
[[nodiscard]] std::span<const TargetTraits> export_targets();

/// The target of an id, in any case.
[[nodiscard]] std::optional<ExportTarget> find_export_target(std::string_view id);

}  // namespace marey
