/**
 * @class   vtkMedialCurves
 * @brief   seams, rims and curves of a medial axis as polylines
 *
 * vtkMedialCurves takes a medial axis as vtkMedialAxis makes it, or any mesh of polygons and lines,
 * and gives the polylines along which its sheets meet (seams: edges with three polygons and more),
 * where they end (rims: edges with one polygon), and where it is no sheet but a curve (lines).
 * Polylines run from junction to junction; loops end where they begin.
 *
 * The points used keep their point data. The cell data array AxisFeature (unsigned char) has the
 * kind of each polyline: 1 rim, 2 seam, 4 curve, the values that the point data array of the same
 * name has on the axis of vtkMedialAxis (0 inside a sheet, 3 junction, 5 alone).
 *
 * @sa
 * vtkMedialAxis
 */

#ifndef vtkMedialCurves_h
#define vtkMedialCurves_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKMEDIALFILTERS_EXPORT vtkMedialCurves : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialCurves* New();
  vtkTypeMacro(vtkMedialCurves, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Whether polylines of each kind are wanted. Default is on for all.
   */
  vtkSetMacro(Rims, vtkTypeBool);
  vtkGetMacro(Rims, vtkTypeBool);
  vtkBooleanMacro(Rims, vtkTypeBool);
  vtkSetMacro(Seams, vtkTypeBool);
  vtkGetMacro(Seams, vtkTypeBool);
  vtkBooleanMacro(Seams, vtkTypeBool);
  vtkSetMacro(Curves, vtkTypeBool);
  vtkGetMacro(Curves, vtkTypeBool);
  vtkBooleanMacro(Curves, vtkTypeBool);
  ///@}

protected:
  vtkMedialCurves() = default;
  ~vtkMedialCurves() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkTypeBool Rims = true;
  vtkTypeBool Seams = true;
  vtkTypeBool Curves = true;

private:
  vtkMedialCurves(const vtkMedialCurves&) = delete;
  void operator=(const vtkMedialCurves&) = delete;
};

#endif
