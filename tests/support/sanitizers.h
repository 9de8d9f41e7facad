#pragma once

// Sanitizers that a test runs under. GCC defines a macro for each, Clang answers when it is asked.
namespace medial::test
{

#if defined(__has_feature)
#  if __has_feature(address_sanitizer)
#    define MEDIAL_UNDER_ADDRESS_SANITIZER
#  endif
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(MEDIAL_UNDER_ADDRESS_SANITIZER)
constexpr bool kUnderAddressSanitizer = true;
#else
constexpr bool kUnderAddressSanitizer = false;
#endif
#if defined(__SANITIZE_THREAD__)
constexpr bool kUnderThreadSanitizer = true;
#else
constexpr bool kUnderThreadSanitizer = false;
#endif

} // namespace medial::test
