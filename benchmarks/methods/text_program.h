#pragma once

#include "gl/gl_objects.h"

#include <string>

namespace medial::benchmark
{

/// A program from shader texts; gl::ShaderProgram knows only the library's own. For use on the GPU
/// thread.
class TextProgram
{
public:
  /// @throws Error ShaderBuild with the driver's log.
  TextProgram(const std::string& vertexText, const std::string& fragmentText);

  void use() const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, float x, float y) const;

private:
  gl::Program program_;
};

} // namespace medial::benchmark
