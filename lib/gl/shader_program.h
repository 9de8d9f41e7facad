#pragma once

#include "gl/gl_objects.h"

#include <glm/glm.hpp>

#include <string>

namespace medial::gl
{

/// A linked program of a vertex and a fragment shader from shaders/. Setting a uniform that no
/// shader uses has no effect.
class ShaderProgram
{
public:
  /// @throws Error ShaderBuild with the driver's log.
  ShaderProgram(const std::string& vertexShader, const std::string& fragmentShader);

  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;

private:
  GLint location(const char* uniform) const;
  Program program_;
};

/// Returns the program of two shader files, compiled once per process. GPU thread only.
const ShaderProgram& cachedProgram(const std::string& vertexShader,
  const std::string& fragmentShader);

/// Deletes the cached programs. Called when the GPU thread ends.
void releaseProgramCache();

} // namespace medial::gl
