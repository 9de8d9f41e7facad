/**
 * Visits cells. Private to the module.
 */

#ifndef vtkMedialCells_h
#define vtkMedialCells_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

/**
 * Calls visit(ids, count) for all cells in their order, with the ids of their points.
 */
template <typename Visit>
void vtkForEachCell(vtkCellArray* cells, const Visit& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    iterator->GetCurrentCell(count, ids);
    visit(ids, count);
  }
}

#endif
