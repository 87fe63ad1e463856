// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

const surfaceVertex = `#version 300 es
uniform mat4 u_view;
uniform mat3 u_turn;
in vec3 a_place;
in vec3 a_normal;
in vec4 a_colour;
out vec3 v_normal;
out vec3 v_colour;
void main() {
  gl_Position = u_view * vec4(a_place, 1.0);
  v_normal = u_turn * a_normal;
  v_colour = a_colour.rgb;
}`;

// A key light at the upper left, a fill light at the right, a soft gloss; both sides alike.
const surfaceFragment = `#version 300 es
precision highp float;
uniform float u_opacity;
in vec3 v_normal;
in vec3 v_colour;
out vec4 colour;
void main() {
  vec3 n = normalize(v_normal);
  if (!(dot(n, n) > 0.5)) n = vec3(0.0, 0.0, 1.0);
  if (n.z < 0.0) n = -n;
  vec3 key = normalize(vec3(-0.45, 0.6, 0.75)), fill = normalize(vec3(0.8, -0.1, 0.5));
  float light = 0.42 + 0.5 * max(dot(n, key), 0.0) + 0.16 * max(dot(n, fill), 0.0);
  float gloss = pow(max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 48.0);
  float rim = pow(1.0 - n.z, 3.0);
  vec3 lit = v_colour * light * (1.0 - 0.25 * rim) + 0.13 * gloss;
  // What is seen through is denser where it turns away.
  float opacity = u_opacity < 1.0 ? u_opacity * (0.45 + 1.6 * rim) : 1.0;
  colour = vec4(lit, 1.0) * clamp(opacity, 0.0, 1.0);
}`;

// A segment is a quad around a capsule of constant width on the screen; one of length zero a disc.
const lineVertex = `#version 300 es
uniform mat4 u_view;
uniform vec2 u_screen;
uniform float u_width, u_disc, u_pixel, u_half, u_lift;
uniform uint u_chosen;
in vec3 a_from, a_to;
in float a_shown;
in uint a_item;
out vec2 v_at;
flat out vec2 v_from, v_to;
flat out float v_half, v_mark;
flat out uint v_item;
void main() {
  vec4 p = u_view * vec4(a_from, 1.0), q = u_view * vec4(a_to, 1.0);
  vec2 from = p.xy * u_screen, to = q.xy * u_screen, along = to - from;
  bool disc = a_from == a_to;
  along = disc || dot(along, along) < 1e-8 ? vec2(1.0, 0.0) : normalize(along);
  bool chosen = a_item == u_chosen;
  float extent = 0.5 * (disc ? u_disc : u_width) + (chosen ? 1.5 * u_pixel : 0.0);
  float reach = extent + 1.0;
  bool at_end = (gl_VertexID & 1) == 1;
  vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 2) == 2 ? reach : -reach);
  vec2 at = (at_end ? to + along * reach : from - along * reach) + across;
  // Nearer to the eye, as far as the surface can rise beside the line.
  float lift = 0.25 * (1.5 * extent * u_half + u_lift + (disc ? 0.004 : 0.0) + (chosen ? 0.006 : 0.0));
  gl_Position = a_shown > 0.5 ? vec4(at / u_screen, (at_end ? q.z : p.z) - lift, 1.0)
                              : vec4(2.0, 2.0, 2.0, 1.0);
  v_at = at;
  v_from = from;
  v_to = to;
  v_half = extent;
  v_mark = chosen ? 1.0 : 0.0;
  v_item = a_item;
}`;

const capsule = `
in vec2 v_at;
flat in vec2 v_from, v_to;
flat in float v_half, v_mark;
flat in uint v_item;
float outside() {
  vec2 along = v_to - v_from, at = v_at - v_from;
  float t = clamp(dot(at, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  return length(at - t * along) - v_half;
}`;

const lineFragment = `#version 300 es
precision highp float;
uniform vec3 u_colour, u_marked;
uniform float u_share;
out vec4 colour;
${capsule}
void main() {
  float cover = clamp(0.5 - outside(), 0.0, 1.0) * u_share;
  if (cover <= 0.0) discard;
  colour = vec4(mix(u_colour, u_marked, 0.6 * v_mark), 1.0) * cover;
}`;

const idFragment = `#version 300 es
precision highp float;
out vec4 colour;
${capsule}
void main() {
  if (outside() > 0.0) discard;
  colour = vec4(uvec4(v_item, v_item >> 8u, v_item >> 16u, v_item >> 24u) & 255u) / 255.0;
}`;
