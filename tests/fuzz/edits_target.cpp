#include <algorithm>
#include <cmath>

#include "core/bvh/reader.h"
#include "tests/fuzz/edit_script.h"
#include "tests/fuzz/soundness.h"
#include "tests/support/same_bits.h"

namespace marey::test {
namespace {

constexpr std::string_view kOwnClip =
    "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 4 Xposition Zrotation Xrotation Yrotation\n  JOINT Chest\n  {\n"
    "    OFFSET 0 5 0\n    CHANNELS 1 Zrotation\n    End Site\n    {\n      OFFSET 0 6 0\n    }\n  }\n}\n"
    "MOTION\nFrames: 6\nFrame Time: 0.04\n"
    "0 1.50 2 -3 1e-3\n0 1.25 2 -4 2e-3\n0.5 1.00 2 -5 3e-3\n0 0.75 2  -6 4e-3\n0 0.50 2 -7 5e-3\n0 0.25 2 -8 6e-3\n";

/// Drives a document by a script, and takes all of it back.
class EditRun {
 public:
  EditRun(std::string_view script, BvhClip clip)
      : script_(script), document_(std::move(clip), "fuzz.bvh"), opened_(bits_of(document_.clip())),
        opened_text_(document_.save_text()) {}

  Harm find_harm();

 private:
  void take_step();
  void take_gesture();
  [[nodiscard]] Harm find_harm_in_saved_text() const;
  [[nodiscard]] Harm find_harm_in_history();

  InputBytes script_;
  Document document_;
  std::vector<std::uint64_t> opened_;
  std::string opened_text_;
  GestureId last_gesture_ = 0;
};

void EditRun::take_step() {
  switch (script_.take_below(8)) {
    case 0: document_.undo(); break;
    case 1: document_.redo(); break;
    case 2: document_.mark_saved(); break;
    case 3:
    case 4: take_gesture(); break;
    default: (void)document_.apply(take_edit(script_, document_.clip())); break;
  }
}

void EditRun::take_gesture() {
  const GestureId gesture = ++last_gesture_;
  const int choice = script_.take_byte();
  for (int states = choice % 4; states >= 0; --states) {
    (void)document_.apply_gesture(gesture, [&](const Clip& clip) { return take_edit(script_, clip); });
  }
  if ((choice & 16) != 0) document_.mark_saved();
  if ((choice & 32) != 0) document_.cancel_gesture(gesture);
}

Harm EditRun::find_harm_in_saved_text() const {
  const std::string text = document_.save_text();
  const Result<BvhClip> again = read_bvh(text);
  if (!again) return "the edited clip cannot be read again: " + again.error().message + "\n" + text;
  return same_numbers(document_.skeleton(), document_.motion(), again->skeleton, again->motion)
             ? std::nullopt
             : Harm("the edited clip is saved as another one\n" + text);
}

Harm EditRun::find_harm_in_history() {
  const std::vector<std::uint64_t> edited = bits_of(document_.clip());
  const std::string edited_text = document_.save_text();
  const int undone = document_.history().redo_depth();
  int steps = 0;
  for (; document_.undo(); ++steps) (void)document_.find_changes();
  if (bits_of(document_.clip()) != opened_) return "undone to the start, the clip is not what was opened";
  if (document_.save_text() != opened_text_) return "undone to the start, the saved text is not what it was";
  for (; steps > 0; --steps) {
    if (!document_.redo()) return "a step cannot be done again";
  }
  if (bits_of(document_.clip()) != edited) return "done again, the clip is not what it was";
  if (document_.save_text() != edited_text) return "done again, the saved text is not what it was";
  return document_.history().redo_depth() == undone ? std::nullopt : Harm("steps that were undone are lost");
}

Harm EditRun::find_harm() {
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps && !script_.empty(); ++step) {
    take_step();
    const Motion& motion = document_.motion();
    const auto samples = motion.samples();
    if (motion.channel_count() != document_.skeleton().channel_count()) return "an edit changed the number of channels";
    if (!std::all_of(samples.begin(), samples.end(), [](double v) { return std::isfinite(v); })) return "an edit let in what is not finite";
    if (document_.declared_frames() < 0 || document_.diagnostics().count(Severity::Error) < 0) return "what was opened has changed";
  }
  if (Harm harm = find_harm_in_saved_text()) return harm;
  return find_harm_in_history();
}

}  // namespace

Harm find_harm_in_edits(std::string_view input) {
  constexpr int kMostFrames = 400;
  const std::size_t clip_begin = std::min(input.find("HIERARCHY"), input.size());
  const std::string_view text = clip_begin < input.size() ? input.substr(clip_begin) : kOwnClip;
  Result<BvhClip> clip = read_bvh(text);
  if (!clip || clip->motion.frame_count() > kMostFrames) return std::nullopt;
  return EditRun(input.substr(0, clip_begin), std::move(*clip)).find_harm();
}

}  // namespace marey::test
