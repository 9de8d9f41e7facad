// Which side of the surface grid points are on. Needs rows.glsl.

layout(std430, binding = 4) readonly buffer Sides { uint sides[]; }; // pseudonormals of all sites by fours, or bits

uniform int sidesBy;

const int kByNormals = 1;
const int kByBits = 2;

// site, v: the closest one, and the vector to it
// row, x: of the grid point; rows begin with those of the slice below the slab
bool isInside(int site, dvec3 v, int row, int x)
{
  if (sidesBy == kByBits)
  {
    return (sides[row * wordsOfRow() + (x >> 5)] >> (x & 31) & 1u) != 0u;
  }
  if (sidesBy == kByNormals)
  {
    vec3 normal = uintBitsToFloat(uvec3(sides[4 * site], sides[4 * site + 1], sides[4 * site + 2]));
    return dot(normal, vec3(v)) > 0.0;
  }
  return false;
}
