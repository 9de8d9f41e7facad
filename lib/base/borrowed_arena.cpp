#include "base/borrowed_arena.h"

#include <map>
#include <mutex>
#include <vector>

namespace medial
{
namespace
{

/// The arenas that nobody uses, by their number of threads.
struct FreeArenas
{
  std::mutex mutex;
  std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> ofThreads;
};

/// Never destroyed: TBB may have ended before the static objects of this library go.
FreeArenas& freeArenas()
{
  static auto* const arenas = new FreeArenas;
  return *arenas;
}

} // namespace

BorrowedArena::BorrowedArena(int threads)
  : threads_(threads)
{
  {
    const std::lock_guard<std::mutex> lock(freeArenas().mutex);
    auto& arenas = freeArenas().ofThreads[threads];
    if (!arenas.empty())
    {
      arena_ = std::move(arenas.back());
      arenas.pop_back();
      return;
    }
    // Room to give it back without an allocation.
    arenas.reserve(arenas.capacity() + 1);
  }
  arena_ = std::make_unique<tbb::task_arena>(threads);
}

BorrowedArena::~BorrowedArena()
{
  const std::lock_guard<std::mutex> lock(freeArenas().mutex);
  freeArenas().ofThreads.find(threads_)->second.push_back(std::move(arena_));
}

} // namespace medial
