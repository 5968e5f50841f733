#pragma once

/// Curves of a graph as bands or lines, one instance per stretch between two places.
namespace marey::app::gl {

inline constexpr char kCurveVertex[] = R"(
layout(location = 0) in vec3 a_before;  // x, top, bottom
layout(location = 1) in vec4 a_before_color;
layout(location = 2) in vec3 a_here;
layout(location = 3) in vec4 a_color;
layout(location = 4) in vec3 a_next;
layout(location = 5) in vec4 a_next_color;
layout(location = 6) in vec3 a_after;
uniform vec4 u_to_clip;  // factors, offsets
uniform vec2 u_options;  // half a pixel in units; 1 for lines
out vec4 v_color;
out vec2 v_inside;  // distances from the upper and from the lower edge, units

vec2 middle(vec3 place) { return vec2(place.x, 0.5 * (place.y + place.z)); }

vec2 across(vec2 from, vec2 to, vec2 otherwise) {
  vec2 way = to - from;
  float size = length(way);
  return size > 1e-4 ? vec2(-way.y, way.x) / size : otherwise;
}

// Where two stretches of a line meet, both end on the line that halves their angle, but for sharp corners.
vec2 mitre(vec2 own, vec2 other) {
  vec2 sum = own + other;
  float reach = dot(sum, own);
  return reach > 0.5 ? sum / reach : own;
}

void main() {
  bool at_end = (gl_VertexID & 2) != 0;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 place = at_end ? a_next : a_here;
  float half_height = 0.5 * (place.z - place.y);
  float fringe = u_options.x;
  vec2 way = vec2(0.0, 1.0);
  if (u_options.y > 0.5) {
    vec2 own = across(middle(a_here), middle(a_next), way);
    bool has_neighbour = at_end ? a_next_color.a > 0.0 : a_before_color.a > 0.0;
    vec2 other = at_end ? across(middle(a_next), middle(a_after), own) : across(middle(a_before), middle(a_here), own);
    way = has_neighbour ? mitre(own, other) : own;
  }
  vec2 point = middle(place) + way * side * (half_height + fringe);
  v_inside = vec2(half_height, half_height) + vec2(side, -side) * (half_height + fringe);
  v_color = a_color;
  gl_Position = a_color.a > 0.0 ? vec4(point * u_to_clip.xy + u_to_clip.zw, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
)";

inline constexpr char kCurveFragment[] = R"(
in vec4 v_color;
in vec2 v_inside;
out vec4 color;

void main() {
  vec2 covered = clamp(v_inside / max(fwidth(v_inside), vec2(1e-6)) + 0.5, 0.0, 1.0);
  color = vec4(v_color.rgb, v_color.a * min(covered.x, covered.y));
}
)";

}  // namespace marey::app::gl
