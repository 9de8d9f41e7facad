#include "base/borrowed_arena.h"

#include <gtest/gtest.h>

namespace
{

using medial::BorrowedArena;

const tbb::task_arena* arenaAfter(int threads)
{
  const BorrowedArena arena(threads);
  return arena.operator->();
}

TEST(BorrowedArena, IsUsedAgain)
{
  const tbb::task_arena* const first = arenaAfter(2);
  EXPECT_EQ(arenaAfter(2), first);
}

TEST(BorrowedArena, HasTheThreadsThatWereAskedFor)
{
  arenaAfter(2);
  const BorrowedArena one(1);
  EXPECT_EQ(one->execute([] { return tbb::this_task_arena::max_concurrency(); }), 1);
}

TEST(BorrowedArena, IsNotLentTwiceAtOnce)
{
  arenaAfter(1);
  const BorrowedArena one(1);
  const BorrowedArena other(1);
  EXPECT_NE(one.operator->(), other.operator->());
}

} // namespace
