// The shaders of a Batch. Light is soft: from the sky above, and a little sun, computed at corners; edges are lines as wide as
// the `rim` numbers of a corner say (surface.ts), smoothed by themselves, so that the picture needs no other smoothing within a
// shape.

// What a kind of batch has no use for is left out: on a software renderer each number that runs across a triangle costs.

const varyings = (way: 'in' | 'out') => /* glsl */ `
${way} vec3 vRim;
${way} vec4 vLook;
#ifdef PLACED
${way} vec3 vWorld;
#endif
#ifdef GRID
flat ${way} float vUp;
#endif
`;

// PLACED: the shader asks where a point is.
const head = /* glsl */ `
precision highp float;
#if defined(CUT) || defined(GRID) || defined(TRANSLUCENT)
#define PLACED
#endif
`;

export const vertexShader = /* glsl */ `
${head}
uniform sampler2D table;
uniform float pick;
in vec4 facing;
in vec4 rim;
in float element;
#ifdef PICK
flat out float vPick;
#endif
${varyings('out')}

void main() {
  int number = int(element + 0.5);
  ivec2 cell = ivec2((number & 255) * 4, number >> 8);
  vec4 look = texelFetch(table, cell + ivec2(3, 0), 0);
  if (look.a < 0.5) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec4 row0 = texelFetch(table, cell, 0);
  vec4 row1 = texelFetch(table, cell + ivec2(1, 0), 0);
  vec4 row2 = texelFetch(table, cell + ivec2(2, 0), 0);
  vec4 p = vec4(position, 1.0);
  vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
  vec3 n = vec3(dot(row0.xyz, facing.xyz), dot(row1.xyz, facing.xyz), dot(row2.xyz, facing.xyz));
  float sun = max(dot(n, vec3(-0.36, -0.62, 0.70)), 0.0);
  vLook = vec4(look.rgb * (0.73 + 0.11 * n.z + 0.26 * sun), look.a);
  vRim = rim.xyz;
#ifdef PLACED
  vWorld = world;
#endif
#ifdef GRID
  vUp = n.z;
#endif
#ifdef PICK
  vPick = pick + element;
#endif
  gl_Position = projectionMatrix * (viewMatrix * vec4(world, 1.0));
}
`;

export const fragmentShader = /* glsl */ `
${head}
uniform float section;
uniform vec3 edge;
uniform vec3 selected;
uniform vec3 gridColour;
uniform float pixelRatio;
${varyings('in')}
out vec4 colour;

#ifdef GRID
// How much of a line of a grid covers this pixel; grids finer than some pixels fade out.
float gridLine(vec2 p, vec2 pixel, float mesh) {
  vec2 away = abs(fract(p / mesh - 0.5) - 0.5) * mesh / pixel;
  float line = 1.0 - min(min(away.x, away.y), 1.0);
  return line * smoothstep(4.0, 24.0, mesh / max(pixel.x, pixel.y));
}
#endif

void main() {
#ifdef CUT
  if (vWorld.z > section) discard;
#endif
  vec3 across = max(fwidth(vRim), vec3(1e-5));
  vec3 away = (1.0 - abs(vRim)) / across;
  float nearest = min(away.x, min(away.y, away.z)) / pixelRatio;
  vec3 shown = vLook.rgb;
#ifdef GRID
  if (vUp > 0.99) {
    vec2 pixel = max(fwidth(vWorld.xy), vec2(1e-5)) * pixelRatio;
    shown = mix(shown, gridColour, max(0.28 * gridLine(vWorld.xy, pixel, 1.0), 0.75 * gridLine(vWorld.xy, pixel, 10.0)));
  }
#endif
#ifdef TRANSLUCENT
  float stripe = fract((vWorld.x + vWorld.y + vWorld.z) * 0.5);
  float hatch = vLook.a > 1.5 ? 0.0 : smoothstep(0.45, 0.5, stripe) - smoothstep(0.95, 1.0, stripe);
  float border = 1.0 - smoothstep(0.5, 1.5, nearest);
  colour = vec4(shown, mix(0.16 + 0.14 * hatch, 0.9, border));
#else
  bool marked = vLook.a > 1.5;
  float width = marked ? 2.0 : 0.75;
  // Where a face is but a few pixels wide, its lines would be all there is.
  float room = marked ? 1.0 : 0.55 - 0.55 * smoothstep(0.25, 0.9, max(across.x, max(across.y, across.z)) * pixelRatio);
  shown = mix(shown, marked ? selected : edge, room * clamp(width + 0.5 - nearest, 0.0, 1.0));
#ifdef CUT
  // The inside of a solid that is cut open, in one flat tint: as if it were closed by the cut.
  if (!gl_FrontFacing) shown = mix(vLook.rgb / max(0.75, max(vLook.r, max(vLook.g, vLook.b))), edge, 0.35);
#endif
  colour = vec4(shown, 1.0);
#endif
}
`;

export const pickShader = /* glsl */ `
${head}
uniform float section;
flat in float vPick;
${varyings('in')}
out vec4 colour;

void main() {
#ifdef CUT
  if (vWorld.z > section) discard;
#endif
  int number = int(vPick + 0.5);
  colour = vec4(float(number & 255), float((number >> 8) & 255), float(number >> 16), 255.0) / 255.0;
}
`;
