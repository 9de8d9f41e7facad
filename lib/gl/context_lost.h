#pragma once

#include "medial/error.h"

#include <string>

namespace medial::gl
{

/// The device was reset, or its context replaced since then: all objects in it are lost. Whoever
/// makes them again gets a new context.
class ContextLost : public Error
{
public:
  /// @param what one line.
  explicit ContextLost(const std::string& what)
    : Error(ErrorCode::NoGpu, what)
  {
  }
};

} // namespace medial::gl
