#include "huge_heap.h"
#include "options.h"
#include "program_main.h"
#include "ranks/rank_session.h"
#include "ranks/run_on_ranks.h"
#include "run.h"

int main(int argc, char** argv)
{
  using medial::app::RankSession;
  return medial::app::runProgram("medial-axis",
    [&]
    {
      if (const std::unique_ptr<RankSession> session = RankSession::start(argc, argv))
      {
        session->run(
          [&]
          {
            medial::Communicator& communicator = session->communicator();
            if (const auto options = medial::app::agreedOptions(argc, argv, communicator))
            {
              medial::app::runOnRanks(*options, communicator);
            }
          });
        return;
      }
      if (const auto options = medial::app::parseOptions(argc, argv))
      {
        medial::app::useHugeHeap();
        medial::app::run(*options);
      }
    });
}
