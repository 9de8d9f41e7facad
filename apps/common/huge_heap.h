#pragma once

namespace medial::app
{

/// Gives the heap of the program huge pages, where the system gives them on request, and keeps in
/// it what is freed until the program ends. For programs of one process that soon end; call it
/// before large arrays are made. Nothing happens where the memory of the process is limited
/// (`ulimit`), or with another allocator than glibc's.
void useHugeHeap();

} // namespace medial::app
