#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace medial::test
{

/// What a parameterised test is about. The test makes it, as GoogleTest lists the parameters of all
/// tests whenever a program starts.
template <class T>
struct Named
{
  std::string name;
  std::function<T()> make;
};

template <class T>
std::ostream& operator<<(std::ostream& stream, const Named<T>& named)
{
  return stream << named.name;
}

/// For INSTANTIATE_TEST_SUITE_P.
inline const auto kNameOfParameter = [](const auto& test) { return test.param.name; };

} // namespace medial::test
