#include "pieces.h"
#include "simulated_ranks.h"

#include "medial/error.h"
#include "medial/ranks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

// What ranks do together where some of them fail.

namespace medial::test
{
namespace
{

constexpr int kRanks = 3;

/// Returns the messages of what ranks throw that fail in some way.
template <typename Exception>
std::vector<std::string> endings(const std::function<void(int rank)>& fail)
{
  std::vector<std::string> messages(kRanks);
  SimulatedRanks(kRanks).run(
    [&](Communicator& communicator)
    {
      try
      {
        agree(communicator,
          [&]
          {
            gathered(communicator, { 'a' });
            fail(communicator.rank());
            gathered(communicator, { 'b' }); // the others wait here
          });
      }
      catch (const Exception& error)
      {
        messages[communicator.rank()] = error.what();
      }
    });
  return messages;
}

std::vector<std::string> onAll(const std::string& message)
{
  return std::vector<std::string>(kRanks, message);
}

TEST(Agreement, TellsAllRanksOfAnError)
{
  const auto fail = [](int rank)
  {
    if (rank == 1)
    {
      throw Error(ErrorCode::CannotRead, "cannot read");
    }
  };
  EXPECT_EQ(endings<Error>(fail), onAll("rank 1: cannot read"));
}

TEST(Agreement, NamesNoRankWhereAllFailAlike)
{
  const auto fail = [](int) { throw Error(ErrorCode::InvalidInput, "bad"); };
  EXPECT_EQ(endings<Error>(fail), onAll("bad"));
}

TEST(Agreement, TellsAllRanksOfAnyException)
{
  const auto memory = [](int rank) { rank == 2 ? throw std::bad_alloc() : void(); };
  EXPECT_EQ(endings<Error>(memory), onAll("rank 2: the memory does not suffice"));
  const auto fault = [](int rank) { rank == 0 ? throw std::logic_error("a fault") : void(); };
  EXPECT_EQ(endings<RankFault>(fault), onAll("rank 0: a fault"));
  const auto unknown = [](int rank) { rank == 1 ? throw 5 : void(); };
  EXPECT_EQ(endings<RankFault>(unknown), onAll("rank 1: an exception of an unknown type"));
}

TEST(Agreement, GathersWhatRanksPassOn)
{
  SimulatedRanks(kRanks).run(
    [&](Communicator& communicator)
    {
      const auto rank = static_cast<std::size_t>(communicator.rank());
      EXPECT_EQ(gathered(communicator, Communicator::Message(rank, 'x')),
        (std::vector<Communicator::Message>{ {}, { 'x' }, { 'x', 'x' } }));
    });
}

TEST(Copies, StayWhereTheyAreFirst)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  // Each rank has the triangles of the ones before, too, turned round within themselves, and some
  // of its own twice; one has none.
  std::vector<TriangleMesh> kept(kRanks + 1);
  SimulatedRanks(kRanks + 1)
    .run(
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        TriangleMesh own = mesh;
        own.triangles.clear();
        own.triangleCells.clear();
        const auto add = [&](std::size_t triangle)
        {
          const auto& [a, b, c] = mesh.triangles[triangle];
          own.triangles.push_back(rank == 1 ? std::array{ b, c, a } : std::array{ a, b, c });
          own.triangleCells.push_back(mesh.triangleCells[triangle]);
        };
        for (std::size_t i = 0; i < mesh.triangles.size() && rank != 2; ++i)
        {
          if (atRandom(kRanks + 1)(i) <= rank)
          {
            add(i);
            i % 5 == 0 ? add(i) : void();
          }
        }
        if (rank == 2)
        {
          own = {};
        }
        dropCopies(communicator, own);
        kept[rank] = own;
      });
  std::vector<int> times(mesh.triangles.size(), 0);
  for (int rank = 0; rank <= kRanks; ++rank)
  {
    ASSERT_EQ(kept[rank].triangles.size(), kept[rank].triangleCells.size());
    for (const std::int64_t cell : kept[rank].triangleCells)
    {
      const int first = atRandom(kRanks + 1)(static_cast<std::size_t>(cell));
      EXPECT_EQ(rank, first == 2 ? 3 : first);
      ++times[cell];
    }
  }
  EXPECT_EQ(times, std::vector<int>(mesh.triangles.size(), 1));
}

TEST(Copies, OfTheOtherOrientationAreNone)
{
  const TriangleMesh mesh = numbered(regularTetrahedron(1.0));
  SimulatedRanks(2).run(
    [&](Communicator& communicator)
    {
      TriangleMesh own = communicator.rank() == 0 ? mesh : flipOrientation(mesh);
      dropCopies(communicator, own);
      EXPECT_EQ(own.triangles.size(), mesh.triangles.size());
    });
}

} // namespace
} // namespace medial::test
