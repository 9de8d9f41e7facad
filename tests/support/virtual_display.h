#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace medial::test
{

/// An X server without a screen (Xvfb) that lives as long as this; the environment variable DISPLAY
/// names it meanwhile.
class VirtualDisplay
{
public:
  /// @param arguments of Xvfb beside the screen's.
  /// @throws std::runtime_error when there is no Xvfb, or it does not start.
  explicit VirtualDisplay(const std::vector<std::string>& arguments = {});
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// As DISPLAY spells it.
  const std::string& name() const { return name_; }
  /// Ends the server under its clients.
  void end();

private:
  pid_t server_ = -1;
  std::string name_;
};

} // namespace medial::test
