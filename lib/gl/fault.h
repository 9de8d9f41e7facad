#pragma once

#include <cstdint>

namespace medial::gl
{

/// Faults of devices and drivers that tests simulate.
enum class Fault
{
  None,
  ShaderRefused,     ///< a shader does not compile
  ContextRefused,    ///< the GPU thread gets no context
  AllocationRefused, ///< a buffer does not fit
  NeverReady,        ///< a fence never signals
  ContextLost,       ///< the device was reset
  WrongResult        ///< a kernel writes something else
};

/// Makes a fault happen once, after it could have happened so many times. For tests.
void injectFault(Fault fault, int opportunities = 0);
/// Whether an injected fault happens here and now.
bool faultHappens(Fault fault);

/// Lowers the limit for storage buffers to so many bytes; 0 takes this back. For tests.
void limitStorageBuffers(std::int64_t bytes);
/// Returns how large a storage buffer may be, bytes. GPU thread only.
std::int64_t storageBufferLimit();

} // namespace medial::gl
