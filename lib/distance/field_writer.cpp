#include "medial/distance/field_writer.h"

#include "medial/sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace medial
{

FieldWriter::FieldWriter(const TriangleMesh& mesh, const MeshTopology& topology,
  const SiteSet& sites, const GridFrame& frame, const Extent& extent, const FieldArrays& arrays,
  bool signedField)
  : mesh_(mesh)
  , topology_(topology)
  , sites_(sites)
  , frame_(frame)
  , extent_(extent)
  , arrays_(arrays)
  , signed_(signedField)
{
}

void FieldWriter::fetch(const SlabRenderer& renderer, const Extent& slab)
{
  const auto count = static_cast<std::size_t>(slab.pointCount());
  if (arrays_.distance || arrays_.closestPoint)
  {
    displacements_.resize(count);
    renderer.readDisplacements(slab.size(2), displacements_.data());
  }
  if (arrays_.closestSite || arrays_.closestFeature || arrays_.closestCell)
  {
    closest_.resize(count);
    renderer.readSites(slab.size(2), closest_.data());
  }
}

void FieldWriter::store(const Extent& slab)
{
  const std::int64_t rowLength = slab.size(0);
  const std::int64_t rows = static_cast<std::int64_t>(slab.size(1)) * slab.size(2);
  const std::int64_t start = (slab.min[2] - extent_.min[2]) * rowLength * slab.size(1);
  tbb::parallel_for(std::int64_t{ 0 }, rows,
    [&](std::int64_t row)
    {
      const std::int64_t slice = row / slab.size(1);
      const auto j = static_cast<double>(slab.min[1] + row - slice * slab.size(1));
      const auto k = static_cast<double>(slab.min[2] + slice);
      for (std::int64_t i = 0; i < rowLength; ++i)
      {
        const std::int64_t source = row * rowLength + i;
        const glm::dvec3 index(slab.min[0] + static_cast<double>(i), j, k);
        this->storePoint(start + source, static_cast<std::size_t>(source), frame_.sample(index));
      }
    });
}

void FieldWriter::storePoint(std::int64_t target, std::size_t source,
  const glm::dvec3& sample) const
{
  if (arrays_.distance)
  {
    arrays_.distance[target] =
      static_cast<float>(static_cast<double>(displacements_[source].w) * frame_.unit);
  }
  if (arrays_.closestPoint)
  {
    const Point3 world = frame_.toWorld(sample + glm::dvec3(glm::vec3(displacements_[source])));
    for (int axis = 0; axis < 3; ++axis)
    {
      arrays_.closestPoint[3 * target + axis] = static_cast<float>(world[axis]);
    }
  }
  this->storeIds(target, closest_[source]);
}

void FieldWriter::storeIds(std::int64_t target, std::int32_t site) const
{
  if (arrays_.closestSite)
  {
    arrays_.closestSite[target] = site;
  }
  if (arrays_.closestFeature)
  {
    const SiteKind kind = sites_.kind(site);
    arrays_.closestFeature[target] = static_cast<std::uint8_t>(kind == SiteKind::Face
        ? Feature::Face
        : (kind == SiteKind::Edge ? Feature::Edge : Feature::Vertex));
  }
  if (arrays_.closestCell)
  {
    arrays_.closestCell[target] = this->cellOf(site);
  }
}

void FieldWriter::store(const Extent& tile, const TileField& field) const
{
  for (int k = 0; k < tile.size(2); ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      const std::int64_t row =
        static_cast<std::int64_t>(tile.min[2] + k - extent_.min[2]) * extent_.size(1) +
        (tile.min[1] + j - extent_.min[1]);
      const std::int64_t target = row * extent_.size(0) + (tile.min[0] - extent_.min[0]);
      this->storeRow(target, { tile.min[0], tile.min[1] + j, tile.min[2] + k }, tile.size(0), field,
        TileField::index(0, j, k));
    }
  }
}

void FieldWriter::storeRow(std::int64_t target, const glm::ivec3& first, int count,
  const TileField& field, int row) const
{
  if (arrays_.distance)
  {
    for (int i = 0; i < count; ++i)
    {
      const float distance = std::sqrt(field.squared[row + i]) * static_cast<float>(frame_.unit);
      arrays_.distance[target + i] = signed_ && field.side[row + i] < 0.0f ? -distance : distance;
    }
  }
  if (arrays_.closestPoint)
  {
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec3 sample = frame_.sample(glm::dvec3(first + glm::ivec3(i, 0, 0)));
      const Point3 world =
        frame_.toWorld(medial::closestPoint(sites_, field.site[row + i], sample).point);
      for (int axis = 0; axis < 3; ++axis)
      {
        arrays_.closestPoint[3 * (target + i) + axis] = static_cast<float>(world[axis]);
      }
    }
  }
  if (arrays_.closestSite && !arrays_.closestFeature && !arrays_.closestCell)
  {
    std::copy_n(field.site + row, count, arrays_.closestSite + target);
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    this->storeIds(target + i, field.site[row + i]);
  }
}

std::int64_t FieldWriter::cellOf(std::int32_t site) const
{
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
      return mesh_.triangleCells[site];
    case SiteKind::Edge:
      return topology_.edgeCells[site - sites_.firstEdge()];
    case SiteKind::Vertex:
      break;
  }
  return topology_.pointCells[site - sites_.firstVertex()];
}

} // namespace medial
