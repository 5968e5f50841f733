#pragma once

/// Lines of a width in pixels, one instance per stretch between two points, mitred where stretches meet.
namespace marey::app::gl {

inline constexpr char kLineVertex[] = R"(
layout(location = 0) in vec3 a_before;
layout(location = 1) in vec3 a_start;
layout(location = 2) in vec4 a_start_color;
layout(location = 3) in vec3 a_end;
layout(location = 4) in vec4 a_end_color;
layout(location = 5) in vec3 a_after;
uniform float u_half_width;  // pixels
out vec4 v_color;
out float v_across;  // pixels from the middle of the line

vec2 to_pixels(vec4 clip) { return clip.xy / clip.w * 0.5 * viewport.xy; }

vec2 direction(vec2 from, vec2 to, vec2 otherwise) {
  vec2 way = to - from;
  float size = length(way);
  return size > 1e-3 ? way / size : otherwise;
}

void main() {
  bool at_end = gl_VertexID >= 2;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 start = world_to_clip * vec4(a_start, 1.0);
  vec4 end = world_to_clip * vec4(a_end, 1.0);
  vec4 clip = at_end ? end : start;
  vec4 beyond = world_to_clip * vec4(at_end ? a_after : a_before, 1.0);
  if (min(start.w, end.w) <= 0.0) {  // a stretch through the eye has no place on the screen
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 way = direction(to_pixels(start), to_pixels(end), vec2(1.0, 0.0));
  vec2 other = way;
  if (beyond.w > 0.0) {
    other = at_end ? direction(to_pixels(end), to_pixels(beyond), way) : direction(to_pixels(beyond), to_pixels(start), way);
  }
  vec2 across = vec2(-way.y, way.x);
  vec2 mitre = across + vec2(-other.y, other.x);
  float reach = dot(mitre, across);
  mitre = reach > 0.5 ? mitre / reach : across;
  v_across = side * (u_half_width + 1.0);
  v_color = at_end ? a_end_color : a_start_color;
  gl_Position = clip;
  gl_Position.xy += mitre * v_across * 2.0 / viewport.xy * clip.w;
}
)";

inline constexpr char kLineFragment[] = R"(
uniform float u_half_width;
in vec4 v_color;
in float v_across;
out vec4 o_color;
void main() {
  float alpha = v_color.a * clamp(u_half_width + 0.5 - abs(v_across), 0.0, 1.0);
  o_color = vec4(v_color.rgb * alpha, alpha);
}
)";

}  // namespace marey::app::gl
