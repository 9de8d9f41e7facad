#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace medial::files
{

/// Bytes that zlib's method makes of one, at most: less than 1,033.
constexpr std::size_t kLargestRatio = 1100;

/// The first `count` bytes of what zlib or gzip has compressed.
/// @throws Error InvalidInput if there are fewer, or the text is damaged. A count that so few bytes
///   cannot hold is refused before memory is allocated.
std::string inflateBytes(std::string_view compressed, std::size_t count);

} // namespace medial::files
