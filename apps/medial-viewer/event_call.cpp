#include "event_call.h"

#include <vtkCommand.h>
#include <vtkNew.h>

#include <utility>

namespace medial::app
{
namespace
{

class Call : public vtkCommand
{
public:
  static Call* New() { return new Call; }
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* /*data*/) override { act(); }

  std::function<void()> act;
};

} // namespace

void observeEvent(vtkObject* object, unsigned long event, std::function<void()> act)
{
  vtkNew<Call> call;
  call->act = std::move(act);
  object->AddObserver(event, call);
}

} // namespace medial::app
