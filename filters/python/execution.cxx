// The extension module medial._execution: executes a filter with Python's global lock released, and
// passes on what happens meanwhile: its success, error and warning events as texts, Ctrl-C and
// exceptions of the progress function as exceptions, after aborting the filter.
#include "vtkPython.h" // must come first

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPythonUtil.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <exception>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
/// Lets other Python threads run while it lives.
class LockRelease
{
public:
  explicit LockRelease(bool release)
    : State(release ? PyEval_SaveThread() : nullptr)
  {
  }
  ~LockRelease()
  {
    if (this->State)
    {
      PyEval_RestoreThread(this->State);
    }
  }
  LockRelease(const LockRelease&) = delete;
  void operator=(const LockRelease&) = delete;

private:
  PyThreadState* State;
};

//------------------------------------------------------------------------------
/// Holds Python's global lock while it lives, whether the thread held it before or not.
class LockHold
{
public:
  LockHold()
    : State(PyGILState_Ensure())
  {
  }
  ~LockHold() { PyGILState_Release(this->State); }
  LockHold(const LockHold&) = delete;
  void operator=(const LockHold&) = delete;

private:
  PyGILState_STATE State;
};

//------------------------------------------------------------------------------
/// The text of vtkErrorMacro or vtkWarningMacro without the place in the sources and the object's
/// address.
std::string WithoutPlace(const std::string& text)
{
  const std::size_t line = text.find('\n');
  const std::size_t address = text.find("): ", line == std::string::npos ? 0 : line);
  const std::size_t begin = address == std::string::npos ? 0 : address + 3;
  const std::size_t end = text.find_last_not_of(" \n");
  return end == std::string::npos || end < begin ? text : text.substr(begin, end + 1 - begin);
}

//------------------------------------------------------------------------------
/// Receives the events of algorithms and of their executives.
class EventReceiver : public vtkCommand
{
public:
  static EventReceiver* New() { return new EventReceiver; }

  /// @param algorithm the one whose progress is wanted.
  /// @param progress function of a fraction and a phase; may be None. Borrowed.
  void SetProgress(vtkAlgorithm* algorithm, PyObject* progress)
  {
    this->Algorithm = algorithm;
    this->Progress = progress;
  }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (event == vtkCommand::ErrorEvent)
    {
      auto& messages = algorithm ? this->Messages : this->ExecutiveMessages;
      messages.push_back(WithoutPlace(data ? static_cast<const char*>(data) : "unknown error"));
    }
    else if (event == vtkCommand::WarningEvent)
    {
      this->Warnings.push_back(
        WithoutPlace(data ? static_cast<const char*>(data) : "unknown warning"));
    }
    else if (algorithm && !this->Raised())
    {
      this->OnProgress(algorithm);
    }
  }

  /// Executives only repeat that an algorithm failed, unless nothing was executed at all.
  const std::vector<std::string>& GetMessages() const
  {
    return this->Messages.empty() ? this->ExecutiveMessages : this->Messages;
  }

  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  bool Raised() const { return this->Type != nullptr; }

  /// Records an exception that a filter threw in C++.
  void SetFailure(const std::string& what) { this->Messages.push_back(what); }

  /// Makes the exception that stopped the execution the current one.
  void Raise()
  {
    PyErr_Restore(std::exchange(this->Type, nullptr), std::exchange(this->Value, nullptr),
      std::exchange(this->Traceback, nullptr));
  }

protected:
  ~EventReceiver() override
  {
    Py_XDECREF(this->Type);
    Py_XDECREF(this->Value);
    Py_XDECREF(this->Traceback);
  }

private:
  void OnProgress(vtkAlgorithm* algorithm)
  {
    const LockHold lock;
    if (PyErr_CheckSignals() != 0 || !this->CallProgress(algorithm))
    {
      // Python code that runs before the filter has stopped must not see it.
      PyErr_Fetch(&this->Type, &this->Value, &this->Traceback);
      algorithm->SetAbortExecute(1);
    }
  }

  bool CallProgress(vtkAlgorithm* algorithm)
  {
    if (this->Progress == Py_None || algorithm != this->Algorithm)
    {
      return true;
    }
    const char* phase = algorithm->GetProgressText();
    PyObject* result =
      PyObject_CallFunction(this->Progress, "ds", algorithm->GetProgress(), phase ? phase : "");
    Py_XDECREF(result);
    return result != nullptr;
  }

  vtkAlgorithm* Algorithm = nullptr;
  PyObject* Progress = Py_None;
  PyObject* Type = nullptr;
  PyObject* Value = nullptr;
  PyObject* Traceback = nullptr;
  std::vector<std::string> Messages;
  std::vector<std::string> ExecutiveMessages;
  std::vector<std::string> Warnings;
};

//------------------------------------------------------------------------------
/// Gives access to the error code of any algorithm, which is protected.
class ErrorCodes : public vtkAlgorithm
{
public:
  /// Readers set it when they fail, but many do not clear it when they next succeed. SetErrorCode()
  /// would also modify them.
  static void Clear(vtkAlgorithm* algorithm)
  {
    algorithm->*(&ErrorCodes::ErrorCode) = vtkErrorCode::NoError;
  }
};

//------------------------------------------------------------------------------
/// Adds the receiver to the algorithm and to everything upstream of it, whose error codes are
/// cleared: afterwards they are those of this update.
class Subscriptions
{
public:
  Subscriptions(vtkAlgorithm* algorithm, EventReceiver* receiver)
    : Receiver(receiver)
  {
    this->Visit(algorithm);
  }
  ~Subscriptions()
  {
    for (const auto& tag : this->Tags)
    {
      if (tag.first)
      {
        tag.first->RemoveObserver(tag.second);
      }
    }
  }
  Subscriptions(const Subscriptions&) = delete;
  void operator=(const Subscriptions&) = delete;

  /// VTK runs algorithms written in Python without asking for the lock.
  bool NeedLock() const { return this->HasPythonAlgorithm; }

private:
  void Visit(vtkAlgorithm* algorithm)
  {
    if (!algorithm || !this->Visited.insert(algorithm).second)
    {
      return;
    }
    this->HasPythonAlgorithm = this->HasPythonAlgorithm || algorithm->IsA("vtkPythonAlgorithm");
    ErrorCodes::Clear(algorithm);
    this->Observe(algorithm, vtkCommand::ErrorEvent);
    this->Observe(algorithm, vtkCommand::WarningEvent);
    this->Observe(algorithm, vtkCommand::ProgressEvent);
    this->Observe(algorithm->GetExecutive(), vtkCommand::ErrorEvent);
    for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
    {
      for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
      {
        this->Visit(algorithm->GetInputAlgorithm(port, i));
      }
    }
  }

  /// Runs before observers in Python: VTK ends the process if Ctrl-C arrives in one of them.
  void Observe(vtkObject* object, unsigned long event)
  {
    constexpr float first = std::numeric_limits<float>::max();
    this->Tags.emplace_back(object, object->AddObserver(event, this->Receiver, first));
  }

  EventReceiver* Receiver;
  std::set<vtkAlgorithm*> Visited;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Tags;
  bool HasPythonAlgorithm = false;
};

//------------------------------------------------------------------------------
PyObject* ToList(const std::vector<std::string>& texts)
{
  PyObject* list = PyList_New(0);
  for (const std::string& text : texts)
  {
    PyObject* item =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (!list || !item || PyList_Append(list, item) != 0)
    {
      Py_CLEAR(list);
    }
    Py_XDECREF(item);
  }
  return list;
}

//------------------------------------------------------------------------------
PyObject* Update(PyObject*, PyObject* arguments)
{
  PyObject* object = nullptr;
  PyObject* progress = Py_None;
  if (!PyArg_ParseTuple(arguments, "O|O:update", &object, &progress))
  {
    return nullptr;
  }
  vtkObjectBase* pointer = vtkPythonUtil::GetPointerFromObject(object, "vtkAlgorithm");
  if (!pointer)
  {
    return PyErr_Occurred() ? nullptr
                            : PyErr_Format(PyExc_TypeError, "a vtkAlgorithm is needed, not None");
  }
  const vtkSmartPointer<vtkAlgorithm> algorithm = vtkAlgorithm::SafeDownCast(pointer);
  vtkNew<EventReceiver> receiver;
  receiver->SetProgress(algorithm, progress);
  vtkTypeBool done = 0;
  {
    const Subscriptions subscriptions(algorithm, receiver);
    const LockRelease release(!subscriptions.NeedLock());
    try
    {
      // As Update(), which keeps to itself whether all went well.
      done = algorithm->Update(algorithm->GetNumberOfOutputPorts() > 0 ? 0 : -1, nullptr);
    }
    catch (const std::exception& error)
    {
      receiver->SetFailure(error.what());
    }
  }
  if (receiver->Raised())
  {
    receiver->Raise();
    return nullptr;
  }
  // "N" takes over the lists; it fails, and releases them, where one of them is null.
  return Py_BuildValue("NNN", PyBool_FromLong(done), ToList(receiver->GetMessages()),
    ToList(receiver->GetWarnings()));
}

PyMethodDef Methods[] = {
  { "update", Update, METH_VARARGS,
    "update(algorithm, progress=None) -> whether all went well, and lists of error messages and of "
    "warnings" },
  { nullptr, nullptr, 0, nullptr }
};

PyModuleDef Module = { PyModuleDef_HEAD_INIT, "_execution",
  "Executes filters with Python's global lock released.", -1, Methods, nullptr, nullptr, nullptr,
  nullptr };

} // namespace

//------------------------------------------------------------------------------
// Python derives the name from that of the module.
PyMODINIT_FUNC PyInit__execution() // NOLINT(bugprone-reserved-identifier)
{
  return PyModule_Create(&Module);
}
