#include "atomistic/protocol/event.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using namespace atomistic;

TEST(Event, EveryKindSurvivesTheLine) {
  const Event events[] = {
      StartEvent{20210929, 2},
      CardEvent{{.a0_A = 2.46}},
      ProgressEvent{3, 7, 1e-4},
      StepEvent{4, "step-0004.bin"},
      EndEvent{{.ended = Ended::artefact, .reason = "bond"}},
      ErrorEvent{"line\nbreak and \"quotes\"", Fault::file},
      ResponseEvent{{.curves = {{.direction = "zigzag", .strain = {0, 0.01}, .artefact_strain = 0.2}},
                     .states = {{.strain = {0.1, 0.2, 0.3, 15}, .S12_eV_per_A2 = 1.5}}}},
      ForcesEvent{{{-7.4, Eigen::Vector3d(0.1, -1e-17, 3)}, {-7.3, Eigen::Vector3d(1, 2, 3)}}}};
  for (const Event& event : events) {
    const std::string line = to_line(event);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const Event back = event_from_line(line);
    EXPECT_EQ(back.index(), event.index());
    EXPECT_EQ(to_line(back), line);
  }
}

TEST(Event, NumbersKeepAllDigits) {
  const Event back = event_from_line(to_line(CardEvent{{.a0_A = 2.4192432769921406}}));
  EXPECT_EQ(std::get<CardEvent>(back).card.a0_A, 2.4192432769921406);
}

TEST(Event, RefusesWhatIsNotAnEvent) {
  EXPECT_FALSE(event_in_line("LAMMPS (29 Sep 2021)"));
  EXPECT_FALSE(event_in_line("}{"));
  EXPECT_FALSE(event_in_line(R"(module {"event":"party"})"));
  EXPECT_EQ(std::get<StepEvent>(event_in_line("[1,0]<stdout>:" + to_line(StepEvent{3, "step-0003.bin"})).value()).level,
            3);
  EXPECT_THROW(event_from_line("LAMMPS (29 Sep 2021)"), std::runtime_error);
  EXPECT_THROW(event_from_line(R"({"event":"party"})"), std::runtime_error);
  EXPECT_THROW(event_from_line(R"({"event":"step","level":1})"), std::runtime_error);
}

}  // namespace
