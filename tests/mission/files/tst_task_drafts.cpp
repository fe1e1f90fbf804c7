#include <QTest>

#include "core/mission/files/task_drafts.h"
#include "tests/suite/suite.h"

namespace tst_task_drafts {

using namespace usar;
using mission::TaskDraft;
using mission::TaskDrafts;

namespace {

const Rectangle area{{0.0, 0.0}, {10.0, 5.0}};

} // namespace

class tst_TaskDrafts : public QObject {
    Q_OBJECT
private slots:
    void aNewRobotTakesOverWhatWasSetUpBeforeItCame() {
        TaskDrafts drafts;
        drafts.shown().behavior_id = "airrobot/cpp";
        drafts.shown().area_in_map = area;
        drafts.show({1});
        QCOMPARE(drafts.shown().behavior_id, std::string("airrobot/cpp"));
        QCOMPARE(drafts.shown().area(), area);
    }

    void eachRobotKeepsItsOwn() {
        TaskDrafts drafts;
        drafts.show({1});
        drafts.shown().behavior_id = "one";
        drafts.show({2});
        drafts.shown().behavior_id = "two";
        drafts.show({1});
        QCOMPARE(drafts.shown().behavior_id, std::string("one"));
        drafts.show({0});
        QVERIFY(drafts.shown().behavior_id.empty());
    }

    void whatWasRemovedIsForgotten() {
        TaskDrafts drafts;
        drafts.show({1});
        drafts.shown().behavior_id = "one";
        drafts.forget({1});
        QVERIFY(std::as_const(drafts).shown().behavior_id.empty());
        drafts.show({0});
        drafts.show({1});
        QVERIFY(drafts.shown().behavior_id.empty());
    }

    void aReplayHasTheDraftOfItsRobot() {
        TaskDrafts drafts;
        drafts.shown().area_in_map = area;
        drafts.show({1});
        drafts.shown().behavior_id = "one";
        drafts.copy({1}, {2});
        drafts.copy({0}, {3});
        drafts.show({2});
        QVERIFY(drafts.shown().behavior_id == "one" && drafts.shown().area_in_map);
        drafts.show({3});
        QVERIFY(drafts.shown().behavior_id.empty() && !drafts.shown().area_in_map);
    }

    void areasGoWithTheirWorld() {
        TaskDrafts drafts;
        for (int robot : {0, 1, 2}) {
            drafts.show({robot});
            drafts.shown().area_in_map = area;
        }
        drafts.forgetAreas();
        for (int robot : {0, 1, 2}) {
            drafts.show({robot});
            QVERIFY(drafts.shown().area().empty());
        }
    }

    void anotherBehaviorBeginsWithItsOwnValues() {
        TaskDraft draft;
        draft.behavior_id = "one";
        draft.plan_path = "a.lap";
        draft.area_in_map = area;
        draft.values = {{"speed", 2.0}};
        draft.choose("one");
        QVERIFY(draft.plan_path == "a.lap" && draft.values.size() == 1);
        draft.choose("two");
        QVERIFY(draft.plan_path.empty() && draft.values.empty());
        QCOMPARE(draft.area(), area);
    }

    void aMissionThatIsTakenIsTheMissionThatIsSaved() {
        mission::Mission mission;
        mission.behavior = "airrobot/posh";
        mission.plan = "mine.lap";
        mission.area_in_map = area;
        mission.cell_size_m = 0.5;
        mission.limit_h = 20.0;
        mission.faults = {"wind speed=4"};
        TaskDraft draft;
        draft.take(mission, {{"speed", 1.5}});
        const mission::Mission saved = draft.mission();
        QCOMPARE(saved.behavior, mission.behavior);
        QCOMPARE(saved.plan, mission.plan);
        QCOMPARE(saved.area_in_map, area);
        QCOMPARE(saved.cell_size_m, 0.5);
        QCOMPARE(saved.limit_h, mission.limit_h);
        QCOMPARE(saved.faults, mission.faults);
        QVERIFY(saved.parameters == draft.values && saved.parameters.size() == 1);
    }
};

USAR_TEST(tst_TaskDrafts)

} // namespace tst_task_drafts

#include "tst_task_drafts.moc"
