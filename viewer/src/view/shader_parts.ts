// SPDX-License-Identifier: Apache-2.0
// Pieces of GLSL that several materials share. Colours are sRGB throughout: no material here converts them.

import { kStepsInward } from "../scene/octree.ts";

/** Colours of numbers by the palette of the chosen map. */
export const kFieldColors = /* glsl */ `
uniform sampler2D palette;
uniform int map_kind; // 0 none, 1 alignment, 2 energy, 3 class, 4 region

vec3 ramp_color(float share) { return texture(palette, vec2(share * 0.99609375 + 0.001953125, 0.5)).rgb; }
vec3 region_color(int region) { return texelFetch(palette, ivec2(region & 255, 0), 0).rgb; }

// Hatching tells the two classes that matter most without their colour.
vec3 class_color(int kind) {
  vec3 color = texelFetch(palette, ivec2(kind, 0), 0).rgb;
  vec2 pixel = gl_FragCoord.xy / pixel_ratio;
  if (kind == 5 && mod(pixel.x + pixel.y, 7.0) < 2.0) color *= 0.6;
  if (kind == 4 && mod(pixel.x - pixel.y, 7.0) < 2.0) color *= 0.7;
  return color;
}
`;

/** Looks up cells in the octree's texture. */
export const kFieldLookup = /* glsl */ `
precision highp usampler2D;
uniform usampler2D octree;     // 2048 entries a row, as scene/octree.ts lays them out
uniform sampler2D cell_values; // 2048 cells a row: alignment, energy density (both 0 to 1 of their legends), class, region / 255
uniform sampler2D corner_values; // 512 cells a row: alignment and energy density at two corners a texel
uniform int octree_depth;
uniform vec3 lattice_low;
uniform float lattice_unit;
uniform vec3 void_color;
${kFieldColors}
struct Cell { int number; vec3 low; float side; }; // low and side in lattice units

Cell cell_at(vec3 lattice_point) {
  Cell none = Cell(-1, vec3(0.0), 0.0);
  float side = exp2(float(octree_depth));
  if (any(lessThan(lattice_point, vec3(0.0))) || any(greaterThanEqual(lattice_point, vec3(side)))) return none;
  ivec3 corner = ivec3(floor(lattice_point));
  uint node = 0u;
  for (int level = octree_depth - 1; level >= 0; --level) {
    ivec3 half_of = (corner >> level) & 1;
    uint entry = node * 8u + uint(half_of.x | (half_of.y << 1) | (half_of.z << 2));
    uint value = texelFetch(octree, ivec2(int(entry & 2047u), int(entry >> 11)), 0).r;
    if (value == 0u) return none;
    if (value >= 0x80000000u) return Cell(int(value & 0x7fffffffu), vec3((corner >> level) << level), float(1 << level));
    node = value;
  }
  return none;
}

vec4 values_of(int cell) { return texelFetch(cell_values, ivec2(cell & 2047, cell >> 11), 0); }
int class_of(vec4 values) { return int(values.b * 255.0 + 0.5); }

// Alignment and energy density at two corners of a cell that are neighbours along x.
vec4 corner_pair(int cell, int pair) { int texel = 4 * cell + pair; return texelFetch(corner_values, ivec2(texel & 2047, texel >> 11), 0); }

// Interpolated between the corners of the cell, at a point in lattice units.
vec2 numbers_at(Cell cell, vec3 at) {
  vec3 share = clamp((at - cell.low) / cell.side, 0.0, 1.0);
  vec4 low = mix(corner_pair(cell.number, 0), corner_pair(cell.number, 1), share.y);
  vec4 high = mix(corner_pair(cell.number, 2), corner_pair(cell.number, 3), share.y);
  vec4 both = mix(low, high, share.z);
  return mix(both.rg, both.ba, share.x);
}

vec3 field_color(Cell cell, vec3 at) {
  if (map_kind == 1) return ramp_color(numbers_at(cell, at).r);
  if (map_kind == 2) return ramp_color(numbers_at(cell, at).g);
  vec4 values = values_of(cell.number);
  return map_kind == 3 ? class_color(class_of(values)) : region_color(int(values.a * 255.0 + 0.5));
}

// Of a point on the surface: from the boundary cell there, or a little inside.
vec3 surface_color(vec3 point, vec3 outward) {
  vec3 at = (point - lattice_low) / lattice_unit;
  float steps[${kStepsInward.length}] = float[${kStepsInward.length}](${kStepsInward.map((step) => step.toFixed(3)).join(", ")});
  vec3 color = void_color;
  bool found = false;
  for (int k = 0; k < ${kStepsInward.length}; ++k) {
    Cell cell = cell_at(at - steps[k] * outward);
    if (cell.number < 0) continue;
    if (class_of(values_of(cell.number)) > 0) return field_color(cell, at);
    if (!found) color = field_color(cell, at);
    found = true;
  }
  return color;
}
`;

/** Takes away what lies beyond the cut. */
export const kClip = /* glsl */ `
uniform vec4 cut; // normal and offset
uniform bool clip;
bool is_taken(vec3 point) { return clip && dot(cut.xyz, point) > cut.w; }
void clip_at_cut(vec3 point) { if (is_taken(point)) discard; }
`;

/** Light that goes with the camera, from above its left shoulder, and never leaves anything black. */
export const kLight = /* glsl */ `
float light_on(vec3 view_normal) {
  vec3 normal = normalize(view_normal);
  return 0.62 + 0.30 * max(0.0, dot(normal, normalize(vec3(-0.35, 0.55, 0.75)))) + 0.12 * normal.y;
}
`;

/** Model units a CSS pixel covers at a point of the view. */
export const kPixelSize = /* glsl */ `
uniform float view_height; // CSS pixels
float pixel_size_at(vec4 view_point) { return 2.0 * -view_point.z / (projectionMatrix[1][1] * view_height); }
// Radius of a line of so many pixels: at most a sixth of the wall that it runs in, and still to be seen.
float line_radius(float pixels, float wall, float pixel) { return max(min(pixels * pixel, wall / 6.0), 0.8 * pixel); }
`;
