#include "vtkMedialRequests.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

//------------------------------------------------------------------------------
void vtkAcceptSurface(vtkInformation* port, bool inPieces)
{
  vtkInformationStringVectorKey* types = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  port->Remove(types);
  port->Append(types, "vtkPolyData");
  if (inPieces)
  {
    port->Append(types, "vtkUnstructuredGrid");
    port->Append(types, "vtkCompositeDataSet");
  }
}

//------------------------------------------------------------------------------
void vtkRequestWhole(vtkInformation* request)
{
  vtkRequestPiece(request, 0, 1);
}

//------------------------------------------------------------------------------
void vtkRequestPiece(vtkInformation* request, int piece, int pieces)
{
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
bool vtkUpdateInput(vtkAlgorithm* algorithm, int piece, int pieces)
{
  int port = 0;
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(0, 0, port);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(producer->GetNumberOfOutputPorts());
  vtkRequestPiece(requests->GetInformationObject(port), piece, pieces);
  return producer->Update(port, requests) != 0;
}
