#pragma once

/// Bones, balls and ellipsoids. Defines: BONE, BALL or ELLIPSOID for the shape; EDGE (outline) or FADED (strobe pose) for the look, none for lit.
/// Vertex stages are kFrameBlock, kSolidShape, then kSolidVertex or kShadowVertex.
namespace marey::app::gl {

inline constexpr char kSolidShape[] = R"(
#ifdef BONE
layout(location = 0) in vec4 a_section;       // point and normal of the cross section
layout(location = 1) in vec3 a_along_outline;
layout(location = 3) in vec3 a_from;
layout(location = 4) in float a_radius;
layout(location = 5) in vec3 a_to;
layout(location = 6) in vec3 a_side;
layout(location = 7) in vec4 a_color;

void place(out vec3 world, out vec3 normal) {
  vec3 along = a_to - a_from;
  float bone_length = length(along);
  vec3 axis = along / bone_length;
  vec3 across = cross(axis, a_side);
  vec3 section = a_side * a_section.x + across * a_section.y;
  vec3 outwards = a_side * a_section.z + across * a_section.w;
  world = a_from + along * a_along_outline.x + section * a_radius;
  normal = normalize(outwards * (a_along_outline.y * bone_length) - axis * (a_along_outline.z * a_radius));
}
#elif defined(ELLIPSOID)
layout(location = 0) in vec3 a_point;
layout(location = 3) in vec3 a_center;
layout(location = 4) in vec3 a_axis_x;
layout(location = 5) in vec3 a_axis_y;
layout(location = 6) in vec3 a_axis_z;
layout(location = 7) in vec4 a_color;

void place(out vec3 world, out vec3 normal) {
  normal = normalize(a_axis_x * (a_point.x / dot(a_axis_x, a_axis_x)) + a_axis_y * (a_point.y / dot(a_axis_y, a_axis_y)) +
                     a_axis_z * (a_point.z / dot(a_axis_z, a_axis_z)));
  world = a_center + a_axis_x * a_point.x + a_axis_y * a_point.y + a_axis_z * a_point.z;
}
#else
layout(location = 0) in vec3 a_point;
layout(location = 3) in vec3 a_center;
layout(location = 4) in float a_radius;
layout(location = 7) in vec4 a_color;

void place(out vec3 world, out vec3 normal) {
  normal = a_point;
  world = a_center + a_point * a_radius;
}
#endif
)";

inline constexpr char kSolidVertex[] = R"(
#ifdef EDGE
uniform float u_edge_width;  // pixels
#endif
out vec3 v_world;
out vec3 v_normal;
out vec4 v_color;

void main() {
  place(v_world, v_normal);
  v_color = a_color;
  gl_Position = world_to_clip * vec4(v_world, 1.0);
#ifdef EDGE
  vec2 outwards = (world_to_clip * vec4(v_normal, 0.0)).xy * viewport.xy;
  float size = length(outwards);
  if (size > 0.0) gl_Position.xy += outwards / size * (2.0 * u_edge_width * gl_Position.w / viewport.xy);
#endif
}
)";

inline constexpr char kSolidFragment[] = R"(
in vec3 v_world;
in vec3 v_normal;
in vec4 v_color;
out vec4 o_color;

vec3 lit(vec3 albedo, vec3 normal, vec3 to_viewer) {
  const float kWrap = 0.35;
  float facing = dot(normal, light_direction.xyz);
  float direct = max((facing + kWrap) / (1.0 + kWrap), 0.0);
  direct *= direct;
  float upness = 0.5 + 0.5 * dot(normal, up.xyz);
  vec3 ambient = mix(bounce.rgb, sky.rgb, upness);
  float edge = pow(1.0 - max(dot(normal, to_viewer), 0.0), 3.0);
  vec3 rim = light_direction.w * edge * mix(0.35, 1.0, upness) * mix(albedo, vec3(1.0), 0.35);
  return albedo * (ambient + direct * key.rgb) + rim;
}

void main() {
#ifdef EDGE
  o_color = vec4(v_color.rgb, 1.0);
#else
  vec3 normal = normalize(v_normal);
  vec3 to_viewer = mix(normalize(eye.xyz - v_world), -view_direction.xyz, eye.w);
  vec3 color = lit(to_linear(v_color.rgb), normal, to_viewer);
  float depth_under_ground = up.w - dot(v_world, up.xyz);
  float eye_above_ground = dot(eye.xyz, up.xyz) - up.w;
  float submerged = step(0.0, eye_above_ground) * clamp(depth_under_ground * haze.w, 0.0, 1.0);
  color = mix(color, haze.rgb, 0.55 * submerged);
  o_color = vec4(to_srgb(color), 1.0);
#ifdef FADED
  o_color = vec4(o_color.rgb * v_color.a, v_color.a);
#endif
#endif
}
)";

/// What stands above the ground, projected onto it along the light. Red: what is near the ground; green: all of it.
inline constexpr char kShadowVertex[] = R"(
uniform vec3 u_center;
uniform vec3 u_axis_u;
uniform vec3 u_axis_v;
uniform vec2 u_scale;  // 1 / half side of the map, 1 / height at which a shadow has softened
out float v_height;

void main() {
  vec3 world, normal;
  place(world, normal);
  float height = max(dot(world, up.xyz) - up.w, 0.0);
  vec3 foot = world - light_direction.xyz * (height / dot(light_direction.xyz, up.xyz)) - u_center;
  v_height = height * u_scale.y;
  gl_Position = vec4(vec2(dot(foot, u_axis_u), dot(foot, u_axis_v)) * u_scale.x, 0.0, 1.0);
}
)";

inline constexpr char kShadowFragment[] = R"(
in float v_height;
out vec4 o_color;
void main() { o_color = vec4(exp(-v_height), 1.0, 0.0, 1.0); }
)";

}  // namespace marey::app::gl
