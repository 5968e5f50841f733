#include <utility>

#include "core/editing/let_go.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/frame_edit.h"

namespace marey {
namespace {

OperationOutcome finish(const OperationCall& call, const LetGo& let_go) {
  const FrameIndex start = call.whole("frame");
  Motion frames = let_go.frames(call.clip);
  std::vector<FrameIndex> file_frames(idx(frames.frame_count()), kNewFrame);
  OperationOutcome outcome;
  outcome.edit = make_frames_edit(call, {start + 1, call.clip.motion.frame_count() - start - 1}, std::move(frames), std::move(file_frames));
  outcome.notes = let_go.notes();
  return outcome;
}

Result<OperationOutcome> make_let_go(const OperationCall& call) {
  if (call.values.let_go != nullptr) return finish(call, *call.values.let_go);
  Result<LetGo> let_go = LetGo::make(call.clip, let_go_choice(call.operation, call.values));
  if (!let_go) return let_go.error();
  if (Status status = let_go->advance(let_go->all()); !status) return status.error();
  return finish(call, *let_go);
}

constexpr std::string_view kRoots[] = {"auto", "held", "free"};
constexpr std::string_view kStarts[] = {"as-it-moves", "at-rest"};
constexpr OperationParameter kLetGo[] = {
    {.name = "frame", .label = "From frame", .help = "The last frame that stays; the figure is let go in its pose.",
     .kind = ParameterKind::Frame, .initial = 0.0, .least = 0.0, .most = 1e9},
    {.name = "seconds", .label = "Duration", .unit = "s", .help = "How long it is watched.", .initial = 5.0, .least = 0.01,
     .most = 60.0},
    {.name = "root", .label = "Root", .help = "It hangs on its root or falls; by itself it hangs where the root stands still.",
     .kind = ParameterKind::Choice, .most = 2.0, .choices = kRoots},
    {.name = "start", .label = "Start", .help = "With the speeds that the clip has there, or with none.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kStarts}};

constexpr Operation kMechanics[] = {
    {.id = "let-go", .label = "Let go", .group = "Mechanics",
     .help = "From a frame on, gravity alone moves the figure, without muscles and without a floor.",
     .reach = OperationReach::Clip, .parameters = kLetGo, .make = make_let_go}};

}  // namespace

std::span<const Operation> mechanics_operations() { return kMechanics; }

}  // namespace marey
