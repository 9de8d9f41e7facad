/**
 * @class   vtkMedialCurves
 * @brief   seams, rims and curves of a medial axis as polylines
 *
 * vtkMedialCurves takes a medial axis as vtkMedialAxis makes it, or any mesh of polygons and lines,
 * and gives the polylines along which its sheets meet (seams: edges with three polygons and more),
 * where they end (rims: edges with one polygon), and where it is a curve instead of a sheet
 * (lines). Polylines run from junction to junction; loops end where they begin.
 *
 * @par Input:
 * A vtkPolyData with polygons and lines, of any number of points; an empty one gives an empty
 * output. Vertices and triangle strips are ignored.
 *
 * @par Output:
 * Lines over the points of the input that they use, in the same precision and with their point
 * data. The cell data array AxisFeature (unsigned char, the active scalars) has the kind of each
 * polyline: 1 rim, 2 seam, 4 curve, the values that the point data array of the same name has on
 * the axis of vtkMedialAxis (0 inside a sheet, 3 junction, 5 alone).
 *
 * @par Errors:
 * A cell with a point id that the input does not have. vtkMedialPolyDataAlgorithm documents how
 * errors are reported, abort and parallel pipelines.
 *
 * @sa
 * vtkMedialAxis vtkMedialPolyDataAlgorithm
 */

#ifndef vtkMedialCurves_h
#define vtkMedialCurves_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialPolyDataAlgorithm.h"

class VTKMEDIALFILTERS_EXPORT vtkMedialCurves : public vtkMedialPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialCurves* New();
  vtkTypeMacro(vtkMedialCurves, vtkMedialPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Whether the output has rims: polylines of edges with one polygon, where a sheet ends.
   * Default is on.
   */
  vtkSetMacro(Rims, vtkTypeBool);
  vtkGetMacro(Rims, vtkTypeBool);
  vtkBooleanMacro(Rims, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the output has seams: polylines of edges with three polygons or more, where sheets
   * meet. Default is on.
   */
  vtkSetMacro(Seams, vtkTypeBool);
  vtkGetMacro(Seams, vtkTypeBool);
  vtkBooleanMacro(Seams, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the output has curves: polylines of the input's lines, where the axis is not a sheet.
   * Default is on.
   */
  vtkSetMacro(Curves, vtkTypeBool);
  vtkGetMacro(Curves, vtkTypeBool);
  vtkBooleanMacro(Curves, vtkTypeBool);
  ///@}

protected:
  vtkMedialCurves();
  ~vtkMedialCurves() override;

  void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) override;

  vtkTypeBool Rims = true;
  vtkTypeBool Seams = true;
  vtkTypeBool Curves = true;

private:
  vtkMedialCurves(const vtkMedialCurves&) = delete;
  void operator=(const vtkMedialCurves&) = delete;
};

#endif
