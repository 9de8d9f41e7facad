#version 450 core
// Rectangles of sites on the slices of a layer of tiles: four vertices for each slice. OpenGL clips them to polygons
// that bound the sites' Voronoi regions.
//
// in   place, vectors, sides  of the rectangle, as rectangles.comp makes them
// out  the same on one slice, `vectors` times a power of two that brings every length below 1

layout(location = 0) in ivec4 place;
layout(location = 1) in vec4 vectors[3];
layout(location = 4) in vec4 sides[8];

uniform vec2 atlasSize;
uniform ivec2 sliceSize; // grid points of a slice
uniform int columns;     // slots of the atlas in a row
uniform float depthScale;

layout(location = 0) flat out int siteId;
layout(location = 1) flat out vec2 firstPixel; // of the rectangle, its centre
layout(location = 2) flat out vec3 alongX;     // how the vector to the site grows from pixel to pixel
layout(location = 3) flat out vec3 alongY;
layout(location = 4) flat out vec3 atFirst;    // the vector at the first pixel

out float gl_ClipDistance[8];

// How far the rectangle reaches beyond its grid points. Different, so that the diagonal between its two triangles
// does not run through pixel centres.
const vec2 kBefore = vec2(-0.375, -0.125);
const vec2 kAfter = vec2(0.125, 0.375);

void main()
{
  int slice = gl_VertexID >> 2;
  ivec2 last = ivec2(place.w & 255, place.w >> 8 & 255);
  bool used = (place.w >> 16 + slice & 1) != 0;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1);
  vec3 point = vec3(mix(kBefore, vec2(last) + kAfter, corner), slice);
  for (int i = 0; i < 8; ++i)
  {
    gl_ClipDistance[i] = used ? -dot(sides[i], vec4(point, 1.0)) : -1.0;
  }
  int slot = 1 + place.z + slice;
  ivec2 first = ivec2(slot % columns, slot / columns) * sliceSize + ivec2(place.y & 65535, place.y >> 16);
  siteId = place.x;
  firstPixel = vec2(first) + 0.5;
  alongX = depthScale * vec3(vectors[0].x, vectors[1].x, vectors[2].x);
  alongY = depthScale * vec3(vectors[0].y, vectors[1].y, vectors[2].y);
  vec4 origin = vec4(0.0, 0.0, slice, 1.0);
  atFirst = depthScale * vec3(dot(vectors[0], origin), dot(vectors[1], origin), dot(vectors[2], origin));
  gl_Position = used ? vec4(2.0 * (firstPixel + point.xy) / atlasSize - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
