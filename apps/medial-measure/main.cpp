#include "huge_heap.h"
#include "measure_command.h"
#include "measure_run.h"
#include "program_main.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-measure",
    [&]
    {
      if (const auto command = medial::app::parseMeasureCommand(argc, argv))
      {
        medial::app::useHugeHeap();
        medial::app::runMeasure(*command);
      }
    });
}
