#include "field/engines/device/split_field.h"

#include "base/stopwatch.h"
#include "field/engines/device/device_run.h"
#include "field/engines/processor/processor_selection.h"
#include "medial/error.h"
#include "sites/closest_point.h"

#include <glm/gtc/type_ptr.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <string>

namespace medial
{
namespace
{

/// A part with its job.
struct PartJob
{
  HostSites host; ///< that nobody asks for
  FieldJob job;
  DeviceSlabs slabs;

  PartJob(const FieldJob& whole, const MeshPart& part, DeviceSlabs::Field& field,
    const std::vector<Extent>& extents, const DeviceCounts& before)
    : host(part.mesh, part.connectivity, whole.frame, FieldSign::None, whole.run, whole.statistics)
    , job{ part.mesh, part.connectivity, host, FieldSign::None, nullptr, whole.frame, whole.whole,
      whole.extent, whole.memoryMiB, false, whole.run, whole.statistics }
    , slabs(job, field, extents, before)
  {
  }
};

/// The nearest of the parts' values at the grid points of a slab.
class NearestValues
{
public:
  explicit NearestValues(bool vectors)
    : wantsVectors_(vectors)
  {
  }

  /// What it needs of every part.
  WantedValues wanted() const { return { true, wantsVectors_, true }; }

  void begin(const Extent& slab)
  {
    const auto points = static_cast<std::size_t>(slab.pointCount());
    distances_.resize(points);
    vectors_.resize(wantsVectors_ ? 3 * points : 0);
    sites_.assign(points, -1);
  }

  /// @param first, count grid points of the slab whose values these are.
  /// @param names sites of the whole mesh, by those of the part.
  void add(const ResolvedSlab& values, std::int64_t first, std::int64_t count,
    const std::vector<std::int32_t>& names)
  {
    tbb::parallel_for(std::int64_t{ 0 }, count,
      [&](std::int64_t at)
      {
        const auto i = static_cast<std::size_t>(first + at);
        const float distance = *values.distances.at(at);
        const std::int32_t site = names[values.sites[at]];
        if (sites_[i] >= 0 &&
          (distance > distances_[i] || (distance == distances_[i] && site > sites_[i])))
        {
          return;
        }
        distances_[i] = distance;
        sites_[i] = site;
        if (wantsVectors_)
        {
          std::copy_n(values.vectors.at(at), 3, &vectors_[3 * i]);
        }
      });
  }

  /// Gives distances their sign by pseudonormals.
  void sign(const std::vector<glm::vec4>& normals)
  {
    tbb::parallel_for(std::size_t{ 0 }, sites_.size(),
      [&](std::size_t i)
      {
        if (glm::dot(glm::vec3(normals[sites_[i]]), glm::make_vec3(&vectors_[3 * i])) > 0.0f)
        {
          distances_[i] = -distances_[i];
        }
      });
  }

  ResolvedSlab values() const
  {
    return { { distances_.data(), 1 }, { wantsVectors_ ? vectors_.data() : nullptr, 3 },
      sites_.data() };
  }

private:
  bool wantsVectors_;
  std::vector<float> distances_, vectors_;
  std::vector<std::int32_t> sites_;
};

/// Slabs, each in bands.
struct Bands
{
  std::vector<Extent> extents;
  std::vector<std::size_t> firsts; ///< of every slab, and the end

  /// @throws Error GpuLimit if a row has too many points.
  Bands(const std::vector<Extent>& slabs, std::int64_t maxPoints)
  {
    for (const Extent& slab : slabs)
    {
      firsts.push_back(extents.size());
      const int rows = rowsOfBand(slab, maxPoints);
      for (int row = slab.min[1]; row <= slab.max[1]; row += rows)
      {
        extents.push_back(slab);
        extents.back().min[1] = row;
        extents.back().max[1] = std::min(row + rows - 1, slab.max[1]);
      }
    }
    firsts.push_back(extents.size());
  }

private:
  static int rowsOfBand(const Extent& slab, std::int64_t maxPoints)
  {
    if (slab.pointCount() <= maxPoints)
    {
      return slab.size(1);
    }
    if (slab.size(0) > maxPoints)
    {
      throw Error(ErrorCode::GpuLimit,
        "rows of " + std::to_string(slab.size(0)) + " grid points exceed the " +
          std::to_string(maxPoints) + " that fit the driver's limit for buffers");
    }
    return static_cast<int>(maxPoints / slab.size(0));
  }
};

/// The slabs of a job, of all parts of its mesh.
class PartSlabs
{
public:
  /// Takes over the job's positions.
  PartSlabs(const FieldJob& job, std::vector<SplitField::Part>& parts,
    const std::vector<Extent>& slabs, std::int64_t maxPoints, const WantedValues& wanted)
    : job_(job)
    , parts_(parts)
    , slabs_(slabs)
    , bands_(slabs, maxPoints)
  {
    for (SplitField::Part& part : parts)
    {
      std::vector<Point3>& points = part.mesh.mesh.points;
      std::transform(part.mesh.points.begin(), part.mesh.points.end(), points.begin(),
        [&](int point) { return job.mesh.points[point]; });
      jobs_.push_back(
        std::make_unique<PartJob>(job, part.mesh, *part.field, bands_.extents, part.counted));
      jobs_.back()->slabs.move(wanted, nullptr);
    }
  }

  /// Computes a slab.
  void compute(std::size_t number, const Checkpoint& checkpoint, NearestValues& nearest)
  {
    nearest.begin(slabs_[number]);
    for (std::size_t i = 0; i < jobs_.size(); ++i)
    {
      for (std::size_t band = bands_.firsts[number]; band < bands_.firsts[number + 1]; ++band)
      {
        this->compute(i, number, band, checkpoint, nearest);
      }
    }
    const std::vector<glm::vec4>& normals = job_.host.signNormals();
    if (!normals.empty())
    {
      job_.run.onThreads([&] { nearest.sign(normals); });
    }
  }

  /// Adds what was moved and started to the statistics.
  void addCounts()
  {
    for (std::size_t i = 0; i < jobs_.size(); ++i)
    {
      jobs_[i]->slabs.addCounts();
      parts_[i].counted = parts_[i].field->object().counts();
    }
  }

private:
  void compute(std::size_t part, std::size_t number, std::size_t band, const Checkpoint& checkpoint,
    NearestValues& nearest)
  {
    DeviceSlabs& slabs = jobs_[part]->slabs;
    timed(job_.statistics.seconds.draw,
      [&]
      {
        slabs.start(band, checkpoint);
        slabs.finish(band, checkpoint);
      });
    const ResolvedSlab values = slabs.take(band);
    const Extent& extent = bands_.extents[band];
    const std::int64_t first =
      std::int64_t{ extent.min[1] - slabs_[number].min[1] } * extent.size(0);
    job_.run.onThreads(
      [&] { nearest.add(values, first, extent.pointCount(), parts_[part].mesh.sites); });
  }

  const FieldJob& job_;
  std::vector<SplitField::Part>& parts_;
  const std::vector<Extent>& slabs_;
  Bands bands_;
  std::vector<std::unique_ptr<PartJob>> jobs_;
};

/// The crossings of a job by sites in host memory.
class HostSelection
{
public:
  HostSelection(const FieldJob& job, const CrossingSelection& selection)
    : job_(job)
    , selection_(selection, job.frame, job.extent, job.sign != FieldSign::None, nullptr)
  {
  }

  void process(const Extent& slab, const ResolvedSlab& values)
  {
    const SiteSet& sites = job_.host.sites();
    job_.run.onThreads(
      [&]
      {
        field_.begin(slab);
        field_.store(values.sites, this->sidesOf(slab, values));
        selection_.process(field_,
          [&](int site, const glm::dvec3& x) { return closestPoint(sites, site, x).point - x; });
      });
  }

  std::vector<Crossing> takeCrossings() { return selection_.takeCrossings(); }

private:
  /// Returns values of a slab that are negative inside.
  const float* sidesOf(const Extent& slab, const ResolvedSlab& values)
  {
    const InsideRows* inside = job_.insideRows();
    if (inside == nullptr)
    {
      return values.distances.values;
    }
    sides_.resize(static_cast<std::size_t>(slab.pointCount()));
    float* row = sides_.data();
    for (int z = slab.min[2]; z <= slab.max[2]; ++z)
    {
      for (int y = slab.min[1]; y <= slab.max[1]; ++y, row += slab.size(0))
      {
        inside->write({ slab.min[0], y, z }, slab.size(0), row);
      }
    }
    return sides_.data();
  }

  const FieldJob& job_;
  ProcessorSelection selection_;
  SlabField field_;
  std::vector<float> sides_;
};

} // namespace

SplitField::SplitField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t limit)
{
  for (MeshPart& made : splitMesh(mesh, connectivity, DeviceMesh::elementsWithin(limit)))
  {
    Part& part = parts_.emplace_back();
    part.mesh = std::move(made);
    part.field = std::make_unique<DeviceSlabs::Field>(part.mesh.mesh, part.mesh.connectivity);
  }
}

std::vector<Crossing> SplitField::compute(const FieldJob& job, const Device& device,
  const std::vector<Extent>& slabs, std::int64_t maxPoints, const CrossingSelection* selection,
  FieldSink& sink)
{
  FieldWriter writer(job, job.insideRows());
  SelfCheck check(job, device);
  std::optional<HostSelection> crossings;
  if (selection != nullptr)
  {
    crossings.emplace(job, *selection);
  }
  FieldArrays arrays = sink.slabArrays(slabs[0]);
  NearestValues nearest(arrays.closestPoint != nullptr || !job.host.signNormals().empty());
  PartSlabs parts(job, parts_, slabs, maxPoints, nearest.wanted());
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(slabs.size());
    job.run.report(done, "distance field");
    parts.compute(i, Checkpoint(job.run, done, "distance field"), nearest);
    const ResolvedSlab values = nearest.values();
    check.check(slabs[i], values);
    arrays = i > 0 ? sink.slabArrays(slabs[i]) : arrays;
    writer.begin(slabs[i], arrays);
    timed(job.statistics.seconds.resolve,
      [&] { job.run.onThreads([&] { writer.store(values); }); });
    if (crossings)
    {
      timed(job.statistics.seconds.medial, [&] { crossings->process(slabs[i], values); });
    }
    sink.stored(slabs[i]);
  }
  check.passed();
  parts.addCounts();
  return crossings ? crossings->takeCrossings() : std::vector<Crossing>();
}

} // namespace medial
