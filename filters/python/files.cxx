// The extension module medial._files: meshes and scans, for Python.
#define PY_SSIZE_T_CLEAN
#include "vtkPython.h"

#include "vtkMeshConversion.h"

#include "files/file_content.h"
#include "files/scans/scan_reader.h"
#include "files/scans/scan_surface.h"
#include "files/surface_reader.h"

#include "medial/error.h"
#include "medial/triangle_mesh.h"
#include "medial/version.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkPythonUtil.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace
{

namespace files = medial::files;
using medial::TriangleMesh;

//------------------------------------------------------------------------------
template <typename T>
PyObject* ToBytes(const std::vector<T>& values)
{
  return PyBytes_FromStringAndSize(reinterpret_cast<const char*>(values.data()),
    static_cast<Py_ssize_t>(values.size() * sizeof(T)));
}

//------------------------------------------------------------------------------
TriangleMesh ToTriangles(const medial::MeshInput& surface)
{
  return medial::buildTriangleMesh(surface);
}

//------------------------------------------------------------------------------
TriangleMesh ToTriangles(vtkPolyData* surface)
{
  return ToTriangles(vtkMeshConversion::ToMeshInput(surface));
}

//------------------------------------------------------------------------------
// What work() makes, which runs without Python's lock, as points and triangles.
template <typename Work>
PyObject* TrianglesOf(const std::string& name, const Work& work)
{
  std::optional<TriangleMesh> mesh;
  std::string problem;
  bool outOfMemory = false;
  PyThreadState* const thread = PyEval_SaveThread();
  try
  {
    mesh = work();
  }
  catch (const medial::Error& error)
  {
    problem = error.what();
    outOfMemory = error.code() == medial::ErrorCode::OutOfMemory;
  }
  catch (const std::bad_alloc&)
  {
    problem = name + ": not enough memory";
    outOfMemory = true;
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  PyEval_RestoreThread(thread);
  if (!mesh)
  {
    PyErr_SetString(outOfMemory ? PyExc_MemoryError : PyExc_ValueError, problem.c_str());
    return nullptr;
  }
  return Py_BuildValue("NN", ToBytes(mesh->points), ToBytes(mesh->triangles));
}

//------------------------------------------------------------------------------
// For PyArg_ParseTuple().
int ToPath(PyObject* argument, void* path)
{
  PyObject* encoded = nullptr;
  if (PyUnicode_FSConverter(argument, &encoded) == 0)
  {
    return 0;
  }
  *static_cast<std::filesystem::path*>(path) = PyBytes_AS_STRING(encoded);
  Py_DECREF(encoded);
  return 1;
}

//------------------------------------------------------------------------------
// For PyArg_ParseTuple(), of a tuple (isovalue, label, smoothing), each a number or None.
int ToWanted(PyObject* argument, void* result)
{
  PyObject* isovalue = nullptr;
  PyObject* label = nullptr;
  PyObject* smoothing = nullptr;
  if (!PyTuple_Check(argument) ||
    PyArg_ParseTuple(argument, "OOO", &isovalue, &label, &smoothing) == 0)
  {
    return 0;
  }
  auto& wanted = *static_cast<files::ScanSurface*>(result);
  if (isovalue != Py_None)
  {
    wanted.isovalue = PyFloat_AsDouble(isovalue);
  }
  if (label != Py_None)
  {
    wanted.label = PyLong_AsLongLong(label);
  }
  if (smoothing != Py_None)
  {
    wanted.smoothing = static_cast<int>(PyLong_AsLong(smoothing));
  }
  return PyErr_Occurred() == nullptr ? 1 : 0;
}

//------------------------------------------------------------------------------
PyObject* ReadMesh(PyObject*, PyObject* arguments)
{
  std::filesystem::path path;
  if (PyArg_ParseTuple(arguments, "O&:read_mesh", ToPath, &path) == 0)
  {
    return nullptr;
  }
  return TrianglesOf(path.string(),
    [&]
    {
      const files::SurfaceContent content = files::readSurface(path);
      return files::withName(path,
        [&] { return std::visit([](const auto& mesh) { return ToTriangles(mesh); }, content); });
    });
}

//------------------------------------------------------------------------------
PyObject* ReadScan(PyObject*, PyObject* arguments)
{
  std::filesystem::path path;
  files::ScanSurface wanted;
  if (PyArg_ParseTuple(arguments, "O&O&:read_scan", ToPath, &path, ToWanted, &wanted) == 0)
  {
    return nullptr;
  }
  return TrianglesOf(path.string(),
    [&] { return ToTriangles(files::extractSurface(files::readScan(path), wanted, path)); });
}

//------------------------------------------------------------------------------
PyObject* ScanSurface(PyObject*, PyObject* arguments)
{
  PyObject* image = nullptr;
  files::Scan scan;
  auto& [x, y, z] = scan.frame;
  files::ScanSurface wanted;
  if (PyArg_ParseTuple(arguments, "O(dddddddddddd)O&:scan_surface", &image, &x[0], &x[1], &x[2],
        &x[3], &y[0], &y[1], &y[2], &y[3], &z[0], &z[1], &z[2], &z[3], ToWanted, &wanted) == 0)
  {
    return nullptr;
  }
  scan.image =
    vtkImageData::SafeDownCast(vtkPythonUtil::GetPointerFromObject(image, "vtkImageData"));
  if (scan.image == nullptr)
  {
    return nullptr;
  }
  const std::string name = "values";
  return TrianglesOf(name, [&] { return ToTriangles(files::extractSurface(scan, wanted, name)); });
}

PyMethodDef Methods[] = {
  { "read_mesh", ReadMesh, METH_VARARGS,
    "read_mesh(path) -> points (float64 x 3) and triangles (int32 x 3) as bytes; raises "
    "ValueError or MemoryError" },
  { "read_scan", ReadScan, METH_VARARGS,
    "read_scan(path, (isovalue, label, smoothing)) -> the same of a surface in a scan" },
  { "scan_surface", ScanSurface, METH_VARARGS,
    "scan_surface(image, frame, (isovalue, label, smoothing)) -> the same of an image, whose NaN "
    "it replaces; frame has 12 numbers, row by row" },
  { nullptr, nullptr, 0, nullptr }
};

PyModuleDef Module = { PyModuleDef_HEAD_INIT, "_files", "Reads meshes and scans.", -1, Methods,
  nullptr, nullptr, nullptr, nullptr };

} // namespace

//------------------------------------------------------------------------------
// Python derives the name from that of the module.
PyMODINIT_FUNC PyInit__files() // NOLINT(bugprone-reserved-identifier)
{
  PyObject* module = PyModule_Create(&Module);
  if (module != nullptr &&
    (PyModule_AddStringConstant(module, "VERSION", MEDIAL_VERSION) != 0 ||
      PyModule_AddIntConstant(module, "MAX_SMOOTHING", files::ScanSurface::kMaxIterations) != 0))
  {
    Py_CLEAR(module);
  }
  return module;
}
