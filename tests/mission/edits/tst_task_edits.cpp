#include <QTest>

#include "core/mission/edits/task_edits.h"
#include "tests/suite/suite.h"

namespace tst_task_edits {

using namespace usar;
using namespace usar::mission;
using Values = std::map<std::string, agent::ParameterValue>;

namespace {

const Rectangle area{{0.0, 0.0}, {10.0, 5.0}};

Rectangle moved(double by_m) {
    return {area.min_m + Vec2(by_m, 0.0), area.max_m + Vec2(by_m, 0.0)};
}

std::vector<agent::ParameterSpec> specs() {
    agent::ParameterSpec speed;
    speed.id = "speed";
    speed.label = "Speed";
    agent::ParameterSpec height;
    height.id = "height";
    height.label = "Height";
    return {speed, height};
}

struct Bench {
    EditHistory history;
    TaskDrafts drafts;
    std::vector<RobotId> shown;
    TaskEdits edits{history, drafts, [this](RobotId robot) { shown.push_back(robot); }};
};

} // namespace

class tst_TaskEdits : public QObject {
    Q_OBJECT
private slots:
    void theTextSaysWhatWasDoneToTheArea_data() {
        QTest::addColumn<std::optional<Rectangle>>("before");
        QTest::addColumn<Rectangle>("after");
        QTest::addColumn<QString>("text");
        using Area = std::optional<Rectangle>;
        QTest::newRow("drawn") << Area() << area << "draw area";
        QTest::newRow("moved") << Area(area) << moved(2.0) << "move area";
        QTest::newRow("resized") << Area(area) << Rectangle{{0.0, 0.0}, {20.0, 5.0}} << "resize area";
        QTest::newRow("removed") << Area(area) << Rectangle{} << "remove area";
    }

    void theTextSaysWhatWasDoneToTheArea() {
        QFETCH(std::optional<Rectangle>, before);
        QFETCH(Rectangle, after);
        QFETCH(QString, text);
        Bench bench;
        bench.drafts.shown().area_in_map = before;
        bench.edits.setArea(after);
        QCOMPARE(bench.drafts.shown().area(), after);
        QCOMPARE(bench.history.undoText(), text);
        bench.history.undo();
        QVERIFY(bench.drafts.shown().area_in_map == before);
        bench.history.redo();
        QCOMPARE(bench.drafts.shown().area(), after);
    }

    void aDragIsOneStepAndTheNextAnother() {
        Bench bench;
        bench.edits.setArea(area);
        bench.history.endStep();
        for (int drag = 0; drag < 2; ++drag) {
            for (int step = 1; step <= 50; ++step)
                bench.edits.setArea(moved(drag * 5.0 + step * 0.1));
            bench.history.endStep();
        }
        QCOMPARE(bench.history.stack()->count(), 3);
        bench.history.undo();
        QCOMPARE(bench.drafts.shown().area(), moved(5.0));
        bench.history.undo();
        QCOMPARE(bench.drafts.shown().area(), area);
    }

    void undoChangesTheRobotThatWasEdited() {
        Bench bench;
        bench.drafts.show({1});
        bench.edits.setArea(area);
        bench.drafts.show({2});
        bench.edits.setArea(moved(7.0));
        bench.drafts.show({1});
        bench.history.undo();
        QCOMPARE(bench.drafts.of({2}).area(), area); // It began with that of robot 1.
        QCOMPARE(bench.drafts.of({1}).area(), area);
        QVERIFY(bench.shown == std::vector<RobotId>{{2}});
    }

    void oneParameterIsNamedAndMergesWithItself() {
        Bench bench;
        bench.drafts.shown().values = {{"speed", 1.0}, {"height", 5.0}};
        bench.edits.setValues({{"speed", 2.0}, {"height", 5.0}}, specs());
        bench.edits.setValues({{"speed", 3.0}, {"height", 5.0}}, specs());
        QCOMPARE(bench.history.stack()->count(), 1);
        QCOMPARE(bench.history.undoText(), QString("set Speed"));
        bench.edits.setValues({{"speed", 3.0}, {"height", 6.0}}, specs());
        QCOMPARE(bench.history.undoText(), QString("set Height"));
        bench.edits.setValues({{"speed", 1.0}, {"height", 5.0}}, specs());
        QCOMPARE(bench.history.undoText(), QString("set parameters"));
        bench.history.undo();
        bench.history.undo();
        QVERIFY(bench.drafts.shown().values == (Values{{"speed", 3.0}, {"height", 5.0}}));
        bench.history.undo();
        QVERIFY(bench.drafts.shown().values == (Values{{"speed", 1.0}, {"height", 5.0}}));
    }

    /// A window that opened a mission flew it with the defaults: it stored the draft's values in the draft once more.
    void theDraftsOwnValuesStay() {
        Bench bench;
        const Values values{{"speed", 1.0}, {"height", 5.0}};
        bench.drafts.shown().values = values;
        bench.edits.setValues(bench.drafts.shown().values, specs());
        QVERIFY(bench.drafts.shown().values == values);
        QVERIFY(!bench.history.canUndo());
    }

    void aMissionThatWasOpenedIsTakenBackWhole() {
        Bench bench;
        bench.edits.setArea(area);
        const TaskDraft before = bench.drafts.shown();
        bench.drafts.shown().behavior_id = "other";
        bench.drafts.shown().area_in_map.reset();
        bench.edits.replaced(before, "open scan.json");
        QCOMPARE(bench.history.undoText(), QString("open scan.json"));
        bench.history.undo();
        QVERIFY(bench.drafts.shown() == before);
    }

    void aRobotThatIsGoneIsNotEdited() {
        Bench bench;
        bench.drafts.show({1});
        bench.edits.setArea(area);
        bench.edits.forget({1});
        bench.drafts.forget({1});
        QVERIFY(!bench.history.canUndo());
        QVERIFY(bench.history.reasonOf(0).contains("gone"));
    }

    void withTheWorldOnlyItsAreasGo() {
        Bench bench;
        bench.edits.setArea(area);
        bench.edits.setValues({{"speed", 2.0}}, specs());
        bench.edits.forgetAreas();
        bench.drafts.forgetAreas();
        QCOMPARE(bench.history.undoText(), QString("set Speed"));
        bench.history.undo();
        QVERIFY(!bench.history.canUndo());
        QVERIFY(!bench.drafts.shown().area_in_map);
    }
};

USAR_TEST(tst_TaskEdits)

} // namespace tst_task_edits

#include "tst_task_edits.moc"
