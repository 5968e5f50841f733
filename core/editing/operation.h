#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/editing/edit.h"
#include "core/editing/operation_target.h"

namespace marey {

class LetGo;

enum class ParameterKind : std::uint8_t {
  Number,
  Whole,   ///< a number without fraction
  Frame,   ///< a frame, counted from 0; people count from 1
  Choice,  ///< one of `choices`; as a number: its place among them
  Axis,    ///< X, Y or Z; as a number 0, 1 or 2
  YesNo,   ///< as a number 1 or 0
  Points,  ///< pairs of frames "1:1,50:80", counted from 1
  File,    ///< another clip
  Text,    ///< any words
};

/// Whether a value of this kind stands in OperationValues::texts; else it is a number.
[[nodiscard]] constexpr bool is_text(ParameterKind kind) { return kind >= ParameterKind::Points; }

/// One thing that an operation wants to know.
struct OperationParameter {
  std::string_view name{};   ///< for programs and recipes: "sigma"
  std::string_view label{};  ///< for people: "Width"
  std::string_view unit{};   ///< "frames", "Hz", "degrees or file units", ""
  std::string_view help{};   ///< a sentence
  ParameterKind kind = ParameterKind::Number;
  double initial = 0.0;  ///< what a slider starts with, and what counts where nothing is given
  double least = 0.0;    ///< the range, ends included
  double most = 0.0;
  std::span<const std::string_view> choices{};
  bool odd = false;  ///< a whole number that is odd
};

/// The values of an operation's parameters, one for each in their order.
struct OperationValues {
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< of the kinds that are texts, as they were given; "" for the others
  const Clip* other = nullptr;     ///< the clip that a File names; outlives the call
  const LetGo* let_go = nullptr;   ///< of the same clip and values, done to the end: "let-go" then takes it; outlives the call
};

/// What an operation changes, so what a target has to say.
enum class OperationReach : std::uint8_t {
  Channels,  ///< samples of the channels of the target, curve by curve
  Joints,    ///< the same, but the channels of a joint belong together
  Roots,     ///< samples of the roots, whatever the channels of the target
  Frames,    ///< the frames of the target are added to, taken away or exchanged, with all channels
  Clip,      ///< the whole clip, whatever the target
  Figure,    ///< the joints of the target themselves, in all frames: channels, names, offsets
  Keys,      ///< keys of the target's channels, whatever its weight; samples follow in all frames
  Layers,    ///< the layers of the clip, whatever the target
};

struct OperationCall;

/// What an operation comes to.
struct OperationOutcome {
  Edit edit;                       ///< empty if nothing changes
  std::vector<std::string> notes;  ///< sentences about what people should know of it
};

/// An operation as a value. The one table of them drives the command line, the page, the module and the manual.
struct Operation {
  std::string_view id{};     ///< "savitzky-golay"; it never changes its meaning
  std::string_view label{};  ///< "Savitzky-Golay"
  std::string_view group{};  ///< where menus show it: "Filter"
  std::string_view help{};   ///< a sentence
  OperationReach reach = OperationReach::Channels;
  std::span<const OperationParameter> parameters{};
  Result<OperationOutcome> (*make)(const OperationCall& call) = nullptr;  ///< called by make_operation_edit() alone
};

/// What Operation::make gets: everything fits the clip and the parameters.
struct OperationCall {
  const Clip& clip;
  const OperationTarget& target;
  const Operation& operation;
  const OperationValues& values;

  /// By the name of a parameter, which the operation has.
  [[nodiscard]] double number(std::string_view parameter) const;
  [[nodiscard]] int whole(std::string_view parameter) const { return static_cast<int>(number(parameter)); }
  [[nodiscard]] bool yes(std::string_view parameter) const { return number(parameter) != 0.0; }
  [[nodiscard]] std::string_view choice(std::string_view parameter) const;
  [[nodiscard]] const std::string& text(std::string_view parameter) const;
};

/// All operations, in the order of menus.
[[nodiscard]] std::span<const Operation> operations();

/// Null for an id that none has.
[[nodiscard]] const Operation* find_operation(std::string_view id);

/// The values that a slider starts with.
[[nodiscard]] OperationValues initial_values(const Operation& operation);

/// Where the parameter of this name stands; -1 if there is none.
[[nodiscard]] int find_parameter(const Operation& operation, std::string_view name);

/// Whether a number fits a parameter: within the range, whole and odd where it must be. Refused with InvalidArgument.
[[nodiscard]] Status check_value(const OperationParameter& parameter, double value);

/// Whether the values fit: as many as there are parameters, finite, within the ranges, whole where they must be. Refused
/// with InvalidArgument, the message names parameter, value and range.
[[nodiscard]] Status check_values(const Operation& operation, const OperationValues& values);

/// The change that an operation makes to a clip, reduced to what differs and checked, so that History::apply() takes it.
/// The clip stays as it is. A target without frames, without what the operation works on, or of weight 0 gives an empty
/// edit. Samples outside of the target stay to the bit; so do those that are not finite, but where an operation says
/// otherwise. Errors: InvalidArgument, NotFinite.
[[nodiscard]] Result<OperationOutcome> make_operation_edit(const Clip& clip, const Operation& operation,
                                                           const OperationTarget& target,
                                                           const OperationValues& values);

}  // namespace marey
