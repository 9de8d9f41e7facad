#include "viewer_window.h"

#include "display.h"
#include "event_call.h"

#include <vtkCommand.h>

namespace medial::app
{
namespace
{

// The value of a line `label: value` of VTK's report.
std::string rendererOf(vtkRenderWindow* window)
{
  const std::string report = window->ReportCapabilities();
  const std::string label = "OpenGL renderer string:";
  const std::size_t at = report.find(label);
  if (at == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t begin = report.find_first_not_of(' ', at + label.size());
  return report.substr(begin, report.find('\n', begin) - begin);
}

} // namespace

ViewerWindow::ViewerWindow(const std::string& title, int width, int height)
{
  requireDisplay();
  failCleanly(window);
  window->SetWindowName(title.c_str());
  window->SetSize(width, height);
  window->SetMultiSamples(0); // as depth peeling needs it
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer);
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  style->SetDefaultRenderer(renderer);
  window->Render(); // opens it
  device = rendererOf(window);
}

// VTK 9.1 keeps a list of initialised interactors. It removes one when its loop ends, but not when
// it is deleted: the next loop of the process would use the deleted one. Window and interactor hold
// references to each other.
ViewerWindow::~ViewerWindow()
{
  if (!looped_)
  {
    observeEvent(interactor, vtkCommand::TimerEvent, [this] { leave(); });
    interactor->EnableRenderOff();
    interactor->CreateOneShotTimer(1);
    loop();
  }
  interactor->SetInteractorStyle(nullptr);
  interactor->SetRenderWindow(nullptr);
  window->SetInteractor(nullptr);
}

void ViewerWindow::loop()
{
  looping_ = true;
  interactor->Start();
  looping_ = false;
  looped_ = true;
}

void ViewerWindow::leave()
{
  if (looping_)
  {
    interactor->TerminateApp();
  }
}

} // namespace medial::app
