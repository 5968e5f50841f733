#pragma once

/// The ground: floor, shadow, grid and axis lines in one plane, premultiplied alpha.
namespace marey::app::gl {

inline constexpr char kGroundVertex[] = R"(
uniform vec3 u_center;
uniform vec3 u_axis_u;
uniform vec3 u_axis_v;
uniform float u_fade_radius;
out vec2 v_plane;   // world coordinates along the two axes
out vec2 v_offset;  // from the centre, in fade radii
out vec3 v_world;

void main() {
  v_offset = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  v_world = u_center + (u_axis_u * v_offset.x + u_axis_v * v_offset.y) * u_fade_radius;
  v_plane = vec2(dot(v_world, u_axis_u), dot(v_world, u_axis_v));
  gl_Position = world_to_clip * vec4(v_world, 1.0);
}
)";

inline constexpr char kGroundFragment[] = R"(
uniform sampler2D u_shadow_map;
uniform vec3 u_shadow_place;  // centre along the two axes, 1 / half side of the map
uniform vec4 u_shadow_color;
uniform vec4 u_plane_color;
uniform vec4 u_line_color;
uniform vec4 u_axis_color_u;
uniform vec4 u_axis_color_v;
uniform float u_cell;
in vec2 v_plane;
in vec2 v_offset;
in vec3 v_world;
out vec4 o_color;

// Coverage of the lines at whole numbers of `place`, of a constant width in pixels; gone where cells get too small.
float lines(vec2 place, float width) {
  vec2 per_pixel = max(fwidth(place), vec2(1e-9));
  vec2 distance = abs(fract(place - 0.5) - 0.5) / per_pixel;
  vec2 line = clamp(0.5 * width + 0.5 - distance, 0.0, 1.0) * (1.0 - smoothstep(0.10, 0.30, per_pixel));
  return max(line.x, line.y);
}

// Coverage of the one line at 0.
float line_at_zero(float place, float width) {
  return clamp(0.5 * width + 0.5 - abs(place) / max(fwidth(place), 1e-9), 0.0, 1.0);
}

void lay(inout vec4 under, vec4 color, float coverage) {
  float alpha = color.a * coverage;
  under = vec4(color.rgb * alpha, alpha) + under * (1.0 - alpha);
}

void main() {
  float distance = length(v_offset);
  float fade = 1.0 - smoothstep(0.15, 1.0, distance);
  vec3 to_viewer = mix(normalize(eye.xyz - v_world), -view_direction.xyz, eye.w);
  fade *= smoothstep(0.0, 0.08, abs(dot(to_viewer, up.xyz)));

  vec4 color = vec4(0.0);
  lay(color, u_plane_color, fade);
  vec2 shadow_uv = (v_plane - u_shadow_place.xy) * u_shadow_place.z;
  vec2 shadow = texture(u_shadow_map, shadow_uv * 0.5 + 0.5).rg;
  float inside = 1.0 - smoothstep(0.8, 1.0, max(abs(shadow_uv.x), abs(shadow_uv.y)));
  lay(color, u_shadow_color, clamp(max(2.0 * shadow.r, shadow.g), 0.0, 1.0) * inside);

  vec2 cells = v_plane / u_cell;
  float pixels = viewport.z;
  lay(color, u_line_color, 0.32 * fade * lines(cells, pixels));
  lay(color, u_line_color, fade * lines(cells / 10.0, pixels * 1.2));
  lay(color, u_axis_color_u, fade * line_at_zero(cells.y, pixels * 1.3));
  lay(color, u_axis_color_v, fade * line_at_zero(cells.x, pixels * 1.3));
  o_color = color;
}
)";

}  // namespace marey::app::gl
