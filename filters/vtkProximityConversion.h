/**
 * Conversion of the library's proximity of two meshes to VTK's data sets. Private to the module.
 */

#ifndef vtkProximityConversion_h
#define vtkProximityConversion_h

#include "medial/proximity.h"

class vtkPolyData;

namespace vtkProximityConversion
{

/**
 * Fills an empty output with the witnesses and the contacts, and their point data arrays.
 */
void ToPolyData(const medial::Proximity& proximity, vtkPolyData* output);

/**
 * Adds the figures of the pair as field data; only those that the options asked for.
 */
void AddFigures(const medial::Proximity& proximity, const medial::ProximityOptions& options,
  vtkPolyData* output);

/**
 * Attaches the point data array PenetrationDepth to the surface that mesh was made from. depths are
 * those of the points of mesh that are inside the other.
 */
void AddDepths(const medial::Proximity& proximity, const std::vector<medial::PointDepth>& depths,
  const medial::TriangleMesh& mesh, vtkPolyData* surface);

} // namespace vtkProximityConversion

#endif
