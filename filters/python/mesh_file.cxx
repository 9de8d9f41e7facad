// The extension module medial._mesh_file: the library's own mesh files, for Python.
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "medial/error.h"
#include "medial/mesh_io.h"
#include "medial/triangle_mesh.h"
#include "medial/version.h"

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
template <typename T>
PyObject* ToBytes(const std::vector<T>& values)
{
  return PyBytes_FromStringAndSize(reinterpret_cast<const char*>(values.data()),
    static_cast<Py_ssize_t>(values.size() * sizeof(T)));
}

//------------------------------------------------------------------------------
// Called without Python's lock.
std::optional<medial::TriangleMesh> ReadTriangles(const std::string& path, std::string& problem)
{
  try
  {
    return medial::buildTriangleMesh(medial::readMesh(path));
  }
  catch (const std::bad_alloc&)
  {
    problem = path + ": not enough memory for the mesh";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
PyObject* Read(PyObject*, PyObject* arguments)
{
  PyObject* encoded = nullptr;
  if (!PyArg_ParseTuple(arguments, "O&:read", PyUnicode_FSConverter, &encoded))
  {
    return nullptr;
  }
  const std::string path = PyBytes_AS_STRING(encoded);
  Py_DECREF(encoded);
  std::string problem;
  std::optional<medial::TriangleMesh> mesh;
  Py_BEGIN_ALLOW_THREADS mesh = ReadTriangles(path, problem);
  Py_END_ALLOW_THREADS if (!mesh)
  {
    PyErr_SetString(PyExc_ValueError, problem.c_str());
    return nullptr;
  }
  return Py_BuildValue("NN", ToBytes(mesh->points), ToBytes(mesh->triangles));
}

PyMethodDef Methods[] = {
  { "read", Read, METH_VARARGS,
    "read(path) -> points (float64 x 3) and triangles (int32 x 3) as bytes; raises ValueError" },
  { nullptr, nullptr, 0, nullptr }
};

PyModuleDef Module = { PyModuleDef_HEAD_INIT, "_mesh_file", "Reads mesh files.", -1, Methods,
  nullptr, nullptr, nullptr, nullptr };

} // namespace

//------------------------------------------------------------------------------
// Python derives the name from that of the module.
PyMODINIT_FUNC PyInit__mesh_file() // NOLINT(bugprone-reserved-identifier)
{
  PyObject* module = PyModule_Create(&Module);
  if (module != nullptr && PyModule_AddStringConstant(module, "VERSION", MEDIAL_VERSION) != 0)
  {
    Py_CLEAR(module);
  }
  return module;
}
