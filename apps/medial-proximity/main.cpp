#include "huge_heap.h"
#include "program_main.h"
#include "proximity_command.h"
#include "proximity_run.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-proximity",
    [&]
    {
      if (const auto command = medial::app::parseProximityCommand(argc, argv))
      {
        medial::app::useHugeHeap();
        medial::app::runProximity(*command);
      }
    });
}
