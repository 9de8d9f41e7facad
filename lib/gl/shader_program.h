#pragma once

#include "gl/gl_objects.h"

#include <glm/glm.hpp>

#include <initializer_list>
#include <string>

namespace medial::gl
{

/// A linked program of shaders from shaders/. Setting a uniform that no shader uses has no effect.
class ShaderProgram
{
public:
  /// @throws Error ShaderBuild with the driver's log.
  ShaderProgram(const std::string& vertexShader, const std::string& fragmentShader);
  /// @throws Error ShaderBuild with the driver's log.
  explicit ShaderProgram(const std::string& computeShader);

  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, double value) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::ivec3& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::dvec3& value) const;

private:
  void link(std::initializer_list<const Shader*> shaders, const std::string& subject);
  GLint location(const char* uniform) const;
  Program program_;
};

/// Returns the program of two shader files, compiled once per process. GPU thread only.
const ShaderProgram& cachedProgram(const std::string& vertexShader,
  const std::string& fragmentShader);

/// Returns the program of a compute shader, compiled once per process. GPU thread only.
const ShaderProgram& cachedProgram(const std::string& computeShader);

/// Deletes the cached programs. Called when the GPU thread ends.
void releaseProgramCache();

} // namespace medial::gl
