#pragma once

namespace medial::files
{

/// Whether this machine keeps the most significant byte of a number first.
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
constexpr bool kIsBigEndian = false;
#else
constexpr bool kIsBigEndian = true;
#endif

} // namespace medial::files
