#pragma once

/// Pieces of GLSL that several programs begin with.
namespace marey::app::gl {

/// Mirror of FrameUniforms.
inline constexpr char kFrameBlock[] = R"(
layout(std140) uniform Frame {
  mat4 world_to_clip;
  vec4 eye;              // w: 1 for an orthographic view
  vec4 view_direction;   // unit, away from the viewer
  vec4 light_direction;  // towards the light; w: strength of the rim
  vec4 key;
  vec4 sky;
  vec4 bounce;
  vec4 up;               // w: height of the ground
  vec4 haze;             // linear colour of what lies under the ground
  vec4 viewport;         // pixels wide, pixels high, pixels per unit
};
)";

inline constexpr char kColorSpace[] = R"(
vec3 to_linear(vec3 srgb) { return pow(srgb, vec3(2.2)); }
vec3 to_srgb(vec3 linear) { return pow(linear, vec3(1.0 / 2.2)); }
)";

}  // namespace marey::app::gl
