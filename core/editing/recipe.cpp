#include "core/editing/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/counted.h"
#include "core/base/number_text.h"
#include "core/editing/name_match.h"

namespace marey {
namespace {

constexpr std::string_view kTargetWords[] = {"joints", "channels", "frames", "blend-in", "blend-out", "weight"};
constexpr double kMostBlendFrames = 1e6;

Error error_at(int column, std::string message, std::string expected = {}, std::string found = {}) {
  const TextPlace place = column > 0 ? TextPlace{1, column} : TextPlace{};
  return {DiagnosticCode::InvalidArgument, place, std::move(message), std::move(expected), std::move(found)};
}

Error error_of(const RecipeWord& word, std::string message, std::string expected) {
  return error_at(word.column, std::move(message), std::move(expected), word.value);
}

std::optional<double> parse_number(std::string_view text) {
  const NumberRead read = read_number(text);
  const bool is_number = !text.empty() && read.length == text.size() && std::isfinite(read.value);
  return is_number ? std::optional(read.value) : std::nullopt;
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

/// Finds what the words of a step mean for a clip.
class Binder {
 public:
  Binder(const RecipeStep& step, const Clip& clip) : step_(step), clip_(clip) {}

  Result<BoundStep> bind() {
    bound_.operation = find_operation(step_.operation);
    if (bound_.operation == nullptr) return unknown_operation();
    bound_.target = whole_clip(clip_);
    bound_.values = initial_values(*bound_.operation);
    for (std::size_t i = 0; i < step_.words.size(); ++i) {
      if (Status status = check_first(i); !status) return status.error();
      if (Status status = bind_word(step_.words[i]); !status) return status.error();
    }
    if (Status status = check_file(); !status) return status.error();
    choose_channels();
    return std::move(bound_);
  }

 private:
  [[nodiscard]] Error unknown_operation() const {
    std::vector<std::string_view> ids;
    for (const Operation& operation : operations()) ids.push_back(operation.id);
    return error_at(1, fmt::format("'{}' is no operation.{}", step_.operation, suggestion(step_.operation, ids)),
                    "the name of an operation", step_.operation);
  }

  [[nodiscard]] Status check_first(std::size_t i) const {
    const RecipeWord& word = step_.words[i];
    const auto is_same = [&](const RecipeWord& other) { return other.name == word.name; };
    const auto before = step_.words.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::none_of(step_.words.begin(), before, is_same)) return {};
    return error_at(word.column, fmt::format("'{}' stands twice.", word.name), "each word once", word.name);
  }

  [[nodiscard]] Status check_file() const {
    for (const OperationParameter& parameter : bound_.operation->parameters) {
      if (parameter.kind != ParameterKind::File || !bound_.other_file.empty()) continue;
      return error_at(0, fmt::format("'{}' wants a file as '{}'.", bound_.operation->id, parameter.name),
                      fmt::format("{}=FILE", parameter.name), "");
    }
    return {};
  }

  Status bind_word(const RecipeWord& word) {
    const int place = find_parameter(*bound_.operation, word.name);
    if (place >= 0) return bind_parameter(word, static_cast<std::size_t>(place));
    if (word.name == "joints") return bind_joints(word);
    if (word.name == "channels") return bind_channels(word);
    if (word.name == "frames") return bind_frames(word);
    if (word.name == "weight") return bind_target_number(word, 1.0, false, bound_.target.weight);
    double frames = 0.0;
    if (word.name != "blend-in" && word.name != "blend-out") return unknown_word(word);
    if (Status status = bind_target_number(word, kMostBlendFrames, true, frames); !status) return status;
    (word.name == "blend-in" ? bound_.target.blend_in_frames : bound_.target.blend_out_frames) = static_cast<int>(frames);
    return {};
  }

  [[nodiscard]] Error unknown_word(const RecipeWord& word) const {
    std::vector<std::string_view> names;
    for (const OperationParameter& parameter : bound_.operation->parameters) names.push_back(parameter.name);
    names.insert(names.end(), std::begin(kTargetWords), std::end(kTargetWords));
    const std::string expected = fmt::format("{}", fmt::join(names, ", "));
    return error_at(word.column,
                    fmt::format("'{}' has no '{}', but {}.{}", bound_.operation->id, word.name, expected,
                                suggestion(word.name, names)),
                    expected, word.name);
  }

  Status bind_parameter(const RecipeWord& word, std::size_t place) {
    const OperationParameter& parameter = bound_.operation->parameters[place];
    if (is_text(parameter.kind)) {
      bound_.values.texts[place] = word.value;
      if (parameter.kind == ParameterKind::File) bound_.other_file = word.value;
      return {};
    }
    const Result<double> value = parse_value(word, parameter);
    if (!value) return value.error();
    if (const Status status = check_value(parameter, *value); !status) {
      return error_of(word, status.error().message, std::string(parameter.label));
    }
    bound_.values.numbers[place] = *value;
    return {};
  }

  [[nodiscard]] static Result<double> parse_value(const RecipeWord& word, const OperationParameter& parameter) {
    static constexpr std::string_view kAxisNames[] = {"x", "y", "z"};
    static constexpr std::string_view kYesNo[] = {"no", "yes"};
    if (parameter.kind == ParameterKind::Choice) return parse_choice(word, parameter.choices);
    if (parameter.kind == ParameterKind::Axis) return parse_choice(word, kAxisNames);
    if (parameter.kind == ParameterKind::YesNo) return parse_choice(word, kYesNo);
    const std::optional<double> number = parse_number(word.value);
    if (!number) return error_of(word, fmt::format("'{}' is a number, not \"{}\".", word.name, word.value), "a number");
    return parameter.kind == ParameterKind::Frame ? *number - 1.0 : *number;
  }

  [[nodiscard]] static Result<double> parse_choice(const RecipeWord& word, std::span<const std::string_view> choices) {
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (word.value == choices[i]) return static_cast<double>(i);
    }
    const std::string expected = fmt::format("{}", fmt::join(choices, ", "));
    return error_of(word, fmt::format("'{}' is one of {}, not \"{}\".{}", word.name, expected, word.value,
                                      suggestion(word.value, choices)), expected);
  }

  static Status bind_target_number(const RecipeWord& word, double most, bool whole, double& out) {
    const std::optional<double> number = parse_number(word.value);
    const bool fits = number && *number >= 0.0 && *number <= most && (!whole || *number == std::floor(*number));
    if (!fits) {
      const std::string expected = fmt::format("a {}number from 0 to {}", whole ? "whole " : "", most);
      return error_of(word, fmt::format("'{}' is {}, not \"{}\".", word.name, expected, word.value), expected);
    }
    out = *number;
    return {};
  }

  Status bind_joints(const RecipeWord& word) {
    std::vector<bool> chosen(idx(clip_.skeleton.joint_count()));
    std::vector<std::string_view> names;
    for (JointIndex joint = 0; joint < clip_.skeleton.joint_count(); ++joint) names.emplace_back(clip_.skeleton.name(joint));
    for (const std::string_view pattern : split_at_commas(word.value)) {
      bool found = false;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] != pattern && !matches_pattern(pattern, names[i])) continue;
        chosen[i] = true;
        found = true;
      }
      if (!found) {
        return error_of(word, fmt::format("No joint is called \"{}\".{}", pattern, suggestion(pattern, names)),
                        "names or patterns of joints");
      }
    }
    std::erase_if(bound_.target.joints, [&](JointIndex joint) { return !chosen[idx(joint)]; });
    return {};
  }

  [[nodiscard]] std::string keyword_of(ChannelIndex channel) const {
    const Channel& c = clip_.skeleton.channel(channel);
    return c.kind == ChannelKind::Other ? c.other_name : std::string(channel_keyword(c.kind));
  }

  Status bind_channels(const RecipeWord& word) {
    std::vector<std::string> keywords;
    std::vector<std::string> labels;
    for (ChannelIndex channel = 0; channel < clip_.skeleton.channel_count(); ++channel) {
      keywords.push_back(keyword_of(channel));
      labels.push_back(channel_label(clip_.skeleton, channel));
    }
    channels_.assign(keywords.size(), false);
    for (const std::string_view pattern : split_at_commas(word.value)) {
      bool found = false;
      for (std::size_t i = 0; i < keywords.size(); ++i) {
        if (!matches_pattern(pattern, keywords[i]) && !matches_pattern(pattern, labels[i])) continue;
        channels_[i] = true;
        found = true;
      }
      if (!found) {
        const std::vector<std::string_view> names(keywords.begin(), keywords.end());
        return error_of(word, fmt::format("No channel is called \"{}\".{}", pattern, suggestion(pattern, names)),
                        "names or patterns of channels");
      }
    }
    return {};
  }

  Status bind_frames(const RecipeWord& word) {
    const int frame_count = clip_.motion.frame_count();
    const std::string_view text = word.value;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view first_text = text.substr(0, colon);
    const std::string_view last_text = colon < text.size() ? text.substr(colon + 1) : first_text;
    const auto first = first_text.empty() && colon < text.size() ? std::optional(1.0) : parse_number(first_text);
    const auto last = last_text.empty() && colon < text.size() ? std::optional<double>(frame_count) : parse_number(last_text);
    const bool whole = first && last && *first == std::floor(*first) && *last == std::floor(*last);
    if (!whole || *first < 1.0 || *last < *first) {
      return error_of(word, fmt::format("\"{}\" is not FIRST:LAST, counted from 1, such as 10:60.", text), "FIRST:LAST");
    }
    if (*last > frame_count) {
      return error_of(word, fmt::format("The clip has {}, so {} cannot be taken.", counted(frame_count, "frame"), text),
                      fmt::format("frames up to {}", frame_count));
    }
    bound_.target.frames = {static_cast<int>(*first) - 1, static_cast<int>(*last - *first) + 1};
    return {};
  }

  // Those of the chosen joints that were chosen themselves; and then only the joints that own them.
  void choose_channels() {
    OperationTarget& target = bound_.target;
    std::erase_if(target.channels, [&](ChannelIndex channel) {
      const JointIndex joint = clip_.skeleton.channel(channel).joint;
      const bool is_chosen = channels_.empty() || channels_[idx(channel)];
      return !is_chosen || !std::binary_search(target.joints.begin(), target.joints.end(), joint);
    });
    if (channels_.empty()) return;
    std::vector<JointIndex> owners;
    for (const ChannelIndex channel : target.channels) owners.push_back(clip_.skeleton.channel(channel).joint);
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    target.joints = std::move(owners);
  }

  const RecipeStep& step_;
  const Clip& clip_;
  BoundStep bound_;
  std::vector<bool> channels_;  // chosen ones; empty: all
};

}  // namespace

Result<RecipeStep> parse_recipe_step(std::string_view text) {
  RecipeStep step;
  std::size_t at = 0;
  while (true) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    if (at == text.size()) break;
    const int column = static_cast<int>(at) + 1;
    std::string word;
    char quote = 0;
    for (; at < text.size() && (quote != 0 || std::string_view(" \t\r\n").find(text[at]) == std::string_view::npos); ++at) {
      const bool is_quote = quote != 0 ? text[at] == quote : text[at] == '"' || text[at] == '\'';
      if (!is_quote) word += text[at];
      if (is_quote) quote = quote != 0 ? '\0' : text[at];
    }
    if (quote != 0) return error_at(column, "A quote is not closed.", "a closing quote", word);
    const std::size_t equals = word.find('=');
    if (step.operation.empty()) {
      if (equals != std::string::npos) return error_at(column, fmt::format("\"{}\" stands where the name of an operation is expected.", word), "an operation", word);
      step.operation = word;
    } else if (equals == std::string::npos || equals == 0) {
      return error_at(column, fmt::format("\"{}\" is not NAME=VALUE, such as frames=10:60.", word), "NAME=VALUE", word);
    } else {
      step.words.push_back({word.substr(0, equals), word.substr(equals + 1), column});
    }
  }
  if (step.operation.empty()) return error_at(1, "The step names no operation.", "an operation", "");
  return step;
}

Result<BoundStep> bind_step(const RecipeStep& step, const Clip& clip) { return Binder(step, clip).bind(); }

std::span<const std::string_view> target_words() { return kTargetWords; }

}  // namespace marey
