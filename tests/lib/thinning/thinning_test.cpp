#include "thinning/thinning.h"

#include "base/extents.h"
#include "thinning/curve_probe.h"
#include "thinning/solid_core.h"
#include "thinning/solid_thinning.h"
#include "thinning/solid_topology.h"
#include "thinning/sparse_voxels.h"
#include "thinning/undecided_voxels.h"

#include "support/shapes.h"
#include "support/voxel_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A grid of made-up distances around a mesh of one point, where no two directions are separated.
class Voxels
{
public:
  explicit Voxels(const std::array<int, 3>& dimensions)
    : grid_{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, dimensions }
    , mesh_(makeMesh({ { 0.0, 0.0, 0.0 } }, {}, {}, { 0 }))
    , frame_(grid_)
    , sites_(mesh_, analyseConnectivity(mesh_), frame_)
    , distance_(static_cast<std::size_t>(grid_.pointCount()), 1.0f)
    , closest_(distance_.size(), 0)
    , depth_(distance_.data(), Side::Interior, 1.0)
    , probe_(sites_, frame_, closest_.data(), depth_, 1.0)
  {
  }

  std::size_t size() const { return distance_.size(); }
  void set(std::size_t voxel, float depth) { distance_[voxel] = -depth; }
  void set(int x, int y, int z, float depth) { this->set(this->index(x, y, z), depth); }
  CubicalComplex solid() const
  {
    std::vector<std::size_t> voxels;
    const VoxelMask mask = voxelsOf(this->voxels());
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      if (mask[i] != 0)
      {
        voxels.push_back(i);
      }
    }
    return this->closed(voxels);
  }
  Extent whole() const { return grid_.wholeExtent(); }
  /// Voxels of the whole grid that are undecided in a part of it.
  std::vector<std::size_t> undecidedIn(const Extent& part, const CubicalComplex& sheets) const
  {
    const glm::ivec3 size(part.size(0), part.size(1), part.size(2));
    const glm::ivec3 first(part.min[0], part.min[1], part.min[2]);
    std::vector<float> distance;
    CubicalComplex here(part, this->dims());
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          const std::size_t at = this->index(first.x + x, first.y + y, first.z + z);
          here.insert(distance.size(), sheets.bits(at));
          distance.push_back(distance_[at]);
        }
      }
    }
    const DepthField depth(distance.data(), Side::Interior, 1.0);
    const SolidVoxels solid(depth, part, this->dims());
    std::vector<std::size_t> undecided;
    for (const std::size_t voxel : undecidedVoxels(solid, voxelsOf(solid), here, checkpoint_))
    {
      const glm::ivec3 point = here.position(8 * static_cast<CubeCell>(voxel));
      undecided.push_back(this->index(point.x, point.y, point.z));
    }
    return undecided;
  }
  /// The depths of a block of SparseVoxels.
  std::array<float, kBlockLength> depthsOf(std::size_t block) const
  {
    std::array<float, kBlockLength> depths{};
    for (std::size_t i = 0; i < kBlockLength && block * kBlockLength + i < this->size(); ++i)
    {
      depths[i] = depth_.at(block * kBlockLength + i);
    }
    return depths;
  }
  SolidVoxels voxels() const { return { depth_, grid_.wholeExtent(), this->dims() }; }
  const Checkpoint& checkpoint() const { return checkpoint_; }
  glm::ivec3 dims() const { return { this->dim(0), this->dim(1), this->dim(2) }; }
  /// The voxels of the core of the solid.
  /// @param sheets faces that stay.
  std::vector<std::size_t> core(const std::vector<Crossing>& crossings = {},
    const std::vector<CubeCell>& sheets = {}) const
  {
    return coreOf(this->voxels(), closureOf(this->dims(), sheets), crossings, checkpoint_);
  }
  CubicalComplex closed(const std::vector<std::size_t>& voxels) const
  {
    CubicalComplex complex(this->dims());
    insertVoxels(voxels, complex);
    return complex;
  }
  CellTopology topology(const std::vector<std::size_t>& voxels) const
  {
    std::vector<char> solid(this->size(), 0);
    for (const std::size_t voxel : voxels)
    {
      solid[voxel] = 1;
    }
    return voxelTopology(solid, grid_.dimensions);
  }
  CellTopology expected() const
  {
    return voxelTopology(solidVoxels(distance_, grid_.dimensions, Side::Interior),
      grid_.dimensions);
  }
  Thinning thinning(CubicalComplex& complex) const
  {
    return { complex, [this](std::size_t voxel) { return depth_.at(voxel); },
      [this, &complex](CubeCell edge) { return probe_.separates(complex, edge); }, frame_.step,
      { 1.0 }, checkpoint_ };
  }

private:
  int dim(int axis) const { return grid_.dimensions[axis]; }
  std::size_t index(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * dim(1) + y) * dim(0) + x;
  }

  Grid grid_;
  TriangleMesh mesh_;
  GridFrame frame_;
  SiteSet sites_;
  std::vector<float> distance_;
  std::vector<std::int32_t> closest_;
  DepthField depth_;
  CurveProbe probe_;
  Checkpoint checkpoint_{ Run(Execution{}), 0.0, "" };
};

int count(const CubicalComplex& complex, int dimension)
{
  int count = 0;
  for (CubeCell cell = 0; cell < 8 * static_cast<CubeCell>(complex.positions()); ++cell)
  {
    count +=
      CubicalComplex::dimension(CubicalComplex::kind(cell)) == dimension && complex.has(cell);
  }
  return count;
}

/// Some of the faces between two voxels.
/// @param share of them, in eighths.
std::vector<CubeCell> innerFaces(const CubicalComplex& solid, std::mt19937& random, unsigned share)
{
  std::vector<CubeCell> inner;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<CubeCell> faces = cellsOf(solid, kFaceKind + axis);
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(inner),
      [&](CubeCell face) { return solid.cofaceCount(face) == 2 && random() % 8 < share; });
  }
  return inner;
}

/// The faces of cells that are there are there.
void expectClosed(const CubicalComplex& complex)
{
  for (CubeCell cell = 0; cell < 8 * static_cast<CubeCell>(complex.positions()); ++cell)
  {
    if (complex.has(cell))
    {
      for (const CubeCell step : complex.faces(CubicalComplex::kind(cell)))
      {
        ASSERT_TRUE(complex.has(cell + step));
      }
    }
  }
}

/// Components, cavities and genus of cells without voxels, from the library's solid and its own
/// Euler characteristic.
MedialAxis asAxis(const CubicalComplex& complex)
{
  MedialAxis axis;
  axis.points.resize(complex.positions());
  const auto point = [](CubeCell cell)
  { return static_cast<std::int64_t>(CubicalComplex::index(cell)); };
  for (CubeCell vertex = 0; vertex < 8 * static_cast<CubeCell>(complex.positions()); vertex += 8)
  {
    if (complex.has(vertex))
    {
      axis.vertices.push_back(point(vertex));
    }
    for (int a = 0; a < 3; ++a)
    {
      const CubeCell along = 8 * complex.stride(a);
      const CubeCell u = 8 * complex.stride((a + 1) % 3);
      const CubeCell v = 8 * complex.stride((a + 2) % 3);
      if (complex.has(vertex + kEdgeKind + a))
      {
        axis.lines.push_back({ point(vertex), point(vertex + along) });
      }
      if (complex.has(vertex + kFaceKind + a))
      {
        axis.quads.push_back(
          { point(vertex), point(vertex + u), point(vertex + u + v), point(vertex + v) });
      }
    }
  }
  return axis;
}

} // namespace

TEST(CubicalComplex, KnowsFacesAndCofaces)
{
  const CubicalComplex complex({ 7, 5, 6 });
  const std::array<int, 4> faces{ 0, 2, 4, 6 };
  const std::array<int, 4> cofaces{ 6, 4, 2, 0 };
  for (int kind = 0; kind < kCubeCellKinds; ++kind)
  {
    const int dimension = CubicalComplex::dimension(kind);
    EXPECT_EQ(complex.faces(kind).count, faces[dimension]);
    EXPECT_EQ(complex.cofaces(kind).count, cofaces[dimension]);
    const CubeCell cell = complex.cell({ 3, 2, 3 }, kind);
    EXPECT_EQ(complex.position(cell), glm::ivec3(3, 2, 3));
    for (const CubeCell step : complex.faces(kind))
    {
      const CubeCell face = cell + step;
      EXPECT_EQ(CubicalComplex::dimension(CubicalComplex::kind(face)), dimension - 1);
      EXPECT_NEAR(glm::distance(complex.centre(face), complex.centre(cell)), 0.5, 1e-12);
      const CubeCellSteps& back = complex.cofaces(CubicalComplex::kind(face));
      EXPECT_NE(std::find(back.begin(), back.end(), -step), back.end());
    }
  }
}

TEST(VoxelSolid, HasTheTopologyThatCountingFinds)
{
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round)
  {
    Voxels voxels({ 9, 11, 8 });
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      voxels.set(i, random() % 40 < static_cast<unsigned>(round) ? 1.0f : -1.0f);
    }
    const CubicalComplex solid = voxels.solid();
    expectClosed(solid);
    EXPECT_EQ(topologyOf(voxels.voxels()), voxels.expected()) << "round " << round;
  }
}

// Of two slices of a grid, both are its border.
TEST(VoxelSolid, AGridOfTwoSlicesHasNone)
{
  for (int slices = 2; slices <= 4; ++slices)
  {
    const glm::ivec3 size(slices, 5, 5);
    const std::vector<float> distances(static_cast<std::size_t>(slices) * 25, -1.0f);
    const DepthField depth(distances.data(), Side::Interior, 1.0);
    std::vector<Crossing> along;
    for (int x = 0; x < slices; ++x)
    {
      along.push_back({ { x, 2, 2 }, 1, 0, 1, true });
    }
    const Extent all{ { 0, 0, 0 }, { slices - 1, 4, 4 } };
    EXPECT_EQ(crossingsWithin(depth, all, size, along).size(),
      static_cast<std::size_t>(slices - 2));
  }
}

TEST(SolidCore, HasTheTopologyOfRandomVoxels)
{
  std::mt19937 random(3);
  for (int round = 0; round < 120; ++round)
  {
    Voxels voxels({ 10, 9, 11 });
    // Many voxels have equal depths in every second round.
    const unsigned depths = round % 2 == 0 ? 100 : 3;
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const float depth = 0.1f + static_cast<float>(random() % depths) * 0.05f;
      voxels.set(i, random() % 60 < static_cast<unsigned>(round) / 2 ? depth : -depth);
    }
    std::vector<Crossing> crossings;
    for (int i = 0; i < round % 5; ++i)
    {
      const glm::ivec3 voxel(random() % 8 + 1, random() % 7 + 1, random() % 9 + 1);
      crossings.push_back({ voxel, static_cast<int>(random() % 3), -1, -1, true });
    }
    const std::vector<std::size_t> core = voxels.core(crossings);
    const CubicalComplex complex = voxels.closed(core);
    const CubicalComplex solid = voxels.solid();
    EXPECT_EQ(voxels.topology(core), voxels.expected()) << "round " << round;
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      EXPECT_EQ(complex.bits(i) & ~solid.bits(i), 0) << "round " << round;
    }
    for (const Crossing& crossing : crossings)
    {
      const CubeCell end = solid.cell(crossing.voxel, kVoxelKind);
      EXPECT_EQ(complex.has(end), solid.has(end)) << "round " << round;
      const CubeCell other = end + 8 * solid.stride(crossing.axis);
      EXPECT_EQ(complex.has(other), solid.has(other)) << "round " << round;
    }
  }
}

TEST(SolidCore, WithSheetsHasTheTopologyOfRandomVoxels)
{
  std::mt19937 random(4);
  for (int round = 0; round < 120; ++round)
  {
    Voxels voxels({ 10, 9, 11 });
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const float depth = 0.1f + static_cast<float>(random() % 20) * 0.05f;
      voxels.set(i, random() % 60 < static_cast<unsigned>(round) / 2 ? depth : -depth);
    }
    const CubicalComplex solid = voxels.solid();
    const std::vector<CubeCell> sheets =
      innerFaces(solid, random, static_cast<unsigned>(round % 8));
    const std::vector<std::size_t> core = voxels.core({}, sheets);
    CubicalComplex complex = voxels.closed(core);
    complex.insert(closureOf(solid.size(), sheets));
    expectClosed(complex);
    voxels.thinning(complex).burn();
    EXPECT_EQ(topologyOf(asAxis(complex)), voxels.expected()) << "round " << round;
  }
}

/// Parts of the grid find out what is undecided, and the rest looks at few voxels.
TEST(SolidCore, FoundInPartsIsThatOfTheWhole)
{
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round)
  {
    // Rows that are longer than a block, and shorter ones.
    Voxels voxels(
      round % 2 == 0 ? std::array<int, 3>{ 70, 9, 8 } : std::array<int, 3>{ 13, 14, 15 });
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const float depth = 0.1f + static_cast<float>(random() % 20) * 0.05f;
      voxels.set(i, random() % 60 < static_cast<unsigned>(round) ? depth : -depth);
    }
    const CubicalComplex solid = voxels.solid();
    const std::vector<CubeCell> faces = innerFaces(solid, random, static_cast<unsigned>(round % 4));
    std::vector<Crossing> crossings;
    for (int i = 0; i < round % 5; ++i)
    {
      const glm::ivec3 voxel(random() % 11 + 1, random() % 7 + 1, random() % 6 + 1);
      crossings.push_back({ voxel, static_cast<int>(random() % 3), -1, -1, true });
    }
    const CubicalComplex sheets = closureOf(voxels.dims(), faces);
    std::vector<std::size_t> undecided;
    visitParts(voxels.whole(), 5,
      [&](const Extent& part)
      {
        const Extent around = grown(part, 1, voxels.whole());
        for (const std::size_t voxel : voxels.undecidedIn(around, sheets))
        {
          if (hasPoint(part, solid.position(8 * static_cast<CubeCell>(voxel))))
          {
            undecided.push_back(voxel);
          }
        }
      });
    std::sort(undecided.begin(), undecided.end());
    std::size_t loaded = 0;
    SparseVoxels sparse(voxels.dims(),
      [&](const std::vector<std::size_t>& blocks)
      {
        loaded += blocks.size();
        for (const std::size_t block : blocks)
        {
          sparse.set(block, voxels.depthsOf(block));
        }
      });
    EXPECT_EQ(coreOf(sparse, sheets, crossings, undecided, voxels.checkpoint()),
      coreOf(voxels.voxels(), sheets, crossings, voxels.checkpoint()))
      << "round " << round;
    EXPECT_LE(loaded, blocksFor(voxels.size()));
  }
}

TEST(SparseVoxels, LoadsNothingTwiceAndNothingFarAway)
{
  const glm::ivec3 size(100, 50, 40);
  std::vector<std::size_t> loaded;
  SparseVoxels voxels(size,
    [&](const std::vector<std::size_t>& blocks)
    {
      loaded.insert(loaded.end(), blocks.begin(), blocks.end());
      for (const std::size_t block : blocks)
      {
        std::array<float, kBlockLength> depths{};
        depths.fill(0.5f);
        voxels.set(block, depths);
      }
    });
  const auto index = [&](int x, int y, int z)
  { return static_cast<std::size_t>((z * size.y + y) * size.x + x); };
  EXPECT_EQ(voxels.value(index(50, 25, 20)), 1);
  EXPECT_EQ(voxels.at(index(50, 25, 20)), 0.5f);
  const std::size_t few = loaded.size();
  EXPECT_LT(few, blocksFor(static_cast<std::size_t>(size.x) * size.y * size.z) / 2);
  EXPECT_EQ(voxels.value(index(51, 26, 19)), 1);
  EXPECT_EQ(loaded.size(), few);
  // On the border of the grid there are no voxels.
  EXPECT_EQ(voxels.value(index(0, 25, 20)), 0);
  EXPECT_EQ(voxels.value(index(99, 25, 20)), 0);
  EXPECT_EQ(voxels.value(index(50, 0, 0)), 0);
  EXPECT_EQ(voxels.value(index(50, 49, 39)), 0);
  voxels.setValue(index(50, 25, 20), 4);
  EXPECT_EQ(voxels.atLeast(4), std::vector<std::size_t>{ index(50, 25, 20) });
  std::sort(loaded.begin(), loaded.end());
  EXPECT_EQ(std::adjacent_find(loaded.begin(), loaded.end()), loaded.end());
}

TEST(SolidCore, HasNoneOfThePlainVoxelsAtASheet)
{
  // A plate whose middle is a sheet: what is left is at the rim at most.
  Voxels voxels({ 16, 16, 10 });
  std::vector<CubeCell> sheet;
  const CubicalComplex empty({ 16, 16, 10 });
  for (int z = 1; z < 9; ++z)
  {
    for (int y = 1; y < 15; ++y)
    {
      for (int x = 1; x < 15; ++x)
      {
        voxels.set(x, y, z, 4.0f - std::abs(static_cast<float>(z) - 4.5f));
        if (z == 5)
        {
          sheet.push_back(empty.cell({ x, y, z }, kFaceKind + 2));
        }
      }
    }
  }
  const std::vector<std::size_t> core = voxels.core({}, sheet);
  EXPECT_TRUE(core.empty());
}

TEST(SolidCore, OfABallIsSmall)
{
  Voxels voxels({ 21, 21, 21 });
  for (int z = 0; z < 21; ++z)
  {
    for (int y = 0; y < 21; ++y)
    {
      for (int x = 0; x < 21; ++x)
      {
        const glm::dvec3 offset(x - 10.2, y - 9.9, z - 10.1);
        voxels.set(x, y, z, static_cast<float>(8.3 - glm::length(offset)));
      }
    }
  }
  const std::vector<std::size_t> core = voxels.core();
  // Besides the deepest voxel, single ones where the ball is outermost and their ways there.
  EXPECT_LT(core.size(), 80u);
  EXPECT_TRUE(
    std::binary_search(core.begin(), core.end(), std::size_t{ (10 * 21 + 10) * 21 + 10 }));
}

TEST(SolidCore, HasWiresThatAreOneVoxelThick)
{
  Voxels voxels({ 12, 5, 5 });
  for (int x = 2; x < 10; ++x)
  {
    voxels.set(x, 2, 2, 0.4f + 0.01f * static_cast<float>(x));
  }
  const std::vector<std::size_t> core = voxels.core();
  EXPECT_EQ(core.size(), 8u);
}

TEST(Thinning, KeepsTheTopologyOfRandomVoxelsWhateverIsAnchored)
{
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round)
  {
    Voxels voxels({ 10, 9, 11 });
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const float depth = 0.1f + static_cast<float>(random() % 100) * 0.05f;
      voxels.set(i, random() % 60 < static_cast<unsigned>(round) ? depth : -depth);
    }
    CubicalComplex complex = voxels.solid();
    Thinning thinning = voxels.thinning(complex);
    std::vector<CubeCell> anchored;
    std::map<CubeCell, float> angles;
    for (CubeCell cell = 0; cell < 8 * static_cast<CubeCell>(complex.positions()); ++cell)
    {
      const bool isFace = CubicalComplex::dimension(CubicalComplex::kind(cell)) == 2;
      if (isFace && complex.has(cell) && random() % 4 == 0)
      {
        anchored.push_back(cell);
        angles[cell] = static_cast<float>(random() % 180);
      }
    }
    thinning.anchor(anchored, [&](CubeCell face) { return angles.at(face); });
    thinning.burn();
    EXPECT_EQ(count(complex, 3), 0);
    expectClosed(complex);
    EXPECT_EQ(topologyOf(asAxis(complex)), voxels.expected()) << "round " << round;
    thinning.release(anchored);
    expectClosed(complex);
    EXPECT_EQ(topologyOf(asAxis(complex)), voxels.expected()) << "round " << round;
  }
}

TEST(Thinning, LeavesAPointOfABlock)
{
  Voxels voxels({ 9, 9, 9 });
  for (int i = 0; i < 125; ++i)
  {
    const glm::ivec3 p(2 + i % 5, 2 + i / 5 % 5, 2 + i / 25);
    const glm::ivec3 from = glm::abs(p - 4);
    voxels.set(p.x, p.y, p.z, 2.5f - static_cast<float>(std::max({ from.x, from.y, from.z })));
  }
  CubicalComplex complex = voxels.solid();
  voxels.thinning(complex).burn();
  EXPECT_EQ(count(complex, 2), 0);
  EXPECT_EQ(count(complex, 1), 0);
  ASSERT_EQ(count(complex, 0), 1);
  for (CubeCell vertex = 0; vertex < 8 * static_cast<CubeCell>(complex.positions()); vertex += 8)
  {
    if (complex.has(vertex))
    {
      EXPECT_LE(glm::distance(complex.centre(vertex), glm::dvec3(4.0)), 1.0);
    }
  }
}

TEST(Thinning, StopsAtAnchoredFacesAndOpensTheOneOfLeastAngle)
{
  Voxels voxels({ 9, 9, 9 });
  for (int i = 0; i < 27; ++i)
  {
    voxels.set(3 + i % 3, 3 + i / 3 % 3, 3 + i / 9, i == 13 ? 2.0f : 1.0f);
  }
  CubicalComplex complex = voxels.solid();
  Thinning thinning = voxels.thinning(complex);
  const CubeCell voxel = complex.cell({ 4, 4, 4 }, kVoxelKind);
  std::vector<CubeCell> walls;
  for (const CubeCell step : complex.faces(kVoxelKind))
  {
    walls.push_back(voxel + step);
  }
  thinning.anchor(walls,
    [&](CubeCell face) { return face == walls[3] ? 50.0f : 100.0f + (face & 7); });
  thinning.burn();
  EXPECT_FALSE(complex.has(voxel));
  for (std::size_t i = 0; i < walls.size(); ++i)
  {
    EXPECT_EQ(complex.has(walls[i]), i != 3) << i;
  }
  EXPECT_EQ(count(complex, 2), 5);
  EXPECT_EQ(topologyOf(asAxis(complex)), (CellTopology{ 1, 1, 0, 0 }));
}
