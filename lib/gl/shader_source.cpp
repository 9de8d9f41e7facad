#include "gl/shader_source.h"

#include "medial/error.h"

namespace medial::gl
{

const char* shaderSource(const std::string& name)
{
  for (std::size_t i = 0; i < kEmbeddedShaderCount; ++i)
  {
    if (name == kEmbeddedShaders[i].name)
    {
      return kEmbeddedShaders[i].text;
    }
  }
  throw Error(ErrorCode::ShaderBuild, "no shader named " + name + " was embedded");
}

} // namespace medial::gl
