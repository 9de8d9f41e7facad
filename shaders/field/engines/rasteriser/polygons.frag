#version 450 core
// Linear factorisation: the distance vector is affine, so that its values at three places tell all others. Its length
// is the depth, so the depth test keeps the closest site of every grid point.
//
// in   of polygons.vert; lengths in [0, 1)
// out  closestSite  site id; colour buffer R32I, cleared to -1

layout(location = 0) flat in int siteId;
layout(location = 1) flat in vec2 firstPixel;
layout(location = 2) flat in vec3 alongX;
layout(location = 3) flat in vec3 alongY;
layout(location = 4) flat in vec3 atFirst;

layout(location = 0) out int closestSite;

void main()
{
  // Interpolating would round at the corners of what clipping leaves.
  vec2 p = gl_FragCoord.xy - firstPixel;
  gl_FragDepth = length(atFirst + p.x * alongX + p.y * alongY);
  closestSite = siteId;
}
