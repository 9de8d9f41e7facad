/**
 * Parameters that take one of several values, each with the library's value and its name. Private
 * to the module.
 */

#ifndef vtkMedialEnumerations_h
#define vtkMedialEnumerations_h

#include "vtkMedialAxis.h"
#include "vtkMedialExecution.h"
#include "vtkMeshFieldAlgorithm.h"

#include "medial/engine.h"
#include "medial/side.h"
#include "medial/sign_method.h"

#include <cctype>
#include <cstddef>
#include <string>

/**
 * One value of a parameter: the filter's, the library's and its name, as Get...AsString() returns
 * it.
 */
template <typename LibraryValue>
struct vtkMedialChoice
{
  int Value;
  LibraryValue Library;
  const char* Name;
};

/**
 * All values of a parameter.
 */
template <typename LibraryValue, std::size_t Count>
struct vtkMedialEnumeration
{
  const char* Parameter;
  vtkMedialChoice<LibraryValue> Choices[Count];

  /**
   * The library's value. Throws medial::Error, which lists the values, if there is none.
   */
  LibraryValue ToLibrary(int value) const
  {
    for (const vtkMedialChoice<LibraryValue>& choice : this->Choices)
    {
      if (choice.Value == value)
      {
        return choice.Library;
      }
    }
    vtkThrowBadParameter(this->Parameter, value, "one of " + this->List());
  }

  /**
   * The name of the filter's value, "Unknown" if it is none.
   */
  const char* NameOf(int value) const
  {
    for (const vtkMedialChoice<LibraryValue>& choice : this->Choices)
    {
      if (choice.Value == value)
      {
        return choice.Name;
      }
    }
    return "Unknown";
  }

  /**
   * The name of the library's value.
   */
  const char* NameOfLibrary(LibraryValue value) const
  {
    for (const vtkMedialChoice<LibraryValue>& choice : this->Choices)
    {
      if (choice.Library == value)
      {
        return choice.Name;
      }
    }
    return "Unknown";
  }

private:
  /**
   * Such as "0 (interior), 1 (exterior)".
   */
  std::string List() const
  {
    std::string list;
    for (const vtkMedialChoice<LibraryValue>& choice : this->Choices)
    {
      std::string name = choice.Name;
      name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
      list += (list.empty() ? "" : ", ") + std::to_string(choice.Value) + " (" + name + ")";
    }
    return list;
  }
};

///@{
/**
 * Parameters of several filters.
 */
inline constexpr vtkMedialEnumeration<medial::Side, 3> vtkMedialSides = { "Side",
  {
    { vtkMedialAxis::INTERIOR, medial::Side::Interior, "Interior" },
    { vtkMedialAxis::EXTERIOR, medial::Side::Exterior, "Exterior" },
    { vtkMedialAxis::BOTH, medial::Side::Both, "Both" },
  } };

inline constexpr vtkMedialEnumeration<medial::SignMethod, 4> vtkMedialSignMethods = { "SignMethod",
  {
    { vtkMeshFieldAlgorithm::SIGN_AUTO, medial::SignMethod::Auto, "Auto" },
    { vtkMeshFieldAlgorithm::SIGN_NONE, medial::SignMethod::None, "None" },
    { vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL, medial::SignMethod::Pseudonormal, "Pseudonormal" },
    { vtkMeshFieldAlgorithm::SIGN_WINDING, medial::SignMethod::Winding, "Winding" },
  } };

inline constexpr vtkMedialEnumeration<medial::Engine, 4> vtkMedialEngines = { "Engine",
  {
    { vtkMeshFieldAlgorithm::ENGINE_AUTO, medial::Engine::Auto, "Auto" },
    { vtkMeshFieldAlgorithm::ENGINE_RASTERISER, medial::Engine::Rasteriser, "Rasteriser" },
    { vtkMeshFieldAlgorithm::ENGINE_PROCESSOR, medial::Engine::Processor, "Processor" },
    { vtkMeshFieldAlgorithm::ENGINE_DEVICE, medial::Engine::Device, "Device" },
  } };

inline constexpr vtkMedialEnumeration<vtkMeshFieldAlgorithm::GridModes, 3> vtkMedialGridModes = {
  "GridMode",
  {
    { vtkMeshFieldAlgorithm::RESOLUTION, vtkMeshFieldAlgorithm::RESOLUTION, "Resolution" },
    { vtkMeshFieldAlgorithm::SPACING, vtkMeshFieldAlgorithm::SPACING, "Spacing" },
    { vtkMeshFieldAlgorithm::EXPLICIT, vtkMeshFieldAlgorithm::EXPLICIT, "Explicit" },
  }
};
///@}

#endif
