/**
 * @file
 * Parameters that several filters have, each declared once. A class names the macro in its public
 * part, below the manual of the parameter, and has the member of the same name.
 */

#ifndef vtkMedialParameters_h
#define vtkMedialParameters_h

#include "vtkSetGet.h"

/// Angle: minimum separation angle in degrees.
#define vtkMedialAngleMacro()                                                                      \
  vtkSetMacro(Angle, double);                                                                      \
  vtkGetMacro(Angle, double)

/// Side: the side of the surface that is wanted, one of Sides.
#define vtkMedialSideMacro()                                                                       \
  vtkSetMacro(Side, int);                                                                          \
  vtkGetMacro(Side, int);                                                                          \
  void SetSideToInterior()                                                                         \
  {                                                                                                \
    this->SetSide(INTERIOR);                                                                       \
  }                                                                                                \
  void SetSideToExterior()                                                                         \
  {                                                                                                \
    this->SetSide(EXTERIOR);                                                                       \
  }                                                                                                \
  void SetSideToBoth()                                                                             \
  {                                                                                                \
    this->SetSide(BOTH);                                                                           \
  }                                                                                                \
  const char* GetSideAsString();                                                                   \
  enum Sides                                                                                       \
  {                                                                                                \
    INTERIOR = 0,                                                                                  \
    EXTERIOR = 1,                                                                                  \
    BOTH = 2                                                                                       \
  }

/// NumberOfThreads: how many CPU threads to use; 0 for all cores.
#define vtkMedialThreadsMacro()                                                                    \
  vtkSetMacro(NumberOfThreads, int);                                                               \
  vtkGetMacro(NumberOfThreads, int)

#endif
