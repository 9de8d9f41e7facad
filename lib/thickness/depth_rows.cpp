#include "thickness/depth_rows.h"

#include "thickness/tile_radii.h"

#include <cmath>

namespace medial
{
namespace
{

/// So many are a unit of the finest spacing.
constexpr float kSteps = 1.0f / kRadiusStep;

/// Depths along a row are about linear.
class Guess
{
public:
  std::int32_t next() const { return 2 * last_ - before_; }
  void add(std::int32_t depth)
  {
    before_ = first_ ? depth : last_;
    last_ = depth;
    first_ = false;
  }

private:
  bool first_ = true;
  std::int32_t last_ = 0;
  std::int32_t before_ = 0;
};

/// Maps numbers near 0, of any sign, to small ones.
std::uint32_t folded(std::int32_t number)
{
  return (static_cast<std::uint32_t>(number) << 1) ^ static_cast<std::uint32_t>(number >> 31);
}

std::int32_t unfolded(std::uint32_t number)
{
  return static_cast<std::int32_t>(number >> 1) ^ -static_cast<std::int32_t>(number & 1);
}

std::uint32_t readNumber(const std::uint8_t*& at)
{
  std::uint32_t number = *at & 0x7f;
  for (int shift = 7; (*at++ & 0x80) != 0; shift += 7)
  {
    number |= static_cast<std::uint32_t>(*at & 0x7f) << shift;
  }
  return number;
}

} // namespace

void DepthRows::addNumber(std::uint32_t number)
{
  for (; number >= 0x80; number >>= 7)
  {
    bytes_.push_back(static_cast<std::uint8_t>(number | 0x80));
  }
  bytes_.push_back(static_cast<std::uint8_t>(number));
}

void DepthRows::add(const float* depths, std::size_t count)
{
  begins_.push_back(bytes_.size());
  std::size_t point = 0;
  while (true)
  {
    const std::size_t before = point;
    while (point < count && !(depths[point] > 0.0f))
    {
      ++point;
    }
    if (point == count)
    {
      return;
    }
    const std::size_t begin = point;
    while (point < count && depths[point] > 0.0f)
    {
      ++point;
    }
    this->addNumber(static_cast<std::uint32_t>(begin - before));
    this->addNumber(static_cast<std::uint32_t>(point - begin));
    Guess guess;
    for (std::size_t p = begin; p < point; ++p)
    {
      const auto depth = static_cast<std::int32_t>(roundedRadius(depths[p]) * kSteps);
      this->addNumber(folded(depth - guess.next()));
      guess.add(depth);
    }
  }
}

void DepthRows::finish()
{
  begins_.shrink_to_fit();
  bytes_.shrink_to_fit();
}

std::size_t DepthRows::byteCount() const
{
  return bytes_.size() + begins_.size() * sizeof(std::size_t);
}

void DepthRows::read(std::size_t row, float* depths) const
{
  const std::uint8_t* at = bytes_.data() + begins_[row];
  const std::uint8_t* const end =
    bytes_.data() + (row + 1 < begins_.size() ? begins_[row + 1] : bytes_.size());
  while (at != end)
  {
    depths += readNumber(at);
    Guess guess;
    for (std::uint32_t left = readNumber(at); left > 0; --left)
    {
      const std::int32_t depth = guess.next() + unfolded(readNumber(at));
      guess.add(depth);
      // A depth that rounds to 0 still tells the side.
      *depths++ = (depth > 0 ? static_cast<float>(depth) : 0.25f) * kRadiusStep;
    }
  }
}

} // namespace medial
