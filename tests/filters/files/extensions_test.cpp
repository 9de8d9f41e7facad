#include "files/extensions.h"
#include "files/surface_reader.h"

#include "support/refusal.h"

#include "medial/error.h"
#include "medial/mesh_io.h"

#include <gtest/gtest.h>

#include <string>

namespace medial::test
{
namespace
{

using files::Extensions;

TEST(Extensions, TextsNameThemInTheirOrder)
{
  EXPECT_EQ(files::joined({ ".b", ".a" }, ", "), ".b, .a");
  EXPECT_EQ(files::enumerated({ ".b", ".c", ".a" }), ".b, .c or .a");
  EXPECT_EQ(files::enumerated({ ".b" }), ".b");
  EXPECT_TRUE(files::hasExtension("x.NII.gz", { ".nii.gz" }));
  EXPECT_FALSE(files::hasExtension("x.gz", { ".nii.gz" }));
}

// The extensions that the library names where it refuses a file.
std::string allowedByLibrary(MeshInput (*read)(const std::filesystem::path&))
{
  const std::string message = refusalOf<Error>(
    "a.none", "", [&](const std::string& file) { read(file); }, [](const Error&) {});
  return message.substr(message.find("allowed: ") + 9);
}

std::string withoutVtp(const Extensions& extensions)
{
  Extensions others;
  for (const std::string& extension : extensions)
  {
    if (extension != ".vtp")
    {
      others.push_back(extension);
    }
  }
  return files::joined(others, " ");
}

TEST(Extensions, ThoseOfMeshesAreTheLibrarysAndVtp)
{
  const std::string meshes = withoutVtp(files::surfaceExtensions());
  EXPECT_EQ(allowedByLibrary(readMesh), meshes);
  EXPECT_EQ(allowedByLibrary(readPoints),
    meshes + " " + files::joined(files::tableExtensions(), " "));
  EXPECT_TRUE(files::isSurfaceFile("a.VTP"));
}

} // namespace
} // namespace medial::test
