#include "thinning/solid_thinning.h"

#include "base/huge_pages.h"
#include "thinning/sheet_faces.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

template <typename T>
std::vector<T> at(const std::vector<std::size_t>& indices, const std::vector<T>& items)
{
  std::vector<T> result;
  reserveLarge(result, indices.size());
  for (const std::size_t i : indices)
  {
    result.push_back(items[i]);
  }
  return result;
}

/// Returns the faces dual to crossings whose grid edge itself crosses a sheet. Fins around a curve
/// do not count, since their bisector point is elsewhere.
/// @param samples the bisector points of the crossings come first.
std::vector<CubeCell> sheetFaces(const CubicalComplex& complex,
  const std::vector<Crossing>& crossings, const AxisSamples& samples,
  const std::vector<std::uint8_t>& exact)
{
  std::vector<CubeCell> faces;
  reserveLarge(faces, crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (samples.points().moved[i] == 0)
    {
      faces.push_back(dualFace(complex, crossings[i]));
    }
  }
  // Crossings come in the order of slabs, whose thickness must have no influence.
  tbb::parallel_sort(faces.begin(), faces.end());
  return splitSheets(complex.size(), faces, samples, exact).sheets;
}

} // namespace

SelectedCrossings someOf(const std::vector<std::size_t>& indices,
  const std::vector<Crossing>& crossings, const BisectorPoints& bisectors,
  const std::vector<std::uint8_t>& exact)
{
  SelectedCrossings some;
  tbb::parallel_invoke([&] { some.bisectors.points = at(indices, bisectors.points); },
    [&] { some.bisectors.moved = at(indices, bisectors.moved); },
    [&] { some.crossings = at(indices, crossings); }, [&] { some.exact = at(indices, exact); });
  return some;
}

std::vector<std::uint8_t> exactPairs(const SheetSelection& sheets)
{
  std::vector<std::uint8_t> exact;
  for (std::size_t sample = 0; sample < sheets.kept.size(); ++sample)
  {
    if (sheets.kept[sample] != 0)
    {
      exact.push_back(sheets.samples.kinds[sample] == SampleKind::Exact ? 1 : 0);
    }
  }
  return exact;
}

std::vector<std::size_t> crossingsWithin(const DepthField& depth, const Extent& part,
  const glm::ivec3& grid, const std::vector<Crossing>& crossings)
{
  // The part without the border of the grid; nothing of a grid of two slices.
  const glm::ivec3 first(part.min[0], part.min[1], part.min[2]);
  const glm::ivec3 low = glm::max(first, 1);
  const glm::ivec3 high = glm::min(glm::ivec3(part.max[0], part.max[1], part.max[2]), grid - 2);
  const auto isVoxel = [&](const glm::ivec3& point)
  {
    if (glm::any(glm::lessThan(point, low)) || glm::any(glm::greaterThan(point, high)))
    {
      return false;
    }
    const glm::ivec3 p = point - first;
    return depth.wanted((static_cast<std::size_t>(p.z) * part.size(1) + p.y) * part.size(0) + p.x);
  };
  std::vector<std::uint8_t> within(crossings.size());
  tbb::parallel_for(std::size_t{ 0 }, crossings.size(),
    [&](std::size_t i)
    {
      glm::ivec3 end = crossings[i].voxel;
      ++end[crossings[i].axis];
      within[i] = isVoxel(crossings[i].voxel) && isVoxel(end) ? 1 : 0;
    });
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < within.size(); ++i)
  {
    if (within[i] != 0)
    {
      indices.push_back(i);
    }
  }
  return indices;
}

SolidThinning::SolidThinning(const glm::ivec3& size, SelectedCrossings selected,
  const Checkpoint& checkpoint)
  : checkpoint_(checkpoint)
  , complex_(size)
  , exact_(std::move(selected.exact))
  , samples_(complex_, selected.crossings, std::move(selected.bisectors))
{
  anchored_ = sheetFaces(complex_, selected.crossings, samples_, exact_);
  complex_ = closureOf(size, anchored_);
  std::copy_if(selected.crossings.begin(), selected.crossings.end(), std::back_inserter(crossings_),
    [&](const Crossing& crossing) { return !complex_.has(dualFace(complex_, crossing)); });
}

/// The rules for curves apply to strips: selected ones, and those that sheets were reduced to where
/// they enclose voxels.
void SolidThinning::burn(Thinning::DepthAt depthAt, Thinning::EdgeTest separates,
  const glm::dvec3& step, const CurveLimits& limits)
{
  Thinning thinning(complex_, std::move(depthAt), std::move(separates), step, limits, checkpoint_);
  thinning.anchor(anchored_,
    [&](CubeCell face)
    { return static_cast<float>(samples_.point(samples_.find(face)).separationAngle()); });
  thinning.burn();
  std::vector<CubeCell> left;
  std::copy_if(anchored_.begin(), anchored_.end(), std::back_inserter(left),
    [&](CubeCell face) { return complex_.has(face); });
  thinning.release(splitSheets(complex_, left, samples_, exact_).strips);
}

} // namespace medial
