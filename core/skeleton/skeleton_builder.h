#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// The only writer of Skeletons. Joints are opened and closed like the braces of a BVH hierarchy, so the result is in
/// depth-first order by construction and nesting depth costs no stack.
///
///     SkeletonBuilder builder;
///     builder.open_joint("Hips", {0, 0, 0});
///     builder.add_channel(ChannelKind::Zrotation);
///     builder.add_end_site({0, 10, 0});
///     builder.close_joint();
///     Result<Skeleton> skeleton = builder.build();
class SkeletonBuilder {
 public:
  /// Opens a joint below the innermost open joint, or a root when none is open. Names are bytes of a file, read as UTF-8
  /// until Skeleton::read_names_in() says otherwise.
  JointIndex open_joint(std::string name_bytes, const glm::dvec3& offset_file_units = glm::dvec3(0.0));
  /// Appends a channel to the innermost open joint. All channels of a joint come before its children.
  void add_channel(ChannelKind kind, std::string other_name = {});
  /// Adds an end site to the innermost open joint.
  NodeIndex add_end_site(const glm::dvec3& offset_file_units, std::string name_bytes = {});
  /// Closes the innermost open joint.
  void close_joint();

  /// Changes what was given on opening; for readers that learn the offset later.
  void set_offset(NodeIndex node, const glm::dvec3& offset_file_units);

  [[nodiscard]] int open_depth() const { return size_of(open_); }
  [[nodiscard]] int joint_count() const { return skeleton_.joint_count(); }
  [[nodiscard]] int channel_count() const { return skeleton_.channel_count(); }
  /// Innermost open joint; kNoParent when none is open.
  [[nodiscard]] JointIndex current_joint() const { return open_.empty() ? kNoParent : open_.back(); }

  /// The finished skeleton, or Error InvalidSkeleton: no joint, joints still open, more closed than opened, a channel
  /// outside of a joint or behind a child, an offset that is not finite. The builder is empty afterwards.
  [[nodiscard]] Result<Skeleton> build();

 private:
  Skeleton skeleton_;
  std::vector<JointIndex> open_;
  std::string defect_;
};

}  // namespace marey
