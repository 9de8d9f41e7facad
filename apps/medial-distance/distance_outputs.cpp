#include "distance_outputs.h"

#include "distance_picture.h"
#include "distance_report.h"
#include "input/input_file.h"
#include "number_text.h"
#include "output/csv_line.h"
#include "output/file_writer.h"
#include "output/vtp_writer.h"

#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <ostream>
#include <string>

namespace medial::app
{
namespace
{

namespace fs = std::filesystem;

constexpr int kDigits = 4; // of numbers in a picture

void writeCsv(const DistanceResults& results, std::ostream& stream)
{
  stream << "x,y,z,distance,closest_x,closest_y,closest_z,cell,feature,direction_x,direction_y,"
            "direction_z\n";
  const PointDistances& found = results.distances;
  for (std::size_t i = 0; i < results.points.size(); ++i)
  {
    CsvLine line;
    line << results.points[i] << found.distance[i] << found.closestPoint[i] << found.closestCell[i]
         << static_cast<int>(found.closestFeature[i]) << found.direction[i];
    stream << line.end();
  }
}

vtkSmartPointer<vtkPolyData> withDistances(DistanceResults& results)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(results.pointSet.polyData());
  if (data->GetNumberOfCells() == 0)
  {
    // Points that no cell shows are invisible.
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      vertices->InsertNextCell(1, &i);
    }
    data->SetVerts(vertices);
  }
  vtkMeshConversion::AddDistances(results.distances, data);
  return data;
}

void writePicture(const DistanceCommand& command, DistanceResults& results, const fs::path& file)
{
  const DistanceSummary summary = summarise(results.distances);
  drawDeviation(withDistances(results), results.mesh.polyData(),
    { command.points.filename().string(),
      "distance from " + command.mesh.filename().string() + ": mean " +
        roundedText(summary.mean, kDigits) + ", RMS " + roundedText(summary.rms, kDigits) },
    file);
}

} // namespace

DistanceOutputs::DistanceOutputs(const DistanceCommand& command)
  : command_(command)
{
  files_.add(command.output);
  files_.add(command.image);
  files_.add(command.json);
}

void DistanceOutputs::write(DistanceResults& results)
{
  files_.write(command_.output,
    [&](const fs::path& file)
    {
      if (extensionOf(command_.output) == ".csv")
      {
        writeFile(file, [&](std::ostream& stream) { writeCsv(results, stream); });
      }
      else
      {
        writeVtp(withDistances(results), file);
      }
    });
  files_.write(command_.image,
    [&](const fs::path& file) { writePicture(command_, results, file); });
  files_.write(command_.json,
    [&](const fs::path& file) { writeFile(file, makeJson(command_, results)); });
  files_.commit();
}

} // namespace medial::app
