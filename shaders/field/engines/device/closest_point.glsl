// The closest points of sites in double precision: as closestPoint(). Needs mesh.glsl and faces.glsl.

struct SitePoint
{
  int site; // whose interior holds the point
  dvec3 point;
};

SitePoint closestOnEdge(int edge, dvec3 x)
{
  ivec2 ends = edgeEnds(edge);
  dvec3 p = pointAt(ends.x);
  dvec3 q = pointAt(ends.y);
  dvec3 along = q - p;
  double squared = dot(along, along);
  double t = squared > 0.0LF ? dot(x - p, along) / squared : 0.0LF;
  if (t <= 0.0LF)
  {
    return SitePoint(firstVertex() + ends.x, p);
  }
  if (t >= 1.0LF)
  {
    return SitePoint(firstVertex() + ends.y, q);
  }
  return SitePoint(faceCount + edge, p + t * along);
}

SitePoint closestOnFace(int face, dvec3 x)
{
  ivec3 corners = faceCorners(face);
  dvec3 p[3] = dvec3[3](pointAt(corners.x), pointAt(corners.y), pointAt(corners.z));
  dvec3 normal = faceNormal(face);
  bool isBeyond[3]; // whether x is beyond the line of an edge
  for (int i = 0; i < 3; ++i)
  {
    isBeyond[i] = dot(cross(p[(i + 1) % 3] - p[i], normal), x - p[i]) >= 0.0LF;
  }
  bool isOver = !(isBeyond[0] || isBeyond[1] || isBeyond[2]);
  if (isOver && faceActive(face))
  {
    return SitePoint(face, x - dot(x - p[0], normal) * normal);
  }
  // The other two edges of a face without area cover the longest.
  int covered = normal == dvec3(0.0LF) ? longestEdge(face) : -1;
  ivec3 border = faceEdges(face);
  SitePoint best = SitePoint(-1, dvec3(0.0LF));
  double least = 0.0LF;
  for (int i = 0; i < 3; ++i)
  {
    // The nearest edge is one that x is beyond, unless the face stands for none.
    if (i != covered && (isBeyond[i] || isOver))
    {
      SitePoint other = closestOnEdge(border[i], x);
      dvec3 v = other.point - x;
      double squared = dot(v, v);
      if (best.site < 0 || squared < least)
      {
        best = other;
        least = squared;
      }
    }
  }
  return best;
}

SitePoint closestOnSite(int site, dvec3 x)
{
  if (site < faceCount)
  {
    return closestOnFace(site, x);
  }
  if (site < firstVertex())
  {
    return closestOnEdge(site - faceCount, x);
  }
  return SitePoint(site, pointAt(site - firstVertex()));
}
