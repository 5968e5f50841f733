#include "tests/mujoco/mujoco_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/gtc/quaternion.hpp>

namespace marey::test {
namespace {

[[noreturn]] void give_up(const char* message) {
  std::fprintf(stderr, "MuJoCo: %s\n", message);
  std::exit(2);
}

std::string text_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

constexpr std::array kAxes = {"1 0 0", "0 1 0", "0 0 1"};

std::string name_of(const Freedom& freedom) {
  return fmt::format("J{}_{}{}", freedom.joint, static_cast<int>(freedom.kind), static_cast<int>(freedom.axis));
}

void write_freedom(const Freedom& freedom, std::string& text) {
  constexpr std::array kTypes = {"free", "slide", "hinge", "ball"};
  const auto kind = static_cast<std::size_t>(freedom.kind);
  text += fmt::format("<joint name='{}' type='{}'", name_of(freedom), kTypes[kind]);
  const bool has_axis = freedom.kind == FreedomKind::Slide || freedom.kind == FreedomKind::Hinge;
  text += has_axis ? fmt::format(" axis='{}'/>\n", kAxes[static_cast<std::size_t>(freedom.axis)]) : "/>\n";
}

/// Axes in which a tensor is diagonal, by Jacobi's rotations. MuJoCo's own search for them ends a millionth of a radian off.
glm::dquat principal_axes(const glm::dmat3& tensor) {
  constexpr int kSteps = 30;
  glm::dquat axes(1.0, 0.0, 0.0, 0.0);
  for (int step = 0; step < kSteps; ++step) {
    const glm::dmat3 turn = glm::mat3_cast(axes);
    const glm::dmat3 seen = glm::transpose(turn) * tensor * turn;
    int i = 0;
    for (int other = 1; other < 3; ++other) {
      if (std::abs(seen[other][(other + 1) % 3]) > std::abs(seen[i][(i + 1) % 3])) i = other;
    }
    const int k = (i + 1) % 3;
    glm::dvec3 about(0.0);
    about[(i + 2) % 3] = 1.0;
    axes = glm::normalize(axes * glm::angleAxis(0.5 * std::atan2(2.0 * seen[i][k], seen[i][i] - seen[k][k]), about));
  }
  return axes;
}

void write_inertial(const Segment& segment, std::string& text) {
  const glm::dquat axes = principal_axes(segment.inertia_kgm2);
  const glm::dmat3 turn = glm::mat3_cast(axes);
  const glm::dmat3 moments = glm::transpose(turn) * segment.inertia_kgm2 * turn;
  text += fmt::format("<inertial pos='{}' mass='{}' diaginertia='{} {} {}' quat='{} {} {} {}'/>\n", text_of(segment.com_m),
                      segment.mass_kg, moments[0][0], moments[1][1], moments[2][2], axes.w, axes.x, axes.y, axes.z);
}

void write_segments(const BodyModel& model, JointIndex joint, std::string& text) {
  bool is_first = true;
  for (const Segment& segment : model.segments) {
    if (segment.joint != joint) continue;
    if (!is_first) text += "<body>\n";
    write_inertial(segment, text);
    if (!is_first) text += "</body>\n";
    is_first = false;
  }
  if (is_first) text += fmt::format("<inertial pos='0 0 0' mass='{0}' diaginertia='{0} {0} {0}'/>\n", kSpeck);
}

/// From memory: MuJoCo reads files only, but not only those of the disk.
mjModel* load(const std::string& text) {
  mju_user_error = give_up;
  mju_user_warning = give_up;
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "figure.xml", size_of(text)) != 0) give_up("no room for the text");
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> message{};
  mjModel* model = mj_loadXML("figure.xml", files.get(), message.data(), static_cast<int>(message.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) give_up(message.data());
  return model;
}

int id_of(const mjModel* model, int type, const std::string& name) {
  const int id = mj_name2id(model, type, name.c_str());
  if (id < 0) give_up(name.c_str());
  return id;
}

}  // namespace

std::vector<Freedom> find_freedoms(const Skeleton& skeleton, TwoAxes two_axes) {
  const std::size_t most_hinges = two_axes == TwoAxes::Hinges ? 2 : 1;
  std::vector<Freedom> freedoms;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    std::vector<Freedom> sliding;
    std::vector<Axis> turning;
    for (const Channel& channel : skeleton.channels(joint)) {
      if (is_position(channel.kind)) sliding.push_back({joint, FreedomKind::Slide, axis_of(channel.kind), 0, 0});
      if (is_rotation(channel.kind)) turning.push_back(axis_of(channel.kind));
    }
    if (skeleton.parent(joint) == kNoParent && sliding.size() == 3 && turning.size() > most_hinges) {
      freedoms.push_back({joint, FreedomKind::Free, Axis::X, 0, 0});
      continue;
    }
    freedoms.insert(freedoms.end(), sliding.begin(), sliding.end());
    if (turning.size() > most_hinges) {
      freedoms.push_back({joint, FreedomKind::Turn, Axis::X, 0, 0});
      continue;
    }
    for (const Axis axis : turning) freedoms.push_back({joint, FreedomKind::Hinge, axis, 0, 0});
  }
  return freedoms;
}

std::string write_mjcf(const Clip& clip, const BodyModel& model, const glm::dvec3& gravity_mps2,
                       const std::vector<Freedom>& freedoms) {
  const Skeleton& skeleton = clip.skeleton;
  std::string text = "<mujoco>\n<compiler angle='radian'/>\n";
  text += fmt::format("<option gravity='{}'><flag energy='enable'/></option>\n<worldbody>\n", text_of(gravity_mps2));
  int depth = 0;
  const auto close_down_to = [&](int end) {
    for (; depth > end; --depth) text += "</body>\n";
  };
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    close_down_to(skeleton.depth(joint));
    ++depth;
    text += fmt::format("<body name='J{}' pos='{}'>\n", joint, text_of(clip.settings.metres_per_unit * skeleton.offset(joint)));
    for (const Freedom& freedom : freedoms) {
      if (freedom.joint == joint) write_freedom(freedom, text);
    }
    write_segments(model, joint, text);
  }
  close_down_to(0);
  return text + "</worldbody>\n</mujoco>\n";
}

MujocoFigure::MujocoFigure(const Clip& clip, const BodyModel& model, const glm::dvec3& gravity_mps2, TwoAxes two_axes)
    : freedoms_(find_freedoms(clip.skeleton, two_axes)),
      model_(load(write_mjcf(clip, model, gravity_mps2, freedoms_))),
      data_(mj_makeData(model_.get())) {
  for (Freedom& freedom : freedoms_) {
    const int id = id_of(model_.get(), mjOBJ_JOINT, name_of(freedom));
    freedom.position = model_->jnt_qposadr[id];
    freedom.velocity = model_->jnt_dofadr[id];
  }
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
    bodies_.push_back(id_of(model_.get(), mjOBJ_BODY, fmt::format("J{}", joint)));
  }
}

}  // namespace marey::test
