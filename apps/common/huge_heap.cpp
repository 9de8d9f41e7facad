#include "huge_heap.h"

#ifdef __GLIBC__
#  include <malloc.h>
#  include <sys/mman.h>
#  include <sys/resource.h>
#  include <unistd.h>

#  include <cstdint>
#  include <cstdlib>
#  include <limits>
#  include <thread>
#endif

namespace medial::app
{
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
namespace
{

bool isLimited(__rlimit_resource_t resource)
{
  rlimit limit{};
  return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

std::uintptr_t endOfHeap()
{
  return reinterpret_cast<std::uintptr_t>(sbrk(0));
}

} // namespace

void useHugeHeap()
{
  // Addresses, not memory, which only pages take that are used.
  constexpr int kHeap = 512 << 20;
  // The most that glibc accepts. Larger blocks have pages of their own, and go back when freed.
  constexpr int kLarge = 32 << 20;
  constexpr std::size_t kBlock = std::size_t{ kLarge } / 2;
  // So few threads hardly wait for one another; more get heaps of their own, without huge pages.
  constexpr unsigned int kFewThreads = 4;
  if (isLimited(RLIMIT_AS) || isLimited(RLIMIT_DATA))
  {
    return;
  }
  if (std::thread::hardware_concurrency() <= kFewThreads)
  {
    mallopt(M_ARENA_MAX, 1);
  }
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, kHeap);
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = (endOfHeap() + page - 1) / page * page;
  // The compiler leaves out blocks that nobody looks at.
  void* volatile const block = std::malloc(kBlock);
  const std::uintptr_t end = endOfHeap() / page * page;
  if (begin < end)
  {
    // Without huge pages all is as before, so the result does not matter.
    static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
  }
  std::free(block);
  mallopt(M_TOP_PAD, kLarge);
}
#else
void useHugeHeap() {}
#endif

} // namespace medial::app
