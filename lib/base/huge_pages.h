#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

// Arrays of many elements in huge pages. The first touch of a page costs a fault, which the system
// handles for one thread at a time: with pages of 4 KB that took up to a quarter of the medial
// stage.
namespace medial
{

/// Asks the system for huge pages where a range of memory that nobody has touched spans some.
/// Nothing happens where there are none, or where the system gives them unasked.
void adviseHugePages(void* begin, std::size_t bytes);

/// std::vector::reserve() with huge pages. Only for what will be filled: untouched parts of a huge
/// page take memory as well.
template <typename T>
void reserveLarge(std::vector<T>& elements, std::size_t count)
{
  if (count > elements.capacity())
  {
    elements.reserve(count);
    adviseHugePages(elements.data() + elements.size(), (count - elements.size()) * sizeof(T));
  }
}

/// std::vector::resize() with huge pages.
template <typename T>
void resizeLarge(std::vector<T>& elements, std::size_t count, const T& value = T())
{
  reserveLarge(elements, count);
  elements.resize(count, value);
}

/// Returns equal elements in huge pages.
template <typename T>
std::vector<T> largeVector(std::size_t count, const T& value = T())
{
  std::vector<T> elements;
  resizeLarge(elements, count, value);
  return elements;
}

/// Memory of zeros that nobody has touched: each page is cleared for the thread that first uses it,
/// and what is never used takes no memory.
/// @tparam Huge whether pages are huge.
template <typename T, bool Huge = true>
struct ZeroAllocator
{
  static_assert(std::is_arithmetic_v<T>, "bits of zeros are the value 0");
  // NOLINTBEGIN(readability-identifier-naming): as the standard has it
  using value_type = T;
  template <typename Other>
  struct rebind
  {
    using other = ZeroAllocator<Other, Huge>;
  };
  // NOLINTEND(readability-identifier-naming)

  ZeroAllocator() = default;
  template <typename Other>
  ZeroAllocator(const ZeroAllocator<Other, Huge>& /*other*/) noexcept
  {
  }

  T* allocate(std::size_t count)
  {
    void* const memory = count <= std::numeric_limits<std::size_t>::max() / sizeof(T)
      ? std::calloc(count, sizeof(T))
      : nullptr;
    if (memory == nullptr)
    {
      throw std::bad_alloc();
    }
    if constexpr (Huge)
    {
      adviseHugePages(memory, count * sizeof(T));
    }
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t /*count*/) noexcept { std::free(memory); }

  /// Leaves the zero that is there.
  void construct(T* /*element*/) noexcept {}

  template <typename Value>
  void construct(T* element, const Value& value) noexcept
  {
    *element = value;
  }

  friend bool operator==(const ZeroAllocator& /*a*/, const ZeroAllocator& /*b*/) { return true; }
  friend bool operator!=(const ZeroAllocator& /*a*/, const ZeroAllocator& /*b*/) { return false; }
};

/// An array that starts with zeros. Elements that it gains by resize() after it has shrunk are what
/// was there before.
template <typename T>
using ZeroedVector = std::vector<T, ZeroAllocator<T>>;

/// The same for few elements here and there, in pages that are not huge.
template <typename T>
using SparseVector = std::vector<T, ZeroAllocator<T, false>>;

} // namespace medial
