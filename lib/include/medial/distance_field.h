#pragma once

#include "medial/closest_feature.h"
#include "medial/engine.h"
#include "medial/execution.h"
#include "medial/grid.h"
#include "medial/run_statistics.h"
#include "medial/side.h"
#include "medial/sign_method.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace medial
{

/// Smallest DistanceFieldOptions::memoryMiB but 0 that filters and programs accept. The library
/// takes any.
constexpr int kMinMemoryMiB = 64;

/// How a distance field is computed.
struct DistanceFieldOptions
{
  SignMethod sign = SignMethod::Auto; ///< how to tell inside from outside
  Engine engine = Engine::Auto;       ///< what finds the closest sites
  /// What an engine that uses OpenGL computes on: a device's number, or a part of its name, as in
  /// DeviceList; empty for the best. If it is missing or fails, Engine::Auto uses the processor,
  /// and RunStatistics::note says why. A process has one device, that of its first such engine.
  std::string device;
  /// Memory in MiB that the slabs in progress should not exceed, on the host together with the
  /// candidates of blocks, and on the device; 0 lets the library choose. Sites, the candidates of
  /// tiles and the caller's arrays are not included. A slab has at least one slice. The limit
  /// changes no byte of what the processor computes.
  std::size_t memoryMiB = 0;
  /// Fail without OpenGL or with a software renderer, whatever the engine.
  bool requireHardware = false;
  /// Check the engine `device` against exact distances at 1,000 random grid points. On graphics
  /// hardware, the first field of a process is checked in any case.
  bool verify = false;
  Execution execution; ///< threads, progress and cancelling
};

/// The arrays that receive results. Each has one element (closestPoint: three) per point of the
/// extent, x fastest. A null pointer means that the array is not needed.
struct FieldArrays
{
  /// World units; negative inside unless unsigned. Beyond 4096 times the finest spacing, it is the
  /// exact distance rounded to single precision.
  float* distance = nullptr;
  float* closestPoint = nullptr;          ///< world coordinates, xyz
  std::int32_t* closestSite = nullptr;    ///< in [0, F+E+V): faces, then edges, then vertices
  std::uint8_t* closestFeature = nullptr; ///< a value of Feature
  std::int64_t* closestCell = nullptr;    ///< id of an input cell that contains the closest site

  /// Whether any array is asked for.
  bool any() const
  {
    return distance || closestPoint || closestSite || closestFeature || closestCell;
  }
};

/// Receives a field slab by slab in ascending z, for grids that do not fit into memory.
class FieldSink
{
public:
  virtual ~FieldSink() = default;

  /// Returns the arrays that receive the values of a slab, with one element (closestPoint: three)
  /// per point of `slab`. The same arrays must be asked for with every slab, and they must stay
  /// valid until stored(slab). There is one slab at a time. This function, like the other members,
  /// is called on the thread that runs the computation.
  virtual FieldArrays slabArrays(const Extent& slab) = 0;
  /// Called when all values of the slab have been written.
  virtual void stored(const Extent& slab) = 0;
  /// Bytes that the sink holds per point of a slab; they count towards
  /// DistanceFieldOptions::memoryMiB.
  virtual std::size_t bytesPerPoint() const = 0;
  /// The side whose values are wanted. Points on the other side may be left out: then the arrays
  /// keep what is there.
  virtual Side side() const { return Side::Both; }
};

/// Receives a field that nobody wants.
class NoField : public FieldSink
{
public:
  FieldArrays slabArrays(const Extent& /*slab*/) override { return {}; }
  void stored(const Extent& /*slab*/) override {}
  std::size_t bytesPerPoint() const override { return 0; }
};

/// A distance field in memory. Each array has one element (closestPoint: three) per grid point, x
/// fastest.
struct DistanceField
{
  Grid grid;                                ///< the grid of the field
  SignMethod sign = SignMethod::None;       ///< the method used, never Auto
  std::vector<float> distance;              ///< as FieldArrays::distance
  std::vector<float> closestPoint;          ///< as FieldArrays::closestPoint
  std::vector<std::int32_t> closestSite;    ///< as FieldArrays::closestSite
  std::vector<std::uint8_t> closestFeature; ///< as FieldArrays::closestFeature
  std::vector<std::int64_t> closestCell;    ///< as FieldArrays::closestCell
  RunStatistics statistics;                 ///< times and counts of the computation
};

} // namespace medial
