// What faces.comp finds out about every face, by fours.

layout(std430, binding = 2) readonly buffer Faces { double faces[]; };

// unit normal; zero if the face has no area
dvec3 faceNormal(int face)
{
  return dvec3(faces[4 * face], faces[4 * face + 1], faces[4 * face + 2]);
}

int longestEdge(int face)
{
  return int(faces[4 * face + 3]) & 3;
}

// whether the face is a site: thin ones are not, since their edges stand for them
bool faceActive(int face)
{
  return (int(faces[4 * face + 3]) & 4) != 0;
}
