#include "vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>

namespace medial::app
{
namespace
{

// "ERROR: In file.cxx, line 1\nvtkClass (0x1): Text.\n\n" becomes "Text".
std::string plainText(const char* message)
{
  std::string text = message;
  if (text.rfind("ERROR: In ", 0) == 0 || text.find("Warning: In ") == 0 ||
    text.rfind("Generic Warning: In ", 0) == 0)
  {
    text.erase(0, std::min(text.size(), text.find('\n') + 1));
  }
  if (text.rfind("vtk", 0) == 0 && text.find("): ") != std::string::npos)
  {
    text.erase(0, text.find("): ") + 3);
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(" .") + 1);
  return text;
}

class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->keep(this->error, text); }
  void DisplayWarningText(const char* text) override { this->keep(this->warning, text); }
  void DisplayGenericWarningText(const char* text) override { this->keep(this->warning, text); }
  void DisplayDebugText(const char*) override {}

  std::string error;
  std::string warning;

private:
  void keep(std::string& place, const char* text)
  {
    if (place.empty())
    {
      place = plainText(text);
    }
  }
};

vtkStandardNewMacro(MessageWindow);

} // namespace

VtkMessages::VtkMessages()
  : outer_(vtkOutputWindow::GetInstance())
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(outer_);
}

std::string VtkMessages::first() const
{
  const auto* window = static_cast<MessageWindow*>(vtkOutputWindow::GetInstance());
  return window->error.empty() ? window->warning : window->error;
}

} // namespace medial::app
