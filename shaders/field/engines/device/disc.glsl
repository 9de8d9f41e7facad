// Discs around groups of elements and around nodes of the tree above them: as Discs.

struct Disc
{
  vec3 centre;
  float radius;
  vec3 normal; // unit vector along the axis
  float halfHeight;
  vec3 surfacePoint; // some point of the surface, near the centre
  float slope;       // of the cone around the normals, kNoCone if there is none
};

const float kNoCone = 1e30;
const int kDisc = 3; // vec4 of a disc

// The slope of a cone of this angle, a little larger by rounding.
float slopeOf(float cone)
{
  const float wide = 1.3;
  const float rounding = 1e-4;
  return cone < wide ? tan(cone) * (1.0 + rounding) + rounding : kNoCone;
}

// An angle by its cosine, a little larger by the rounding of any driver.
float angleOf(double cosine)
{
  const float rounding = 1e-3;
  float c = float(clamp(cosine, -1.0LF, 1.0LF));
  return atan(sqrt(max(1.0 - c * c, 0.0)), c) + rounding;
}
