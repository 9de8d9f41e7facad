#version 450 core
// Normals of faces, their longest edges, and which of them are sites: as SiteSet.
//
// out  faces  by fours: unit normal; 4 if the face is a site, plus which edge is longest
#include "numbering.glsl"
#include "mesh.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) writeonly buffer Faces { double faces[]; };

uniform double flatHeight; // faces up to this height are not told from those without area
uniform double minHeight;  // lower faces are no sites

void main()
{
  int face = int(itemNumber());
  if (face >= faceCount)
  {
    return;
  }
  ivec3 corners = faceCorners(face);
  dvec3 p[3] = dvec3[3](pointAt(corners.x), pointAt(corners.y), pointAt(corners.z));
  int longest = 0;
  double longestLength = 0.0LF;
  for (int i = 0; i < 3; ++i)
  {
    double size = distance(p[i], p[(i + 1) % 3]);
    if (size > longestLength)
    {
      longestLength = size;
      longest = i;
    }
  }
  dvec3 area = cross(p[1] - p[0], p[2] - p[0]);
  double doubled = length(area);
  double height = longestLength > 0.0LF ? doubled / longestLength : 0.0LF;
  bool isFlat = height <= flatHeight;
  dvec3 normal = isFlat ? dvec3(0.0LF) : area / doubled;
  faces[4 * face] = normal.x;
  faces[4 * face + 1] = normal.y;
  faces[4 * face + 2] = normal.z;
  faces[4 * face + 3] = double(longest + (!isFlat && height >= minHeight ? 4 : 0));
}
