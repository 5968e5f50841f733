#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/interchange/export_target.h"

namespace marey::app {

enum class SavedForm : std::uint8_t { Bvh, ChannelTable, PositionTable };

/// What a copy is to be like.
struct SaveAs {
  SavedForm form = SavedForm::Bvh;
  std::optional<ExportTarget> target;  ///< of a BVH; nothing: as the file is
  SaveOptions options;                 ///< a table takes its frames only
  friend bool operator==(const SaveAs&, const SaveAs&) = default;
};

/// "walk-blender.bvh", "walk-positions.csv"; the download's own name for a BVH as the file is.
[[nodiscard]] std::string copy_name(const Document& document, const SaveAs& wanted);

/// In what the copy will differ from what was opened, as sentences; none when it is the same. Runs the export that it
/// tells of.
[[nodiscard]] std::vector<std::string> describe_copy(const Document& document, const SaveAs& wanted);

struct Copy {
  std::string bytes;
  std::vector<std::string> differences;  ///< as describe_copy() tells them
};

/// Makes the copy. Fails where the target cannot take the clip. Precondition: the frames lie within the clip.
[[nodiscard]] Result<Copy> make_copy(const Document& document, const SaveAs& wanted);

/// The same as arguments of the command file.save_as.
[[nodiscard]] nlohmann::json arguments_of(const SaveAs& wanted);

/// True for a BVH that holds all there is, so that nothing is lost when the page is closed afterwards.
[[nodiscard]] bool is_whole(const SaveAs& wanted);

}  // namespace marey::app
