#include <QtTest>

#include "robots/airrobot/descriptions.h"
#include "tests/doubles/toy_airrobot.h"

using namespace usar;
using namespace usar::agent;
using namespace usar::tests;

namespace {

Task taskOver(const Vec2& min_m, const Vec2& max_m) {
    return {"R1", Pose{}, {min_m, max_m}};
}

ToyFlight flight(const ToyWorld& world, const Task& task, std::map<std::string, ParameterValue> values = {},
                 ToyFaults faults = {}, Seconds battery = Seconds(1e5)) {
    auto parameters = ParameterSet::make(airrobot::describeAirRobot().behaviors[0].parameters, values);
    Q_ASSERT(parameters);
    auto behavior = airrobot::makeBehavior("airrobot/cpp", {task, *parameters});
    Q_ASSERT(behavior);
    return {ToyAirRobot(world, task.start_in_map, faults, battery), std::move(*behavior)};
}

} // namespace

class TestSurveyBehavior : public QObject {
    Q_OBJECT

private slots:
    void scansAnOpenField() {
        ToyFlight toy = flight({}, taskOver({5, 5}, {45, 35}));
        toy.run(Seconds(2000));
        QVERIFY(toy.ending());
        QVERIFY(toy.ending()->success);
    }
};

QTEST_APPLESS_MAIN(TestSurveyBehavior)
#include "tst_survey_behavior.moc"
