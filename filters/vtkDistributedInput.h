/**
 * What the filters with DistributedInput and Controller share. Private to the module.
 */

#ifndef vtkDistributedInput_h
#define vtkDistributedInput_h

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialRanks.h"
#include "vtkMedialRequests.h"
#include "vtkMultiProcessController.h"

/**
 * Defines the functions of a filter that these parameters need: those that their macros declare,
 * and what its input may be and is asked for. Unless DistributedInput is on, the process is a rank
 * on its own and gets the whole. A macro, since the superclasses differ and VTK wraps only what a
 * class itself declares.
 */
#define vtkCxxDistributedInputMacro(filter)                                                        \
  vtkCxxSetSmartPointerMacro(filter, Controller, vtkMultiProcessController);                       \
  vtkMultiProcessController* filter::GetController()                                               \
  {                                                                                                \
    return this->Controller;                                                                       \
  }                                                                                                \
  void filter::Modified()                                                                          \
  {                                                                                                \
    this->FillInputPortInformation(0, this->GetInputPortInformation(0));                           \
    this->Superclass::Modified();                                                                  \
  }                                                                                                \
  int filter::FillInputPortInformation(int, vtkInformation* info)                                  \
  {                                                                                                \
    vtkAcceptSurface(info, this->DistributedInput != 0);                                           \
    return 1;                                                                                      \
  }                                                                                                \
  int filter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,             \
    vtkInformationVector*)                                                                         \
  {                                                                                                \
    const vtkMedialRanks ranks(this->DistributedInput ? this->Controller.Get() : nullptr);         \
    vtkRequestPiece(inputVector[0]->GetInformationObject(0), ranks.rank(), ranks.size());          \
    return 1;                                                                                      \
  }

#endif
