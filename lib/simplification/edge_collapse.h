#pragma once

#include "balls/ball.h"
#include "simplification/ball_complex.h"
#include "simplification/ball_quadric.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace medial
{

/// Contracts edges of a complex of balls, cheapest first, until few enough balls are left.
class EdgeCollapse
{
public:
  /// A contraction keeps the topology of the complex and the shape of its triangles. These flags
  /// allow more.
  struct Freedom
  {
    bool fill;  ///< close loops of three balls and hollows of four that the balls fill
    bool fold;  ///< turn triangles over
    bool close; ///< do all of that, and close any loop and hollow
  };

  /// @param balls, complex changed in place.
  EdgeCollapse(std::vector<Ball>& balls, std::vector<BallQuadric> quadrics, BallComplex& complex);

  /// Contracts edges until `target` balls are left.
  /// @param step called regularly with the number of balls left.
  /// @return number of balls left: `target`, or more if the freedom does not allow it.
  int reduceTo(int target, Freedom freedom, const std::function<void(int)>& step);

  /// Returns the vertex that each of the original ones has been merged into.
  std::vector<int> representatives() const;

private:
  struct Candidate
  {
    double cost;
    int edge;
    std::uint32_t version; ///< of the edge at that time

    bool operator<(const Candidate& other) const
    {
      return cost != other.cost ? cost > other.cost : edge > other.edge;
    }
  };

  struct Plan
  {
    Ball ball;
    double cost = 0.0;
    std::uint32_t version = 0;
    bool refused = false; ///< under the current freedom, as long as its neighbourhood stays
  };

  void plan(int edge);
  void enqueue(int edge);
  bool allowed(int edge, Freedom freedom) const;
  bool keepsTopology(int edge, bool mayFill) const;
  bool keepsShape(int edge, bool mayFold) const;
  bool keepsTriangle(const std::array<int, 3>& corners, int edge, bool mayFold) const;
  void contract(int edge);

  std::vector<Ball>& balls_;
  std::vector<BallQuadric> quadrics_;
  BallComplex& complex_;
  std::vector<Plan> plans_;
  std::vector<int> mergedInto_;
  std::priority_queue<Candidate> queue_;
  int left_;
};

} // namespace medial
