#pragma once

#include <array>
#include <string_view>

namespace marey::app {

/// A clip that the page brings along, as web/samples/<id>.bvh.
struct Sample {
  std::string_view id;
  std::string_view title;
  std::string_view summary;  ///< one line: what it shows
};

inline constexpr std::array kSamples = {
    Sample{"giant-swing", "Giant swing", "A gymnast of three links, from a printed paper"},
    Sample{"walk", "Walk", "A person walks three full cycles"},
    Sample{"pendulum", "Pendulum", "A swing with a known closed form"},
    Sample{"double-pendulum", "Double pendulum", "Two rods that never repeat themselves"},
    Sample{"robot-arm", "Robot arm", "Six axes and a gripper carry a part"},
};

}  // namespace marey::app
