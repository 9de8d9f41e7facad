#include "field/engines/rasteriser/site_rectangles.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <array>
#include <limits>

namespace medial
{
namespace
{

constexpr int kTileSize = 8;

} // namespace

SiteRectangles::Counts& SiteRectangles::Counts::operator+=(const Counts& other)
{
  tests += other.tests;
  pairs += other.pairs;
  polygons += other.polygons;
  seconds += other.seconds;
  return *this;
}

SiteRectangles::SiteRectangles(const DeviceMesh& mesh, Kernels& kernels)
  : mesh_(mesh)
  , kernels_(kernels)
  , lists_(mesh, kernels)
{
}

void SiteRectangles::move()
{
  constexpr std::int64_t kSlotBytes = 8 * sizeof(std::int32_t);
  constexpr std::int64_t kReachBytes = 4 * sizeof(std::int32_t);
  obtainBuffer(partSites_, mesh_.slotCount() * kSlotBytes);
  obtainBuffer(reaches_, mesh_.siteCount() * kReachBytes);
  obtainBuffer(firsts_, mesh_.siteCount() * std::int64_t{ sizeof(std::uint32_t) });
  const gl::ShaderProgram& kernel = gl::cachedProgram("part_sites.comp");
  mesh_.describe(kernel);
  kernel.set("slotCount", mesh_.slotCount());
  kernels_.startItems(kernel,
    { &mesh_.connectivity(), &mesh_.points(), &mesh_.faces(), &mesh_.order(), &partSites_ },
    mesh_.slotCount());
}

void SiteRectangles::begin(const GridFrame& frame, const Extent& slab)
{
  frame_ = frame;
  slab_ = slab;
  layer_ = -1;
  total_ = 0;
  listed_ = 0;
  counts_ = {};
  this->cull();
}

void SiteRectangles::cull()
{
  SearchCounters counters{};
  do
  {
    lists_.begin(slab_);
    for (std::size_t level = 0; level < TileLists::kLevels; ++level)
    {
      lists_.refine(*frame_, slab_, level);
    }
    counters = this->readCounters();
    counts_.tests += counters.tests;
  } while (lists_.grow(counters));
}

SearchCounters SiteRectangles::readCounters() const
{
  SearchCounters counters{};
  glGetNamedBufferSubData(lists_.counters().id(), 0, sizeof(counters), &counters);
  kernels_.counts().bytesReadBack += sizeof(counters);
  gl::checkGl("reading counters back");
  return counters;
}

int SiteRectangles::next(const gl::Buffer& rectangles, int room)
{
  return timed(counts_.seconds, [&] { return this->list(rectangles, room); });
}

int SiteRectangles::list(const gl::Buffer& rectangles, int room)
{
  while (listed_ == total_)
  {
    if (!this->openLayer())
    {
      return 0;
    }
  }
  const int count = std::min(room, total_ - listed_);
  const gl::ShaderProgram& kernel = gl::cachedProgram("list_rectangles.comp");
  const int firstSlice = slab_.min[2] + layer_ * kTileSize;
  kernel.set("siteCount", mesh_.siteCount());
  kernel.set("slabMin", glm::ivec3(slab_.min[0], slab_.min[1], slab_.min[2]));
  kernel.set("slices", glm::ivec2(firstSlice, firstSlice + this->slicesOfLayer() - 1));
  kernel.set("begin", listed_);
  kernel.set("end", listed_ + count);
  kernels_.startItems(kernel, { &reaches_, &firsts_, &rectangles }, mesh_.siteCount());
  listed_ += count;
  counts_.polygons += std::int64_t{ count } * this->slicesOfLayer();
  return count;
}

int SiteRectangles::slicesOfLayer() const
{
  return std::min(kTileSize, slab_.size(2) - layer_ * kTileSize);
}

/// Goes on with the next layer of tiles.
/// @return whether there is one.
bool SiteRectangles::openLayer()
{
  if (++layer_ >= lists_.tiles().z)
  {
    return false;
  }
  this->gather();
  const gl::ShaderProgram& count = gl::cachedProgram("count_rectangles.comp");
  count.set("siteCount", mesh_.siteCount());
  kernels_.startItems(count, { &reaches_, &firsts_ }, mesh_.siteCount());
  const gl::ShaderProgram& number = gl::cachedProgram("number_shares.comp");
  number.set("count", mesh_.siteCount());
  kernels_.start(number, { &firsts_, nullptr, nullptr, nullptr, &lists_.counters() },
    glm::ivec3(1));
  const SearchCounters counters = this->readCounters();
  counts_.pairs = counters.pairs;
  total_ = static_cast<int>(counters.listed);
  listed_ = 0;
  return true;
}

void SiteRectangles::gather()
{
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  constexpr std::array<std::int32_t, 4> kNowhere = { kMost, kMost, -1, -1 };
  glClearNamedBufferData(reaches_.id(), GL_RGBA32I, GL_RGBA_INTEGER, GL_INT, kNowhere.data());
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  const gl::ShaderProgram& kernel = gl::cachedProgram("gather_reaches.comp");
  lists_.setGrid(kernel, *frame_, slab_);
  kernel.set("tiles", lists_.tiles());
  kernel.set("tilesAt", lists_.firstTile());
  kernel.set("layer", layer_);
  kernels_.start(kernel,
    { &mesh_.elements(), &mesh_.discs(), &lists_.ranges(), &lists_.lists(), &lists_.counters(),
      &partSites_, &reaches_ },
    { lists_.tiles().x, lists_.tiles().y, 1 });
  gl::checkGl("gathering tiles");
}

} // namespace medial
