#pragma once

#include "medial/device.h"

#include <memory>
#include <string>
#include <vector>

namespace medial::gl
{

/// Whether the system has any graphics device. Takes no time, and loads no library.
bool mayHaveHardware();

/// A surfaceless OpenGL 4.5 core context from EGL. The library computes in one, and medial-axis
/// draws its pictures in another. (The header does not include epoxy, since epoxy's declarations of
/// OpenGL exclude those of GLEW.)
///
/// Every EGL device is tried, hardware before software renderers, then Mesa's surfaceless platform.
class EglContext
{
public:
  /// Makes a context and makes it current on this thread.
  /// @param debug whether to make a debug context.
  /// @param wanted number of a device in list(), or a part of its renderer's name; empty for any.
  /// @throws Error NoGpu with the reason.
  explicit EglContext(bool debug = false, const std::string& wanted = "");
  /// To be called on the thread that used the context last. The display stays initialised, since
  /// others may use it.
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void makeCurrent();
  bool isCurrent() const;
  /// Leaves this thread without a current context.
  void release();

  const Device& device() const { return device_; }

  /// Lists what there is to choose from. The thread has no current context afterwards.
  /// @throws Error NoGpu where the libraries are missing.
  static std::vector<ListedDevice> list();

private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  Device device_;
};

} // namespace medial::gl
