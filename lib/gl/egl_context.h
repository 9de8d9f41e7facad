#pragma once

#include "medial/device.h"

#include <memory>

namespace medial::gl
{

/// A surfaceless OpenGL 4.5 core context, current on the thread that made it until destroyed there.
///
/// Every EGL device is tried, hardware before software renderers, then Mesa's surfaceless platform.
/// With the environment variable MEDIAL_GL_DEBUG set the context is a debug context.
class EglContext
{
public:
  /// @throws Error NoGpu with the reason.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  const Device& device() const { return device_; }

private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  Device device_;
};

} // namespace medial::gl
