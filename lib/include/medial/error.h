#pragma once

#include "medial/export.h"

#include <stdexcept>
#include <string>

/// Distance fields and medial axes of meshes: algorithms over plain arrays. Failures are reported
/// by exceptions of the class Error.
namespace medial
{

/// Why an operation of the library failed.
enum class ErrorCode
{
  InvalidInput, ///< a mesh, grid or option outside its documented range
  NoGpu, ///< no usable OpenGL 4.5 context, or only a software renderer where hardware is required
  ShaderBuild, ///< the driver refused a shader
  GpuLimit,    ///< the request exceeds a limit of the GPU or its driver
  OutOfMemory, ///< host or device memory ran out
  CannotRead,  ///< a file is missing, of an unknown format, or not readable
  CannotWrite, ///< a file cannot be written completely, for example on a full disk
  Cancelled    ///< Progress::cancelled() returned true
};

/// The only exception type that the library throws on purpose. The message is one line that names
/// the offending value and the allowed range (ShaderBuild: also the driver's log); the library
/// never prints and never exits.
class MEDIAL_EXPORT Error : public std::runtime_error
{
public:
  /// @param code why the operation failed.
  /// @param message one line that names the value and the allowed range.
  Error(ErrorCode code, const std::string& message)
    : std::runtime_error(message)
    , code_(code)
  {
  }

  /// Why the operation failed.
  ErrorCode code() const noexcept { return code_; }

private:
  ErrorCode code_;
};

} // namespace medial
