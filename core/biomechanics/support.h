#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "core/biomechanics/mechanics.h"
#include "core/math/axis.h"

namespace marey {

/// What holds a body.
enum class SupportKind {
  Pivot,   ///< its root is held by a bar or a joint with the world
  Flight,  ///< nothing: what the root would need is a residual
  Ground,  ///< a floor beneath what touches it
  Auto,    ///< a pivot where the root stands still; else ground in frames with a contact and flight in the others
};

/// A point of the body that can touch the floor: a node without children.
struct ContactPoint {
  JointIndex joint = 0;       ///< whose segment it belongs to
  glm::dvec3 local_m{0.0};    ///< from the joint's origin, in its axes
  NodeIndex node = 0;         ///< the joint itself, or its end site
};

/// When a point touches the floor: near it and slow, with other limits for ending than for beginning.
struct ContactLimits {
  double begin_height_m = 0.03;
  double end_height_m = 0.05;
  double begin_speed_mps = 0.3;
  double end_speed_mps = 0.5;
  double least_duration_s = 0.1;  ///< shorter contacts, and shorter gaps between contacts, are none
};

/// Floor and contacts of a clip.
struct Contacts {
  double floor_m = 0.0;              ///< height of the floor, in the world
  std::vector<ContactPoint> points;
  std::vector<std::uint8_t> down;    ///< [frame][point]: 1 where the point touches

  [[nodiscard]] bool is_down(FrameIndex frame, std::size_t point) const { return down[idx(frame) * points.size() + point] != 0; }
  [[nodiscard]] bool any_down(FrameIndex frame) const;
};

/// What a body was found to be held by, for all frames of a clip.
struct SettledSupport {
  SupportKind kind = SupportKind::Flight;  ///< never Auto
  bool follows_contacts = false;           ///< ground in frames with a contact, flight in the others
  Contacts contacts;

  /// That of some of the frames.
  [[nodiscard]] SettledSupport of_frames(FrameRange frames) const;
  /// Whether the ground holds the body at a frame.
  [[nodiscard]] bool is_ground(FrameIndex frame) const {
    return kind == SupportKind::Ground && (!follows_contacts || contacts.any_down(frame));
  }
};

/// The floor is the height that the lowest point of the body has in most frames: the median of the lowest heights of frames in
/// which that point is slow, the lowest height of all if it never is.
[[nodiscard]] Contacts find_contacts(const BodyMotion& body, const Skeleton& skeleton, Axis up, const ContactLimits& limits = {});

/// The contacts with what people say of them in place of what was found, the later word counting where two differ. Frames and
/// points that there are not are passed over.
[[nodiscard]] Contacts apply_own_contacts(Contacts found, std::span<const OwnContact> own);

/// The points that can touch the floor at a node and beneath it, or of the whole figure with kNoParent: nodes without children,
/// rising.
[[nodiscard]] std::vector<NodeIndex> find_contact_nodes(const Skeleton& skeleton, NodeIndex node);

/// One for each point at and beneath the first node that node_label() names so. Errors: InvalidArgument where there is none, and
/// for frames that do not follow one another.
[[nodiscard]] Result<std::vector<OwnContact>> make_own_contacts(const Skeleton& skeleton, std::string_view label, FrameIndex first,
                                                                FrameIndex last, bool touches);

/// Whether no root moves by more than a thousandth of the figure's stature.
[[nodiscard]] bool roots_stand_still(const BodyMotion& body, const Skeleton& skeleton);
/// The same of the samples as they are; missing ones do not count.
[[nodiscard]] bool roots_stand_still(const Clip& clip);

/// The force of the floor on the body at one frame, as it must be for the body to move as it does.
struct GroundReaction {
  glm::dvec3 force{0.0};
  glm::dvec3 centre_of_pressure{0.0};  ///< on the floor; not finite where the force does not press
};

[[nodiscard]] GroundReaction find_ground_reaction(const BodyState& state, double mass_kg, const glm::dvec3& gravity_mps2, Axis up,
                                                  double floor_m);

/// The reaction, shared out among the points that are down: by the inverse of their distances from the centre of pressure,
/// which for two points is the lever rule. An estimate wherever there are more than one. The moments that are left go along
/// in the same shares, so that together they are the reaction to the last digit.
[[nodiscard]] std::vector<OuterForce> share_out(const GroundReaction& reaction, const BodyState& state, const BodyMotion& body,
                                                const Contacts& contacts, FrameIndex frame);

/// Null for an unknown name: "pivot", "flight", "ground", "auto".
[[nodiscard]] const SupportKind* find_support_kind(std::string_view name);
[[nodiscard]] std::string_view support_name(SupportKind kind);

}  // namespace marey
