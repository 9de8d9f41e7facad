/**
 * @class   vtkMedialLocalThickness
 * @brief   local thickness of a solid, or separation of the space around it, as an image
 *
 * vtkMedialLocalThickness computes at every point of a regular grid the diameter of the largest
 * ball inside a solid that contains the point (Hildebrand, Rueegsegger 1997). The same for the
 * space outside is the separation. The centres of the balls are points of the medial axis, not only
 * grid points, and their radii are exact. Values are rounded to 1/256 of the finest spacing.
 *
 * The output is a vtkImageData with the point data array LocalThickness as its active scalars
 * (float32, world units; 0 on a side that was not asked for).
 *
 * vtkMeshFieldAlgorithm documents the parameters of the grid and of the distance field, the input,
 * the field data, errors and abort. The Generate parameters have no effect. The field data has more
 * arrays here. ThicknessDistribution (float64) is that of the grid points inside, with the
 * components Points (their number), Minimum, Mean, StandardDeviation, Maximum and HistogramEnd,
 * in world units, NaN without points; ThicknessHistogram (vtkIdType) counts them in NumberOfBins
 * equally wide bins from 0 to HistogramEnd. SeparationDistribution and SeparationHistogram are the
 * same of the points outside. Input without an inside, such as a mesh with large holes, is an
 * error.
 *
 * @par Parameter tuning:
 * Walls thinner than the spacing may be missed; their points then have twice their own distance to
 * the surface, which is too little. Where the grid ends, so do the centres of balls: raise Padding
 * if the separation around a part matters, not only that of its pores.
 *
 * @par Parallel pipelines:
 * The filter computes the whole grid whatever extent is requested, since a ball may reach anywhere,
 * and returns the extent. Figures are those of the whole.
 *
 * @sa
 * vtkMedialThickness vtkMeshDistanceField vtkMeshFieldAlgorithm
 */

#ifndef vtkMedialLocalThickness_h
#define vtkMedialLocalThickness_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For the parameters that filters share
#include "vtkMeshFieldAlgorithm.h"

class vtkImageData;

class VTKMEDIALFILTERS_EXPORT vtkMedialLocalThickness : public vtkMeshFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialLocalThickness* New();
  vtkTypeMacro(vtkMedialLocalThickness, vtkMeshFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * What to compute: INTERIOR, the thickness of the solid; EXTERIOR, the separation outside; BOTH,
   * the thickness inside and the separation outside as a negative number. Default is INTERIOR.
   */
  vtkMedialSideMacro();
  ///@}

  ///@{
  /**
   * Number of bins of the histograms in the field data, in [1, 65536]. The bins are equally wide,
   * and the first begins at 0. Default is 64.
   */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  /**
   * The local thickness, output port 0.
   */
  vtkImageData* GetOutput();

protected:
  vtkMedialLocalThickness();
  ~vtkMedialLocalThickness() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Side = INTERIOR;
  int NumberOfBins = 64;

private:
  vtkMedialLocalThickness(const vtkMedialLocalThickness&) = delete;
  void operator=(const vtkMedialLocalThickness&) = delete;
};

#endif
