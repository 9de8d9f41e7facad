#pragma once

#include "medial/export.h"

namespace medial
{

/// Receives progress and answers whether to go on. Long operations call both from the thread that
/// started them: for every slab of slices, and within steps that take long.
class MEDIAL_EXPORT Progress
{
public:
  virtual ~Progress() = default; ///< by derived classes

  /// @param fraction share of the whole work that is done, in [0, 1], never decreasing.
  /// @param phase what is being done, a short lower-case text with static storage.
  virtual void report(double fraction, const char* phase) = 0;

  /// Returns true to stop the work: the operation then throws Error with ErrorCode::Cancelled.
  virtual bool cancelled() { return false; }
};

/// How an operation runs. It never changes a result.
struct Execution
{
  /// CPU threads to use, >= 0; 0 for all cores, and no more than there are cores.
  int threads = 0;
  /// Hears of progress and may cancel; may be null. Must outlive the operation.
  Progress* progress = nullptr;
};

} // namespace medial
