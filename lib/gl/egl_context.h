#pragma once

#include "medial/device.h"

#include <memory>
#include <string>
#include <vector>

namespace medial::gl
{

/// Whether the system has any graphics device. Takes no time, and loads no library.
bool mayHaveHardware();
/// Whether a device has this number or, in upper or lower case, this part of its name or origin.
/// Each answers to an empty word.
bool answersTo(const Device& device, const std::string& wanted);

/// Returns what EGL offers, tried one by one. Leaves the thread without a current context.
/// @throws Error NoGpu if EGL or OpenGL is not installed.
std::vector<ListedDevice> openableDevices();

/// A surfaceless OpenGL 4.5 core context from EGL. The library computes in one, and medial-axis
/// draws its pictures in another. (The header does not include epoxy, since epoxy's declarations of
/// OpenGL exclude those of GLEW.)
///
/// Unless one is asked for, every EGL device is tried, hardware before software renderers, then
/// EGL's surfaceless platform.
class EglContext
{
public:
  /// Makes a context and makes it current on this thread.
  /// @param wanted the device's number, or a part of its name; empty for the best.
  /// @param debug whether to make a debug context.
  /// @throws Error NoGpu with the reason.
  explicit EglContext(const std::string& wanted = {}, bool debug = false);
  /// To be called on the thread that used the context last; another context that is current there
  /// stays so. The display stays initialised, since others may use it.
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void makeCurrent();
  bool isCurrent() const;
  /// Leaves this thread without a current context.
  void release();

  const Device& device() const { return device_; }

private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  Device device_;
};

} // namespace medial::gl
