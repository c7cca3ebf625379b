// The shaders of a Batch. Light is soft: from the sky above, and a little sun, computed at corners; edges are lines as wide as the `rim`
// numbers of a corner say (surface.ts), smoothed by themselves, so that the picture needs no other smoothing within a shape.

export const vertexShader = /* glsl */ `
precision highp float;
uniform sampler2D table;
uniform float pick;
in vec4 facing;
in vec4 rim;
in float element;
out vec4 vRim;
out vec3 vColour;
out vec3 vWorld;
flat out float vStyle;
flat out float vUp;
flat out float vPick;

void main() {
  int number = int(element + 0.5);
  ivec2 cell = ivec2((number & 255) * 4, number >> 8);
  vec4 row0 = texelFetch(table, cell, 0);
  vec4 row1 = texelFetch(table, cell + ivec2(1, 0), 0);
  vec4 row2 = texelFetch(table, cell + ivec2(2, 0), 0);
  vec4 look = texelFetch(table, cell + ivec2(3, 0), 0);
  vec4 p = vec4(position, 1.0);
  vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
  vec3 n = normalize(vec3(dot(row0.xyz, facing.xyz), dot(row1.xyz, facing.xyz), dot(row2.xyz, facing.xyz)));
  float sky = 0.5 + 0.5 * n.z;
  float sun = max(dot(n, vec3(-0.36, -0.62, 0.70)), 0.0);
  vColour = look.rgb * (0.62 + 0.22 * sky + 0.26 * sun);
  vRim = rim;
  vWorld = world;
  vStyle = look.a;
  vUp = n.z;
  vPick = pick + element;
  gl_Position = look.a < 0.5 ? vec4(0.0, 0.0, 2.0, 1.0) : projectionMatrix * viewMatrix * vec4(world, 1.0);
}
`;

const inputs = /* glsl */ `
precision highp float;
uniform float section;
in vec4 vRim;
in vec3 vColour;
in vec3 vWorld;
flat in float vStyle;
flat in float vUp;
flat in float vPick;
out vec4 colour;
`;

export const fragmentShader = /* glsl */ `
${inputs}
uniform vec3 edge;
uniform vec3 selected;
uniform vec3 gridColour;
uniform float pixelRatio;

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
  vec3 shown = vColour;
  vec3 across = max(fwidth(vRim.xyz), vec3(1e-5));
  vec3 away = (1.0 - abs(vRim.xyz)) / across;
  float nearest = min(away.x, min(away.y, away.z)) / pixelRatio;
  // Where a face is but a few pixels wide, its lines would be all there is.
  float room = 1.0 - smoothstep(0.25, 0.9, max(across.x, max(across.y, across.z)) * pixelRatio);
  bool marked = vStyle > 1.5;
  float width = marked ? 2.0 : 0.75;
  float line = (1.0 - smoothstep(width - 0.5, width + 0.5, nearest)) * (marked ? 1.0 : 0.55 * room);
#ifdef GRID
  if (vUp > 0.99) {
    vec2 pixel = max(fwidth(vWorld.xy), vec2(1e-5)) * pixelRatio;
    float fine = 0.28 * gridLine(vWorld.xy, pixel, 1.0);
    float coarse = 0.75 * gridLine(vWorld.xy, pixel, 10.0);
    shown = mix(shown, gridColour, max(fine, coarse));
  }
#endif
#ifdef TRANSLUCENT
  float stripe = fract((vWorld.x + vWorld.y + vWorld.z) * 0.5);
  float hatch = vStyle > 1.5 ? 0.0 : smoothstep(0.45, 0.5, stripe) - smoothstep(0.95, 1.0, stripe);
  float border = 1.0 - smoothstep(0.5, 1.5, nearest);
  colour = vec4(shown, mix(0.16 + 0.14 * hatch, 0.9, border));
#else
  shown = mix(shown, marked ? selected : edge, line);
#ifdef CUT
  // The inside of a solid that is cut open, in one flat tint: as if it were closed by the cut.
  if (!gl_FrontFacing) shown = mix(vColour / max(0.75, max(vColour.r, max(vColour.g, vColour.b))), edge, 0.35);
#endif
  colour = vec4(shown, 1.0);
#endif
}
`;

export const pickShader = /* glsl */ `
${inputs}
void main() {
#ifdef CUT
  if (vWorld.z > section) discard;
#endif
  int number = int(vPick + 0.5);
  colour = vec4(float(number & 255), float((number >> 8) & 255), float(number >> 16), 255.0) / 255.0;
}
`;
