#pragma once

#include <cstdint>

/// Replaces operator new and delete of the whole process, to count allocations on all threads and
/// to make some of them fail.
namespace medial::test
{

/// What fails, of the allocations that are counted.
enum class Failing
{
  Once,  ///< the n-th one
  FromOn ///< the n-th one and all that follow
};

/// Counts from 1 again, and makes allocation `n` fail by std::bad_alloc; none for 0.
void failAllocation(std::int64_t n, Failing failing);

/// Lets all allocations succeed again, and returns how many there were since failAllocation().
std::int64_t stopFailing();

/// Returns the distance between the allocations that tests let fail: that in the environment
/// variable MEDIAL_FAULT_STEP, where 1 tries all of them, or less, so that 50 are tried.
/// @param count of allocations.
std::int64_t stepBetweenFailures(std::int64_t count);

/// Blocks that are allocated now.
std::int64_t liveBlocks();

} // namespace medial::test
