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

/// SignMethod: how inside is told from outside, one of SignMethods.
#define vtkMedialSignMethodMacro()                                                                 \
  vtkSetMacro(SignMethod, int);                                                                    \
  vtkGetMacro(SignMethod, int);                                                                    \
  void SetSignMethodToAuto()                                                                       \
  {                                                                                                \
    this->SetSignMethod(SIGN_AUTO);                                                                \
  }                                                                                                \
  void SetSignMethodToNone()                                                                       \
  {                                                                                                \
    this->SetSignMethod(SIGN_NONE);                                                                \
  }                                                                                                \
  void SetSignMethodToPseudonormal()                                                               \
  {                                                                                                \
    this->SetSignMethod(SIGN_PSEUDONORMAL);                                                        \
  }                                                                                                \
  void SetSignMethodToWinding()                                                                    \
  {                                                                                                \
    this->SetSignMethod(SIGN_WINDING);                                                             \
  }                                                                                                \
  const char* GetSignMethodAsString();                                                             \
  enum SignMethods                                                                                 \
  {                                                                                                \
    SIGN_AUTO = 0,                                                                                 \
    SIGN_NONE = 1,                                                                                 \
    SIGN_PSEUDONORMAL = 2,                                                                         \
    SIGN_WINDING = 3                                                                               \
  }

/// DistributedInput: whether the inputs of all processes together are the surface. What the input
/// may be follows from it.
#define vtkMedialDistributedInputMacro()                                                           \
  vtkSetMacro(DistributedInput, vtkTypeBool);                                                      \
  vtkGetMacro(DistributedInput, vtkTypeBool);                                                      \
  vtkBooleanMacro(DistributedInput, vtkTypeBool);                                                  \
  void Modified() override

/// Controller: the processes among which the surface is distributed.
#define vtkMedialControllerMacro()                                                                 \
  void SetController(vtkMultiProcessController* controller);                                       \
  vtkMultiProcessController* GetController()

/// NumberOfThreads: how many CPU threads to use; 0 for all cores.
#define vtkMedialThreadsMacro()                                                                    \
  vtkSetMacro(NumberOfThreads, int);                                                               \
  vtkGetMacro(NumberOfThreads, int)

#endif
