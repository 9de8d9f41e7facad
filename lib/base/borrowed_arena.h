#pragma once

#include <tbb/task_arena.h>

#include <memory>

namespace medial
{

/// An arena of TBB, given back when this goes. Arenas are used again: TBB (2021.8) keeps some 7 KB
/// of every arena that it destroys.
class BorrowedArena
{
public:
  /// @param threads how many it may use, at least 1.
  explicit BorrowedArena(int threads);
  ~BorrowedArena();
  BorrowedArena(const BorrowedArena&) = delete;
  BorrowedArena& operator=(const BorrowedArena&) = delete;

  tbb::task_arena* operator->() const { return arena_.get(); }

private:
  int threads_;
  std::unique_ptr<tbb::task_arena> arena_;
};

} // namespace medial
