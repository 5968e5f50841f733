#pragma once

/// Programs that fill the view: background, blur.
namespace marey::app::gl {

/// One triangle over the whole view, without vertex buffers.
inline constexpr char kScreenVertex[] = R"(
out vec2 v_uv;  // 0,0 bottom left
void main() {
  v_uv = vec2((gl_VertexID & 1) << 1, gl_VertexID & 2);
  gl_Position = vec4(v_uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

inline constexpr char kBackgroundFragment[] = R"(
uniform vec4 u_top;
uniform vec4 u_bottom;
in vec2 v_uv;
out vec4 o_color;

// Noise of one step of a colour channel, which keeps a slow gradient from showing bands.
float noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

void main() {
  vec3 color = mix(u_bottom.rgb, u_top.rgb, smoothstep(0.0, 1.0, v_uv.y));
  o_color = vec4(color + (noise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
}
)";

/// One direction of a Gaussian blur: narrow for red, wide for green. Each tap but the middle one reads two texels.
inline constexpr char kBlurFragment[] = R"(
uniform sampler2D u_map;
uniform vec2 u_step;  // one texel along the direction, in texture coordinates
in vec2 v_uv;
out vec4 o_color;

const int kTaps = 4;
const vec2 kSigma = vec2(0.9, 2.5);  // texels

void main() {
  vec2 sum = texture(u_map, v_uv).rg;
  vec2 weights = vec2(1.0);
  for (int tap = 0; tap < kTaps; ++tap) {
    float distance = float(tap) * 2.0 + 1.5;
    vec2 weight = 2.0 * exp(-0.5 * distance * distance / (kSigma * kSigma));
    vec2 offset = u_step * distance;
    sum += weight * (texture(u_map, v_uv + offset).rg + texture(u_map, v_uv - offset).rg);
    weights += 2.0 * weight;
  }
  o_color = vec4(sum / weights, 0.0, 1.0);
}
)";

}  // namespace marey::app::gl
