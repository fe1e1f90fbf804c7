#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_reasons.h"

namespace tst_plan_activity {

using namespace usar;
using namespace usar::widgets;

namespace {

/// Fills a snapshot path by path.
struct Scene {
    std::vector<std::string> paths;
    std::vector<PlanActivity> activities;
    Seconds now{100.0};

    PlanActivity& operator[](const std::string& path) {
        paths.push_back(path);
        return activities.emplace_back();
    }
    void answer(const std::string& path, const char* value, bool holds, double since_s) {
        (*this)[path].answer = SenseAnswer{QString::fromLatin1(value), holds, Seconds(since_s), now};
    }
    PlanSnapshot snapshot() const { return {std::make_shared<const std::vector<std::string>>(paths), activities, now}; }
};

const std::string root = "/P:0/DC:0";
const std::string fetch = "/P:0/DC:0/DE:1/A:0/C:0";

} // namespace

class tst_PlanActivity : public QObject {
    Q_OBJECT
private slots:
    void init();
    void eachPathReachesItsNode();
    void sharedPartsSumUp();
    void linkAndItsTargetBothRun();
    void pathsOfAnotherPlanAreCounted();
    void glowHalvesAndGoesOut_data();
    void glowHalvesAndGoesOut();
    void fewerActivitiesThanPathsAreNoTrouble();
    void runningCardsAreListedInOrder();
    void reasons_data();
    void reasons();
    void aReasonKnowsSinceWhen();
    void whatPreventsTheDrivesIsListedOnce();
    void answersSayVerdictValueAndAge();
    void countersAreWords();

private:
    PlanTree tree_;
    PlanStates states_;
};

void tst_PlanActivity::init() {
    tree_ = PlanTree(planOf(courier_plan));
    states_.reset(tree_);
}

void tst_PlanActivity::eachPathReachesItsNode() {
    Scene scene;
    scene[fetch + "/CE:0"].started = 7;
    scene.answer(fetch + "/CE:0/S:1", "true", false, 90.0);
    states_.take(tree_, scene.snapshot());
    QCOMPARE(states_[tree_.find(fetch + "/CE:0")].started, std::uint64_t(7));
    QCOMPARE(states_[tree_.find(fetch + "/CE:0/S:1")].answer->value, QStringLiteral("true"));
    states_.reset(tree_);
    QCOMPARE(states_[tree_.find(fetch + "/CE:0")].started, std::uint64_t(0));
}

void tst_PlanActivity::sharedPartsSumUp() {
    Scene scene;
    PlanActivity& first = scene[root + "/DE:0/A:0/AP:1/A:0"];
    first.started = 2;
    first.last_active = Seconds(90.0);
    PlanActivity& second = scene[fetch + "/CE:1/A:0/AP:0/A:2/AP:1/A:0"];
    second.started = 3;
    second.last_active = Seconds(95.0);
    states_.take(tree_, scene.snapshot());
    const PlanActivity& stop = states_[tree_.find(root + "/DE:0/A:0/AP:1/A:0")];
    QCOMPARE(stop.started, std::uint64_t(5));
    QCOMPARE(stop.last_active->count(), 95.0);
}

void tst_PlanActivity::linkAndItsTargetBothRun() {
    Scene scene;
    const std::string link = fetch + "/CE:1/A:0/AP:0/A:2/AP:1";
    scene[link].running = true;
    states_.take(tree_, scene.snapshot());
    QVERIFY(states_[tree_.find(link)].running);
    QVERIFY(states_[tree_[tree_.find(link)].link].running);
}

void tst_PlanActivity::pathsOfAnotherPlanAreCounted() {
    Scene scene;
    scene[root].running = true;
    scene["/P:0/DC:0/DE:99"].running = true;
    states_.take(tree_, scene.snapshot());
    QCOMPARE(states_.strangers(), 1);
}

void tst_PlanActivity::glowHalvesAndGoesOut_data() {
    QTest::addColumn<double>("age_s");
    QTest::addColumn<double>("glow");
    QTest::newRow("just now") << 0.0 << 1.0;
    QTest::newRow("one half-life") << 2.0 << 0.5;
    QTest::newRow("two") << 4.0 << 0.25;
    QTest::newRow("long ago") << 60.0 << 0.0;
    QTest::newRow("a clock that was set back") << -5.0 << 1.0;
}

void tst_PlanActivity::glowHalvesAndGoesOut() {
    QFETCH(double, age_s);
    QFETCH(double, glow);
    Scene scene;
    scene[fetch].last_active = scene.now - Seconds(age_s);
    states_.take(tree_, scene.snapshot());
    QCOMPARE(states_.recency(tree_.find(fetch)), glow);
    QCOMPARE(states_.recency(tree_.find(root)), 0.0);
}

void tst_PlanActivity::fewerActivitiesThanPathsAreNoTrouble() {
    Scene scene;
    scene[root].running = true;
    PlanSnapshot snapshot = scene.snapshot();
    snapshot.activities.clear();
    states_.take(tree_, snapshot);
    QVERIFY(!states_[PlanNodeId{0}].running);
    snapshot.paths.reset();
    states_.take(tree_, snapshot);
}

void tst_PlanActivity::runningCardsAreListedInOrder() {
    Scene scene;
    for (const char* part : {"/DE:1/A:0/C:0/CE:3/A:0", "/DE:1", "/DE:1/A:0/C:0", "", "/DE:1/A:0/C:0/CE:3"})
        scene[root + part].running = true;
    states_.take(tree_, scene.snapshot());
    QStringList names;
    for (const PlanNodeId node : states_.running(tree_))
        names << tree_[node].name;
    QCOMPARE(names.mid(0, 4).join(u' '), QStringLiteral("courier work fetch go"));
    QCOMPARE(names.size(), 5);
}

void tst_PlanActivity::reasons_data() {
    QTest::addColumn<std::string>("path");
    QTest::addColumn<QString>("verdict");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* spoken, const std::string& path, const char* verdict, const char* reason) {
        QTest::newRow(spoken) << path << QString::fromUtf8(verdict) << QString::fromUtf8(reason);
    };
    row("own sense said no", fetch + "/CE:0/A:0",
        "CloseGripper does not run, for one reason:", "no grab: Distance < 0.3 – no, it is 0.9, for 8.0 s");
    row("a sense that holds is no reason", fetch + "/CE:0",
        "grab does not run, for one reason:", "yes grab: Loaded = false – yes, it is false, for 90 s");
    row("something more important runs", root + "/DE:2",
        "rest does not run, for one reason:", "no work is running now and has priority over rest");
    row("it runs", fetch + "/CE:1", "near runs now", "yes near: Distance < 2.0 – yes, it is 0.9, for 8.0 s");
    row("an equal runs", fetch + "/CE:2",
        "beep does not run, for one reason:", "no near, which has the same priority, is running now");
    row("held back", root + "/DE:0",
        "safety does not run, for 2 reasons:", "no safety is held back by its frequency: 1.2 s left");
    row("a step before it runs", fetch + "/CE:1/A:0/AP:0/A:1",
        "Distance does not run, for one reason:", "no Slow comes before it and is running now");
    row("never asked", root + "/S:0", "Delivered has not been asked yet", "");
    row("a goal that does not hold is no news", fetch, "fetch runs now",
        "yes work: Battery > 0.2 – yes, it is 0.8, for 2 min");
}

void tst_PlanActivity::reasons() {
    QFETCH(std::string, path);
    QFETCH(QString, verdict);
    QFETCH(QString, reason);
    Scene scene;
    for (const char* part : {"", "/DE:1", "/DE:1/A:0/C:0", "/DE:1/A:0/C:0/CE:1", "/DE:1/A:0/C:0/CE:1/A:0/AP:0",
                             "/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:0"})
        scene[root + part].running = true;
    scene.answer(fetch + "/CE:0/S:0", "0.9", false, 92.0);
    scene.answer(fetch + "/CE:0/S:1", "false", true, 10.0);
    scene.answer(fetch + "/CE:1/S:0", "0.9", true, 92.0);
    scene.answer(fetch + "/S:0", "false", false, 10.0);
    scene.answer(root + "/DE:1/S:0", "0.8", true, 0.0);
    scene.answer(root + "/DE:0/S:0", "false", false, 99.0);
    scene[root + "/DE:0"].hold_back = QStringLiteral("its frequency: 1.2 s left");
    states_.take(tree_, scene.snapshot());
    const PlanNodeId node = tree_.find(path);
    QCOMPARE(planVerdict(tree_, states_, node), verdict);
    QStringList found;
    for (const PlanReason& said : planReasons(tree_, states_, node))
        found << (said.verdict == PlanVerdict::Yes  ? QStringLiteral("yes ")
                  : said.verdict == PlanVerdict::No ? QStringLiteral("no ")
                                                    : QStringLiteral("open ")) +
                     said.text;
    QVERIFY2(reason.isEmpty() || found.contains(reason), qPrintable(found.join('\n')));
}

void tst_PlanActivity::aReasonKnowsSinceWhen() {
    Scene scene;
    scene[root + "/DE:1"].running = true;
    scene.answer(root + "/DE:0/S:0", "false", false, 92.5);
    states_.take(tree_, scene.snapshot());
    const auto sinceOf = [this](const std::string& path, const std::string& of) {
        for (const PlanReason& said : planReasons(tree_, states_, tree_.find(path)))
            if (said.node == tree_.find(of))
                return said.since;
        return std::optional(Seconds(-1.0));
    };
    QCOMPARE(sinceOf(root + "/DE:0", root + "/DE:0/S:0"), std::optional(Seconds(92.5)));
    QCOMPARE(sinceOf(root + "/DE:1", root + "/DE:1/S:0"), std::optional<Seconds>()); // not asked
    QCOMPARE(sinceOf(root + "/DE:2", root + "/DE:1"), std::optional<Seconds>());     // no sense
}

void tst_PlanActivity::whatPreventsTheDrivesIsListedOnce() {
    QVERIFY(driveRefusals(tree_, states_).empty()); // nothing is known
    Scene scene;
    scene[root + "/DE:1"].running = true;
    scene.answer(root + "/DE:0/S:0", "false", false, 92.0);
    scene.answer(root + "/DE:1/S:0", "0.1", false, 99.0); // it runs, so nothing prevents it
    scene.answer(root + "/S:0", "true", true, 98.0);
    states_.take(tree_, scene.snapshot());
    QStringList found;
    for (const PlanReason& said : driveRefusals(tree_, states_)) {
        QCOMPARE(said.verdict, PlanVerdict::No);
        found << said.text;
    }
    QCOMPARE(found, QStringList({QStringLiteral("courier, goal: Delivered – yes, it is true, for 2.0 s"),
                                 QStringLiteral("safety: Bumped – no, it is false, for 8.0 s"),
                                 QStringLiteral("work is running now and has priority over rest")}));
}

void tst_PlanActivity::answersSayVerdictValueAndAge() {
    PlanActivity state;
    QVERIFY(answerText(state, Seconds(5)).contains(QStringLiteral("not asked yet")));
    state.answer = SenseAnswer{QStringLiteral("0.12"), false, Seconds(2), Seconds(5)};
    QCOMPARE(answerText(state, Seconds(5)), QStringLiteral("no, it is 0.12, for 3.0 s"));
    QVERIFY(!answerText(state, Seconds(0)).contains(QStringLiteral("−"))); // a clock that was set back
}

void tst_PlanActivity::countersAreWords() {
    PlanActivity state;
    QVERIFY(countersText(state).isEmpty());
    state.started = 12;
    state.succeeded = 1;
    state.skipped = 4;
    QCOMPARE(countersText(state), QStringLiteral("12 starts, 1 success, held back 4 times"));
    QCOMPARE(lastRunText(state, Seconds(9)), QStringLiteral("has not run yet"));
    state.last_active = Seconds(6.0);
    QCOMPARE(lastRunText(state, Seconds(9.0)), QStringLiteral("ran 3.0 s ago"));
}

USAR_TEST(tst_PlanActivity)

} // namespace tst_plan_activity

#include "tst_plan_activity.moc"
