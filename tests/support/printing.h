#pragma once

#include <iosfwd>

// How GoogleTest prints parameters in the names of tests. This header is precompiled, since all
// files of a program must print a type in the same way.

namespace medial
{

enum class Engine;
enum class Side;
enum class SignMethod;
enum class Topology;
struct Extent;

std::ostream& operator<<(std::ostream& stream, Engine engine);
std::ostream& operator<<(std::ostream& stream, Side side);
std::ostream& operator<<(std::ostream& stream, SignMethod method);
std::ostream& operator<<(std::ostream& stream, Topology topology);
std::ostream& operator<<(std::ostream& stream, const Extent& extent);

} // namespace medial
