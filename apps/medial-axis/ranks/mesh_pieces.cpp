#include "ranks/mesh_pieces.h"

#include "files/xml_elements.h"
#include "input/input_file.h"
#include "input/vtp_file.h"
#include "library_calls.h"
#include "ranks/rank_agreement.h"

#include "vtkMedialRanks.h"
#include "vtkSurfacePiece.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <cstddef>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

/// Returns the files of the pieces.
/// @throws Error InvalidInput, without the name of the index.
std::vector<fs::path> filesOf(const std::string& content, const fs::path& folder)
{
  const std::vector<files::XmlElement> elements = files::scanXml(content, "AppendedData");
  const files::XmlElement* const data = files::childOf(elements, elements.front(), "PPolyData");
  if (elements.front().name != "VTKFile" || data == nullptr)
  {
    refuseContent("not an index of polygonal data: it has no element VTKFile with PPolyData in it");
  }
  std::vector<fs::path> files;
  for (const std::size_t child : data->children)
  {
    if (elements[child].name == "Piece")
    {
      const std::string source = elements[child].attribute("Source", "");
      if (source.empty())
      {
        refuseContent("a Piece has no Source");
      }
      files.push_back(folder / source);
    }
  }
  return files;
}

} // namespace

bool isInPieces(const fs::path& path)
{
  return extensionOf(path) == ".pvtp";
}

std::vector<fs::path> filesOfPieces(const fs::path& path)
{
  if (!isInPieces(path))
  {
    return {};
  }
  try
  {
    return filesOf(files::readContent(path), path.parent_path());
  }
  catch (const Error&)
  {
    return {};
  }
}

MeshPiece readMeshPiece(const fs::path& index, Communicator& communicator)
{
  vtkSurfacePiece own;
  withSharedFailures(communicator,
    [&]
    {
      const std::string content = readContent(index);
      std::vector<fs::path> files;
      withFailures(index, [&] { files = filesOf(content, index.parent_path()); });
      vtkNew<vtkMultiBlockDataSet> blocks;
      // One run of files for each rank: cells are numbered rank after rank, and so file after file.
      const auto firstOf = [&](int rank)
      {
        return files.size() * static_cast<std::size_t>(rank) /
          static_cast<std::size_t>(communicator.size());
      };
      for (std::size_t i = firstOf(communicator.rank()); i < firstOf(communicator.rank() + 1); ++i)
      {
        blocks->SetBlock(blocks->GetNumberOfBlocks(), readVtp(files[i]));
      }
      withFailures(index, [&] { own = vtkSurfacePiece(blocks); });
    });
  MeshPiece result;
  withFailures(index,
    [&]
    {
      agree(communicator,
        [&]
        {
          const std::vector<vtkPieceFacts> facts = gatheredValues(communicator, own.Facts());
          result.bounds = vtkMedialRanks::BoundsOf(facts);
          result.piece = own.Numbered(communicator, facts);
        });
    });
  return result;
}

} // namespace medial::app
