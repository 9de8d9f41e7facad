#pragma once

#include <functional>

class vtkObject;

namespace medial::app
{

/// Calls a function whenever a VTK object invokes an event, as long as that object lives.
void observeEvent(vtkObject* object, unsigned long event, std::function<void()> act);

} // namespace medial::app
