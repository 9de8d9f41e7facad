#include "methods/text_program.h"

#include "medial/error.h"

#include <array>

namespace medial::benchmark
{
namespace
{

gl::Shader compiled(GLenum stage, const std::string& text)
{
  gl::Shader shader(glCreateShader(stage));
  const char* start = text.c_str();
  glShaderSource(shader.id(), 1, &start, nullptr);
  glCompileShader(shader.id());
  return shader;
}

} // namespace

TextProgram::TextProgram(const std::string& vertexText, const std::string& fragmentText)
  : program_(glCreateProgram())
{
  const gl::Shader vertex = compiled(GL_VERTEX_SHADER, vertexText);
  const gl::Shader fragment = compiled(GL_FRAGMENT_SHADER, fragmentText);
  glAttachShader(program_.id(), vertex.id());
  glAttachShader(program_.id(), fragment.id());
  glLinkProgram(program_.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (!linked)
  {
    // A shader that did not compile has a log of its own.
    std::array<GLchar, 2048> log{};
    std::string reasons;
    for (const GLuint shader : { vertex.id(), fragment.id() })
    {
      glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
      reasons += log.data();
    }
    glGetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw Error(ErrorCode::ShaderBuild,
      "a baseline's shaders were refused: " + reasons + log.data());
  }
}

void TextProgram::use() const
{
  glUseProgram(program_.id());
}

void TextProgram::set(const char* uniform, float value) const
{
  glProgramUniform1f(program_.id(), glGetUniformLocation(program_.id(), uniform), value);
}

void TextProgram::set(const char* uniform, float x, float y) const
{
  glProgramUniform2f(program_.id(), glGetUniformLocation(program_.id(), uniform), x, y);
}

} // namespace medial::benchmark
