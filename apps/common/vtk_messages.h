#pragma once

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace medial::app
{

/// Keeps VTK's errors and warnings from standard error while it lives, and remembers the first. May
/// be nested: the inner one gets the messages.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error, or without one the first warning, on one line and without VTK's source
  /// position; empty when there was neither.
  std::string first() const;

private:
  vtkSmartPointer<vtkOutputWindow> outer_;
};

} // namespace medial::app
