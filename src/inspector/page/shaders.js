// The programs of the view in three dimensions.

/** Triangles, in world space. */
export const SOLID_VERTEX = `#version 300 es
uniform mat4 toClip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 place;
out vec3 across;
void main() {
    place = position;
    across = normal;
    gl_Position = toClip * vec4(position, 1.0);
}`;

/** Lit from the eye and a little from above; checkers; glass denser at its rim; planes that fade out. */
export const SOLID_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 eye;
uniform vec4 color;
uniform vec3 second;
uniform float checkerSize;
uniform vec3 middle;
uniform float fadeFrom;
in vec3 place;
in vec3 across;
out vec4 result;
void main() {
    vec3 n = normalize(across);
    vec3 v = normalize(eye - place);
    float facing = abs(dot(n, v));
    float light = 0.55 + 0.3 * facing + 0.15 * n.y * sign(dot(n, v));
    vec3 base = color.rgb;
    if (checkerSize > 0.0) {
        vec3 cell = floor((place - n * 1e-3 * checkerSize) / checkerSize);
        if (mod(cell.x + cell.y + cell.z, 2.0) > 0.5) base = second;
    }
    float alpha = color.a;
    if (alpha < 1.0) alpha = mix(min(1.0, alpha * 3.2), alpha, facing);
    if (fadeFrom > 0.0) alpha *= 1.0 - smoothstep(fadeFrom * 0.4, fadeFrom, length(place - middle));
    result = vec4(base * light, alpha);
}`;

/** A line as a strip on the screen, of one width near and far. */
export const LINE_VERTEX = `#version 300 es
uniform mat4 toClip;
uniform vec2 size;
layout(location = 0) in vec2 corner;
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec4 color;
layout(location = 4) in vec2 look;
out vec4 tint;
out vec2 at;
flat out float wide;
flat out float reach;
flat out int dash;
void main() {
    vec4 a = toClip * vec4(from, 1.0);
    vec4 b = toClip * vec4(to, 1.0);
    float near = 0.02;
    if (a.w < near && b.w < near) { gl_Position = vec4(0.0, 0.0, -2.0, 1.0); return; }
    if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
    if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
    vec2 p = a.xy / a.w * size * 0.5;
    vec2 q = b.xy / b.w * size * 0.5;
    vec2 along = q - p;
    reach = length(along);
    along = reach > 1e-4 ? along / reach : vec2(1.0, 0.0);
    wide = look.x;
    dash = int(look.y);
    float pad = wide * 0.5 + 1.0;
    vec2 offset = along * (corner.x * 2.0 - 1.0) * pad + vec2(-along.y, along.x) * corner.y * pad;
    vec4 end = corner.x < 0.5 ? a : b;
    at = vec2(corner.x < 0.5 ? -pad : reach + pad, corner.y * pad);
    tint = color;
    gl_Position = vec4((end.xy / end.w * size * 0.5 + offset) / (size * 0.5) * end.w, end.z, end.w);
}`;

/** Dashes and dots with round ends. */
export const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 dashes[4];
uniform float strength;
in vec4 tint;
in vec2 at;
flat in float wide;
flat in float reach;
flat in int dash;
out vec4 result;
float capsule(float u, float v, float from, float to) {
    float beyond = max(max(from - u, u - to), 0.0);
    return length(vec2(beyond, v));
}
void main() {
    float u = at.x;
    vec4 d = dashes[dash] * wide;
    float period = d.x + d.y + d.z + d.w;
    float off;
    if (period <= 0.0) {
        off = capsule(u, at.y, 0.0, reach);
    } else {
        float m = mod(u, period);
        off = min(capsule(m, at.y, 0.0, d.x), capsule(m, at.y, period, period + d.x));
        if (d.z > 0.0) off = min(off, capsule(m, at.y, d.x + d.y, d.x + d.y + d.z));
        off = max(off, capsule(u, at.y, 0.0, reach));
    }
    float cover = 1.0 - smoothstep(wide * 0.5 - 0.6, wide * 0.5 + 0.6, off);
    if (cover <= 0.0) discard;
    result = vec4(tint.rgb, tint.a * cover * strength);
}`;

/** The picture on the image plane. */
export const PLATE_FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D picture;
in vec3 across;
out vec4 result;
void main() { result = vec4(texture(picture, across.xy).rgb, 0.9); }`;
