/**
 * Conversion of a medial axis to the library's model of balls. Not installed: private to the module
 * and to the project's programs.
 */

#ifndef vtkMedialModelConversion_h
#define vtkMedialModelConversion_h

#include "medial/medial_model.h"

class vtkPolyData;

namespace vtkMedialModelConversion
{

/**
 * All points as balls with the point data array Radius, and the cells over them: polylines as their
 * segments, polygons of more than four corners and strips as triangles. Throws medial::Error
 * InvalidInput for an array that is missing, and as medial::checkMedialModel().
 */
medial::MedialModel ToMedialModel(vtkPolyData* axis);

} // namespace vtkMedialModelConversion

#endif
