#include "field/engines/device/inside_bits.h"

#include <algorithm>
#include <cstddef>

namespace medial
{
namespace
{

/// Where there are more doubts, the host does it all.
constexpr std::uint32_t kDoubts = 1 << 12;
constexpr std::int64_t kFirstDoubt = sizeof(std::uint32_t);

int slotsOf(const Extent& slab)
{
  return 1 + slab.size(2);
}

std::int64_t rowsOf(const Extent& slab)
{
  return std::int64_t{ slotsOf(slab) } * slab.size(1);
}

/// The slices of which the rows count: with the one below the slab, where there is one.
int firstSliceOf(const FieldJob& job, const Extent& slab)
{
  return std::max(slab.min[2] - 1, job.extent.min[2]);
}

/// Bound of the errors of positions on the device and of rounding on both sides, local units.
double doubtOf(const DeviceMesh& mesh, const GridFrame& frame)
{
  constexpr double kRounding = 1e-12;
  return mesh.positionError() + kRounding * (1.0 + frame.reach() + mesh.reach());
}

void setRows(const gl::ShaderProgram& kernel, const Extent& slab)
{
  kernel.set("slabSize", glm::ivec3(slab.size(0), slab.size(1), slab.size(2)));
  kernel.set("slots", slotsOf(slab));
}

} // namespace

InsideBits::InsideBits(const DeviceMesh& mesh, Kernels& kernels)
  : mesh_(mesh)
  , kernels_(kernels)
{
}

void InsideBits::prepare(const FieldJob& job)
{
  isWanted_ = job.inside != nullptr;
  hasLids_ = isWanted_ && job.inside->sign().surface().holes > 0;
  if (!isWanted_ || hasLids_)
  {
    return;
  }
  const std::vector<std::int8_t>& weights = job.inside->sign().weights();
  if (!std::equal(weights_.begin(), weights_.end(), weights.begin(), weights.end()))
  {
    weights_.assign(weights.begin(), weights.end());
    isUploaded_ = false;
  }
}

void InsideBits::uploadWeights()
{
  const auto bytes = static_cast<std::int64_t>(weights_.size() * sizeof(std::int32_t));
  obtainBuffer(weightBuffer_, bytes);
  kernels_.upload(weightBuffer_, 0, bytes, weights_.data());
  isUploaded_ = true;
}

void InsideBits::cut(const FieldJob& job, const Extent& slab)
{
  obtainBuffer(changes_, 4 * rowsOf(slab) * slab.size(0));
  obtainBuffer(doubtBuffer_, kFirstDoubt + kDoubts * std::int64_t{ sizeof(Doubt) });
  clearBuffer(changes_);
  clearBuffer(doubtBuffer_);
  byHost_ = hasLids_;
  if (byHost_)
  {
    return;
  }
  if (!isUploaded_)
  {
    this->uploadWeights();
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  const gl::ShaderProgram& kernel = gl::cachedProgram("cut_rows.comp");
  mesh_.describe(kernel);
  setRows(kernel, slab);
  kernel.set("rowFirst", job.inside->sign().frame().first);
  kernel.set("exactSpacing", job.frame.step);
  kernel.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  kernel.set("firstSlice", firstSliceOf(job, slab));
  kernel.set("doubt", doubtOf(mesh_, job.frame));
  kernel.set("room", static_cast<int>(kDoubts));
  kernels_.startGroups(kernel,
    { &mesh_.connectivity(), &mesh_.points(), &weightBuffer_, &changes_, &doubtBuffer_ },
    static_cast<std::int64_t>(weights_.size()));
  fence_.set();
  gl::checkGl("cutting rows");
}

bool InsideBits::isCut(std::uint64_t nanoseconds)
{
  doubts_.clear();
  if (byHost_)
  {
    return true;
  }
  if (!fence_.isReached(nanoseconds))
  {
    return false;
  }
  const auto read = [&](std::int64_t offset, std::int64_t bytes, void* values)
  {
    glGetNamedBufferSubData(doubtBuffer_.id(), static_cast<GLintptr>(offset),
      static_cast<GLsizeiptr>(bytes), values);
    kernels_.counts().bytesReadBack += bytes;
  };
  std::uint32_t count = 0;
  read(0, sizeof(count), &count);
  if (count > kDoubts)
  {
    byHost_ = true;
    clearBuffer(changes_);
  }
  else if (count > 0)
  {
    doubts_.resize(count);
    read(kFirstDoubt, static_cast<std::int64_t>(count * sizeof(Doubt)), doubts_.data());
  }
  gl::checkGl("reading doubts back");
  return true;
}

void InsideBits::decide(const FieldJob& job, const Extent& slab)
{
  found_.clear();
  const auto add = [&](const glm::ivec3& point, int change)
  {
    const glm::ivec3 at = point - glm::ivec3(slab.min[0], slab.min[1], slab.min[2] - 1);
    found_.emplace_back((at.z * slab.size(1) + at.y) * slab.size(0) + at.x, change);
  };
  if (byHost_)
  {
    job.inside->rows().visitChanges(firstSliceOf(job, slab), slab.max[2], add);
    return;
  }
  const SignChoice& sign = job.inside->sign();
  SliceCrossings crossings;
  for (const Doubt& doubt : doubts_)
  {
    Extent row = job.extent;
    row.min[1] = row.max[1] = doubt.row;
    crossings.clear();
    addCrossings(
      sign.surface().chain.cornersOf({ job.mesh.triangles[doubt.face], weights_[doubt.face] }),
      weights_[doubt.face], sign.frame(), row, doubt.slice, crossings);
    for (const RowCrossing& crossing : crossings)
    {
      add({ crossing.point, crossing.row, doubt.slice }, crossing.change);
    }
  }
}

void InsideBits::wind(const Extent& slab)
{
  if (!found_.empty())
  {
    const auto bytes = static_cast<std::int64_t>(found_.size() * sizeof(found_[0]));
    obtainBuffer(foundBuffer_, bytes);
    kernels_.upload(foundBuffer_, 0, bytes, found_.data());
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    const gl::ShaderProgram& kernel = gl::cachedProgram("add_changes.comp");
    kernel.set("count", static_cast<int>(found_.size()));
    kernels_.startItems(kernel, { &foundBuffer_, &changes_ },
      static_cast<std::int64_t>(found_.size()));
  }
  obtainBuffer(bits_, 4 * rowsOf(slab) * ((slab.size(0) + 31) / 32));
  const gl::ShaderProgram& kernel = gl::cachedProgram("wind_rows.comp");
  setRows(kernel, slab);
  kernels_.startItems(kernel, { &changes_, &bits_ }, rowsOf(slab));
  gl::checkGl("winding rows");
}

} // namespace medial
