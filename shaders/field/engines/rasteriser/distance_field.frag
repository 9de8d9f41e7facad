#version 450 core
// Linear factorisation: the interpolated distance vector is exact. Its length is the depth, so
// the depth test keeps the closest site of every grid point.
//
// in   scaledVector  distance vector, length in [0, 1)
// out  closestSite   site id; colour buffer R32I, cleared to -1

layout(location = 0) in vec3 scaledVector;
layout(location = 1) flat in int siteId;

layout(location = 0) out int closestSite;

void main()
{
  gl_FragDepth = length(scaledVector);
  closestSite = siteId;
}
