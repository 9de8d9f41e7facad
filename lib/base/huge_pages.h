#pragma once

#include <cstddef>
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

} // namespace medial
