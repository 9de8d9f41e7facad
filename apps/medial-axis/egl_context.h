#pragma once

namespace medial::app
{

/// An OpenGL 4.5 core context from EGL that has no surface, for EglRenderWindow. (In files of their
/// own, since epoxy's declarations of OpenGL and GLEW's exclude each other.)
class EglContext
{
public:
  EglContext() = default;
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes the context on the first display that has one, hardware first, and makes it current.
  /// @return false where there is none.
  bool create();

  bool exists() const { return context_ != nullptr; }
  void makeCurrent();
  bool isCurrent() const;
  void release();

private:
  bool createOn(void* display);

  void* display_ = nullptr;
  void* context_ = nullptr;
};

} // namespace medial::app
