// The filters leave the OpenGL context of their caller alone.
#include "filter_support.h"

#include "medial/device.h"

#include <gtest/gtest.h>

#include <vtkMedialAxis.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <functional>
#include <future>
#include <vector>

namespace
{

using namespace medial::test;

/// An OpenGL context of the host, current in the thread that makes it.
class HostContext
{
public:
  HostContext()
  {
    display_ =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display_, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display_, wanted, &config, 1, &count);
    const EGLint version[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
      EGL_NONE };
    context_ = eglCreateContext(display_, count > 0 ? config : nullptr, EGL_NO_CONTEXT, version);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }

  ~HostContext()
  {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }

  HostContext(const HostContext&) = delete;
  HostContext& operator=(const HostContext&) = delete;

  EGLContext context() const { return context_; }
  EGLDisplay display() const { return display_; }

private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// OpenGL state that a careless library would change.
struct State
{
  std::vector<GLint> integers;
  std::vector<GLboolean> switches;
  std::vector<GLint> boxes;
  std::array<GLfloat, 4> clearColor{};
  std::vector<unsigned char> bufferContent;

  bool operator==(const State& other) const
  {
    return integers == other.integers && switches == other.switches && boxes == other.boxes &&
      clearColor == other.clearColor && bufferContent == other.bufferContent;
  }
};

State currentState()
{
  State state;
  for (const GLenum name :
    { GL_CURRENT_PROGRAM, GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_ACTIVE_TEXTURE,
      GL_TEXTURE_BINDING_2D, GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING,
      GL_DEPTH_FUNC, GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT, GL_PIXEL_PACK_BUFFER_BINDING })
  {
    glGetIntegerv(name, &state.integers.emplace_back());
  }
  for (const GLenum name : { GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_DITHER })
  {
    state.switches.push_back(glIsEnabled(name));
  }
  for (const GLenum name : { GL_VIEWPORT, GL_SCISSOR_BOX })
  {
    std::array<GLint, 4> box{};
    glGetIntegerv(name, box.data());
    state.boxes.insert(state.boxes.end(), box.begin(), box.end());
  }
  glGetFloatv(GL_COLOR_CLEAR_VALUE, state.clearColor.data());
  state.bufferContent.resize(16);
  glGetBufferSubData(GL_ARRAY_BUFFER, 0, 16, state.bufferContent.data());
  return state;
}

/// Objects and switches of a host in the middle of its work.
void makeState()
{
  GLuint names[4] = {};
  glGenVertexArrays(1, &names[0]);
  glBindVertexArray(names[0]);
  glGenBuffers(1, &names[1]);
  glBindBuffer(GL_ARRAY_BUFFER, names[1]);
  const unsigned char content[16] = { 3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3 };
  glBufferData(GL_ARRAY_BUFFER, sizeof(content), content, GL_STATIC_DRAW);
  glActiveTexture(GL_TEXTURE3);
  glGenTextures(1, &names[2]);
  glBindTexture(GL_TEXTURE_2D, names[2]);
  glGenFramebuffers(1, &names[3]);
  glBindFramebuffer(GL_FRAMEBUFFER, names[3]);
  glEnable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_DITHER);
  glDepthFunc(GL_GEQUAL);
  glViewport(1, 2, 345, 67);
  glScissor(5, 6, 78, 9);
  glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
}

template <typename Filter>
void expectUntouched()
{
  const HostContext host;
  ASSERT_NE(host.context(), EGL_NO_CONTEXT);
  ASSERT_EQ(eglGetCurrentContext(), host.context());
  makeState();
  ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  const State before = currentState();
  ASSERT_NE(before.integers[1], 0);

  vtkNew<Filter> filter;
  filter->SetInputData(lumpPolyData());
  filter->SetResolution(20);
  filter->SetEngineToRasteriser();
  bool sameInObserver = true;
  const auto observe = [&](vtkObject*, unsigned long, void*)
  { sameInObserver = sameInObserver && eglGetCurrentContext() == host.context(); };
  struct Observer
  {
    std::function<void(vtkObject*, unsigned long, void*)> call;
    void run(vtkObject* caller, unsigned long event, void* data) { call(caller, event, data); }
  } observer{ observe };
  filter->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::run);
  filter->Update();

  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(sameInObserver);
  EXPECT_EQ(eglGetCurrentContext(), host.context());
  EXPECT_EQ(eglGetCurrentDisplay(), host.display());
  EXPECT_TRUE(currentState() == before);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(medial::deviceDebugLog(), "");
}

TEST(HostContext, DistanceFieldLeavesItAlone)
{
  expectUntouched<vtkMeshDistanceField>();
}

TEST(HostContext, MedialAxisLeavesItAlone)
{
  expectUntouched<vtkMedialAxis>();
}

TEST(HostContext, NoneIsCurrentAfterwardsWhereNoneWasBefore)
{
  ASSERT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputData(lumpPolyData());
  field->SetResolution(12);
  field->SetEngineToRasteriser();
  field->Update();
  EXPECT_EQ(field->GetErrorCode(), 0u);
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(HostContext, FiltersRunInAnyThread)
{
  const auto distanceInTheMiddle = []
  {
    vtkNew<vtkMeshDistanceField> field;
    field->SetInputData(boxPolyData({ 1.0, 1.0, 1.0 }));
    field->SetResolution(9);
    field->Update();
    return valueOf(field->GetOutput(), "Distance", 9 * 9 * 9 / 2);
  };
  // VTK sets up its object factories at the first use, which is not safe in several threads.
  EXPECT_NEAR(distanceInTheMiddle(), -1.0, 1e-5);
  std::vector<std::future<double>> results;
  for (int i = 0; i < 4; ++i)
  {
    results.push_back(std::async(std::launch::async, distanceInTheMiddle));
  }
  for (auto& result : results)
  {
    EXPECT_NEAR(result.get(), -1.0, 1e-5);
  }
}

} // namespace
