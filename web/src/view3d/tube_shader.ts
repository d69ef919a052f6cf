// The shaders of the yarns. An instance is an element: its key carries its number and what never changes of it, the
// positions (and the value of a field as fourth number) of its nodes and their neighbours come from a texture.

export const kTextureColumns = 1024;

export const kFirstOfYarn = 1 << 24; // no element before it: the yarn ends there or is broken
export const kLastOfYarn = 1 << 25;
export const kEdgeYarn = 1 << 26;
export const kOddCourse = 1 << 27;
export const kElementBits = kFirstOfYarn - 1;

/** Values from here on stand for what is not a number: a texture need not keep NaN. */
export const kNotANumber = 1e30;

export const tubeVertexShader = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;

uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D nodes;
uniform float radius;
uniform float edgeRadius;
uniform vec4 eye;        // towards the viewer if w is 0, otherwise where the viewer is
uniform bool isRibbon;   // yarns of a pixel or two need no tube: a strip across the line of sight
uniform float leastRadius;
uniform float widening;  // of a prism with few sides, which would look thinner than its yarn

in vec2 corner;  // turn around the yarn, place along the element; both 0 to 1
in uint key;

out vec3 place;
out vec3 inView;
out vec3 normal;
out float value;
flat out uint traits;

vec4 nodeAt(int i) {
  return texelFetch(nodes, ivec2(i & ${kTextureColumns - 1}, i / ${kTextureColumns}), 0);
}

// Tangent at the node between two others, as that of the parabola through the three.
vec3 tangentAt(vec3 before, vec3 here, vec3 after) {
  vec3 a = here - before;
  vec3 b = after - here;
  float la = max(length(a), 1e-9);
  float lb = max(length(b), 1e-9);
  return (a / la * lb + b / lb * la) / (la + lb);
}

void main() {
  int i = int(key & ${kElementBits}u);
  vec4 nodeA = nodeAt(i);
  vec4 nodeB = nodeAt(i + 1);
  vec3 a = nodeA.xyz;
  vec3 b = nodeB.xyz;
  vec3 chord = b - a;
  float len = max(length(chord), 1e-9);
  bool first = (key & ${kFirstOfYarn}u) != 0u;
  bool last = (key & ${kLastOfYarn}u) != 0u;
  vec3 ta = first ? chord / len : tangentAt(nodeAt(i - 1).xyz, a, b);
  vec3 tb = last ? chord / len : tangentAt(a, b, nodeAt(i + 2).xyz);

  float u = corner.y;
  float v = 1.0 - u;
  vec3 middle = v * v * (1.0 + 2.0 * u) * a + u * u * (1.0 + 2.0 * v) * b + len * u * v * (v * ta - u * tb);
  vec3 along = normalize(6.0 * u * v * chord / len + v * (v - 2.0 * u) * ta + u * (u - 2.0 * v) * tb);

  // The ring lies across the yarn and begins at the fabric's face; where a yarn runs through the plane, at its side.
  vec3 begin = abs(chord.z) < 0.9 * len ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 n = normalize(begin - along * dot(along, begin));
  vec3 m = cross(along, n);
  float angle = 6.28318530718 * corner.x;
  vec3 outward = cos(angle) * n + sin(angle) * m;
  vec3 facing = outward;
  if (isRibbon) {
    vec3 sight = normalize(eye.xyz - eye.w * middle);
    vec3 across = cross(along, sight);
    across = dot(across, across) > 1e-8 ? normalize(across) : n;
    outward = (2.0 * corner.x - 1.0) * across;
    facing = cross(across, along);
  }
  float r = (key & ${kEdgeYarn}u) != 0u ? edgeRadius : radius;
  r = max(r, leastRadius);

  place = middle + r * widening * outward;
  vec4 seen = viewMatrix * vec4(place, 1.0);
  inView = seen.xyz;
  normal = mat3(viewMatrix) * facing;
  value = nodeA.w > 9e29 || nodeB.w > 9e29 ? ${kNotANumber.toExponential()} : mix(nodeA.w, nodeB.w, u);
  traits = key;
  gl_Position = projectionMatrix * seen;
}
`;

export const tubeFragmentShader = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;

uniform int colouring;  // 0 courses, 1 plain, 2 field
uniform vec3 courses[2];
uniform vec3 plain;
uniform vec3 unknown;
uniform vec3 picked;
uniform vec3 back;
uniform sampler2D colourMap;
uniform vec2 range;
uniform vec3 clipLowest;
uniform vec3 clipHighest;
uniform float orthographic;
uniform vec2 depths;     // nearest and farthest of the fabric along the view
uniform float rimDarkness;  // less on yarns too thin to show a rim
uniform ivec2 pickedYarn;  // its first and last node; -1: none
uniform int pickedElement;

in vec3 place;
in vec3 inView;
in vec3 normal;
in float value;
flat in uint traits;

out vec4 colour;

vec3 toLinear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 toSrgb(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)); }

vec3 yarnColour() {
  if (colouring == 0) return courses[(traits & ${kOddCourse}u) != 0u ? 1 : 0];
  if (colouring == 1) return (traits & ${kEdgeYarn}u) != 0u ? mix(plain, unknown, 0.5) : plain;
  if (value > 9e29) return unknown;
  float t = (value - range.x) / (range.y - range.x);
  return texture(colourMap, vec2((clamp(t, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  if (any(lessThan(place, clipLowest)) || any(greaterThan(place, clipHighest))) discard;
  int element = int(traits & ${kElementBits}u);
  vec3 base = toLinear(yarnColour());
  vec3 behind = toLinear(back);
  if (pickedYarn.x >= 0 && (element < pickedYarn.x || element >= pickedYarn.y)) base = mix(base, behind, 0.5);
  if (element == pickedElement) base = toLinear(picked);
  // The inside of a tube is seen only where it is cut or ends; even colour makes it look solid.
  if (!gl_FrontFacing) {
    colour = vec4(toSrgb(base * 0.55), 1.0);
    return;
  }
  vec3 n = normalize(normal);
  vec3 v = orthographic > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-inView);
  const vec3 key = normalize(vec3(-0.50, 0.62, 0.80));
  const vec3 fill = normalize(vec3(0.85, -0.15, 0.55));
  float facing = max(dot(n, v), 0.0);
  float sky = 0.30 + 0.12 * n.y;
  float light = sky + 0.62 * max(dot(n, key), 0.0) + 0.18 * max(dot(n, fill), 0.0);
  float rim = mix(1.0 - rimDarkness, 1.0, smoothstep(0.0, 0.62, facing));
  float gloss = 0.16 * pow(max(dot(n, normalize(key + v)), 0.0), 30.0);
  float depth = clamp((-inView.z - depths.x) / max(depths.y - depths.x, 1e-6), 0.0, 1.0);
  float cue = 1.0 - 0.30 * depth;
  colour = vec4(toSrgb(base * light * rim * cue + gloss * rim), 1.0);
}
`;
