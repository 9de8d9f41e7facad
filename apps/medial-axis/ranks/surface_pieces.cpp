#include "ranks/surface_pieces.h"

#include "files/xml_elements.h"
#include "output/file_writer.h"
#include "output/output_names.h"
#include "output/vtp_writer.h"
#include "volumes/field_layout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <string>

namespace medial::app
{
namespace
{

/// The type of an array's values as XML files of VTK name it.
std::string typeOf(vtkDataArray* array)
{
  const bool isFloat = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const bool isUnsigned = array->GetDataType() == VTK_UNSIGNED_CHAR;
  return (isFloat         ? "Float"
             : isUnsigned ? "UInt"
                          : "Int") +
    std::to_string(8 * array->GetDataTypeSize());
}

std::string elementOf(vtkDataArray* array)
{
  return "      <PDataArray type=\"" + typeOf(array) + "\" Name=\"" + array->GetName() +
    "\" NumberOfComponents=\"" + std::to_string(array->GetNumberOfComponents()) + "\"/>\n";
}

std::string elementsOf(vtkDataSetAttributes* attributes)
{
  std::string text;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    text += elementOf(attributes->GetArray(i));
  }
  return text;
}

/// The text of a .pvtp file.
/// @param piece one of the pieces; all have the same arrays.
std::string indexOf(vtkPolyData* piece, const std::vector<std::string>& sources)
{
  std::string text = fileElement("PPolyData") +
    "  <PPolyData GhostLevel=\"0\">\n"
    "    <PPointData Scalars=\"" +
    piece->GetPointData()->GetScalars()->GetName() + "\" GlobalIds=\"vtkGlobalPointIds\">\n" +
    elementsOf(piece->GetPointData()) +
    "    </PPointData>\n    <PCellData GlobalIds=\"vtkGlobalCellIds\">\n" +
    elementsOf(piece->GetCellData()) +
    "    </PCellData>\n    <PPoints>\n"
    "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
    "    </PPoints>\n";
  for (const std::string& source : sources)
  {
    text += "    <Piece Source=\"" + files::escapedXml(source) + "\"/>\n";
  }
  return text + "  </PPolyData>\n</VTKFile>\n";
}

} // namespace

SurfacePieces::SurfacePieces(const std::filesystem::path& path)
  : path_(path)
{
  const OutputFile check(path);
}

void SurfacePieces::write(vtkPolyData* piece, const std::vector<std::int64_t>& cells,
  std::size_t rank)
{
  if (cells[rank] > 0)
  {
    piece_.emplace(pieceOf(path_, rank));
    namingFile(piece_->path(), [&] { writeVtp(piece, piece_->open()); });
  }
  if (rank == 0)
  {
    std::vector<std::string> sources;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (cells[i] > 0)
      {
        sources.push_back(pieceOf(path_, i).filename().string());
      }
    }
    index_.emplace(path_);
    namingFile(path_, [&] { writeFile(index_->open(), indexOf(piece, sources)); });
  }
}

void SurfacePieces::commitPiece()
{
  if (piece_)
  {
    piece_->commit();
  }
}

void SurfacePieces::commitIndex()
{
  if (index_)
  {
    index_->commit();
  }
}

} // namespace medial::app
