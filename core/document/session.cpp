#include "core/document/session.h"

#include <utility>

namespace marey {
namespace {

Error refusal_of_partial() {
  return {DiagnosticCode::InvalidArgument, {}, "The file is still being read. Wait for its end, then edit.", "", ""};
}

void follow_clip(Session& session) {
  const Motion& motion = session.document.motion();
  session.selection.follow(session.document.skeleton());
  if (motion.frame_count() != session.playback.frame_count()) session.selection.change_samples().clear();
  const int layers = size_of(session.document.clip().stack.layers);
  if (session.active_layer >= layers) session.active_layer = layers == 0 ? kOwnKeys : layers - 1;
  session.playback.set_clip(motion.frame_count(), motion.frame_time_s());
}

}  // namespace

Session Session::open(BvhClip clip, std::string file_name) {
  Session session;
  session.document = Document(std::move(clip), std::move(file_name));
  session.selection = Selection(session.document.skeleton());
  const Motion& motion = session.document.motion();
  session.playback = Playback(motion.frame_count(), motion.frame_time_s());
  return session;
}

void Session::put_beside(std::shared_ptr<const OtherClip> other) {
  others.push_back(std::move(other));
  if (size_of(others) > kMostOtherClips) others.erase(others.begin());
  ++others_serial;
}

void Session::take_away(int other) {
  others.erase(others.begin() + other);
  ++others_serial;
}

Status Session::apply(Edit edit) {
  if (is_partial) return refusal_of_partial();
  Status status = document.apply(std::move(edit));
  follow_clip(*this);
  return status;
}

Status Session::apply_gesture(GestureId gesture, const History::MakeEdit& make_edit) {
  if (is_partial) return refusal_of_partial();
  Status status = document.apply_gesture(gesture, make_edit);
  follow_clip(*this);
  return status;
}

void Session::cancel_gesture(GestureId gesture) {
  document.cancel_gesture(gesture);
  follow_clip(*this);
}

bool Session::undo() {
  const bool undone = document.undo();
  follow_clip(*this);
  return undone;
}

bool Session::redo() {
  const bool redone = document.redo();
  follow_clip(*this);
  return redone;
}

}  // namespace marey
