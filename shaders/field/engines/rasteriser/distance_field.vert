#version 450 core
// Vertices of polygons that bound the Voronoi regions of sites on one slice (paper, section 3).
//
// in   position      atlas pixels; pixel centres are grid points
//      distance      vector to the site, affine in the position; only its length matters, so
//                    its axes are those of the site; local units
//      site          site id
// out  scaledVector  `distance` times a power of two that brings every length below 1

layout(location = 0) in vec2 position;
layout(location = 1) in vec3 distance;
layout(location = 2) in int site;

uniform vec2 atlasSize;
uniform float depthScale;

layout(location = 0) out vec3 scaledVector;
layout(location = 1) flat out int siteId;

void main()
{
  scaledVector = distance * depthScale;
  siteId = site;
  gl_Position = vec4(2.0 * position / atlasSize - 1.0, 0.0, 1.0);
}
