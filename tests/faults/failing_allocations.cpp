#include "failing_allocations.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace medial::test
{
namespace
{

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

// Not on the heap, and ready before any constructor runs.
std::atomic<bool> counting{ false };
std::atomic<std::int64_t> counted{ 0 };
std::atomic<std::int64_t> firstToFail{ kNever };
std::atomic<std::int64_t> lastToFail{ kNever };
std::atomic<std::int64_t> live{ 0 };

bool mustFail()
{
  if (!counting)
  {
    return false;
  }
  const std::int64_t number = ++counted;
  return number >= firstToFail && number <= lastToFail;
}

void* allocate(std::size_t bytes, std::size_t alignment) noexcept
{
  if (mustFail())
  {
    return nullptr;
  }
  const std::size_t size = std::max<std::size_t>(bytes, 1);
  void* block = alignment <= alignof(std::max_align_t)
    ? std::malloc(size)
    : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block != nullptr)
  {
    ++live;
  }
  return block;
}

void* allocateOrThrow(std::size_t bytes, std::size_t alignment)
{
  void* block = allocate(bytes, alignment);
  if (block == nullptr)
  {
    if (const std::new_handler handler = std::get_new_handler())
    {
      handler();
    }
    throw std::bad_alloc();
  }
  return block;
}

void release(void* block) noexcept
{
  if (block != nullptr)
  {
    --live;
    std::free(block);
  }
}

} // namespace

void failAllocation(std::int64_t n, Failing failing)
{
  counted = 0;
  firstToFail = n > 0 ? n : kNever;
  lastToFail = failing == Failing::Once ? firstToFail.load() : kNever;
  counting = true;
}

std::int64_t stopFailing()
{
  counting = false;
  return counted;
}

std::int64_t stepBetweenFailures(std::int64_t count)
{
  constexpr std::int64_t kTries = 50;
  const char* text = std::getenv("MEDIAL_FAULT_STEP");
  const std::int64_t step = text != nullptr ? std::atoll(text) : 101;
  return std::max<std::int64_t>(std::min(count / kTries, step), 1);
}

std::int64_t liveBlocks()
{
  return live;
}

} // namespace medial::test

using medial::test::allocate;
using medial::test::allocateOrThrow;
using medial::test::release;

void* operator new(std::size_t bytes)
{
  return allocateOrThrow(bytes, 0);
}

void* operator new[](std::size_t bytes)
{
  return allocateOrThrow(bytes, 0);
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return allocateOrThrow(bytes, static_cast<std::size_t>(alignment));
}

void* operator new[](std::size_t bytes, std::align_val_t alignment)
{
  return allocateOrThrow(bytes, static_cast<std::size_t>(alignment));
}

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
  return allocate(bytes, 0);
}

void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept
{
  return allocate(bytes, 0);
}

void operator delete(void* block) noexcept
{
  release(block);
}

void operator delete[](void* block) noexcept
{
  release(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  release(block);
}

void operator delete[](void* block, std::size_t) noexcept
{
  release(block);
}

void operator delete(void* block, std::align_val_t) noexcept
{
  release(block);
}

void operator delete[](void* block, std::align_val_t) noexcept
{
  release(block);
}

void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  release(block);
}

void operator delete[](void* block, std::size_t, std::align_val_t) noexcept
{
  release(block);
}

void operator delete(void* block, const std::nothrow_t&) noexcept
{
  release(block);
}

void operator delete[](void* block, const std::nothrow_t&) noexcept
{
  release(block);
}
