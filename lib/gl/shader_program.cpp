#include "gl/shader_program.h"

#include "gl/fault.h"
#include "gl/shader_source.h"
#include "medial/error.h"

#include <glm/gtc/type_ptr.hpp>

#include <map>
#include <utility>
#include <vector>

namespace medial::gl
{
namespace
{

Shader compile(GLenum stage, const std::string& name)
{
  Shader shader(glCreateShader(stage));
  const char* text = shaderSource(name);
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint ok = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (!ok || faultHappens(Fault::ShaderRefused))
  {
    std::vector<GLchar> log(4096, '\0');
    glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    throw Error(ErrorCode::ShaderBuild, "shader " + name + " was refused: " + log.data());
  }
  return shader;
}

using ProgramCache = std::map<std::pair<std::string, std::string>, ShaderProgram>;

ProgramCache& programCache()
{
  // Never destroyed: the GPU thread clears it when it ends, which may be after static destructors.
  static ProgramCache& cache = *new ProgramCache;
  return cache;
}

template <typename Make>
const ShaderProgram& obtainProgram(const ProgramCache::key_type& key, const Make& make)
{
  auto found = programCache().find(key);
  if (found == programCache().end())
  {
    found = programCache().emplace(key, make()).first;
  }
  return found->second;
}

} // namespace

ShaderProgram::ShaderProgram(const std::string& vertexShader, const std::string& fragmentShader)
  : program_(glCreateProgram())
{
  const Shader vertex = compile(GL_VERTEX_SHADER, vertexShader);
  const Shader fragment = compile(GL_FRAGMENT_SHADER, fragmentShader);
  this->link({ &vertex, &fragment }, "shaders " + vertexShader + " and " + fragmentShader + " do");
}

ShaderProgram::ShaderProgram(const std::string& computeShader)
  : program_(glCreateProgram())
{
  const Shader compute = compile(GL_COMPUTE_SHADER, computeShader);
  this->link({ &compute }, "shader " + computeShader + " does");
}

void ShaderProgram::link(std::initializer_list<const Shader*> shaders, const std::string& subject)
{
  for (const Shader* shader : shaders)
  {
    glAttachShader(program_.id(), shader->id());
  }
  glLinkProgram(program_.id());
  for (const Shader* shader : shaders)
  {
    glDetachShader(program_.id(), shader->id());
  }
  GLint ok = GL_FALSE;
  glGetProgramiv(program_.id(), GL_LINK_STATUS, &ok);
  if (!ok)
  {
    std::vector<GLchar> log(4096, '\0');
    glGetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    throw Error(ErrorCode::ShaderBuild, subject + " not link: " + log.data());
  }
}

void ShaderProgram::use() const
{
  glUseProgram(program_.id());
}

GLint ShaderProgram::location(const char* uniform) const
{
  return glGetUniformLocation(program_.id(), uniform);
}

void ShaderProgram::set(const char* uniform, int value) const
{
  glProgramUniform1i(program_.id(), this->location(uniform), value);
}

void ShaderProgram::set(const char* uniform, float value) const
{
  glProgramUniform1f(program_.id(), this->location(uniform), value);
}

void ShaderProgram::set(const char* uniform, double value) const
{
  glProgramUniform1d(program_.id(), this->location(uniform), value);
}

void ShaderProgram::set(const char* uniform, const glm::ivec3& value) const
{
  glProgramUniform3iv(program_.id(), this->location(uniform), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* uniform, const glm::dvec3& value) const
{
  glProgramUniform3dv(program_.id(), this->location(uniform), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* uniform, const glm::ivec2& value) const
{
  glProgramUniform2iv(program_.id(), this->location(uniform), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* uniform, const glm::vec2& value) const
{
  glProgramUniform2fv(program_.id(), this->location(uniform), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* uniform, const glm::vec3& value) const
{
  glProgramUniform3fv(program_.id(), this->location(uniform), 1, glm::value_ptr(value));
}

const ShaderProgram& cachedProgram(const std::string& vertexShader,
  const std::string& fragmentShader)
{
  return obtainProgram({ vertexShader, fragmentShader },
    [&] { return ShaderProgram(vertexShader, fragmentShader); });
}

const ShaderProgram& cachedProgram(const std::string& computeShader)
{
  return obtainProgram({ computeShader, "" }, [&] { return ShaderProgram(computeShader); });
}

void releaseProgramCache()
{
  programCache().clear();
}

} // namespace medial::gl
