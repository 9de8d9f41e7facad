#pragma once

#include "field/field_job.h"
#include "field/field_writer.h"
#include "medial/grid.h"

#include <cstdint>
#include <string>

namespace medial
{

/// Compares what a device has computed with exact queries, at random grid points: drivers may
/// compile shaders wrongly. On hardware this is done for the first field of a process.
class SelfCheck
{
public:
  /// @param job its sites are made on the host, if the check is due.
  /// @param device says what is to blame.
  SelfCheck(const FieldJob& job, const Device& device);

  /// Whether there is anything to check.
  bool isDue() const { return share_ > 0.0; }

  /// Checks the distances of a slab, before it is stored.
  /// @throws Error NoGpu if one is wrong.
  void check(const Extent& slab, const ResolvedSlab& values);
  /// To be called when the whole field is right.
  void passed() const;

private:
  std::uint64_t random();

  const FieldJob& job_;
  std::string device_;
  double share_ = 0.0; ///< of the grid points that are checked
  bool isFirst_ = true;
  std::uint64_t state_ = 0x9e3779b97f4a7c15ull;
};

} // namespace medial
