#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/motion/body_choice.h"

namespace marey {

inline constexpr int kBodyPartCount = 8;

/// "head", "upper arm" ...
[[nodiscard]] std::string_view body_part_name(BodyPart part);

/// Null for an unknown name: "deleva-male", "deleva-female", "winter", "rods".
[[nodiscard]] const BodyTable* find_body_table(std::string_view name);
[[nodiscard]] std::string_view body_table_name(BodyTable table);

/// A part as shares of the body and of its own length, from its proximal end on: the joint that carries it.
struct PartProportions {
  double length_mm = 0.0;  ///< of the average subject
  double mass = 0.0;       ///< of the body's, one side
  double com = 0.0;        ///< of the length
  double radius_sagittal = 0.0;      ///< of gyration about the axis from back to front, of the length
  double radius_transverse = 0.0;    ///< about the axis from side to side
  double radius_longitudinal = 0.0;  ///< about the bone
};

/// Ends of the parts: head from the seventh vertebra to the vertex (Head 2); trunk from mid hips to mid shoulders (Trunk 3);
/// shank to the ankle joint (Shank 2); hand to the fingertip (Hand 2). The foot has de Leva's mass, but centre and radius
/// of Winter (2009), half way from ankle to toe base and .475, as the heel is no joint of a BVH figure.
/// Winter's table has no radii about the bone, none of the trunk, and the head's centre at the ear canal: those are de Leva's, as
/// are the heights of the pieces of its trunk. Not of rods.
[[nodiscard]] const PartProportions& proportions_of(BodyTable table, BodyPart part);

/// Three pieces of a trunk, from mid hips to mid shoulders.
struct TrunkPiece {
  double end = 0.0;  ///< where it ends, of the trunk's length
  double mass = 0.0; ///< of the body's
  double com = 0.0;  ///< of the trunk's length
  double radius_sagittal = 0.0;  ///< of the trunk's length, as the others
  double radius_transverse = 0.0;
  double radius_longitudinal = 0.0;
};
[[nodiscard]] const std::array<TrunkPiece, 3>& trunk_pieces_of(BodyTable table);

/// How far above mid shoulders the seventh vertebra lies, in mm of the average subject.
[[nodiscard]] double neck_height_mm(BodyTable table);

}  // namespace marey
