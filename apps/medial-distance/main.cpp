#include "distance_command.h"
#include "distance_run.h"
#include "huge_heap.h"
#include "program_main.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-distance",
    [&]
    {
      if (const auto command = medial::app::parseDistanceCommand(argc, argv))
      {
        medial::app::useHugeHeap();
        medial::app::runDistance(*command);
      }
    });
}
