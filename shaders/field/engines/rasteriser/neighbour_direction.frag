#version 450 core
// Neighbour direction field (Foskey, Lin, Manocha 2003): the unit vector from every grid point to
// its closest surface point.
//
// in   displacement  RGBA32F atlas; xyz: vector to the closest point, w: signed distance
// out  direction     xyz: unit vector, zero on the surface; w: signed distance, local units

uniform sampler2D displacement;

layout(location = 0) out vec4 direction;

void main()
{
  vec4 d = texelFetch(displacement, ivec2(gl_FragCoord.xy), 0);
  float distance = abs(d.w);
  direction = vec4(distance > 0.0 ? d.xyz / distance : vec3(0.0), d.w);
}
