#include "field/engines/rasteriser/polygon_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace medial
{
namespace
{

/// Layout of Instance in rectangles.comp.
struct Instance
{
  glm::ivec4 place;
  glm::vec4 vectors[3];
  glm::vec4 sides[8];
};

constexpr GLuint kAttributes = sizeof(Instance) / sizeof(glm::vec4);
constexpr int kClipDistances = 8;
/// Rectangles that are drawn at once, so that their instances take 12 MiB.
constexpr int kRectanglesPerDraw = 65536;
constexpr int kMaxSlices = 8; ///< of a rectangle
constexpr int kIndicesPerSlice = 6;

/// The error of single precision, in local units.
constexpr float kRoundingMargin = 0.0005f;

/// Returns how far rounding to subpixels can move two edges, in pixels.
float snappingMargin()
{
  constexpr double kSubpixels = 2.05; // half of each diagonal, twice, and the rounding of positions
  GLint bits = 0;
  glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
  return static_cast<float>(kSubpixels * std::exp2(-bits));
}

/// Two triangles for the four vertices of each slice.
std::array<GLubyte, kIndicesPerSlice * kMaxSlices> indicesOfSlices()
{
  constexpr GLubyte kTriangles[kIndicesPerSlice] = { 0, 1, 2, 2, 1, 3 };
  std::array<GLubyte, kIndicesPerSlice * kMaxSlices> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    indices[i] =
      static_cast<GLubyte>(4 * (i / kIndicesPerSlice) + kTriangles[i % kIndicesPerSlice]);
  }
  return indices;
}

bool countsFragments()
{
  return epoxy_gl_version() >= 46 || epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query");
}

/// While it lives, gl_ClipDistance cuts what is drawn.
class Clipping
{
public:
  Clipping()
  {
    for (int i = 0; i < kClipDistances; ++i)
    {
      glEnable(GL_CLIP_DISTANCE0 + i);
    }
  }
  ~Clipping()
  {
    for (int i = 0; i < kClipDistances; ++i)
    {
      glDisable(GL_CLIP_DISTANCE0 + i);
    }
  }
  Clipping(const Clipping&) = delete;
  Clipping& operator=(const Clipping&) = delete;
};

} // namespace

PolygonDrawing::PolygonDrawing()
  : snappingMargin_(snappingMargin())
  , format_(gl::createVertexArray())
{
  obtainBuffer(rectangles_, kRectanglesPerDraw * sizeof(SiteRectangle));
  obtainBuffer(instances_, kRectanglesPerDraw * sizeof(Instance));
  const auto indices = indicesOfSlices();
  indices_ = gl::createStorageBuffer(sizeof(indices), indices.data());
  this->bindVertexFormat();
  if (countsFragments())
  {
    GLuint id = 0;
    glGenQueries(1, &id); // Mesa's glCreateQueries() does not know this kind
    fragmentQuery_ = gl::Query(id);
  }
}

void PolygonDrawing::bindVertexFormat()
{
  const GLuint format = format_.id();
  glVertexArrayVertexBuffer(format, 0, instances_.id(), 0, sizeof(Instance));
  glVertexArrayBindingDivisor(format, 0, 1);
  glVertexArrayElementBuffer(format, indices_.id());
  glVertexArrayAttribIFormat(format, 0, 4, GL_INT, offsetof(Instance, place));
  for (GLuint attribute = 0; attribute < kAttributes; ++attribute)
  {
    if (attribute > 0)
    {
      glVertexArrayAttribFormat(format, attribute, 4, GL_FLOAT, GL_FALSE,
        static_cast<GLuint>(attribute * sizeof(glm::vec4)));
    }
    glVertexArrayAttribBinding(format, attribute, 0);
    glEnableVertexArrayAttrib(format, attribute);
  }
}

void PolygonDrawing::draw(RectangleSource& source, const DeviceMesh& mesh, const GridFrame& frame,
  const Extent& slab, const AtlasLayout& atlas, float depthScale, Kernels& kernels)
{
  static_assert(sizeof(SiteRectangle) == 7 * sizeof(int), "rectangles.comp reads them by sevens");
  const gl::ShaderProgram& cutting = gl::cachedProgram("rectangles.comp");
  mesh.describe(cutting);
  cutting.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  cutting.set("exactFirst", frame.first);
  cutting.set("exactSpacing", frame.step);
  cutting.set("roundingMargin", kRoundingMargin);
  cutting.set("snappingMargin", snappingMargin_);
  const gl::ShaderProgram& drawing = gl::cachedProgram("polygons.vert", "polygons.frag");
  drawing.set("atlasSize", glm::vec2(atlas.size()));
  drawing.set("sliceSize", atlas.sliceSize);
  drawing.set("columns", atlas.columns);
  drawing.set("depthScale", depthScale);
  const int slices = std::min(kMaxSlices, slab.size(2));
  const Clipping clipping;
  if (fragmentQuery_)
  {
    glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS, fragmentQuery_.id());
  }
  while (const GLsizei count = source.next(rectangles_, kRectanglesPerDraw))
  {
    cutting.set("count", count);
    kernels.startItems(cutting,
      { &mesh.connectivity(), &mesh.points(), &mesh.faces(), &rectangles_, &instances_ }, count);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    drawing.use();
    glBindVertexArray(format_.id());
    glDrawElementsInstanced(GL_TRIANGLES, kIndicesPerSlice * slices, GL_UNSIGNED_BYTE, nullptr,
      count);
    // The next instances take the place of these.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  this->countFragments();
}

/// Waits for the driver's count.
void PolygonDrawing::countFragments()
{
  if (fragmentQuery_)
  {
    glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS);
    glGetQueryObjecti64v(fragmentQuery_.id(), GL_QUERY_RESULT, &fragments_);
  }
}

} // namespace medial
