#pragma once

#include <cstddef>
#include <string>

namespace medial::gl
{

/// A file from shaders/, embedded at build time.
struct EmbeddedShader
{
  const char* name;
  const char* text;
};

extern const EmbeddedShader kEmbeddedShaders[];
extern const std::size_t kEmbeddedShaderCount;

/// Returns the text of the shader file `name`.
/// @throws Error ShaderBuild if no such file was embedded.
const char* shaderSource(const std::string& name);

} // namespace medial::gl
