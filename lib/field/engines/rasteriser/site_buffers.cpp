#include "field/engines/rasteriser/site_buffers.h"

namespace medial
{
namespace
{

/// Overwrites a buffer.
template <typename T>
void upload(const std::vector<T>& values, gl::Buffer& buffer, Kernels& kernels)
{
  const auto bytes = static_cast<std::int64_t>(values.size() * sizeof(T));
  obtainBuffer(buffer, bytes);
  kernels.upload(buffer, 0, bytes, values.data());
}

/// Returns what faces.comp would write.
std::vector<glm::dvec4> facesOf(const SiteSet& sites)
{
  constexpr int kActive = 4;
  std::vector<glm::dvec4> faces;
  faces.reserve(sites.faces().size());
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    faces.emplace_back(sites.faceNormal(face),
      sites.longestEdge(face) + (sites.active(face) ? kActive : 0));
  }
  return faces;
}

} // namespace

SiteBuffers::SiteBuffers(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  Kernels& kernels)
  : connectivity_(mesh, connectivity, kernels)
{
}

void SiteBuffers::move(const SiteSet& sites, const std::vector<glm::vec4>& normals,
  Kernels& kernels)
{
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(double), "points lie by threes");
  upload(sites.points(), points_, kernels);
  upload(facesOf(sites), faces_, kernels);
  upload(normals, normals_, kernels);
}

} // namespace medial
