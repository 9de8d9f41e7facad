/**
 * What filters ask of the pipeline. Private to the module.
 */

#ifndef vtkMedialRequests_h
#define vtkMedialRequests_h

class vtkAlgorithm;
class vtkInformation;

/**
 * Lets an input port take vtkPolyData and, where it may be in pieces, all that these come as. The
 * pipeline goes through the blocks of composite input that is not asked for.
 */
void vtkAcceptSurface(vtkInformation* port, bool inPieces);

///@{
/**
 * Asks for the whole input, or for one of several pieces without ghosts, whatever is asked of the
 * filter.
 */
void vtkRequestWhole(vtkInformation* request);
void vtkRequestPiece(vtkInformation* request, int piece, int pieces);
///@}

/**
 * Brings the first input up to date, as that. Returns whether its producer could.
 */
bool vtkUpdateInput(vtkAlgorithm* algorithm, int piece, int pieces);

#endif
