// The reader of VTK's XML format agrees with VTK's own on whole files, and refuses damaged ones
// before it allocates what they ask for.
#include "files/vtp_reader.h"

#include "support/files.h"
#include "support/refusal.h"
#include "support/sanitizers.h"

#include "medial/error.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

using files::readVtp;
using Mesh = vtkSmartPointer<vtkPolyData>;

/// Cells of all four kinds, arrays of several types, and enough points for two compressed blocks.
Mesh sample(vtkIdType points = 5000)
{
  auto mesh = Mesh::New();
  vtkNew<vtkPoints> positions;
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  for (vtkIdType i = 0; i < points; ++i)
  {
    const auto x = static_cast<double>(i);
    positions->InsertNextPoint(x, 0.5 * x, 1.0 / (x + 1.0));
    heat->InsertNextValue(0.1 * x);
  }
  mesh->SetPoints(positions);
  mesh->AllocateEstimate(10, 10);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4 };
  for (const int type : { VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON, VTK_TRIANGLE_STRIP })
  {
    mesh->InsertNextCell(type, 5, ids);
  }
  mesh->InsertNextCell(VTK_TRIANGLE, 3, ids);
  mesh->GetPointData()->SetScalars(heat);
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> run;
  run->SetName("Run");
  run->InsertNextValue(-7);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    colour->InsertNextTuple3(static_cast<double>(i), 100.0, 255.0);
  }
  mesh->GetCellData()->AddArray(colour);
  mesh->GetFieldData()->AddArray(run);
  return mesh;
}

using Spoil = std::function<void(vtkXMLPolyDataWriter*)>;

std::string written(vtkPolyData* mesh, const Spoil& with)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  with(writer);
  writer->Write();
  return writer->GetOutputString();
}

// A file that can be edited by hand.
std::string text(vtkPolyData* mesh)
{
  return written(mesh, [](vtkXMLPolyDataWriter* writer) { writer->SetDataModeToAscii(); });
}

std::string compressed(vtkPolyData* mesh)
{
  return written(mesh,
    [](vtkXMLPolyDataWriter* writer)
    {
      writer->SetDataModeToBinary();
      writer->SetCompressorTypeToZLib();
    });
}

void expectSameArray(vtkDataArray* read, vtkDataArray* expected)
{
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->GetDataType(), expected->GetDataType());
  ASSERT_EQ(read->GetNumberOfTuples(), expected->GetNumberOfTuples());
  ASSERT_EQ(read->GetNumberOfComponents(), expected->GetNumberOfComponents());
  for (vtkIdType i = 0; i < read->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < read->GetNumberOfComponents(); ++component)
    {
      ASSERT_EQ(read->GetComponent(i, component), expected->GetComponent(i, component)) << i;
    }
  }
}

void expectSameFields(vtkFieldData* read, vtkFieldData* expected)
{
  ASSERT_EQ(read->GetNumberOfArrays(), expected->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    SCOPED_TRACE(expected->GetArrayName(i));
    expectSameArray(read->GetArray(expected->GetArrayName(i)), expected->GetArray(i));
  }
}

void expectSameCells(vtkCellArray* read, vtkCellArray* expected)
{
  expectSameArray(read->GetOffsetsArray(), expected->GetOffsetsArray());
  expectSameArray(read->GetConnectivityArray(), expected->GetConnectivityArray());
}

void expectSame(vtkPolyData* read, vtkPolyData* expected)
{
  expectSameArray(read->GetPoints()->GetData(), expected->GetPoints()->GetData());
  expectSameCells(read->GetVerts(), expected->GetVerts());
  expectSameCells(read->GetLines(), expected->GetLines());
  expectSameCells(read->GetPolys(), expected->GetPolys());
  expectSameCells(read->GetStrips(), expected->GetStrips());
  expectSameFields(read->GetPointData(), expected->GetPointData());
  expectSameFields(read->GetCellData(), expected->GetCellData());
  expectSameFields(read->GetFieldData(), expected->GetFieldData());
  ASSERT_NE(read->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(read->GetPointData()->GetScalars()->GetName(),
    expected->GetPointData()->GetScalars()->GetName());
}

void expectReadAsByVtk(const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file("a.vtp"), content);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("a.vtp").c_str());
  reader->Update();
  expectSame(readVtp(folder.file("a.vtp")), reader->GetOutput());
}

TEST(VtpReader, ReadsEveryEncodingAsVtkDoes)
{
  const Mesh mesh = sample();
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    for (const int compressor :
      { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
    {
      for (const bool plain : { false, true })
      {
        SCOPED_TRACE(
          std::to_string(mode) + " " + std::to_string(compressor) + (plain ? " plain" : ""));
        expectReadAsByVtk(written(mesh,
          [&](vtkXMLPolyDataWriter* writer)
          {
            writer->SetDataMode(mode);
            writer->SetCompressorType(compressor);
            writer->SetEncodeAppendedData(plain ? 0 : 1);
            writer->SetHeaderType(plain ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
            writer->SetByteOrder(plain ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
          }));
      }
    }
  }
}

TEST(VtpReader, ReadsSeveralPiecesAsVtkDoes)
{
  const Mesh mesh = sample(30);
  mesh->GetStrips()->Initialize(); // of several pieces, VTK orders them differently
  mesh->DeleteCells();
  mesh->GetCellData()->GetArray("Colour")->RemoveLastTuple();
  expectReadAsByVtk(written(mesh,
    [](vtkXMLPolyDataWriter* writer)
    {
      writer->SetDataModeToAscii();
      writer->SetNumberOfPieces(2);
    }));
}

std::string refusal(const std::string& content)
{
  return refusalOf<Error>(
    "a.vtp", content, [](const std::string& file) { readVtp(file); },
    [](const Error& error) { EXPECT_EQ(error.code(), ErrorCode::InvalidInput); });
}

// The message after the first `from` behind `start` has become `to`.
std::string refusalWith(std::string content, const std::string& start, const std::string& from,
  const std::string& to)
{
  const std::size_t place = content.find(from, content.find(start));
  EXPECT_NE(place, std::string::npos) << from;
  return refusal(content.replace(place, from.size(), to));
}

TEST(VtpReader, ComparesCountsWithTheNumbersThatAreThere)
{
  const Mesh mesh = sample(40);
  EXPECT_EQ(refusalWith(text(mesh), "", "NumberOfPoints=\"40", "NumberOfPoints=\"4000000000"),
    "a.vtp: array 'Points' has 120 numbers, which are not 4000000000 x 3");
  EXPECT_EQ(refusalWith(text(mesh), "", "NumberOfPoints=\"40", "NumberOfPoints=\"-40"),
    "a.vtp: NumberOfPoints is '-40', which is not a count");
  EXPECT_EQ(refusalWith(text(mesh), "", "NumberOfPolys=\"2", "NumberOfPolys=\"2000000000"),
    "a.vtp: NumberOfPolys is 2000000000, but there are 2 offsets");
  EXPECT_EQ(
    refusalWith(text(mesh), "<Points", "NumberOfComponents=\"3", "NumberOfComponents=\"4000000000"),
    "a.vtp: array 'Points' has NumberOfComponents '4000000000', allowed: 0 to 65536");
  EXPECT_EQ(
    refusalWith(text(mesh), "<FieldData", "NumberOfTuples=\"1", "NumberOfTuples=\"1000000000000"),
    "a.vtp: array 'Run' has 1 numbers, which are not 1000000000000 x 1");
}

TEST(VtpReader, ComparesOffsetsWithThePointIds)
{
  const std::string whole = text(sample(40));
  const std::string before = whole.substr(0, whole.find("Name=\"offsets\"", whole.find("<Polys")));
  EXPECT_EQ(refusalWith(whole, before.substr(before.size() - 30), "5 8", "5 8000000000"),
    "a.vtp: Polys: the last offset is 8000000000, but there are 8 point ids");
  EXPECT_EQ(refusalWith(whole, before.substr(before.size() - 30), "5 8", "9 8"),
    "a.vtp: Polys: the offset 8 comes after 9");
  EXPECT_EQ(refusalWith(whole, "<Polys", "0 1 2 3 4", "0 1 2 3 -4"),
    "a.vtp: point index -4 is outside [0, 39]");
}

std::string base64Words(const std::vector<std::uint32_t>& words)
{
  static const char* const kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes(reinterpret_cast<const char*>(words.data()), 4 * words.size());
  std::string result;
  std::uint32_t bits = 0;
  int known = 0;
  bytes.append((3 - bytes.size() % 3) % 3, '\0');
  for (const char byte : bytes)
  {
    bits = bits << 8 | static_cast<unsigned char>(byte);
    for (known += 8; known >= 6; known -= 6)
    {
      result += kDigits[bits >> (known - 6) & 63];
    }
  }
  return result;
}

// A file whose points begin with the given words, compressed or not.
std::string withHeader(const std::vector<std::uint32_t>& words, const std::string& compressor)
{
  return "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"" + compressor +
    "><PolyData><Piece NumberOfPoints=\"1\" NumberOfVerts=\"0\"><Points>"
    "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"binary\">" +
    base64Words(words) + "</DataArray></Points></Piece></PolyData></VTKFile>";
}

TEST(VtpReader, ComparesHeadersOfArraysWithTheBytesThatAreThere)
{
  const std::string zlib = " compressor=\"vtkZLibDataCompressor\"";
  for (const auto& words : std::vector<std::vector<std::uint32_t>>{ { 0xFFFFFFFF, 1, 1, 1 },
         { 1, 0xFFFFFFFF, 0, 4, 5 }, { 1, 12, 0xFFFFFFFF, 4, 5 }, { 1, 12, 0, 0xFFFFFFFF, 5 },
         { 200, 0xFFFFFFFF, 0, 0, 0 }, { 0, 1, 1 }, { 1, 12, 0, 4, 5 } })
  {
    EXPECT_NE(refusal(withHeader(words, zlib)), "") << words[0];
  }
  EXPECT_NE(refusal(withHeader({ 0xFFFFFFFF, 0, 0, 0 }, "")).find("4294967295 bytes"),
    std::string::npos);
  EXPECT_EQ(refusal(withHeader({ 1, 12, 0, 0 }, " compressor=\"no&#10;ne\""))
              .find("a.vtp: unknown compressor"),
    0U);
}

TEST(VtpReader, ArraysHaveAFormat)
{
  const std::string whole = withHeader({ 12, 0, 0, 0 }, "");
  EXPECT_EQ(refusalWith(whole, "<DataArray", " format=\"binary\"", ""),
    "a.vtp: array 'Points' has the format '', allowed: ascii binary appended");
}

std::int64_t maxMemoryKiB()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// VTK's reader takes up to 20 GB and 50 s for such files.
TEST(VtpReader, DamagedFilesTakeLittleMemory)
{
  const std::string whole = compressed(sample(500));
  const TemporaryFolder folder;
  const std::int64_t before = maxMemoryKiB();
  int refused = 0;
  for (std::size_t place = 0; place < whole.size(); place += 1 + whole.size() / 300)
  {
    for (const char byte : { '9', 'A', '/', '\0' })
    {
      std::string damaged = whole;
      damaged[place] = byte;
      writeFile(folder.file("a.vtp"), damaged);
      try
      {
        readVtp(folder.file("a.vtp"));
      }
      catch (const Error& error)
      {
        ++refused;
        EXPECT_EQ(error.code(), ErrorCode::InvalidInput) << error.what();
        EXPECT_TRUE(contains(error.what(), folder.file("a.vtp"))) << error.what();
      }
    }
  }
  EXPECT_GT(refused, 600);
  // AddressSanitizer's quarantine
  constexpr std::int64_t kFreedButKept = kUnderAddressSanitizer ? 256 * 1024 : 0;
  EXPECT_LT(maxMemoryKiB() - before, kFreedButKept + 100 * 1024);
}

TEST(VtpReader, ArraysShareNoBytes)
{
  const std::string whole =
    written(sample(4000), [](vtkXMLPolyDataWriter* writer) { writer->SetCompressorTypeToNone(); });
  const std::size_t array = whole.find("<DataArray", whole.find("<PointData"));
  const std::string element = whole.substr(array, whole.find('>', array) + 1 - array);
  std::string many = whole;
  for (int i = 0; i < 20; ++i)
  {
    many.insert(array, element);
  }
  EXPECT_NE(refusal(many).find("ends early or is damaged"), std::string::npos);
}

// 190 KB that become 80 MB.
TEST(VtpReader, SmallFilesDoNotBecomeLarge)
{
  const Mesh mesh = sample(40);
  vtkNew<vtkUnsignedCharArray> zeros;
  zeros->SetName("Zeros");
  zeros->SetNumberOfValues(80'000'000);
  zeros->Fill(0.0);
  mesh->GetFieldData()->AddArray(zeros);
  const std::string bomb = compressed(mesh);
  EXPECT_LT(bomb.size(), 250'000U);
  EXPECT_EQ(refusal(bomb),
    "a.vtp: its arrays become more than 64 MiB and 64 times as large as the file");
}

TEST(VtpReader, RefusesWhatIsNoXmlOfMeshes)
{
  for (const char* content :
    { "", "<", "<a", "<a/", "<a b>", "<a b=c/>", "<a b='c", "<a></b>", "<a><b></a>", "</a>",
      "<a/><b/>", "<?xml", "<!-- ", "<!a", "<VTKFile/>", "<VTKFile><PolyData></PolyData>",
      "<VTKFile><AppendedData>_abc", "<VTKFile><AppendedData></AppendedData></VTKFile>" })
  {
    EXPECT_NE(refusal(content), "") << content;
  }
  EXPECT_EQ(refusal("<VTKFile><\x1b[31m\n>"),
    "a.vtp: not a complete XML file: its element '?[31m' has no end");
}

TEST(VtpReader, DeeplyNestedElementsAreNoProblem)
{
  std::string deep;
  for (int i = 0; i < 100000; ++i)
  {
    deep += "<a>";
  }
  EXPECT_NE(refusal(deep).find("has no end"), std::string::npos);
}

} // namespace
} // namespace medial::test
