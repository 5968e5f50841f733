#pragma once

#include <span>
#include <vector>

#include "core/motion/key_curve.h"

namespace marey {

/// Two keys nearer to each other than this are one, frames.
inline constexpr double kSameKeyFrames = 1e-6;

/// Position of the key at a frame; -1 where there is none.
[[nodiscard]] int find_key_at(const KeyCurve& curve, double frame);

/// Gives the key at a frame a value; a key that was not there yet is like the key before it, with AutoClamped handles.
/// Returns its position.
int set_key(KeyCurve& curve, double frame, double value);

/// Puts a key on the curve as it is. Between two keys the curve keeps its shape: handles that face the new key are set
/// where they followed from the keys around. Returns its position. Precondition: the curve has a key.
int insert_key(KeyCurve& curve, double frame);

/// Takes keys away whose frames lie in [first, last]. All of them may go.
void delete_keys(KeyCurve& curve, double first, double last);

/// Moves some keys, given by rising positions, in time and value. Keys that stay give way where one comes to lie on them.
void move_keys(KeyCurve& curve, std::span<const int> keys, double frames, double value);

/// Sets how the curve runs behind the keys in [first, last].
void set_interpolation(KeyCurve& curve, double first, double last, Interpolation interpolation);

/// Sets both handles of the keys in [first, last]; kinds that are set start as they are in effect. Aligned handles get the
/// mean of both slopes.
void set_handle_kinds(KeyCurve& curve, double first, double last, HandleKind kind);

enum class HandleSide : std::uint8_t { Left, Right };

/// Pulls a handle. One that followed from the keys around becomes Aligned with the other one; an Aligned one turns the
/// other with it; a Free one moves alone. A handle on the wrong side is put upright.
void pull_handle(KeyCurve& curve, int key, HandleSide side, Handle handle);

}  // namespace marey
