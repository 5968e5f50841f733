#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/biomechanics/passive_chain.h"
#include "core/editing/operation.h"
#include "core/motion/clip.h"

namespace marey {

/// How a figure is let go.
struct LetGoChoice {
  enum class Root { Auto, Held, Free };
  FrameIndex frame = 0;  ///< the last that stays
  double seconds = 5.0;
  Root root = Root::Auto;  ///< Auto: held where the root stands still
  bool is_moving = true;   ///< begins with the speeds of the clip, else at rest
};

/// What the values of the operation "let-go" say.
[[nodiscard]] LetGoChoice let_go_choice(const Operation& operation, const OperationValues& values);

/// A clip whose figure gravity alone moves from a frame on, some frames at a time, so that who shows it can go on answering.
class LetGo {
 public:
  /// Precondition: the frame is one of the clip's. Errors: those of find_chain_state(), find_chosen_body() and
  /// PassiveChain::make(); InvalidArgument for a figure that is to fall and has no channels to, and for too many frames.
  [[nodiscard]] static Result<LetGo> make(const Clip& clip, const LetGoChoice& choice);

  [[nodiscard]] int done() const { return passive_.frame_count(); }
  [[nodiscard]] int all() const { return frame_count_; }
  /// Moves on by so many frames, or to the end. Error InvalidArgument where the figure runs away.
  [[nodiscard]] Status advance(int frames);
  /// A measure of the work done so far: how often the accelerations of a joint were found.
  [[nodiscard]] std::int64_t work() const { return chain_.evaluation_count() * chain_.joint_count(); }

  /// The frames behind the one that stays, as far as they are done. `clip` is that of make(), unchanged.
  [[nodiscard]] Motion frames(const Clip& clip) const;
  /// How far energy drifted, and what masses were taken, in sentences.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  LetGo(PassiveChain chain, ChainState state) : chain_(std::move(chain)), state_(std::move(state)) {}

  PassiveChain chain_;
  ChainState state_;  // at the start
  PassiveMotion passive_;
  FrameIndex start_ = 0;
  int frame_count_ = 0;
  double frame_time_s_ = 0.0;
  bool is_held_ = true;
  std::string body_;  // "73 kg by deleva-male"
};

}  // namespace marey
